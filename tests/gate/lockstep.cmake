# cmake -DPROGRAM= -DSOURCE= "-DARGUMENTS=..." -DCACHE= | -DFOLDER= -DFILE= -DEXPECT= -P lockstep.cmake
# Runs `rayclock verify --netlist`. With EXPECT, in a copy of rtl/ whose FILE is changed (OLD and NEW in
# FOLDER, see tests/meta): the report of the first divergence must contain these words.
include(${CMAKE_CURRENT_LIST_DIR}/faulty.cmake)
separate_arguments(arguments UNIX_COMMAND "${ARGUMENTS}")
execute_process(COMMAND ${PROGRAM} verify ${arguments} --netlist --no-judge --json ${FOLDER}/report.json
  WORKING_DIRECTORY ${SOURCE}
  RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
string(REGEX MATCH "model and RTL: [^\n]*" compared "${output}")
string(REGEX MATCH "FIRST DIVERGENCE[^\n]*" divergence "${output}")
if(NOT EXPECT)
  if(NOT result EQUAL 0 OR NOT compared MATCHES " 0 values differ, cycle gap 0, counters equal")
    message(FATAL_ERROR
      "the netlist does not move as the model does; verify ended with ${result}:\n${output}")
  endif()
  file(READ ${FOLDER}/report.json report)
  string(JSON is_netlist GET "${report}" netlist)
  if(NOT is_netlist)
    message(FATAL_ERROR "the report does not say that a netlist was simulated")
  endif()
  message(STATUS "${compared}")
  return()
endif()
faulty_end()
if(NOT result EQUAL 1 OR NOT divergence MATCHES "${EXPECT}")
  message(FATAL_ERROR
    "a netlist with a fault in ${FILE} SURVIVED, or its fault is not told as '${EXPECT}'; verify "
    "ended with ${result}:\n${output}")
endif()
message(STATUS "${divergence}")

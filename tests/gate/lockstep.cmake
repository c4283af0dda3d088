# cmake -DPROGRAM= -DSOURCE= "-DARGUMENTS=..." -DCACHE= | -DFOLDER= -DFILE= -DEXPECT= -P lockstep.cmake
# Runs `rayclock verify --netlist`. With EXPECT, in a copy of rtl/ whose FILE is changed (OLD and NEW in FOLDER, see
# tests/meta): the first divergence must be told in these words.
set(kept ${CACHE})
if(EXPECT)
  file(REMOVE_RECURSE ${FOLDER}/rtl ${FOLDER}/cache)
  file(COPY ${SOURCE}/rtl DESTINATION ${FOLDER})
  execute_process(COMMAND ${CMAKE_COMMAND} -DOLD=${FOLDER}/old -DNEW=${FOLDER}/new -DFROM=${SOURCE}/rtl/${FILE}
    -DTO=${FOLDER}/rtl/${FILE} -P ${CMAKE_CURRENT_LIST_DIR}/../meta/apply.cmake COMMAND_ERROR_IS_FATAL ANY)
  set(ENV{RAYCLOCK_RTL} ${FOLDER}/rtl)
  set(kept ${FOLDER}/cache)
endif()
set(ENV{RAYCLOCK_CACHE} ${kept})
separate_arguments(arguments UNIX_COMMAND "${ARGUMENTS}")
execute_process(COMMAND ${PROGRAM} verify ${arguments} --netlist --no-judge WORKING_DIRECTORY ${SOURCE}
  RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
string(REGEX MATCH "model and RTL: [^\n]*" compared "${output}")
string(REGEX MATCH "FIRST DIVERGENCE[^\n]*" divergence "${output}")
if(NOT EXPECT)
  if(NOT result EQUAL 0 OR NOT compared MATCHES " 0 values differ, cycle gap 0, counters equal")
    message(FATAL_ERROR "the netlist does not move as the model does; verify ended with ${result}:\n${output}")
  endif()
  message(STATUS "${compared}")
  return()
endif()
file(REMOVE_RECURSE ${FOLDER}/rtl ${FOLDER}/cache)
if(NOT result EQUAL 1 OR NOT divergence MATCHES "${EXPECT}")
  message(FATAL_ERROR "a netlist with a fault in ${FILE} SURVIVED, or its fault is not told as '${EXPECT}'; verify "
    "ended with ${result}:\n${output}")
endif()
message(STATUS "${divergence}")

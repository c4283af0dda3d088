# cmake -DPROGRAM= -DSOURCE= -DCONFIG= -DUNIT= -DFLOOR=MHz -DFOLDER= -DCACHE= | -DFILE= -DEXPECT= -P
# fmax.cmake
# Places and routes a unit alone. Its clock must reach the floor. With EXPECT, does the same in a copy of rtl/
# whose FILE is changed (OLD and NEW in FOLDER, see tests/meta). The clock must then miss the floor, and the
# report of the slowest path must contain these words.
include(${CMAKE_CURRENT_LIST_DIR}/faulty.cmake)
execute_process(COMMAND ${PROGRAM} chip --config ${CONFIG} --unit ${UNIT} --json ${FOLDER}/report.json
  WORKING_DIRECTORY ${SOURCE} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
faulty_end()
if(output MATCHES "nextpnr-ecp5 is not installed")
  message("SKIPPED: nextpnr-ecp5 is not installed; ./bootstrap chip installs it")
  return()
elseif(NOT result EQUAL 0)
  message(FATAL_ERROR "chip --config ${CONFIG} --unit ${UNIT} ended with ${result}:\n${output}")
endif()
file(READ ${FOLDER}/report.json report)
string(JSON mhz GET "${report}" fmax_mhz)
string(JSON from GET "${report}" paths 0 from)
string(JSON to GET "${report}" paths 0 to)
set(told "${UNIT} of ${CONFIG} reaches ${mhz} MHz, and its floor is ${FLOOR}; slowest path: ${from} to ${to}")
if(NOT EXPECT)
  if(mhz LESS FLOOR)
    message(FATAL_ERROR "${told}")
  endif()
  message(STATUS "${told}")
elseif(NOT mhz LESS FLOOR OR NOT told MATCHES "${EXPECT}")
  message(FATAL_ERROR "a longer path SURVIVED, or is not told as '${EXPECT}': ${told}")
else()
  message(STATUS "noticed: ${told}")
endif()

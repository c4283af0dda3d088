# cmake -DYOSYS= -DGEN= -DRTL= -DFOLDER= "-DCONFIG=name [key=value ...]" -DTOP= -DMODE=check|synth [-DFILE=
# -DEXPECT=words] -P yosys.cmake
# Reads the RTL of a configuration into Yosys. `check`: the hierarchy is complete, nothing is undriven, driven
# twice or a loop, and there is no latch. `synth`: maps the module to an ECP5 as well. No warning is accepted
# in either. With EXPECT the RTL is a mutant (OLD and NEW in FOLDER, see tests/meta). Yosys must refuse it
# with these words.
file(MAKE_DIRECTORY ${FOLDER})
separate_arguments(config UNIX_COMMAND "${CONFIG}")
execute_process(COMMAND ${GEN} ${FOLDER}/rc_pkg.sv ${config} COMMAND_ERROR_IS_FATAL ANY)
if(EXPECT)
  file(REMOVE_RECURSE ${FOLDER}/rtl)
  file(COPY ${RTL}/ DESTINATION ${FOLDER}/rtl)
  execute_process(COMMAND ${CMAKE_COMMAND} -DOLD=${FOLDER}/old -DNEW=${FOLDER}/new -DFROM=${RTL}/${FILE}
    -DTO=${FOLDER}/rtl/${FILE} -P ${CMAKE_CURRENT_LIST_DIR}/../meta/apply.cmake COMMAND_ERROR_IS_FATAL ANY)
  set(RTL ${FOLDER}/rtl)
endif()
file(GLOB_RECURSE sources ${RTL}/*.sv)
list(FILTER sources EXCLUDE REGEX "rc_pkg\\.sv$")
file(GLOB_RECURSE of_board ${RTL}/board/${TOP}.sv)
if(NOT of_board)   # a chip of several pipelines has no board
  list(FILTER sources EXCLUDE REGEX "/rtl/board/")
endif()
list(SORT sources)
list(JOIN sources "\" \"" sources)   # in quotes: a folder may have a space in its name
set(script "read_verilog -lib +/ecp5/cells_sim.v +/ecp5/cells_bb.v\n")
string(APPEND script "read_verilog -sv -D RC_ECP5 \"${FOLDER}/rc_pkg.sv\" \"${sources}\"\n"
  "hierarchy -check -top ${TOP}\nproc\ncheck -assert\n")
string(APPEND script "select -assert-none t:$dlatch* t:$_DLATCH*\n")
if(MODE STREQUAL "synth")
  string(APPEND script "synth_ecp5 -top ${TOP}\nselect -assert-none t:$dlatch* t:$_DLATCH*\n")
endif()
file(WRITE ${FOLDER}/run.ys "${script}")
execute_process(COMMAND ${YOSYS} -q -l ${FOLDER}/yosys.log ${FOLDER}/run.ys RESULT_VARIABLE result
  OUTPUT_VARIABLE output ERROR_VARIABLE output)
string(REGEX MATCHALL "[^\n]*(Warning|ERROR)[^\n]*" complaints "${output}")
list(JOIN complaints "\n" complaints)
if(EXPECT)
  if(result EQUAL 0 OR NOT output MATCHES "${EXPECT}")
    message(FATAL_ERROR "the mutant of ${FILE} was not refused with '${EXPECT}':\n${output}")
  endif()
  message(STATUS "refused: ${complaints}")
elseif(NOT result EQUAL 0 OR complaints)
  message(FATAL_ERROR "Yosys on ${TOP} of ${CONFIG}, see ${FOLDER}/yosys.log:\n${output}")
endif()

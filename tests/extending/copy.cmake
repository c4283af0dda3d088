# For the tests of docs/machine/extending.md. Defines run(COMMAND ... [OUTPUT variable]), which runs a command
# in ${FOLDER}. Empties ${FOLDER} and copies the sources of the program there.
function(run)
  cmake_parse_arguments(PARSE_ARGV 0 ARG "" "OUTPUT" "COMMAND")
  execute_process(COMMAND ${ARG_COMMAND} WORKING_DIRECTORY ${FOLDER} RESULT_VARIABLE result
    OUTPUT_VARIABLE output ERROR_VARIABLE errors TIMEOUT 3000)
  if(NOT result EQUAL 0)
    list(JOIN ARG_COMMAND " " command)
    message(FATAL_ERROR "${command} ended with ${result}:\n${output}\n${errors}")
  endif()
  if(NOT "${ARG_OUTPUT}" STREQUAL "")   # a variable may be called "off"
    set(${ARG_OUTPUT} "${output}" PARENT_SCOPE)
  endif()
endfunction()

file(REMOVE_RECURSE ${FOLDER})
file(MAKE_DIRECTORY ${FOLDER})
file(COPY ${SOURCE}/CMakeLists.txt ${SOURCE}/bench ${SOURCE}/library ${SOURCE}/model
  ${SOURCE}/python ${SOURCE}/rtl ${SOURCE}/sim ${SOURCE}/scenes DESTINATION ${FOLDER})

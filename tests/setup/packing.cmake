# cmake -DBUILD= -DFOLDER= -P packing.cmake
# Without a program that a Debian package needs, cpack refuses in a sentence that names its package, and makes
# nothing.
file(REMOVE_RECURSE ${FOLDER})
file(MAKE_DIRECTORY ${FOLDER}/bin)
function(check_refusal words)
  execute_process(COMMAND ${CMAKE_COMMAND} -E env PATH=${FOLDER}/bin ${CMAKE_CPACK_COMMAND}
    --config ${BUILD}/CPackConfig.cmake -G DEB -B ${FOLDER}/out
    WORKING_DIRECTORY ${FOLDER} RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE output)
  string(REGEX REPLACE "[ \n]+" " " output "${output}")
  file(GLOB made ${FOLDER}/out/*.deb)
  if(code EQUAL 0 OR made OR NOT output MATCHES "cannot be made without the program ${words}")
    message(FATAL_ERROR "cpack ended with ${code}, made '${made}' and did not say '${words}':\n${output}")
  endif()
endfunction()
check_refusal("file: apt-get install file")
file(WRITE ${FOLDER}/bin/file "#!/bin/sh\n")
file(CHMOD ${FOLDER}/bin/file PERMISSIONS OWNER_READ OWNER_EXECUTE)
check_refusal("dpkg-shlibdeps: apt-get install dpkg-dev")
file(REMOVE_RECURSE ${FOLDER})

# cmake -DFOLDER= -DSOURCE= -P texts.cmake
# Every row of the table, slow ones too, still finds its text: so that a change to the code is told at once that a mutant
# has to follow.
file(STRINGS ${FOLDER}/names names)
set(lost "")
foreach(name IN LISTS names)
  foreach(place "" 2)   # some have a second file
    if(NOT EXISTS ${FOLDER}/${name}/file${place})
      continue()
    endif()
    file(READ ${FOLDER}/${name}/file${place} file)
    execute_process(COMMAND ${CMAKE_COMMAND} -DOLD=${FOLDER}/${name}/old${place} -DNEW=${FOLDER}/${name}/new${place} -DFROM=${SOURCE}/${file}
      -DTO=${FOLDER}/${name}/tried -P ${CMAKE_CURRENT_LIST_DIR}/apply.cmake RESULT_VARIABLE result ERROR_VARIABLE error)
    file(REMOVE ${FOLDER}/${name}/tried)
    if(NOT result EQUAL 0)
      string(APPEND lost "${name}: ${error}\n")
    endif()
  endforeach()
endforeach()
if(lost)
  message(FATAL_ERROR "${lost}")
endif()

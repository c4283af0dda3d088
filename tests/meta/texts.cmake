# cmake -DFOLDER= -DSOURCE= -P texts.cmake
# Checks that every mutant, also each slow one, still finds its text. So a change to the code shows at once
# which mutants must follow.
file(STRINGS ${FOLDER}/names names)
set(lost "")
foreach(name IN LISTS names)
  foreach(place "" 2)   # some have a second file
    if(NOT EXISTS ${FOLDER}/${name}/file${place})
      continue()
    endif()
    file(READ ${FOLDER}/${name}/file${place} file)
    execute_process(COMMAND ${CMAKE_COMMAND} -DOLD=${FOLDER}/${name}/old${place}
      -DNEW=${FOLDER}/${name}/new${place} -DFROM=${SOURCE}/${file} -DTO=${FOLDER}/${name}/tried
      -P ${CMAKE_CURRENT_LIST_DIR}/apply.cmake RESULT_VARIABLE result ERROR_VARIABLE error)
    file(REMOVE ${FOLDER}/${name}/tried)
    if(NOT result EQUAL 0)
      string(APPEND lost "${name}: ${error}\n")
    endif()
  endforeach()
endforeach()
# docs/proofs/who-checks-the-rules.md names every fault of a rule, and no mutant that does not exist.
cmake_policy(SET CMP0057 NEW)
file(READ ${SOURCE}/docs/proofs/who-checks-the-rules.md verdict)
string(REGEX MATCHALL "`(rule|judge|tex_model|tex_image|simulate_tex)_[a-z0-9_]+`" told "${verdict}")
string(REPLACE "`" "" told "${told}")
foreach(name IN LISTS told)
  if(NOT name IN_LIST names)
    string(APPEND lost "docs/proofs/who-checks-the-rules.md names the mutant ${name}, which is not there\n")
  endif()
endforeach()
foreach(name IN LISTS names)
  if(name MATCHES "^rule_" AND NOT name IN_LIST told)
    string(APPEND lost "docs/proofs/who-checks-the-rules.md does not name the mutant ${name}\n")
  endif()
endforeach()
if(lost)
  message(FATAL_ERROR "${lost}")
endif()

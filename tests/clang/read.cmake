# cmake -DCLANG= -DSOURCE= -DFOLDER=model -DSTRICT=[-Werror] -P read.cmake
# Every source below the folder is parsed and checked by Clang with the project's warnings; nothing is generated.
file(GLOB_RECURSE files ${SOURCE}/${FOLDER}/*.cpp)
list(LENGTH files count)
if(count LESS 2)
  message(FATAL_ERROR "no sources below ${FOLDER}")
endif()
string(REPLACE ";" "\n" list "${files}")
string(RANDOM LENGTH 8 name)
set(input ${CMAKE_CURRENT_BINARY_DIR}/clang_reads_${name})
file(WRITE ${input} "${list}\n")
cmake_host_system_information(RESULT cores QUERY NUMBER_OF_LOGICAL_CORES)
execute_process(COMMAND xargs -d "\\n" -n 4 -P ${cores} ${CLANG} -std=c++20 -I ${SOURCE} -fsyntax-only
  -Wall -Wextra -Wpedantic -Wconversion -Wno-sign-conversion -Wno-bitwise-instead-of-logical ${STRICT}
  INPUT_FILE ${input} RESULT_VARIABLE result OUTPUT_VARIABLE said ERROR_VARIABLE said)
file(REMOVE ${input})
if(NOT result EQUAL 0)
  message("${said}")   # a notice: an error's text would be wrapped, and how depends on the length of the tree's path
  message(FATAL_ERROR "Clang refuses what is below ${FOLDER}")
endif()
message("Clang reads ${count} files")

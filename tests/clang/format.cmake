# cmake -DFORMAT=clang-format -DSOURCE= -DFOLDERS=a,b -P format.cmake
# Checks that every C++ file in the folders has the layout of .clang-format. Generated files and deliberate
# faults lie elsewhere.
string(REPLACE "," ";" folders "${FOLDERS}")
set(files)
foreach(folder IN LISTS folders)
  file(GLOB_RECURSE more ${SOURCE}/${folder}/*.cpp ${SOURCE}/${folder}/*.hpp ${SOURCE}/${folder}/*.inl)
  list(APPEND files ${more})
endforeach()
if(NOT FOLDERS MATCHES "unformatted")
  list(FILTER files EXCLUDE REGEX "/tests/clang/unformatted/")
endif()
list(LENGTH files count)
if(count EQUAL 0)
  message(FATAL_ERROR "there is no file to read in ${FOLDERS}")
endif()
execute_process(COMMAND ${FORMAT} --dry-run -Werror ${files} RESULT_VARIABLE result ERROR_VARIABLE said)
if(NOT result EQUAL 0)
  message("${said}")
  message(FATAL_ERROR
    "some of ${count} files are not as .clang-format wants them: clang-format -i FILE mends them")
endif()
message("${count} files are as .clang-format wants them")

# cmake -DSOURCE= -DFOLDERS=a,b -P openings.cmake
# Checks that every C and C++ file in the folders opens with a comment. A C++ header has #pragma once in its
# first line, and the comment in its second.
string(REPLACE "," ";" folders "${FOLDERS}")
set(faults "")
set(count 0)
foreach(folder IN LISTS folders)
  file(GLOB_RECURSE files RELATIVE ${SOURCE} ${SOURCE}/${folder}/*.cpp ${SOURCE}/${folder}/*.hpp
    ${SOURCE}/${folder}/*.inl ${SOURCE}/${folder}/*.c ${SOURCE}/${folder}/*.h)
  if(NOT folder MATCHES "^tests/meta/checks")
    list(FILTER files EXCLUDE REGEX "^tests/meta/checks/")   # the controls
  endif()
  foreach(file IN LISTS files)
    math(EXPR count "${count} + 1")
    file(READ ${SOURCE}/${file} start LIMIT 32)
    if(file MATCHES "[.]hpp$" AND NOT start MATCHES "^#pragma once\n")
      string(APPEND faults "${file}: #pragma once is not its first line\n")
    elseif(NOT start MATCHES "^(#pragma once\n)?/[/*]")
      string(APPEND faults "${file}: does not open with a comment\n")
    endif()
  endforeach()
endforeach()
if(count EQUAL 0)
  message(FATAL_ERROR "there is no file to read in ${FOLDERS}")
endif()
if(faults)
  message(FATAL_ERROR "${faults}")
endif()
message("${count} files open with a comment")

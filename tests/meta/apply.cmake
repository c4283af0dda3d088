# cmake -DOLD=file -DNEW=file -DFROM=file -DTO=file -P apply.cmake
# Copies FROM to TO with one text replaced; the text must be there exactly once.
file(READ ${OLD} old)
file(READ ${NEW} new)
file(READ ${FROM} text)
string(FIND "${text}" "${old}" first)
string(FIND "${text}" "${old}" last REVERSE)
if(NOT old STREQUAL "" AND (first EQUAL -1 OR NOT first EQUAL last))
  message(FATAL_ERROR "${FROM}: the text to change must be there exactly once:\n${old}")
endif()
if(NOT old STREQUAL "")
  string(REPLACE "${old}" "${new}" text "${text}")
endif()
file(WRITE ${TO} "${text}")

# cmake -DSOURCE=folder -DENGINE=name -P rooms.cmake
# Outside its own folders and generated files, at most five lines of code in five files name an engine.
string(SUBSTRING ${ENGINE} 0 1 first)
string(SUBSTRING ${ENGINE} 1 -1 rest)
string(TOUPPER ${first} upper)
set(lines 0)
set(files 0)
set(found "")
foreach(tree model rtl sim bench tests)
  file(GLOB_RECURSE sources RELATIVE ${SOURCE} ${SOURCE}/${tree}/*.cpp ${SOURCE}/${tree}/*.hpp
    ${SOURCE}/${tree}/*.inl ${SOURCE}/${tree}/*.sv ${SOURCE}/${tree}/*.core ${SOURCE}/${tree}/*.js
    ${SOURCE}/${tree}/*.py ${SOURCE}/${tree}/CMakeLists.txt)
  foreach(source IN LISTS sources)
    if(source MATCHES "/engine/${ENGINE}/|rc_pkg\\.sv$")
      continue()
    endif()
    file(STRINGS ${SOURCE}/${source} named REGEX "[${first}${upper}]${rest}")
    list(FILTER named EXCLUDE REGEX "^ *//")
    list(LENGTH named count)
    if(count GREATER 0 AND NOT source STREQUAL "tests/meta/CMakeLists.txt")
      math(EXPR lines "${lines} + ${count}")
      math(EXPR files "${files} + 1")
      string(APPEND found "${source}: ${count}\n")
    endif()
  endforeach()
endforeach()
if(lines EQUAL 0 OR lines GREATER 5 OR files GREATER 5)
  message(FATAL_ERROR
    "${lines} lines in ${files} files name the engine ${ENGINE} outside its rooms; "
    "the limit is 5 lines in 5 files.\n${found}")
endif()
message("${lines} lines in ${files} files:\n${found}")

# Checks that cpack reads before it packs. Without `file`, CPack fails with an internal error. Without
# dpkg-shlibdeps, it makes a package that names no library and cannot start.
set(programs file dpkg-shlibdeps)
set(packages file dpkg-dev)
foreach(name package IN ZIP_LISTS programs packages)
  find_program(found_${name} ${name} NO_DEFAULT_PATH PATHS ENV PATH)
  if(NOT found_${name})
    message(FATAL_ERROR
      "A Debian package cannot be made without the program ${name}: apt-get install ${package}")
  endif()
endforeach()

# rc_options: compiler options of every file of the project. No option is set globally.
option(RAYCLOCK_SANITIZE "Build with address and undefined-behaviour sanitizers" OFF)
# Off for users: a newer compiler may warn about something new, and the program is still sound.
option(RAYCLOCK_WERROR "Stop at the first warning of the C++ compiler" OFF)

add_library(rc_options INTERFACE)
target_include_directories(rc_options INTERFACE ${PROJECT_SOURCE_DIR})
# Without contraction, all compilers and machines compute the same digits.
target_compile_options(rc_options INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wno-sign-conversion $<$<BOOL:${RAYCLOCK_WERROR}>:-Werror>
  -ffp-contract=off)
# GCC 12 reports overlaps inside std::string's operator+ that cannot happen (GCC bug 105651).
target_compile_options(rc_options INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)
# The model joins flags by & and | where the host should not branch: model/core/ring.hpp.
target_compile_options(rc_options INTERFACE $<$<CXX_COMPILER_ID:Clang>:-Wno-bitwise-instead-of-logical>)
# A program loads only the libraries that it calls: OpenImageIO pulls in 250, which add 0.2 s to every start.
target_link_options(rc_options INTERFACE LINKER:--as-needed)
# The Python module is a shared library, and needs position-independent code. Functions may still be inlined and
# called directly, since nothing replaces them at run time. Without the module the flags stay the same, so that
# the tests reuse what the program was built from.
target_compile_options(rc_options INTERFACE -fPIC $<$<CXX_COMPILER_ID:GNU>:-fno-semantic-interposition>)
if(RAYCLOCK_SANITIZE)
  target_compile_options(rc_options INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=undefined)
  target_link_options(rc_options INTERFACE -fsanitize=address,undefined)
endif()

# rc_define(SOURCE NAME=VALUE...): defines macros for one source only. A macro that holds a path would prevent
# the compiler cache from sharing other sources between folders.
function(rc_define source)
  set_property(SOURCE ${source} APPEND PROPERTY COMPILE_DEFINITIONS ${ARGN})
endfunction()

# Options of code that waits for files, other programs or the model: compiling it takes longer than running
# it.
set(rc_less_optimised $<$<CONFIG:Release>:-O1>)

# rc_jumbo(NAME): compiles sixteen sources of a target as one, so that headers are parsed and templates
# instantiated once for all of them. Sources with options of their own (rc_define, SKIP_UNITY_BUILD_INCLUSION)
# and generated sources stay alone. The sources of a unit share file-local names. A unit includes its sources by
# their path in the project, so that the compiler cache serves other clones too, which the units of CMake's own
# UNITY_BUILD prevent. The global property rc_jumbo_PATH lists the sources that are compiled together with
# PATH; mutants are made of it (tests/meta).
function(rc_jumbo name)
  get_target_property(sources ${name} SOURCES)
  set(units)
  set(members)
  foreach(source IN LISTS sources)
    get_filename_component(source ${source} ABSOLUTE)
    get_source_file_property(defined ${source} COMPILE_DEFINITIONS)
    get_source_file_property(alone ${source} SKIP_UNITY_BUILD_INCLUSION)
    cmake_path(IS_PREFIX CMAKE_CURRENT_BINARY_DIR ${source} generated)
    if(defined OR alone OR generated)
      list(APPEND units ${source})
      continue()
    endif()
    file(RELATIVE_PATH part ${PROJECT_SOURCE_DIR} ${source})
    list(APPEND members ${part})
    list(LENGTH members length)
    if(length EQUAL 16)
      rc_jumbo_unit(${name})
    endif()
  endforeach()
  rc_jumbo_unit(${name})
  set_target_properties(${name} PROPERTIES SOURCES "${units}")
endfunction()

# Writes the unit of the sources in `members`, lists it in `units`, and empties `members`.
macro(rc_jumbo_unit name)
  if(members)
    list(LENGTH units number)
    set(unit ${CMAKE_CURRENT_BINARY_DIR}/jumbo/${name}_${number}.cpp)
    rc_write_unit(${unit} ${members})
    list(APPEND units ${unit})
    foreach(member IN LISTS members)
      set_property(GLOBAL PROPERTY rc_jumbo_${member} ${members})
    endforeach()
    set(members)
  endif()
endmacro()

# rc_write_unit(UNIT SOURCE...): writes a source that includes the others.
function(rc_write_unit unit)
  list(TRANSFORM ARGN PREPEND "#include \"")
  list(TRANSFORM ARGN APPEND "\"\n")
  list(JOIN ARGN "" text)
  file(CONFIGURE OUTPUT ${unit} CONTENT "${text}" @ONLY)
endfunction()

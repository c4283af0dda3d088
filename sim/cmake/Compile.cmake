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
# GCC may allocate 1 GB before it collects garbage. This saves about 10 % of the compile time and does not
# change the code.
target_compile_options(rc_options INTERFACE
  $<$<COMPILE_LANG_AND_ID:CXX,GNU>:--param=ggc-min-heapsize=1000000>)
# GCC 12 reports overlaps inside std::string's operator+ that cannot happen (GCC bug 105651).
target_compile_options(rc_options INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)
# The model joins flags by & and | where the host should not branch: model/core/ring.hpp.
target_compile_options(rc_options INTERFACE $<$<CXX_COMPILER_ID:Clang>:-Wno-bitwise-instead-of-logical>)
# A program loads only the libraries that it calls: OpenImageIO pulls in 250, which add 0.2 s to every start.
target_link_options(rc_options INTERFACE LINKER:--as-needed)
# The Python module is a shared library, and needs position-independent code. Functions may still be inlined
# and called directly, since nothing replaces them at run time. Without the module the flags stay the same, so
# that the tests reuse what the program was built from.
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

include(Unity)

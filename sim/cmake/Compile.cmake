# rc_options: how every file of the project is compiled. Nothing is set globally.
option(RAYCLOCK_SANITIZE "Build with address and undefined-behaviour sanitizers" OFF)
# Off for users: a compiler newer than ours may warn of something new, and the program is still sound.
option(RAYCLOCK_WERROR "Stop at the first warning of the C++ compiler" OFF)

add_library(rc_options INTERFACE)
target_include_directories(rc_options INTERFACE ${PROJECT_SOURCE_DIR})
# No contraction: the same digits from every compiler and machine.
target_compile_options(rc_options INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wno-sign-conversion $<$<BOOL:${RAYCLOCK_WERROR}>:-Werror>
  -ffp-contract=off)
# GCC 12 reports overlaps inside std::string's operator+ that cannot happen (GCC bug 105651).
target_compile_options(rc_options INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)
# Flags of the model are joined by & and | where the host should not branch: model/core/ring.hpp.
target_compile_options(rc_options INTERFACE $<$<CXX_COMPILER_ID:Clang>:-Wno-bitwise-instead-of-logical>)
# A program loads the libraries that it calls, and no other: OpenImageIO brings 250, a fifth of a second at every start.
target_link_options(rc_options INTERFACE LINKER:--as-needed)
if(RAYCLOCK_SANITIZE)
  target_compile_options(rc_options INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=undefined)
  target_link_options(rc_options INTERFACE -fsanitize=address,undefined)
endif()

# rc_define(SOURCE NAME=VALUE...): macros that only this source sees. One that holds a path would keep a compiler's cache
# from knowing the others in another folder.
function(rc_define source)
  set_property(SOURCE ${source} APPEND PROPERTY COMPILE_DEFINITIONS ${ARGN})
endfunction()

# The libraries that rayclock links against, all from the distribution's packages.
find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)
find_package(glm REQUIRED)
find_package(TBB REQUIRED)
find_package(fmt REQUIRED)
find_package(ZLIB REQUIRED)
find_package(EXPAT REQUIRED)
find_package(CLI11 REQUIRED)
find_package(nlohmann_json 3.10 REQUIRED)
find_package(verilator 5.006 REQUIRED)
# Use pkg-config for OpenImageIO: the CMake target of Debian names an include folder that does not exist.
pkg_check_modules(OIIO REQUIRED IMPORTED_TARGET OpenImageIO)
if(BUILD_TESTING)
  # Debian 12 has Catch2 2.13 and Embree 3.13, Debian 13 has 3.7 and 4.3. Tests support both.
  find_package(Catch2 REQUIRED)
  if(Catch2_VERSION VERSION_GREATER_EQUAL 3)
    target_include_directories(Catch2::Catch2 INTERFACE ${PROJECT_SOURCE_DIR}/tests/support/catch2_3)
  endif()
  find_package(embree REQUIRED)
  find_package(Boost 1.74 REQUIRED)
endif()

find_program(CCACHE ccache)
if(CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  # Paths in the project count as relative, so that a second clone uses what the first has compiled.
  set(CMAKE_CXX_COMPILER_LAUNCHER env CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} CCACHE_NOHASHDIR=1
    CCACHE_SLOPPINESS=pch_defines,time_macros ${CCACHE})   # without this, nothing with precompiled headers is cached
endif()

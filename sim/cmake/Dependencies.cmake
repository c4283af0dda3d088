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
pkg_check_modules(STB REQUIRED IMPORTED_TARGET stb)
if(BUILD_TESTING)
  # Debian 12 has Catch2 2.13 and Embree 3.13, Debian 13 has 3.7 and 4.3. Tests support both.
  find_package(Catch2 REQUIRED)
  if(Catch2_VERSION VERSION_GREATER_EQUAL 3)
    target_include_directories(Catch2::Catch2 INTERFACE ${PROJECT_SOURCE_DIR}/tests/support/catch2_3)
  endif()
  find_package(embree REQUIRED)
  find_package(Boost 1.74 REQUIRED)
endif()

# The Python module: ON, OFF, or AUTO, which builds it if Python's headers and pybind11 are installed. A
# sanitised module cannot be loaded by an ordinary Python.
set(RAYCLOCK_PYTHON AUTO CACHE
  STRING "Build the Python module: ON, OFF, or AUTO if its packages are installed")
set_property(CACHE RAYCLOCK_PYTHON PROPERTY STRINGS AUTO ON OFF)
set(rc_python ${RAYCLOCK_PYTHON})
if(rc_python STREQUAL AUTO AND RAYCLOCK_SANITIZE)
  set(rc_python OFF)
endif()
if(rc_python)
  set(required)
  if(NOT rc_python STREQUAL AUTO)
    set(required REQUIRED)
  endif()
  # Debian's packages belong to Debian's Python. Another Python may come first in PATH.
  if(NOT Python_EXECUTABLE AND NOT SKBUILD AND EXISTS /usr/bin/python3)
    set(Python_EXECUTABLE /usr/bin/python3)
  endif()
  find_package(Python 3.9 ${required} COMPONENTS Interpreter Development.Module)
  if(Python_FOUND AND NOT pybind11_DIR)
    # A package of PyPI knows its own place.
    execute_process(COMMAND ${Python_EXECUTABLE} -m pybind11 --cmakedir OUTPUT_VARIABLE pybind11_ROOT
      OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  endif()
  set(PYBIND11_FINDPYTHON ON)
  find_package(pybind11 2.10 CONFIG ${required})
  if(Python_FOUND AND pybind11_FOUND)
    set(rc_python ON)
  else()
    set(rc_python OFF)
    message(STATUS "The Python module is left out: python3-dev or pybind11-dev is not installed")
  endif()
endif()

option(RAYCLOCK_CCACHE "Compile through ccache if it is installed" ON)
find_program(CCACHE ccache)
if(RAYCLOCK_CCACHE AND CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  # Paths in the project count as relative, so that a second clone uses what the first has compiled.
  set(CMAKE_CXX_COMPILER_LAUNCHER env CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} CCACHE_NOHASHDIR=1
    # Without this, nothing with precompiled headers is cached.
    CCACHE_SLOPPINESS=pch_defines,time_macros ${CCACHE})
endif()

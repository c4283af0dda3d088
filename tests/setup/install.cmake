# cmake -DBUILD= -DFOLDER= -DSOURCE= -DLIBDIR= -P install.cmake
# Installs into a folder of its own, and uses what is there from elsewhere, as a user would.
file(REMOVE_RECURSE ${FOLDER})
set(prefix ${FOLDER}/prefix)
file(MAKE_DIRECTORY ${FOLDER}/elsewhere)
unset(ENV{RAYCLOCK_RTL})

function(run result)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${FOLDER}/elsewhere RESULT_VARIABLE code
    OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "${ARGN} ended with ${code}:\n${output}")
  endif()
  set(${result} "${output}" PARENT_SCOPE)
endfunction()
function(demand text part)
  string(FIND "${text}" "${part}" at)
  if(at EQUAL -1)
    message(FATAL_ERROR "'${part}' is missing in:\n${text}")
  endif()
endfunction()

run(output ${CMAKE_COMMAND} --install ${BUILD} --prefix ${prefix})
set(program ${prefix}/bin/rayclock)

# It finds its own RTL, and its own library of pictures.
run(output ${program} doctor)
demand("${output}" "${prefix}/share/rayclock/rtl")
run(output ${CMAKE_COMMAND} -E env LD_DEBUG=files ${program} render gears:1 --size 8x8 -o picture.png)
demand("${output}" "${prefix}/${LIBDIR}/rayclock/rayclock_pictures.so")
run(output ${program} simulate ${prefix}/share/rayclock/scenes/desk.json --size 8x8 --no-reference)

# So does the Python module, if it was built.
if(EXISTS ${prefix}/lib/python3/dist-packages/rayclock AND PYTHON)
  execute_process(COMMAND ${PYTHON} -c "import numpy" RESULT_VARIABLE lacks_numpy ERROR_QUIET)
  if(lacks_numpy EQUAL 0)
    run(output ${CMAKE_COMMAND} -E env PYTHONPATH=${prefix}/lib/python3/dist-packages
      PYTHONDONTWRITEBYTECODE=1 ${PYTHON} -c
      "import rayclock; print(rayclock.simulate('gears:1', size=(8, 8), clock=66).digest)")
  endif()
endif()

# Manual page and completions.
file(READ ${prefix}/share/man/man1/rayclock.1 manual)
run(commands ${program} --help)
foreach(command simulate verify explain trace sweep)
  demand("${manual}" "\n.SS ${command}\n")
endforeach()
demand("${manual}" "\\fB\\-\\-max\\-other\\fR")
file(WRITE ${FOLDER}/ask.sh "source ${prefix}/share/bash-completion/completions/rayclock
ask() {
  COMP_WORDS=(rayclock \"$@\") COMP_CWORD=$#
  _rayclock
  echo \"<\${COMPREPLY[*]}>\"
}
ask expl
ask simulate --no-ref
ask simulate --config ulx
ask sweep tet
ask sweep gears --axis node_w
ask stu
ask study gig
ask study area --no-such --uni
")
run(output bash ${FOLDER}/ask.sh)
string(CONCAT completed "<explain>\n<--no-reference>\n<ulx3s ulx3s-shaded ulx3s-board>\n<tetra>\n"
  "<node_width= node_ways=>\n<study>\n<gigahertz>\n<--unit>")
demand("${output}" "${completed}")
set(shells zsh fish)
set(completions zsh/vendor-completions/_rayclock fish/vendor_completions.d/rayclock.fish)
foreach(name file IN ZIP_LISTS shells completions)
  file(READ ${prefix}/share/${file} text)
  demand("${text}" "max-other")
  find_program(${name} ${name})
  if(${name})
    run(output ${${name}} -n ${prefix}/share/${file})
  endif()
endforeach()

# Another project builds on the RTL.
file(WRITE ${FOLDER}/other/CMakeLists.txt "cmake_minimum_required(VERSION 3.25)
project(other LANGUAGES NONE)
find_package(rayclock 0.1 REQUIRED)
execute_process(COMMAND verilator --lint-only -Wall --top-module rc_chip \${rayclock_RTL_SOURCES}
  COMMAND_ERROR_IS_FATAL ANY)
get_target_property(program rayclock::rayclock IMPORTED_LOCATION)
execute_process(COMMAND \${program} --version COMMAND_ERROR_IS_FATAL ANY)
")
run(output ${CMAKE_COMMAND} -S ${FOLDER}/other -B ${FOLDER}/other/build -DCMAKE_PREFIX_PATH=${prefix})

# Another project builds on the library: the example of docs/guide/library.md, copied to a folder of its own.
file(COPY ${prefix}/share/doc/rayclock/docs/examples/library DESTINATION ${FOLDER})
run(output ${CMAKE_COMMAND} -S ${FOLDER}/library -B ${FOLDER}/library/build -DCMAKE_PREFIX_PATH=${prefix})
run(output ${CMAKE_COMMAND} --build ${FOLDER}/library/build)
run(output ${FOLDER}/library/build/example)
run(expected ${program} simulate gears:4 --size 256x192 --clock 200 --set node_sets=128 --no-reference --json
  -)
string(JSON cycles GET "${expected}" clocks 0 cycles)
string(JSON triangles GET "${expected}" scene triangles)
demand("${output}" "gears:4: ${triangles} triangles")
demand("${output}" "200 MHz: ${cycles} cycles")
string(REGEX MATCHALL "triangle [0-9]+ at t = [0-9.]+|no hit" answers "${output}")
list(LENGTH answers count)
if(NOT count EQUAL 3 OR NOT answers MATCHES "no hit$")
  message(FATAL_ERROR "the example traces three rays, and the last one leaves the scene:\n${output}")
endif()
# A later minor version is refused.
file(READ ${FOLDER}/library/CMakeLists.txt project)
string(REPLACE "rayclock 0.1" "rayclock 0.2" project "${project}")
file(WRITE ${FOLDER}/later/CMakeLists.txt "${project}")
execute_process(COMMAND ${CMAKE_COMMAND} -S ${FOLDER}/later -B ${FOLDER}/later/build
  -DCMAKE_PREFIX_PATH=${prefix} RESULT_VARIABLE code OUTPUT_QUIET ERROR_VARIABLE said)
if(code EQUAL 0 OR NOT said MATCHES "0.2")
  message(FATAL_ERROR "find_package(rayclock 0.2) ended with ${code} and said:\n${said}")
endif()
# Only the header's functions are visible: a program may link other versions of the same libraries.
find_program(nm nm)
if(nm)
  file(GLOB library ${prefix}/${LIBDIR}/librayclock.so)
  run(output ${nm} -D --defined-only -C ${library})
  string(REGEX MATCHALL "[^\n]+" symbols "${output}")
  list(FILTER symbols EXCLUDE REGEX "rayclock::library::| A rayclock")
  if(symbols)
    message(FATAL_ERROR "the library shows more than its header:\n${symbols}")
  endif()
endif()
# An unknown scene is an Error with one sentence.
file(READ ${FOLDER}/library/example.cpp source)
string(REPLACE "\"gears:4\"" "\"nothing.obj\"" source "${source}")
file(WRITE ${FOLDER}/library/example.cpp "${source}")
run(output ${CMAKE_COMMAND} --build ${FOLDER}/library/build)
execute_process(COMMAND ${FOLDER}/library/build/example RESULT_VARIABLE code ERROR_VARIABLE said)
if(NOT code EQUAL 2 OR NOT said MATCHES "^[^\n]*nothing.obj[^\n]*\n$")
  message(FATAL_ERROR "the example with a scene that does not exist ended with ${code} and said:\n${said}")
endif()

# The core file has every source.
file(STRINGS ${prefix}/share/rayclock/rtl/rayclock.core lines REGEX "^      - .*\\.sv$")
list(TRANSFORM lines REPLACE "^      - " "")
list(SORT lines)
file(GLOB_RECURSE sources RELATIVE ${prefix}/share/rayclock/rtl ${prefix}/share/rayclock/rtl/*.sv)
list(SORT sources)
if(NOT lines STREQUAL sources)
  message(FATAL_ERROR "rtl/rayclock.core lists\n${lines}\nand the folder has\n${sources}")
endif()
file(REMOVE_RECURSE ${FOLDER})

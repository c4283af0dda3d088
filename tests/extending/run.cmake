# cmake -DSOURCE= -DFOLDER= -DPATCH= -DPROGRAM= -DWERROR= -P run.cmake
# Lays the files of the new unit `out` and the patch that wires it over a copy of the tree, builds program and
# unit's test there, and runs them. Model and RTL must agree, and a frame must end exactly one cycle later
# than without the unit: it has fewer pixels than the machine has contexts, so that no context is used again.
cmake_policy(VERSION 3.25)
set(here ${CMAKE_CURRENT_LIST_DIR})
include(${here}/copy.cmake)
file(COPY ${SOURCE}/tests/support DESTINATION ${FOLDER}/tests)
file(COPY ${here}/rtl ${here}/model ${here}/tests DESTINATION ${FOLDER})
run(COMMAND ${PATCH} --fuzz=0 -p0 -i ${here}/out.patch)
run(COMMAND ${CMAKE_COMMAND} -S . -B build -G Ninja -DCMAKE_BUILD_TYPE=Release -DBUILD_TESTING=ON
  -DRAYCLOCK_WERROR=${WERROR})
run(COMMAND ${CMAKE_COMMAND} --build build --target rayclock rc_out_tests)

set(ENV{RAYCLOCK_CACHE} ${FOLDER}/cache)
set(ENV{RAYCLOCK_RTL} ${FOLDER}/rtl)
run(COMMAND build/tests/rc_out_tests)
set(frame gears:1 --size 8x6 --json -)
file(GLOB program ${FOLDER}/build/rayclock ${FOLDER}/build/sim/rayclock)
run(COMMAND ${program} verify ${frame} OUTPUT verified)
run(COMMAND ${program} simulate ${frame} OUTPUT with)
unset(ENV{RAYCLOCK_RTL})
run(COMMAND ${PROGRAM} simulate ${frame} OUTPUT without)
string(JSON gap GET "${verified}" cycle_gap)
string(JSON values GET "${verified}" value_mismatches)
string(JSON cycles_with GET "${with}" clocks 0 cycles)
string(JSON cycles_without GET "${without}" clocks 0 cycles)
math(EXPR later "${cycles_with} - ${cycles_without}")
if(NOT gap EQUAL 0 OR NOT values EQUAL 0 OR NOT later EQUAL 1)
  message(FATAL_ERROR "cycle gap ${gap}, ${values} values differ, the frame ends ${later} cycles later")
endif()
message(STATUS
  "model and RTL agree, and the frame ends one cycle later: ${cycles_with} for ${cycles_without}")
file(REMOVE_RECURSE ${FOLDER})

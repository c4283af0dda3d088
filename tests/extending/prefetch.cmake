# cmake -DSOURCE= -DFOLDER= -DPATCH= -DPROGRAM= -P prefetch.cmake
# Lays the experiment of docs/machine/extending.md, a prefetch in the model alone, over a copy of the tree,
# builds the program, and runs it. Without the switch digest, cycles and the units' accounts do not change.
# With it the picture's errors and rays are the same, and the primitive cache misses less often.
cmake_policy(VERSION 3.25)
set(here ${CMAKE_CURRENT_LIST_DIR})
include(${here}/copy.cmake)
run(COMMAND ${PATCH} --fuzz=0 -p0 -i ${here}/prefetch.patch)
run(COMMAND ${CMAKE_COMMAND} -S . -B build -G Ninja -DCMAKE_BUILD_TYPE=Release -DBUILD_TESTING=OFF)
run(COMMAND ${CMAKE_COMMAND} --build build --target rayclock)

set(frame gears:4 --size 128x96 --clock 200 --json -)
file(GLOB program ${FOLDER}/build/rayclock ${FOLDER}/build/sim/rayclock)
run(COMMAND ${PROGRAM} simulate ${frame} OUTPUT plain)
run(COMMAND ${program} simulate ${frame} OUTPUT off)
run(COMMAND ${program} simulate ${frame} --set prefetch=1 OUTPUT on)
foreach(run plain off on)
  string(JSON ${run}_digest GET "${${run}}" digest)   # of pixels and cycles
  string(JSON ${run}_error GET "${${run}}" error)
  string(JSON ${run}_rays GET "${${run}}" rays)
  string(JSON ${run}_cycles GET "${${run}}" clocks 0 cycles)
  string(JSON ${run}_units GET "${${run}}" clocks 0 units)
  string(JSON ${run}_misses GET "${${run}}" clocks 0 units prim_cache busy_with miss)
endforeach()
foreach(figure digest cycles units)
  if(NOT plain_${figure} STREQUAL off_${figure})
    message(FATAL_ERROR "without the switch ${figure} changed: ${plain_${figure}}, ${off_${figure}}")
  endif()
endforeach()
if(NOT on_error STREQUAL off_error OR NOT on_rays STREQUAL off_rays OR NOT on_misses LESS off_misses)
  message(FATAL_ERROR "errors ${off_error} and ${on_error}, misses ${off_misses} and ${on_misses}")
endif()
message(STATUS "misses of the primitive cache: ${off_misses}, with prefetch ${on_misses}")
file(REMOVE_RECURSE ${FOLDER})

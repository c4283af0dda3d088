# cmake -DCLANG= -DSOURCE= -DFOLDER= -DWERROR= -DPROGRAM=gcc's rayclock -P same.cmake
# Builds the program with Clang in a folder of its own. Its digests (hits, colours, cycles) must equal the
# digests of GCC's program.
execute_process(COMMAND ${CMAKE_COMMAND} -S ${SOURCE} -B ${FOLDER} -G Ninja -DCMAKE_BUILD_TYPE=Release
  -DBUILD_TESTING=OFF -DCMAKE_CXX_COMPILER=${CLANG} -DRAYCLOCK_WERROR=${WERROR} COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --build ${FOLDER} --target rayclock COMMAND_ERROR_IS_FATAL ANY)

function(digest_by program arguments result)
  execute_process(COMMAND ${program} simulate ${arguments} --json - OUTPUT_VARIABLE report
    COMMAND_ERROR_IS_FATAL ANY)
  string(JSON digest GET "${report}" digest)
  set(${result} ${digest} PARENT_SCOPE)
endfunction()
foreach(scene "gears:4 --size 192x144" "balls:3 --size 192x144 --depth 4"
    "spheres --size 192x144 --depth 5 --aa 2" "teapot:8 --size 192x144 --config small"
    "mount:6 --size 192x144 --set primitive_test=sheared" "tree:6 --size 192x144 --config wide")
  separate_arguments(arguments UNIX_COMMAND ${scene})
  digest_by(${PROGRAM} "${arguments}" expected)
  digest_by(${FOLDER}/rayclock "${arguments}" got)
  message("${scene}: ${got}")
  if(NOT got STREQUAL expected)
    message(SEND_ERROR "${scene}: Clang's program has digest ${got}, the other ${expected}")
  endif()
endforeach()

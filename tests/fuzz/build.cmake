# cmake -DCLANG= -DLAUNCHER=[ccache] -DSOURCE= -DFOLDER= -DMUTANTS= -P build.cmake rc_fuzz|mutants
# Builds rc_fuzz or all its mutants with Clang, in a separate folder.
math(EXPR last "${CMAKE_ARGC} - 1")
execute_process(COMMAND ${CMAKE_COMMAND} -S ${SOURCE} -B ${FOLDER} -G Ninja -DCMAKE_CXX_COMPILER=${CLANG}
  -DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER} -DMUTANTS=${MUTANTS} COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --build ${FOLDER} --target ${CMAKE_ARGV${last}}
  COMMAND_ERROR_IS_FATAL ANY)

# cmake -DPROGRAM= -DMODEL=folder -P model_alone.cmake
# The model needs neither Verilator nor the libraries for files and pictures: not to link, not to compile.
execute_process(COMMAND ${PROGRAM} RESULT_VARIABLE result OUTPUT_VARIABLE output)
if(NOT result EQUAL 0 OR NOT output MATCHES "^[0-9]+ cycles")
  message(FATAL_ERROR "the model alone makes no frame: ${output}")
endif()
execute_process(COMMAND ldd ${PROGRAM} OUTPUT_VARIABLE libraries COMMAND_ERROR_IS_FATAL ANY)
if(libraries MATCHES "(OpenImageIO|assimp|verilat|libfmt|embree|libdl)[^\n]*")
  message(FATAL_ERROR "the model loads ${CMAKE_MATCH_0}")
endif()
file(GLOB_RECURSE sources ${MODEL}/*.cpp ${MODEL}/*.hpp)
foreach(source IN LISTS sources)
  file(READ ${source} text)
  if(text MATCHES
      "#include [<\"](sim/|tests/|verilated|OpenImageIO|assimp|nlohmann|fmt/|CLI/|embree|dlfcn)[^\n]*")
    message(FATAL_ERROR "${source} has ${CMAKE_MATCH_0}")
  endif()
endforeach()

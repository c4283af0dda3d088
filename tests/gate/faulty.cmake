# Other scripts include this file. It sets the folders of the RTL and of its builds. With EXPECT the RTL is a
# copy of rtl/ whose FILE is changed (OLD and NEW in FOLDER, see tests/meta), and faulty_end() removes it.
file(MAKE_DIRECTORY ${FOLDER})
set(ENV{RAYCLOCK_CACHE} ${CACHE})
if(EXPECT)
  file(REMOVE_RECURSE ${FOLDER}/rtl ${FOLDER}/cache)
  file(COPY ${SOURCE}/rtl DESTINATION ${FOLDER})
  execute_process(COMMAND ${CMAKE_COMMAND} -DOLD=${FOLDER}/old -DNEW=${FOLDER}/new
    -DFROM=${SOURCE}/rtl/${FILE} -DTO=${FOLDER}/rtl/${FILE} -P ${CMAKE_CURRENT_LIST_DIR}/../meta/apply.cmake
    COMMAND_ERROR_IS_FATAL ANY)
  set(ENV{RAYCLOCK_RTL} ${FOLDER}/rtl)
  set(ENV{RAYCLOCK_CACHE} ${FOLDER}/cache)
endif()

macro(faulty_end)
  if(EXPECT)
    file(REMOVE_RECURSE ${FOLDER}/rtl ${FOLDER}/cache)
  endif()
endmacro()

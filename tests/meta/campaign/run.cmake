# cmake -DBUILD= -DSOURCE= -P run.cmake
# A campaign from its beginning, or on from where it was stopped: several hundred drawn faults, the torture set first, then the tests.
set(folder ${BUILD}/campaign)
function(run)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${SOURCE} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()
run(${CMAKE_COMMAND} --build ${BUILD} --target rc_campaign rc_unit_tests rc_accel_tests rc_system_tests)
set(campaign ${BUILD}/tests/meta/rc_campaign)
run(${campaign} rtl ${folder}/rtl 20261122 180)
run(${campaign} tests ${folder}/rtl "${BUILD}/tests/rc_unit_tests ~[slow]" "${BUILD}/tests/rc_system_tests ~[slow]" "${BUILD}/tests/rc_unit_tests [slow]")
run(${campaign} report ${folder}/rtl ${SOURCE}/tests/meta/campaign/RESULTS.md 98)
run(${CMAKE_COMMAND} -E env RAYCLOCK_CACHE=${BUILD}/rtl ${campaign} model ${folder}/model 20261122 120)
run(${campaign} report ${folder}/model ${SOURCE}/tests/meta/campaign/RESULTS.md 95)

# cmake -DBUILD= -DSOURCE= -P run.cmake
# Runs a campaign, or continues one that was stopped: 180 faults of the RTL and 120 of the model, drawn from
# one seed, and the rows of the tables. The torture set runs first, then the quick tests and the slow ones.
set(folder ${BUILD}/campaign)
set(campaign ${BUILD}/tests/meta/rc_campaign)
set(page ${SOURCE}/tests/meta/campaign/RESULTS.md)
set(rows ${BUILD}/tests/meta/mutants)
function(run)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${SOURCE} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()
run(${CMAKE_COMMAND} --build ${BUILD} --target rc_campaign rc_unit_tests rc_system_tests)
run(${campaign} rtl ${folder}/rtl 20261122 180 ${rows})
run(${CMAKE_COMMAND} -E env RAYCLOCK_CACHE=${BUILD}/rtl ${campaign} model ${folder}/model 20261122 120
  ${BUILD} ${rows})
foreach(part rtl model)
  foreach(speed quick slow)
    run(${CMAKE_COMMAND} -E env RAYCLOCK_CACHE=${BUILD}/rtl ${campaign} tests ${folder}/${part} ${BUILD}
      ${page} ${speed})
  endforeach()
  run(${campaign} report ${folder}/${part} ${page} 98)
endforeach()

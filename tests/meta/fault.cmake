# rc_write_fault(FOLDER FILE OLD NEW [NUMBER]): writes the fault "FILE with the text OLD replaced by NEW" into
# FOLDER, as the files `file`, `old` and `new`. apply.cmake makes the faulty file from them. A second fault in
# the same folder has a NUMBER after its names.
function(rc_write_fault folder file old new)
  file(CONFIGURE OUTPUT ${folder}/file${ARGN} CONTENT "${file}" @ONLY)
  file(CONFIGURE OUTPUT ${folder}/old${ARGN} CONTENT "${old}" @ONLY)
  file(CONFIGURE OUTPUT ${folder}/new${ARGN} CONTENT "${new}" @ONLY)
endfunction()

# cmake -DYOSYS= -DRTL= -DFOLDER= -P resets.cmake
# A netlist has a reset register for each unit, because the borders of rc_reset_register stay. Without these
# borders Yosys merges two of them into one.
file(MAKE_DIRECTORY ${FOLDER})
file(WRITE ${FOLDER}/two.sv "module two (input clk_i, input rst_ni, output first_o, output second_o);
  rc_reset_register u_first (.clk_i(clk_i), .rst_ni(rst_ni), .rst_no(first_o));
  rc_reset_register u_second (.clk_i(clk_i), .rst_ni(rst_ni), .rst_no(second_o));
endmodule\n")
file(READ ${RTL}/cells/delays/rc_reset_register.sv text)
string(REPLACE "(* keep_hierarchy *)" "" bare "${text}")
function(expect_registers count text)
  file(WRITE ${FOLDER}/rc_reset_register.sv "${text}")
  file(WRITE ${FOLDER}/run.ys
    "read_verilog -sv \"${FOLDER}/rc_reset_register.sv\" \"${FOLDER}/two.sv\"\nsynth_ecp5 -top two
setattr -mod -unset keep_hierarchy *\nflatten\nopt_clean\nselect -assert-count ${count} t:TRELLIS_FF\n")
  execute_process(COMMAND ${YOSYS} -q -l ${FOLDER}/yosys.log ${FOLDER}/run.ys COMMAND_ERROR_IS_FATAL ANY)
endfunction()
expect_registers(2 "${text}")
expect_registers(1 "${bare}")

// The reset of a unit, a cycle later: a register that can lie beside the unit, so that no wire of a
// reset goes over the whole chip. Nothing may begin in the cycle in which reset ends. It begins
// in reset. Its borders stay when a netlist is made: Yosys would make one register of them all.
`default_nettype none
(* keep_hierarchy *)
module rc_reset_register (
  input  logic clk_i,
  input  logic rst_ni,
  output logic rst_no
);
  logic rst_q = 1'b0;
  always_ff @(posedge clk_i) rst_q <= rst_ni;
  assign rst_no = rst_q;
endmodule
`default_nettype wire

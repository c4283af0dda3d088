// Delays the reset of a unit by one cycle. The register can be placed next to the unit, so no reset
// wire crosses the chip.
//
// It starts in reset. Nothing may begin in the cycle in which reset ends. keep_hierarchy stops
// Yosys from merging the registers of all units into one.
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

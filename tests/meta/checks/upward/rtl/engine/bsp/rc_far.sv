// A module of another engine.
`default_nettype none
module rc_far (
  input logic clk_i
);
endmodule
`default_nettype wire

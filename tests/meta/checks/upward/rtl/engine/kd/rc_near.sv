// A module that instantiates a module of another engine.
`default_nettype none
module rc_near (
  input logic clk_i
);
  rc_far u_far (.clk_i);
endmodule
`default_nettype wire

// Counts how many cycles a unit spent on each of eight causes: exactly one holds in
// every cycle. Not cleared by reset, so that it is a small memory: the host takes the
// difference of two readings, modulo 2^CountW. Model: model/core/units.hpp.
`default_nettype none
module rc_tally (
  input logic       clk_i,
  input logic [2:0] cause_i
);
  localparam int unsigned CountW = 40;
  logic [CountW-1:0] count_q [8];
  always_ff @(posedge clk_i) count_q[cause_i] <= count_q[cause_i] + 1'b1;
endmodule
`default_nettype wire

// Counts how many cycles a unit spent on each of eight causes: exactly one holds in every
// cycle. A small memory with one port: it is written while something is counted, and read
// while nothing is. A cause is counted one cycle after it held.
// Model: model/core/units.hpp.
`default_nettype none
module rc_cause_counters (
  input  logic                         clk_i,
  input  logic                         count_i,   // cause_i is counted
  input  logic [2:0]                   cause_i,
  input  logic                         clear_i,   // at_i's counter becomes 0; not while counting
  input  logic [2:0]                   at_i,
  output logic [rc_pkg::TallyBits-1:0] count_o    // at_i's counter, while nothing is counted
);
  logic       counts_q;
  logic [2:0] cause_q, at;
  always_ff @(posedge clk_i) begin
    counts_q <= count_i;
    cause_q  <= cause_i;
  end

  logic [rc_pkg::TallyBits-1:0] count_q [8];
  assign at      = counts_q ? cause_q : at_i;
  assign count_o = count_q[at];
  always_ff @(posedge clk_i) begin
    if (counts_q || clear_i) count_q[at] <= counts_q ? count_o + 1'b1 : '0;
  end
endmodule
`default_nettype wire

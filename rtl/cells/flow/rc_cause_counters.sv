// Counts how many cycles a unit spends on each of eight causes. Exactly one cause holds per cycle.
//
// The counters are a memory of eight words with one port: written while counting, readable
// otherwise. A cause is counted one cycle after it holds. Model: model/machine/units.hpp.
`default_nettype none
module rc_cause_counters (
  input  logic                         clk_i,
  input  logic                         count_i,   // counts cause_i in this cycle
  input  logic [rc_pkg::CauseBits-1:0] cause_i,
  input  logic                         clear_i,   // clears at_i's counter; not while counting
  input  logic [rc_pkg::CauseBits-1:0] at_i,
  output logic [rc_pkg::CounterBits-1:0] count_o   // at_i's counter; valid while nothing is counted
);
  logic                         counts_q;
  logic [rc_pkg::CauseBits-1:0] cause_q, at;

  // The cause, delayed by one cycle.
  always_ff @(posedge clk_i) begin
    counts_q <= count_i;
    cause_q  <= cause_i;
  end

  // The memory. Its port serves the delayed cause while counting, and at_i otherwise.
  logic [rc_pkg::CounterBits-1:0] count_q [1 << rc_pkg::CauseBits];
  assign at      = counts_q ? cause_q : at_i;
  assign count_o = count_q[at];

  always_ff @(posedge clk_i) begin
    if (counts_q || clear_i) count_q[at] <= counts_q ? count_o + 1'b1 : '0;
  end
endmodule
`default_nettype wire

// Merges two valid/ready sources into one link. The first source has priority, but an offer that
// was not accepted stays, so a stalled payload does not change.
//
// No latency: valid_o follows the sources in the same cycle, and ready goes to the source on offer.
// Model: model/core/ring.hpp (Merge). Proof: tests/formal/priority_merge.sv.
`default_nettype none
module rc_priority_merge #(
  parameter int unsigned Width = 1
) (
  input  logic             clk_i,
  input  logic             rst_ni,
  // First source, which has priority
  input  logic             first_valid_i,
  output logic             first_ready_o,
  input  logic [Width-1:0] first_i,
  // Second source
  input  logic             second_valid_i,
  output logic             second_ready_o,
  input  logic [Width-1:0] second_i,
  // Merged link
  output logic             valid_o,
  input  logic             ready_i,
  output logic [Width-1:0] data_o
);
  if (Width < 1) begin : gen_refuse
    $error("rc_priority_merge: Width must be at least 1");
  end
  logic held_q, held_second_q, second;

  assign second         = held_q ? held_second_q : !first_valid_i;
  assign valid_o        = first_valid_i || second_valid_i;
  assign data_o         = second ? second_i : first_i;
  assign first_ready_o  = ready_i && !second;
  assign second_ready_o = ready_i && second;

  // An offer that stalls holds its source.
  always_ff @(posedge clk_i) begin
    if (!rst_ni) held_q <= 1'b0;
    else         held_q <= valid_o && !ready_i;
    held_second_q <= second;
  end
endmodule
`default_nettype wire

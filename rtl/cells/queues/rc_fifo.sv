// First-in first-out queue of Depth entries; Depth is a power of two, at least 2. Latency 1.
//
// This is rc_fifo_peek without its outputs for the next head. Model: model/core/ring.hpp (Ring).
`default_nettype none
module rc_fifo #(
  parameter int unsigned Width = 1,
  parameter int unsigned Depth = 4,
  parameter int unsigned Cut   = rc_pkg::PathCut
) (
  input  logic             clk_i,
  input  logic             rst_ni,
  // Input
  input  logic             valid_i,
  output logic             ready_o,
  input  logic [Width-1:0] data_i,
  // Output
  output logic             valid_o,
  input  logic             ready_i,
  output logic [Width-1:0] data_o
);
  logic             next_fires;
  logic [Width-1:0] next;

  rc_fifo_peek #(.Width(Width), .Depth(Depth), .Cut(Cut)) u_fifo (
    .clk_i, .rst_ni, .valid_i, .ready_o, .data_i, .valid_o, .ready_i, .data_o,
    .next_fires_o(next_fires), .next_o(next));

  logic unused;
  assign unused = ^{next_fires, next};
endmodule
`default_nettype wire

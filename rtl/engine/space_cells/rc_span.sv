// The intersection of three intervals of a ray: the latest start, the earliest end, and whether all
// three exist. Part of rc_bounds and rc_exits.
//
// Latency 1. In a fast chip it is 2: the comparison of the first two intervals is a separate stage.
`default_nettype none
module rc_span #(
  localparam int unsigned TBits = rc_pkg::TBits
) (
  input  logic               clk_i,
  input  logic               valid_i,   // the last stage holds a node
  input  logic [3*TBits-1:0] from_i,
  input  logic [3*TBits-1:0] to_i,
  input  logic [2:0]         there_i,
  output logic [TBits-1:0]   from_o,
  output logic [TBits-1:0]   to_o,
  output logic               there_o
);
  logic [TBits-1:0] from_a, from_b, from_c, to_a, to_b, to_c, from_two, to_two, from_rest, to_rest;
  logic             there;

  assign {from_a, from_b, from_c} = from_i;
  assign {to_a, to_b, to_c}       = to_i;

  rc_path_register #(.Width(4 * TBits + 1)) u_two (
    .clk_i,
    .data_i({from_a > from_b ? from_a : from_b, from_c, to_a < to_b ? to_a : to_b, to_c,
             there_i == 3'b111}),
    .data_o({from_two, from_rest, to_two, to_rest, there}));

  always_ff @(posedge clk_i) begin
    if (valid_i) begin
      from_o  <= from_two > from_rest ? from_two : from_rest;
      to_o    <= to_two < to_rest ? to_two : to_rest;
      there_o <= there;
    end
  end
endmodule
`default_nettype wire

// Sum of two values of 0 to 1, saturated at 1. A value is U1.16 (rc_pkg::ValueBits). Combinational.
// Model: add() in model/unit/shade/pass/pass.cpp.
`default_nettype none
module rc_add_saturated #(
  localparam int unsigned ValueBits = rc_pkg::ValueBits,
  localparam int unsigned UnitBits  = rc_pkg::UnitBits
) (
  input  logic [ValueBits-1:0] a_i,
  input  logic [ValueBits-1:0] b_i,
  output logic [ValueBits-1:0] sum_o
);
  logic [ValueBits:0] sum;   // U2.16

  assign sum   = {1'b0, a_i} + {1'b0, b_i};
  assign sum_o = sum[ValueBits:UnitBits] != '0 ? rc_pkg::ValueOne : sum[ValueBits-1:0];
endmodule
`default_nettype wire

// Property of rc_mul_spill: it returns the product, for every pair of numbers.
module mul_spill #(
  parameter int unsigned AW    = 5,
  parameter int unsigned BW    = 5,
  parameter int unsigned Block = 3
) (
  input logic                 clk_i,
  input logic signed [AW-1:0] a_i,
  input logic signed [BW-1:0] b_i
);
  logic [AW+BW-1:0] p_o, a, b;
  rc_mul_spill #(.AW(AW), .BW(BW), .Block(Block)) u_dut (.a_i(a_i), .b_i(b_i), .p_o(p_o));
  assign a = {{BW{a_i[AW-1]}}, a_i};
  assign b = {{AW{b_i[BW-1]}}, b_i};
  always @(posedge clk_i) begin
    a_product: assert (p_o == a * b);
  end
endmodule

// Weighted corner normals of a triangle: w na + u nb + v nc, with w = 2^B - u - v. Part of rc_surf,
// which has the valid bits. The sum is in the registers of s4.
`default_nettype none
module rc_corner_normals #(
  parameter  int unsigned WeightW    = 16,   // of u and v, signed; w has two more
  parameter  int unsigned NormalSumW = 30,   // of a sum, signed
  localparam int unsigned CornerBits = rc_pkg::CornerBits,
  localparam int unsigned Every = rc_pkg::ShadeInterval
) (
  input  logic                      clk_i,
  input  logic [3:0]                valid_i,
  input  logic [Every-1:0]          phase_i,       // the cycle of s2
  input  logic [9*CornerBits-1:0]   s0_normal_i,   // [corner][axis]
  input  logic signed [WeightW+1:0] s2_rest_i,
  input  logic signed [WeightW-1:0] s2_u_i,
  input  logic signed [WeightW-1:0] s2_v_i,
  output logic [3*NormalSumW-1:0]   s4_sum_o
);
  localparam int unsigned ProductW = WeightW + 2 + CornerBits;

  // s2: products.
  logic [9*CornerBits-1:0] s2_normal;
  rc_shift_register #(.Width(9 * CornerBits), .Stages(2)) u_normal (
    .clk_i, .enable_i(valid_i[1:0]), .data_i(s0_normal_i), .data_o(s2_normal));

  logic [9*ProductW-1:0] s2_product;   // [corner][axis]

  rc_mul_held #(.AW(WeightW + 2), .BW(CornerBits), .Products(9)) u_products (
    .clk_i, .phase_i, .a_i({{3{(WeightW+2)'(s2_v_i)}}, {3{(WeightW+2)'(s2_u_i)}}, {3{s2_rest_i}}}),
    .b_i(s2_normal), .p_o(s2_product));

  // s3, s4: their sums.
  for (genvar k = 0; k < 3; k++) begin : gen_axis
    logic signed [ProductW-1:0] s3_a_q, s3_b_q, s3_c_q;

    always_ff @(posedge clk_i) begin
      if (valid_i[2]) begin
        s3_a_q <= s2_product[k*ProductW +: ProductW];
        s3_b_q <= s2_product[(3+k)*ProductW +: ProductW];
        s3_c_q <= s2_product[(6+k)*ProductW +: ProductW];
      end
      if (valid_i[3])
        s4_sum_o[k*NormalSumW +: NormalSumW] <=
            NormalSumW'(s3_a_q) + NormalSumW'(s3_b_q) + NormalSumW'(s3_c_q);
    end
  end
endmodule
`default_nettype wire

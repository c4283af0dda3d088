// Sign of n . d, exactly. Part of rc_pass, which has the valid bits of s15 and s16.
`default_nettype none
module rc_side #(
  localparam int unsigned NB = rc_pkg::NormalBits,
  localparam int unsigned D  = rc_pkg::RayDirBits,
  localparam int unsigned Every = rc_pkg::ShadeInterval
) (
  input  logic            clk_i,
  input  logic [1:0]      valid_i,
  input  logic [Every-1:0] turn_i,     // in which cycle of s15 a pass is
  input  logic [3*NB-1:0] s15_n_i,
  input  logic [3*D-1:0]  s15_d_i,
  output logic            s17_above_o,
  output logic            s17_below_o
);
  localparam int unsigned Q = NB + D;
  logic [3*Q-1:0] s15_product, s16_product_q;
  rc_mul_held #(.AW(NB), .BW(D), .Products(3)) u_products (
    .clk_i, .turn_i, .a_i(s15_n_i), .b_i(s15_d_i), .p_o(s15_product));
  always_ff @(posedge clk_i) if (valid_i[0]) s16_product_q <= s15_product;
  logic signed [Q+1:0] s16_sum;
  assign s16_sum = (Q+2)'($signed(s16_product_q[0 +: Q])) + (Q+2)'($signed(s16_product_q[Q +: Q]))
      + (Q+2)'($signed(s16_product_q[2*Q +: Q]));
  always_ff @(posedge clk_i) begin
    if (valid_i[1]) begin
      s17_above_o <= !s16_sum[Q+1] && s16_sum != '0;
      s17_below_o <= s16_sum[Q+1];
    end
  end
endmodule
`default_nettype wire

// A triangle's corner normals, weighted: w na + u nb + v nc, w = 2^B - u - v. Part of
// rc_surf, which has the valid bits; from the registers of s4.
`default_nettype none
module rc_corners #(
  parameter  int unsigned W = 16,   // of u and v, signed; of w two more
  parameter  int unsigned S = 30,   // of a sum, signed
  localparam int unsigned C = rc_pkg::CornerBits
) (
  input  logic                clk_i,
  input  logic [3:0]          valid_i,
  input  logic [9*C-1:0]      s0_normal_i,   // [corner][axis]
  input  logic signed [W+1:0] s2_rest_i,
  input  logic signed [W-1:0] s2_u_i,
  input  logic signed [W-1:0] s2_v_i,
  output logic [3*S-1:0]      s4_sum_o
);
  localparam int unsigned Q = W + 2 + C;
  logic [9*C-1:0] s2_normal;
  rc_delay #(.Width(9 * C), .Stages(2)) u_normal (
    .clk_i, .valid_i(valid_i[1:0]), .data_i(s0_normal_i), .data_o(s2_normal));
  for (genvar k = 0; k < 3; k++) begin : gen_axis
    logic signed [Q-1:0] s3_a_q, s3_b_q, s3_c_q;
    always_ff @(posedge clk_i) begin
      if (valid_i[2]) begin
        s3_a_q <= Q'(s2_rest_i) * Q'($signed(s2_normal[k*C +: C]));
        s3_b_q <= Q'(s2_u_i) * Q'($signed(s2_normal[(3+k)*C +: C]));
        s3_c_q <= Q'(s2_v_i) * Q'($signed(s2_normal[(6+k)*C +: C]));
      end
      if (valid_i[3]) s4_sum_o[k*S +: S] <= S'(s3_a_q) + S'(s3_b_q) + S'(s3_c_q);
    end
  end
endmodule
`default_nettype wire

// Sign of n . d, exactly. Part of rc_pass, which has the valid bits of s15 and s16.
`default_nettype none
module rc_side #(
  localparam int unsigned NB = rc_pkg::NormalBits,
  localparam int unsigned D  = rc_pkg::RayDirBits
) (
  input  logic            clk_i,
  input  logic [1:0]      valid_i,
  input  logic [3*NB-1:0] s15_n_i,
  input  logic [3*D-1:0]  s15_d_i,
  output logic            s17_above_o,
  output logic            s17_below_o
);
  localparam int unsigned Q = NB + D;
  logic [3*Q-1:0] s16_product_q;
  for (genvar k = 0; k < 3; k++) begin : gen_axis
    always_ff @(posedge clk_i)
      if (valid_i[0])
        s16_product_q[k*Q +: Q] <= Q'($signed(s15_n_i[k*NB +: NB]))
                                 * Q'($signed(s15_d_i[k*D +: D]));
  end
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

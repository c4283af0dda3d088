// The exact sign of n . d, which is the side of a surface on which a ray starts. Latency two
// stages.
//
// Part of rc_pass, which has the valid bits of both stages. If a pass stays long in a stage, the
// operands first pass through additional registers.
`default_nettype none
module rc_normal_side #(
  localparam int unsigned NormalBits = rc_pkg::NormalBits,
  localparam int unsigned RayDirBits = rc_pkg::RayDirBits,
  localparam int unsigned Every = rc_pkg::ShadeInterval
) (
  input  logic            clk_i,
  input  logic [1:0]      valid_i,
  input  logic [Every-1:0] phase_i,    // the cycle of the first stage, ShadeCut cycles late
  // Operands
  input  logic [3*NormalBits-1:0] n_i,
  input  logic [3*RayDirBits-1:0] d_i,
  // n . d > 0, n . d < 0
  output logic                    above_o,
  output logic                    below_o
);
  localparam int unsigned ProductW = NormalBits + RayDirBits;

  logic [3*ProductW-1:0]   product, product_q;
  logic [3*NormalBits-1:0] n;
  logic [3*RayDirBits-1:0] d;

  rc_path_register #(.Width(3 * (NormalBits + RayDirBits)), .Stages(rc_pkg::PassCut)) u_in (
    .clk_i, .data_i({n_i, d_i}), .data_o({n, d}));

  rc_mul_held #(.AW(NormalBits), .BW(RayDirBits), .Products(3), .Late(rc_pkg::PassCut))
  u_products (
    .clk_i, .phase_i, .a_i(n), .b_i(d), .p_o(product));

  always_ff @(posedge clk_i) if (valid_i[0]) product_q <= product;

  // Sum of the products.
  logic signed [ProductW+1:0] sum_now, sum;

  assign sum_now = (ProductW+2)'($signed(product_q[0 +: ProductW]))
      + (ProductW+2)'($signed(product_q[ProductW +: ProductW]))
      + (ProductW+2)'($signed(product_q[2*ProductW +: ProductW]));

  rc_path_register #(.Width(ProductW + 2), .Stages(rc_pkg::PassCut)) u_sum (
    .clk_i, .data_i(sum_now), .data_o(sum));

  always_ff @(posedge clk_i) begin
    if (valid_i[1]) begin
      above_o <= !sum[ProductW+1] && sum != '0;
      below_o <= sum[ProductW+1];
    end
  end
endmodule
`default_nettype wire

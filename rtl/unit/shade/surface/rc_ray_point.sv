// The point of a ray at the distance of its hit: o + t d, rounded to nearest and clamped to the
// range of o. It is in the registers of s3, and again in those of s4.
//
// Part of rc_surf, which uses it for spheres, and of rc_instance_space, which uses it for all
// primitives. These have the valid bits, and mark in sphere_i the passes that need the point.
`default_nettype none
module rc_ray_point #(
  localparam int unsigned M           = rc_pkg::DirBits,
  localparam int unsigned OriginWidth = rc_pkg::OriginWidth,
  localparam int unsigned TBits       = rc_pkg::TBits,
  localparam int unsigned Every = rc_pkg::ShadeInterval
) (
  input  logic           clk_i,
  input  logic [3:0]     valid_i,
  input  logic [Every-1:0] phase_i,   // the cycle of s0
  input  logic [3:0]               sphere_i,
  // Ray
  input  logic [3*OriginWidth-1:0] s0_o_i,
  input  logic [3*M-1:0]           s0_d_i,
  input  logic [TBits-1:0]         s0_t_i,
  // Point
  output logic [3*OriginWidth-1:0] s3_o_o,
  output logic [3*OriginWidth-1:0] s4_o_o
);
  localparam int unsigned ProductW = M + TBits + 1;
  localparam int unsigned Drop     = M - 1 + rc_pkg::TFracBits - rc_pkg::OriginBits;
  localparam int unsigned SumW     = (ProductW > OriginWidth ? ProductW : OriginWidth) + 1;
  localparam logic signed [SumW-1:0] Most = SumW'((65'(1) << (OriginWidth - 1)) - 65'd1);

  // If a pass stays long in s0, the flag for a sphere comes from a register, because it has many
  // loads.
  logic s0_sphere;

  rc_path_register #(.Width(1), .Stages(rc_pkg::PassCut)) u_sphere (
    .clk_i, .data_i(sphere_i[0]), .data_o(s0_sphere));

  logic [3*OriginWidth-1:0] s1_o;
  rc_shift_register #(.Width(3 * OriginWidth), .Stages(1)) u_o (
    .clk_i, .enable_i(valid_i[0] && s0_sphere), .data_i(s0_o_i), .data_o(s1_o));

  // s1: the way t d. s2: the sum. s3: clamped.
  logic [3*ProductW-1:0] s0_way;

  rc_mul_held #(.AW(M), .BW(TBits + 1), .Products(3)) u_ways (
    .clk_i, .phase_i, .a_i(s0_d_i), .b_i({3{1'b0, s0_t_i}}), .p_o(s0_way));

  for (genvar k = 0; k < 3; k++) begin : gen_axis
    logic signed [ProductW-1:0] s1_way_q, s1_rounded;
    logic signed [SumW-1:0]     s2_at_q;

    assign s1_rounded = (s1_way_q + $signed(ProductW'(65'(1) << Drop >> 1))) >>> Drop;

    always_ff @(posedge clk_i) begin
      if (valid_i[0] && s0_sphere) s1_way_q <= s0_way[k*ProductW +: ProductW];
      if (valid_i[1] && sphere_i[1])
        s2_at_q <= SumW'($signed(s1_o[k*OriginWidth +: OriginWidth])) + SumW'(s1_rounded);
      if (valid_i[2] && sphere_i[2])
        s3_o_o[k*OriginWidth +: OriginWidth] <= s2_at_q > Most ? Most[OriginWidth-1:0]
                                              : s2_at_q < -Most ? -Most[OriginWidth-1:0]
                                              : s2_at_q[OriginWidth-1:0];
      if (valid_i[3] && sphere_i[3])
        s4_o_o[k*OriginWidth +: OriginWidth] <= s3_o_o[k*OriginWidth +: OriginWidth];
    end
  end
endmodule
`default_nettype wire

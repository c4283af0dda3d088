// The work of shade in two spaces, if the chip has instances. Part of rc_pass, which has the valid
// bits: the pass leaves that stage. A signal's prefix names its stage.
//
// A surface that was found in a mesh's space is transformed to the scene's space. Its point is the
// ray's, o + t d, and its normal comes from A^T n'.
//
// A ray that leaves, or a shadow ray that ends, goes the other way. In the mesh's space it begins
// or ends exactly at the point that was found there. Its direction there selects the side of the
// triangle. A light is rounded to a lattice point of the mesh. Models: transform_surface() in
// model/unit/shade/surface/surf.hpp, Home in model/core/payloads.hpp.
`default_nettype none
module rc_instance_space #(
  parameter  int unsigned UnitW = 44,   // bits of toward
  localparam int unsigned AxisBits    = rc_pkg::AxisBits,
  localparam int unsigned N           = rc_pkg::CoordBits,
  localparam int unsigned M           = rc_pkg::DirBits,
  localparam int unsigned OriginBits  = rc_pkg::OriginBits,
  localparam int unsigned OriginWidth = rc_pkg::OriginWidth,
  localparam int unsigned RayDirBits  = rc_pkg::RayDirBits,
  localparam int unsigned TBits       = rc_pkg::TBits,
  localparam int unsigned MapFrac     = rc_pkg::MapFrac,
  localparam int unsigned MapBits     = rc_pkg::MapBits,
  localparam int unsigned Cosine      = rc_pkg::StageCosine,
  localparam int unsigned Home        = rc_pkg::StageHome,
  localparam int unsigned Every       = rc_pkg::ShadeInterval
) (
  input  logic                     clk_i,
  input  logic                     rst_ni,
  // A surface is transformed
  input  logic [4:0]               transform_valid_i,
  input  logic [Every-1:0]         s0_phase_i,    // the cycle of its stage
  input  logic [3*OriginWidth-1:0] s0_o_i,        // of the ray that has hit it
  input  logic [3*M-1:0]           s0_d_i,
  input  logic [TBits-1:0]         s0_t_i,
  input  logic [3*AxisBits-1:0]    s0_normal_i,
  input  logic [9*MapBits-1:0]     s0_a_i,
  output logic [3*UnitW-1:0]       s5_toward_o,
  output logic [3*OriginWidth-1:0] s5_o_o,
  // A ray leaves, or a shadow ray ends
  input  logic                     leave_0_i,     // the pass leaves s0,
  input  logic [Home-1:Cosine]     leave_valid_i, // s15 and later stages
  input  logic [Every-1:0]         s15_phase_i,
  input  logic [3*(N+MapFrac)-1:0] s0_b_i,
  input  logic [3*OriginWidth-1:0] s0_inner_i,    // the point in the mesh's space
  input  logic                     s15_near_i,    // from a light within the lattice
  input  logic [3*N-1:0]           s15_place_i,   // which lies there
  input  logic [3*RayDirBits-1:0]  s15_d_i,
  output logic [3*OriginWidth-1:0] s19_o_o,
  output logic [3*RayDirBits-1:0]  s19_d_o
);
  // ---- The point.
  logic [3*OriginWidth-1:0] s3_o, s4_o;

  rc_ray_point u_ray_point (
    .clk_i, .valid_i(transform_valid_i[3:0]), .phase_i(s0_phase_i), .sphere_i(4'b1111),
    .s0_o_i, .s0_d_i, .s0_t_i, .s3_o_o(s3_o), .s4_o_o(s4_o));
  rc_shift_register #(.Width(3 * OriginWidth), .Stages(1)) u_o (
    .clk_i, .enable_i(transform_valid_i[4]), .data_i(s4_o), .data_o(s5_o_o));

  // ---- The normal.
  logic [9*MapBits-1:0]            s0_factor_a;
  logic [9*AxisBits-1:0]           s0_factor_n;
  logic [9*(MapBits+AxisBits)-1:0] s0_product, s1_product;
  logic [3*UnitW-1:0]              s1_toward, s2_toward;

  for (genvar k = 0; k < 3; k++) begin : gen_column
    for (genvar i = 0; i < 3; i++) begin : gen_row
      assign s0_factor_a[(3*k+i)*MapBits +: MapBits]   = s0_a_i[(3*i+k)*MapBits +: MapBits];
      assign s0_factor_n[(3*k+i)*AxisBits +: AxisBits] = s0_normal_i[i*AxisBits +: AxisBits];
    end

    assign s1_toward[k*UnitW +: UnitW] =
        UnitW'($signed(s1_product[(3*k)*(MapBits+AxisBits) +: MapBits+AxisBits]))
        + UnitW'($signed(s1_product[(3*k+1)*(MapBits+AxisBits) +: MapBits+AxisBits]))
        + UnitW'($signed(s1_product[(3*k+2)*(MapBits+AxisBits) +: MapBits+AxisBits]));
  end

  rc_mul_held #(.AW(MapBits), .BW(AxisBits), .Products(9)) u_normal (
    .clk_i, .phase_i(s0_phase_i), .a_i(s0_factor_a), .b_i(s0_factor_n), .p_o(s0_product));
  rc_shift_register #(.Width(9 * (MapBits + AxisBits)), .Stages(1)) u_product (
    .clk_i, .enable_i(transform_valid_i[0]), .data_i(s0_product), .data_o(s1_product));

  rc_shift_register #(.Width(3 * UnitW), .Stages(1)) u_sum (
    .clk_i, .enable_i(transform_valid_i[1]), .data_i(s1_toward), .data_o(s2_toward));
  rc_shift_register #(.Width(3 * UnitW), .Stages(3)) u_toward (
    .clk_i, .enable_i(transform_valid_i[4:2]), .data_i(s2_toward), .data_o(s5_toward_o));

  // ---- Into the mesh's space: a direction, or a light.
  localparam int unsigned FactorW = N > M ? N : M;
  localparam int unsigned SumW    = FactorW + MapFrac + 1;   // width of a sum
  localparam logic [SumW-1:0] Half = SumW'(1) << (MapFrac - 1);

  logic [9*MapBits-1:0]     s15_a;
  logic [3*(N+MapFrac)-1:0] s15_b;
  logic [3*OriginWidth-1:0] s18_inner;

  rc_stage_delay #(.Width(9 * MapBits + 3 * (N + MapFrac)), .Stages(Cosine)) u_map (
    .clk_i, .rst_ni, .enter_i(leave_0_i), .leave_i(leave_valid_i[Cosine]),
    .data_i({s0_a_i, s0_b_i}), .data_o({s15_a, s15_b}));
  rc_stage_delay #(.Width(3 * OriginWidth), .Stages(Home - 1)) u_inner (
    .clk_i, .rst_ni, .enter_i(leave_0_i), .leave_i(leave_valid_i[Home-1]), .data_i(s0_inner_i),
    .data_o(s18_inner));

  // Products.
  logic [3*FactorW-1:0]            s15_v;
  logic [3*SumW-1:0]               s15_rest, s16_rest;
  logic [9*(MapBits+FactorW)-1:0]  s15_product, s16_product;
  logic                            s18_near;

  for (genvar k = 0; k < 3; k++) begin : gen_axis
    assign s15_v[k*FactorW +: FactorW] = s15_near_i ? FactorW'($signed(s15_place_i[k*N +: N]))
                                        : FactorW'($signed(s15_d_i[k*RayDirBits +: M]));
    assign s15_rest[k*SumW +: SumW] =
        s15_near_i ? SumW'($signed(s15_b[k*(N+MapFrac) +: N+MapFrac])) + Half : Half;
  end

  rc_mul_held #(.AW(MapBits), .BW(FactorW), .Products(9)) u_map_products (
    .clk_i, .phase_i(s15_phase_i), .a_i(s15_a), .b_i({3{s15_v}}), .p_o(s15_product));
  rc_shift_register #(.Width(9 * (MapBits + FactorW) + 3 * SumW), .Stages(1)) u_map_product (
    .clk_i, .enable_i(leave_valid_i[Cosine]), .data_i({s15_product, s15_rest}),
    .data_o({s16_product, s16_rest}));

  rc_shift_register #(.Width(1), .Stages(Home - 1 - Cosine)) u_near (
    .clk_i, .enable_i(leave_valid_i[Home-2:Cosine]), .data_i(s15_near_i), .data_o(s18_near));

  // Sums, rounded; then the origin and the direction.
  for (genvar i = 0; i < 3; i++) begin : gen_moved
    logic [SumW-1:0]        s17_first_q, s17_second_q, s17_total;
    logic [FactorW-1:0]     s18_moved_q;
    logic [OriginWidth-1:0] s18_light;

    assign s17_total = s17_first_q + s17_second_q;
    assign s18_light = OriginWidth'(s18_moved_q[N-1:0]) << OriginBits;

    always_ff @(posedge clk_i) begin
      if (leave_valid_i[Cosine+1]) begin
        s17_first_q <= SumW'($signed(s16_product[3*i*(MapBits+FactorW) +: MapBits+FactorW]))
                      + SumW'($signed(s16_product[(3*i+1)*(MapBits+FactorW) +: MapBits+FactorW]));
        s17_second_q <= SumW'($signed(s16_product[(3*i+2)*(MapBits+FactorW) +: MapBits+FactorW]))
                        + s16_rest[i*SumW +: SumW];
      end
      if (leave_valid_i[Home-2]) s18_moved_q <= s17_total[MapFrac +: FactorW];
      if (leave_valid_i[Home-1]) begin
        s19_o_o[i*OriginWidth +: OriginWidth] <= s18_near ? s18_light
                                               : s18_inner[i*OriginWidth +: OriginWidth];
        s19_d_o[i*RayDirBits +: RayDirBits] <=
            s18_near ? RayDirBits'($signed(s18_inner[i*OriginWidth +: OriginWidth]))
                       - RayDirBits'($signed(s18_light))
                     : RayDirBits'($signed(s18_moved_q));
      end
    end

    logic unused;
    assign unused = ^s17_total;
  end

  logic unused;
  assign unused = ^{s3_o, s15_d_i};
endmodule
`default_nettype wire

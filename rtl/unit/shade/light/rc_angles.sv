// Unit vectors and cosines of a pass. One unit vector is along s5_toward_i: the normal of a
// surface, or the way to a light. The other one, the view, points against the ray's direction.
//
// Part of rc_pass, which has the valid bits for surfaces and for lights. A signal's prefix names
// its stage. s13_view_i and s13_normal_i belong to a surface that was met before, s13_view_o to the
// one that is met now. Unit vectors are S1.16, cosines U1.16. Model: unit_dot() in
// model/fixed/rounding.hpp.
`default_nettype none
module rc_angles #(
  localparam int unsigned ValueBits = rc_pkg::ValueBits,
  localparam int unsigned AxisBits  = rc_pkg::AxisBits,
  parameter  int unsigned UnitW     = 44,
  localparam int unsigned M         = rc_pkg::DirBits,
  localparam int unsigned Unit      = rc_pkg::StageUnit,   // stage with the unit vectors
  localparam int unsigned Every     = rc_pkg::ShadeInterval
) (
  input  logic               clk_i,
  input  logic               rst_ni,
  input  logic [Unit+1:0]       surf_i,
  input  logic [Unit+1:0]       light_i,
  input  logic [(Unit+1)*Every-1:0] phase_i,   // the cycle of each stage
  input  logic                  s13_surf_i,    // s13 holds a surface's pass
  // Vectors
  input  logic [3*M-1:0]        s0_d_i,
  input  logic [3*UnitW-1:0]    s5_toward_i,
  input  logic [3*AxisBits-1:0] s13_normal_i,
  input  logic [3*AxisBits-1:0] s13_view_i,
  // Results
  output logic [3*AxisBits-1:0] s13_unit_o,
  output logic [3*AxisBits-1:0] s13_view_o,
  output logic [ValueBits-1:0]  s15_cosine_o,  // surface: unit . view; light: normal . unit
  output logic signed [AxisBits:0] s15_mirror_o   // light: unit . view, S2.16
);
  localparam int unsigned UnitBits = rc_pkg::UnitBits;
  localparam int unsigned Toward   = rc_pkg::StageToward;
  localparam int unsigned View     = rc_pkg::UnitStages;   // stage in which the view is ready
  localparam int unsigned ProductW = 2 * AxisBits;         // product of two components, S3.32
  localparam int unsigned SumW     = ProductW + 2;         // sum of three, S5.32

  // s13: the unit vector.
  rc_unit_vector #(.VectorW(UnitW)) u_unit (
    .clk_i, .valid_i(Every == 1 ? surf_i[Toward] || light_i[Toward] : phase_i[Toward*Every]),
    .v_i(s5_toward_i), .u_o(s13_unit_o));

  // s13: the view, against the ray.
  logic [3*AxisBits-1:0] s8_along, s8_view;

  rc_unit_vector #(.VectorW(M)) u_view (
    .clk_i, .valid_i(Every == 1 ? surf_i[0] : phase_i[0]), .v_i(s0_d_i), .u_o(s8_along));

  for (genvar k = 0; k < 3; k++) begin : gen_view
    assign s8_view[k*AxisBits +: AxisBits] = -s8_along[k*AxisBits +: AxisBits];
  end

  rc_stage_delay #(.Width(3 * AxisBits), .Stages(Unit - View)) u_wait (
    .clk_i, .rst_ni, .enter_i(surf_i[View]), .leave_i(surf_i[Unit]), .data_i(s8_view),
    .data_o(s13_view_o));

  // Products of the unit vector with the view or the normal, and with the earlier view.
  logic [3*AxisBits-1:0] s13_with;

  assign s13_with = s13_surf_i ? s13_view_o : s13_normal_i;
  logic [6*ProductW-1:0] product;   // [with, view][axis]

  rc_mul_held #(.AW(AxisBits), .BW(AxisBits), .Products(6)) u_products (
    .clk_i, .phase_i(phase_i[Unit*Every +: Every]), .a_i({2{s13_unit_o}}),
    .b_i({s13_view_i, s13_with}), .p_o(product));

  logic [3*ProductW-1:0] s14_cosine_q, s14_mirror_q;

  for (genvar k = 0; k < 3; k++) begin : gen_axis
    always_ff @(posedge clk_i) begin
      if (surf_i[Unit] || light_i[Unit])
        s14_cosine_q[k*ProductW +: ProductW] <= product[k*ProductW +: ProductW];
      if (light_i[Unit])
        s14_mirror_q[k*ProductW +: ProductW] <= product[(3+k)*ProductW +: ProductW];
    end
  end

  // Cosines: sums of the products, rounded to nearest, halves up.
  localparam logic signed [SumW-1:0] Half = SumW'(rc_pkg::ProductHalf);
  logic signed [SumW-1:0] s14_cosine, s14_mirror;

  assign s14_cosine = SumW'($signed(s14_cosine_q[0 +: ProductW]))
                    + SumW'($signed(s14_cosine_q[ProductW +: ProductW]))
                    + SumW'($signed(s14_cosine_q[2*ProductW +: ProductW])) + Half;
  assign s14_mirror = SumW'($signed(s14_mirror_q[0 +: ProductW]))
                    + SumW'($signed(s14_mirror_q[ProductW +: ProductW]))
                    + SumW'($signed(s14_mirror_q[2*ProductW +: ProductW])) + Half;

  always_ff @(posedge clk_i) begin
    if (surf_i[Unit+1] || light_i[Unit+1])
      s15_cosine_o <= s14_cosine < 0 ? '0
                    : s14_cosine[SumW-2:2*UnitBits] != '0 ? rc_pkg::ValueOne
                    : {1'b0, s14_cosine[UnitBits +: UnitBits]};
    if (light_i[Unit+1]) s15_mirror_o <= s14_mirror[UnitBits +: AxisBits+1];
  end

  logic unused;
  assign unused = ^{s14_cosine, s14_mirror, surf_i, light_i, phase_i};
endmodule
`default_nettype wire

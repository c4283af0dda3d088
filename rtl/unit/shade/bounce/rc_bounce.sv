// Directions of reflected and refracted rays, and the weights of these rays.
//
// Part of rc_pass, which has the valid bits: valid_i[i] is set if stage i holds a pass for a
// bounce. A signal's prefix names its stage.
//
// Both directions are along * normal - ratio * view. A reflected one has along = 2 cosine and ratio
// = 1. A refracted one has along = ratio * cosine - sqrt(1 - ratio^2 (1 - cosine^2)). Model:
// model/unit/shade/bounce/bounce.hpp.
`default_nettype none
module rc_bounce #(
  localparam int unsigned ValueBits = rc_pkg::ValueBits,
  localparam int unsigned AxisBits  = rc_pkg::AxisBits,
  localparam int unsigned UnitBits  = rc_pkg::UnitBits,
  localparam int unsigned RatioBits = rc_pkg::RatioBits,
  localparam int unsigned M         = rc_pkg::DirBits,
  localparam int unsigned Unit      = rc_pkg::StageUnit,   // stage with the unit vectors
  localparam int unsigned Every     = rc_pkg::ShadeInterval
) (
  input  logic                  clk_i,
  input  logic                  rst_ni,
  input  logic [Unit+1:0]       valid_i,
  input  logic [(Unit+1)*Every-1:0] phase_i,     // the cycle of each stage
  // Pass
  input  logic                  s0_refract_i,  // refract, not reflect
  input  rc_pkg::shade_state_t  s0_state_i,
  input  logic [3*AxisBits-1:0] s13_normal_i,
  input  logic [3*AxisBits-1:0] s13_view_i,
  // Results
  output logic [ValueBits-1:0]  s9_weight_o,
  output logic                  s13_total_o,   // total reflection
  output logic [3*M-1:0]        s15_d_o
);
  localparam int unsigned ProductW = 2 * ValueBits;   // product of two values
  localparam int unsigned ShareW   = ValueBits + 1;                                   // up to 2
  // AlongW: width of rc_snell's s13_along_o, signed.
  localparam int unsigned AlongW   = RatioBits - rc_pkg::IndexFrac + ValueBits + 2;
  localparam int unsigned NormalW  = AlongW + AxisBits;   // along * normal
  localparam int unsigned ViewW    = RatioBits + 1 + AxisBits;   // ratio * view
  localparam int unsigned SumW     = NormalW + 1;
  localparam int unsigned UnitW    = SumW - UnitBits;                         // the sum, S.16
  localparam logic signed [SumW-1:0]  Half = SumW'(1) << (UnitBits - 1);
  localparam logic signed [UnitW-1:0] One  = UnitW'(1) << UnitBits;

  logic [ValueBits-1:0] s0_cosine, s0_weight;
  logic [RatioBits-1:0] s0_ratio;
  logic [ValueBits-1:0] s0_mirror, s0_transmit, s0_r0;
  logic        s0_schlick, s0_total;

  assign s0_cosine   = s0_state_i.cosine;
  assign s0_weight   = s0_state_i.weight;
  assign s0_ratio    = s0_state_i.ratio;
  assign s0_mirror   = s0_state_i.mirror;
  assign s0_transmit = s0_state_i.transmit;
  assign s0_r0       = s0_state_i.r0;
  assign s0_schlick  = s0_state_i.schlick;
  assign s0_total    = s0_state_i.total;

  // Factors of both directions, and the share of the weight.
  logic signed [AlongW-1:0] s13_along;
  logic [RatioBits-1:0]     s13_ratio;
  logic [ShareW-1:0]        s7_share;

  if (rc_pkg::Refraction) begin : gen_refraction
    rc_snell u_snell (
      .clk_i, .rst_ni, .valid_i(valid_i[Unit:0]), .phase_i(phase_i[2*Every-1:0]), .s0_refract_i,
      .s0_cosine_i(s0_cosine),
      .s0_ratio_i(s0_ratio), .s13_along_o(s13_along), .s13_ratio_o(s13_ratio), .s13_total_o);

    rc_schlick u_schlick (
      .clk_i, .valid_i(valid_i[6:0]), .phase_i(phase_i[6*Every-1:0]), .s0_refract_i,
      .s0_cosine_i(s0_cosine),
      .s0_mirror_i(s0_mirror), .s0_transmit_i(s0_transmit), .s0_r0_i(s0_r0),
      .s0_schlick_i(s0_schlick), .s0_total_i(s0_total), .s7_share_o(s7_share));
  end else begin : gen_reflection
    logic [ValueBits-1:0] s13_cosine;
    logic [ValueBits-1:0] s7_mirror;
    rc_stage_delay #(.Width(ValueBits), .Stages(Unit)) u_cosine (
      .clk_i, .rst_ni, .enter_i(valid_i[0]), .leave_i(valid_i[Unit]), .data_i(s0_cosine),
      .data_o(s13_cosine));
    rc_shift_register #(.Width(ValueBits), .Stages(7)) u_mirror (
      .clk_i, .enable_i(valid_i[6:0]), .data_i(s0_mirror), .data_o(s7_mirror));

    assign s13_along   = $signed({{(AlongW-ValueBits-1){1'b0}}, s13_cosine, 1'b0});
    assign s13_ratio   = RatioBits'(1) << rc_pkg::IndexFrac;
    assign s13_total_o = 1'b0;
    assign s7_share    = {1'b0, s7_mirror};

    logic unused;
    assign unused = ^{s0_refract_i, s0_ratio, s0_transmit, s0_r0, s0_schlick, s0_total,
                      valid_i[Unit-1:rc_pkg::StageWeight]};
  end

  // s15: the direction, S1.16; no component is above 1 in magnitude.
  logic [3*NormalW-1:0] s13_along_normal;
  logic [3*ViewW-1:0]   s13_ratio_view;

  rc_mul_held #(.AW(AlongW), .BW(AxisBits), .Products(3)) u_normal (
    .clk_i, .phase_i(phase_i[Unit*Every +: Every]), .a_i({3{s13_along}}), .b_i(s13_normal_i),
    .p_o(s13_along_normal));

  rc_mul_held #(.AW(RatioBits + 1), .BW(AxisBits), .Products(3)) u_view (
    .clk_i, .phase_i(phase_i[Unit*Every +: Every]), .a_i({3{1'b0, s13_ratio}}), .b_i(s13_view_i),
    .p_o(s13_ratio_view));

  for (genvar k = 0; k < 3; k++) begin : gen_axis
    logic signed [NormalW-1:0]  s14_normal_q;
    logic signed [ViewW-1:0]    s14_view_q;
    logic signed [SumW-1:0]     s14_sum;
    logic signed [UnitW-1:0]    s14_unit;   // registered in the stage if a pass stays long enough
    logic signed [AxisBits-1:0] s15_unit_q;
    logic signed [M-1:0]        d;

    assign s14_sum = SumW'(s14_normal_q) - (SumW'(s14_view_q) <<< (UnitBits - rc_pkg::IndexFrac))
                   + Half;
    rc_path_register #(.Width(UnitW), .Stages(rc_pkg::PassCut)) u_unit (
      .clk_i, .data_i(s14_sum[SumW-1:UnitBits]), .data_o(s14_unit));

    always_ff @(posedge clk_i) begin
      if (valid_i[Unit]) begin
        s14_normal_q <= s13_along_normal[k*NormalW +: NormalW];
        s14_view_q   <= s13_ratio_view[k*ViewW +: ViewW];
      end
      if (valid_i[Unit+1])
        s15_unit_q <= s14_unit > One ? AxisBits'(One)
                    : s14_unit < -One ? -AxisBits'(One) : s14_unit[AxisBits-1:0];
    end

    rc_to_direction u_turn (.unit_i(s15_unit_q), .d_o(d));
    assign s15_d_o[k*M +: M] = d;

    logic unused;
    assign unused = ^s14_sum[UnitBits-1:0];
  end

  // s9: weight of the new ray, U1.16.
  logic [ValueBits-1:0] s7_weight, s7_cut;
  logic [ProductW-1:0]  s7_product, s8_weight_q, s8_rounded;

  rc_shift_register #(.Width(ValueBits), .Stages(7)) u_weight (
    .clk_i, .enable_i(valid_i[6:0]), .data_i(s0_weight), .data_o(s7_weight));

  assign s7_cut = s7_share[ShareW-1:UnitBits] != '0 ? rc_pkg::ValueOne : s7_share[ValueBits-1:0];

  rc_mul_held #(.AW(ValueBits), .BW(ValueBits), .Signed(1'b0)) u_weighted (
    .clk_i, .phase_i(phase_i[7*Every +: Every]), .a_i(s7_weight), .b_i(s7_cut), .p_o(s7_product));

  assign s8_rounded = s8_weight_q + rc_pkg::ProductHalf;

  always_ff @(posedge clk_i) begin
    if (valid_i[7]) s8_weight_q <= s7_product;
    if (valid_i[8]) s9_weight_o <= s8_rounded[UnitBits +: ValueBits];
  end

  logic unused;
  assign unused = ^{s0_state_i, s8_rounded[ProductW-1], s8_rounded[UnitBits-1:0], phase_i};
endmodule
`default_nettype wire

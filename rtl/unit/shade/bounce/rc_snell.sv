// Refraction: the share of the normal in the new direction, and whether a refracted ray exists.
// Part of rc_bounce.
//
// Results are in the registers of s13. For a reflected ray they are 2 cosine, and the ratio 1.
// cosine has 16 fraction bits, ratio has 12.
`default_nettype none
module rc_snell #(
  localparam int unsigned ValueBits = rc_pkg::ValueBits,
  localparam int unsigned UnitBits  = rc_pkg::UnitBits,
  localparam int unsigned RatioBits = rc_pkg::RatioBits,
  localparam int unsigned IndexFrac = rc_pkg::IndexFrac,
  localparam int unsigned Unit      = rc_pkg::StageUnit,   // stage with the unit vectors
  localparam int unsigned Every     = rc_pkg::ShadeInterval,
  // LongW: width of ratio * cosine.
  localparam int unsigned LongW     = RatioBits + ValueBits,
  // AlongW: width of this product rounded to 16 fraction bits, signed.
  localparam int unsigned AlongW    = LongW - IndexFrac + 2
) (
  input  logic                 clk_i,
  input  logic                 rst_ni,
  input  logic [Unit:0]        valid_i,
  input  logic [2*Every-1:0]   phase_i,       // the cycle of each stage
  input  logic                 s0_refract_i,
  input  logic [ValueBits-1:0] s0_cosine_i,
  input  logic [RatioBits-1:0] s0_ratio_i,
  output logic signed [AlongW-1:0] s13_along_o,
  output logic [RatioBits-1:0]      s13_ratio_o,
  output logic                      s13_total_o
);
  localparam int unsigned SquareW = 2 * UnitBits + 1;          // square of a value, 0 to 1
  localparam int unsigned BentW   = 2 * RatioBits + SquareW;   // ratio^2 * square
  localparam int unsigned InsideW = BentW - 2 * IndexFrac + 2; // 1 - ratio^2 * square, signed
  localparam int unsigned RootW   = UnitBits + 2;              // a root
  localparam logic [SquareW-1:0]   One  = SquareW'(1) << (2 * UnitBits);
  localparam logic [LongW-1:0]     Half = LongW'(1) << (IndexFrac - 1);
  // Unbent: the ratio of refractive indices for a reflection, which is 1.
  localparam logic [RatioBits-1:0] Unbent = RatioBits'(1) << IndexFrac;

  // s3: 2^32 times the squared cosine inside, rounded up. If negative, the reflection is total.
  logic [SquareW-1:0]     s1_cosine2_q, s1_sine2;
  logic [2*RatioBits-1:0] s1_ratio2_q;
  logic [BentW-1:0]       s2_bent_q;
  logic signed [InsideW-1:0] s2_cosine2;
  logic               s1_refract, s2_refract, s3_total_q, s3_refract_q;
  logic [SquareW-1:0] s3_square_q;

  rc_shift_register #(.Width(1), .Stages(1)) u_refract1 (
    .clk_i, .enable_i(valid_i[0]), .data_i(s0_refract_i), .data_o(s1_refract));
  rc_shift_register #(.Width(1), .Stages(1)) u_refract2 (
    .clk_i, .enable_i(valid_i[1]), .data_i(s1_refract), .data_o(s2_refract));

  assign s1_sine2   = One - s1_cosine2_q;
  assign s2_cosine2 = $signed(InsideW'(One)) - $signed({2'b00, s2_bent_q[BentW-1:2*IndexFrac]});

  logic [2*ValueBits-1:0] s0_cosine2;
  logic [2*RatioBits-1:0] s0_ratio2;
  logic [BentW-1:0]       s1_bent;

  rc_mul_held #(.AW(ValueBits), .BW(ValueBits), .Signed(1'b0)) u_cosine2 (
    .clk_i, .phase_i(phase_i[Every-1:0]), .a_i(s0_cosine_i), .b_i(s0_cosine_i), .p_o(s0_cosine2));
  rc_mul_held #(.AW(RatioBits), .BW(RatioBits), .Signed(1'b0)) u_ratio2 (
    .clk_i, .phase_i(phase_i[Every-1:0]), .a_i(s0_ratio_i), .b_i(s0_ratio_i), .p_o(s0_ratio2));
  rc_mul_held #(.AW(2 * RatioBits), .BW(SquareW), .Signed(1'b0)) u_bent (
    .clk_i, .phase_i(phase_i[Every +: Every]), .a_i(s1_ratio2_q), .b_i(s1_sine2), .p_o(s1_bent));

  always_ff @(posedge clk_i) begin
    if (valid_i[0] && s0_refract_i) begin
      s1_cosine2_q <= s0_cosine2[SquareW-1:0];
      s1_ratio2_q  <= s0_ratio2;
    end
    if (valid_i[1] && s1_refract) s2_bent_q <= s1_bent;
    if (valid_i[2]) s3_refract_q <= s2_refract;
    if (valid_i[2] && s2_refract) begin
      s3_total_q  <= s2_cosine2[InsideW-1];
      s3_square_q <= s2_cosine2[InsideW-1] ? '0 : s2_cosine2[SquareW-1:0];
    end
  end

  // s12: its root.
  logic [RootW-1:0] s12_root;
  logic             inexact;

  rc_sqrt #(.Stages(Unit - 4), .Held(Every)) u_sqrt (
    .clk_i, .valid_i(valid_i[3] && s3_refract_q),
    .square_i({{(2*RootW-SquareW){1'b0}}, s3_square_q}),
    .root_o(s12_root), .inexact_o(inexact));

  // s13: ratio * cosine minus the root, or 2 cosine.
  logic [LongW-1:0]  s0_long, s1_long_q, s1_rounded;
  logic [AlongW-2:0] s2_long_q, s12_long;
  logic              s12_refract, s12_total;

  rc_mul_held #(.AW(RatioBits), .BW(ValueBits), .Signed(1'b0)) u_long_product (
    .clk_i, .phase_i(phase_i[Every-1:0]), .a_i(s0_ratio_i), .b_i(s0_cosine_i), .p_o(s0_long));

  assign s1_rounded = s1_long_q + Half;

  always_ff @(posedge clk_i) begin
    if (valid_i[0])
      s1_long_q <= s0_refract_i ? s0_long : {{(LongW-ValueBits-1){1'b0}}, s0_cosine_i, 1'b0};
    if (valid_i[1])
      s2_long_q <= s1_refract ? {1'b0, s1_rounded[LongW-1:IndexFrac]} : s1_long_q[AlongW-2:0];
    if (valid_i[Unit-1]) begin
      s13_along_o <= $signed({1'b0, s12_long})
                   - (s12_refract ? $signed({{(AlongW-RootW){1'b0}}, s12_root})
                                  : $signed(AlongW'(0)));
      s13_total_o <= s12_refract && s12_total;
    end
  end

  rc_stage_delay #(.Width(AlongW - 1), .Stages(Unit - 3)) u_long (
    .clk_i, .rst_ni, .enter_i(valid_i[2]), .leave_i(valid_i[Unit-1]), .data_i(s2_long_q),
    .data_o(s12_long));
  rc_stage_delay #(.Width(2), .Stages(Unit - 4)) u_flags (
    .clk_i, .rst_ni, .enter_i(valid_i[3]), .leave_i(valid_i[Unit-1]),
    .data_i({s3_refract_q, s3_total_q}),
    .data_o({s12_refract, s12_total}));
  rc_stage_delay #(.Width(RatioBits), .Stages(Unit)) u_ratio (
    .clk_i, .rst_ni, .enter_i(valid_i[0]), .leave_i(valid_i[Unit]),
    .data_i(s0_refract_i ? s0_ratio_i : Unbent), .data_o(s13_ratio_o));

  logic unused;
  assign unused = ^{inexact, valid_i, s0_cosine2[2*ValueBits-1:SquareW], s1_rounded[IndexFrac-1:0],
                    s2_bent_q[2*IndexFrac-1:0], s2_cosine2[InsideW-2:SquareW]};
endmodule
`default_nettype wire

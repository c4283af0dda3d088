// The light that a light source adds to a point of a surface if nothing is in its way, and the
// shadow ray's direction.
//
// Part of rc_pass, which has the valid bits: valid_i[i] is set if stage i holds a pass for a light.
// A signal's prefix names its stage. Values are U1.16, colours of a surface U1.12, colours of a
// light U5.12. Model: model/unit/shade/light/light.hpp.
`default_nettype none
module rc_light #(
  localparam int unsigned ValueBits  = rc_pkg::ValueBits,
  localparam int unsigned AxisBits   = rc_pkg::AxisBits,
  localparam int unsigned N          = rc_pkg::CoordBits,
  localparam int unsigned M          = rc_pkg::DirBits,
  localparam int unsigned OriginBits = rc_pkg::OriginBits,
  localparam int unsigned PointWidth = rc_pkg::PointWidth,
  localparam int unsigned RayDirBits = rc_pkg::RayDirBits,
  localparam int unsigned LightBits  = rc_pkg::LightBits,
  // ToLightW: width of a component of the vector to the light, signed.
  localparam int unsigned ToLightW   = LightBits + OriginBits + 1,
  localparam int unsigned Stages     = rc_pkg::ShadeStages,
  localparam int unsigned Every      = rc_pkg::ShadeInterval
) (
  input  logic                    clk_i,
  input  logic                    rst_ni,
  input  rc_pkg::shade_frame_t    frame_i,
  input  logic [Stages:0]         valid_i,
  input  logic [Stages*Every-1:0] phase_i,     // the cycle of each stage
  // Light and surface
  input  logic [6:0]              s0_light_i,
  input  logic [3*PointWidth-1:0] s0_o_i,
  input  logic                    s0_far_i,    // beyond the lattice
  input  logic [ValueBits-1:0]    s0_weight_i,
  input  rc_pkg::shade_state_t    s0_state_i,
  output logic [3*ToLightW-1:0]   s5_to_o,     // from the point to the light
  // From rc_angles
  input  logic [3*AxisBits-1:0]   s13_unit_i,  // the same, normalised
  input  logic [ValueBits-1:0]    s15_cosine_i,
  input  logic signed [AxisBits:0] s15_mirror_i,
  // Results
  output logic [3*RayDirBits-1:0] s15_d_o,     // the shadow ray's direction
  output logic                    s15_near_o,  // it begins at a light within the lattice
  output logic [3*N-1:0]          s15_place_o, // the light's place; 0 without instances
  output logic [3*N-1:0]          s28_place_o,
  output logic                    s28_near_o,
  output logic                    s28_clear_o,
  output logic [3*ValueBits-1:0]  s28_share_o
);
  localparam int unsigned Lights       = rc_pkg::Lights;
  localparam int unsigned UnitBits     = rc_pkg::UnitBits;       // fraction bits of a value
  localparam int unsigned ShareBits    = rc_pkg::ShareBits;      // fraction bits of a colour
  localparam int unsigned ColourBits   = rc_pkg::ColourBits;
  localparam int unsigned ShineBits    = rc_pkg::ShineBits;
  localparam int unsigned StrengthBits = rc_pkg::StrengthBits;   // of a light's colour

  // Stages in which a value is ready.
  localparam int unsigned Toward = rc_pkg::StageToward;   // the vector to the light
  localparam int unsigned Unit   = rc_pkg::StageUnit;     // its unit vector
  localparam int unsigned Cosine = rc_pkg::StageCosine;   // the cosines
  localparam int unsigned Power  = rc_pkg::StagePower;    // R . V
  localparam int unsigned Phong  = rc_pkg::StagePhong;    // R . V to the power of shine
  localparam int unsigned Lit    = rc_pkg::StageLit;      // matte and gloss

  // s1: the light.
  logic [Lights*3*LightBits-1:0] place;
  logic [Lights*3*StrengthBits-1:0] colour;
  logic [Lights-1:0]             near, clear;

  assign place  = frame_i.place;
  assign colour = frame_i.colour;
  assign near   = frame_i.is_near;
  assign clear  = frame_i.is_clear;

  logic [3*LightBits-1:0] s0_place, s1_place_q;
  logic [3*StrengthBits-1:0] s0_colour, s1_colour_q;
  logic                      s0_near, s1_near_q, s0_clear, s1_clear_q;

  // A light is clear if it lies on the path's side of every pane.
  logic [Lights-1:0] clear_here;
  if (rc_pkg::Panes != 0) begin : gen_panes
    localparam int unsigned Panes = rc_pkg::Panes;
    logic [Panes-1:0]        cell_here;
    logic [Lights*Panes-1:0] cells;

    assign cell_here = s0_state_i.in_cell;
    assign cells     = frame_i.light_cell;

    for (genvar i = 0; i < Lights; i++) begin : gen_light
      assign clear_here[i] = clear[i] && cells[i*Panes +: Panes] == cell_here;
    end
  end else begin : gen_no_panes
    assign clear_here = clear;
  end

  always_comb begin
    s0_place  = '0;
    s0_colour = '0;
    s0_near   = 1'b0;
    s0_clear  = 1'b0;
    if (valid_i[0])
      for (int i = 0; i < Lights; i++)
        if (s0_light_i == 7'(i)) begin
          s0_place  = place[i*3*LightBits +: 3*LightBits];
          s0_colour = colour[i*3*StrengthBits +: 3*StrengthBits];
          s0_near   = near[i];
          s0_clear  = clear_here[i];
        end
  end

  always_ff @(posedge clk_i) begin
    if (valid_i[0]) begin
      s1_place_q  <= s0_place;
      s1_colour_q <= s0_colour;
      s1_near_q   <= s0_near;
      s1_clear_q  <= s0_clear;
    end
  end

  // s1: the point, its weight, and its position relative to the lattice.
  logic [3*PointWidth-1:0] s1_o;
  logic [ValueBits-1:0]    s1_weight;
  logic                    s1_far;

  rc_shift_register #(.Width(3 * PointWidth + ValueBits + 1), .Stages(1)) u_o (
    .clk_i, .enable_i(valid_i[0]), .data_i({s0_o_i, s0_weight_i, s0_far_i}),
    .data_o({s1_o, s1_weight, s1_far}));

  // s2: the vector to the light, in units of 2^-OriginBits; strength, the light's colour times the
  // ray's weight, U6.28.
  localparam int unsigned StrengthW = StrengthBits + ValueBits;
  logic [3*ToLightW-1:0]   s2_to_q;
  logic [3*StrengthW-1:0]  s1_strength, s2_strength_q, s26_strength;
  logic [3*N-1:0]          s1_lattice;
  logic [3*RayDirBits-1:0] s2_from, s15_from;
  logic [3*AxisBits-1:0]   s15_unit;
  logic                    s15_near, s15_far;
  logic [3*RayDirBits-1:0] s15_away;

  rc_shift_register #(.Width(3 * ToLightW), .Stages(Toward - 2)) u_to (
    .clk_i, .enable_i(valid_i[Toward-1:2]), .data_i(s2_to_q), .data_o(s5_to_o));

  rc_stage_delay #(.Width(3 * StrengthW), .Stages(Lit - 2)) u_strength (
    .clk_i, .rst_ni, .enter_i(valid_i[2]), .leave_i(valid_i[Lit]), .data_i(s2_strength_q),
    .data_o(s26_strength));

  localparam int unsigned Out = rc_pkg::PassOutStage;   // then rc_pass_end has accepted it

  rc_stage_delay #(.Width(3 * N + 2), .Stages(Out - 1), .Parts(rc_pkg::PassParts)) u_place (
    .clk_i, .rst_ni, .enter_i(valid_i[1]), .leave_i(valid_i[Out]),
    .data_i({s1_lattice, s1_near_q, s1_clear_q}),
    .data_o({s28_place_o, s28_near_o, s28_clear_o}));

  rc_stage_delay #(.Width(2), .Stages(Cosine - 1)) u_near (
    .clk_i, .rst_ni, .enter_i(valid_i[1]), .leave_i(valid_i[Cosine]), .data_i({s1_near_q, s1_far}),
    .data_o({s15_near, s15_far}));

  rc_stage_delay #(.Width(3 * RayDirBits), .Stages(Cosine - 2)) u_from (
    .clk_i, .rst_ni, .enter_i(valid_i[2]), .leave_i(valid_i[Cosine]), .data_i(s2_from),
    .data_o(s15_from));

  rc_shift_register #(.Width(3 * AxisBits), .Stages(Cosine - Unit)) u_unit (
    .clk_i, .enable_i(valid_i[Cosine-1:Unit]), .data_i(s13_unit_i), .data_o(s15_unit));

  rc_mul_held #(.AW(StrengthBits), .BW(ValueBits), .Signed(1'b0), .Products(3)) u_strengths (
    .clk_i, .phase_i(phase_i[Every +: Every]), .a_i(s1_colour_q), .b_i({3{s1_weight}}),
    .p_o(s1_strength));

  // s15: the direction, from the light or to it.
  for (genvar k = 0; k < 3; k++) begin : gen_axis
    logic signed [ToLightW-1:0]   at, from;
    logic signed [M-1:0]          away;
    logic signed [RayDirBits-1:0] wide;

    assign at   = ToLightW'($signed(s1_place_q[k*LightBits +: LightBits])) <<< OriginBits;
    assign from = -$signed(s2_to_q[k*ToLightW +: ToLightW]);

    assign s1_lattice[k*N +: N]                = s1_place_q[k*LightBits +: N];
    assign s2_from[k*RayDirBits +: RayDirBits] = from[RayDirBits-1:0];

    always_ff @(posedge clk_i) begin
      if (valid_i[1]) begin
        s2_to_q[k*ToLightW +: ToLightW] <=
            at - ToLightW'($signed(s1_o[k*PointWidth +: PointWidth]));
        s2_strength_q[k*StrengthW +: StrengthW] <= s1_strength[k*StrengthW +: StrengthW];
      end
    end

    rc_to_direction u_turn (.unit_i(s15_unit[k*AxisBits +: AxisBits]), .d_o(away));

    assign wide = RayDirBits'(away);
    assign s15_away[k*RayDirBits +: RayDirBits] = s15_near ? -wide : wide;

    logic unused;
    assign unused = ^from;
  end

  assign s15_near_o = s15_near && !s15_far;   // a ray goes from the light to the point
  if (rc_pkg::HasHomes) begin : gen_place
    rc_stage_delay #(.Width(3 * N), .Stages(Cosine - 1)) u_lattice (
      .clk_i, .rst_ni, .enter_i(valid_i[1]), .leave_i(valid_i[Cosine]), .data_i(s1_lattice),
      .data_o(s15_place_o));
  end else begin : gen_no_place
    assign s15_place_o = '0;
  end

  assign s15_d_o = s15_near && !s15_far ? s15_from : s15_away;

  // Fields of the surface are delayed.
  logic [ValueBits-1:0]    s15_cosine;
  logic [ColourBits-1:0]   s15_diffuse, s15_highlight, s24_highlight;
  logic [ShineBits-1:0]    s15_shine, s17_shine;
  logic [3*ColourBits-1:0] s15_albedo, s16_albedo;

  rc_stage_delay #(.Width(ValueBits + 2 * ColourBits + ShineBits + 3 * ColourBits), .Stages(Cosine))
  u_surface (
    .clk_i, .rst_ni, .enter_i(valid_i[0]), .leave_i(valid_i[Cosine]),
    .data_i({s0_state_i.cosine, s0_state_i.diffuse, s0_state_i.highlight, s0_state_i.shine,
             s0_state_i.albedo}),
    .data_o({s15_cosine, s15_diffuse, s15_highlight, s15_shine, s15_albedo}));

  rc_stage_delay #(.Width(ColourBits), .Stages(Phong - Cosine)) u_highlight (
    .clk_i, .rst_ni, .enter_i(valid_i[Cosine]), .leave_i(valid_i[Phong]), .data_i(s15_highlight),
    .data_o(s24_highlight));

  rc_shift_register #(.Width(ShineBits), .Stages(Power - Cosine)) u_shine (
    .clk_i, .enable_i(valid_i[Power-1:Cosine]), .data_i(s15_shine), .data_o(s17_shine));

  // Widths of products and sums.
  localparam int unsigned ReflectedW = ColourBits + ValueBits; // share of light * cosine, U2.28
  localparam int unsigned TintedW    = ReflectedW + ColourBits; // that times the albedo, U3.40
  localparam int unsigned LitW       = ValueBits + 1;         // matte + gloss, U2.16
  localparam int unsigned ShareW     = LitW + StrengthW;      // that times the strength, U8.44
  localparam int unsigned DoubleW    = 2 * ValueBits + 1;     // 2 (N . L) (N . V), U3.32
  localparam int unsigned PhongW     = DoubleW + 2 - UnitBits; // R . V, S5.16

  // Fraction bits that rounding to U.16 drops, and half the last bit that stays.
  localparam int unsigned GlossDrop = ShareBits;
  localparam int unsigned MatteDrop = 2 * ShareBits;
  localparam int unsigned ShareDrop = ShareBits + UnitBits;
  localparam logic [ReflectedW-1:0] GlossHalf = ReflectedW'(1) << (GlossDrop - 1);
  localparam logic [TintedW-1:0]    MatteHalf = TintedW'(1) << (MatteDrop - 1);
  localparam logic [ShareW:0]       ShareHalf = (ShareW+1)'(1) << (ShareDrop - 1);

  // s17: R . V = 2 (N . L) (N . V) - L . V, clamped to 0..1. s24: that to the power of shine.
  logic [2*ValueBits-1:0]   s15_double;
  logic [DoubleW-1:0]       s16_double_q;
  logic [DoubleW:0]         s16_rounded;
  logic signed [AxisBits:0] s16_mirror_q;
  logic signed [PhongW-1:0] s16_phong;
  logic [ReflectedW-1:0]    s15_matte, s16_matte_q, s24_gloss, s25_gloss_q, s25_rounded;
  logic [ValueBits-1:0]     s17_phong_q, s24_phong;

  assign s16_rounded = {1'b0, s16_double_q} + (DoubleW+1)'(rc_pkg::ProductHalf);
  assign s16_phong   = $signed({1'b0, s16_rounded[UnitBits +: PhongW-1]}) - PhongW'(s16_mirror_q);

  rc_mul_held #(.AW(ValueBits), .BW(ValueBits), .Signed(1'b0)) u_double (
    .clk_i, .phase_i(phase_i[Cosine*Every +: Every]), .a_i(s15_cosine_i), .b_i(s15_cosine),
    .p_o(s15_double));

  rc_mul_held #(.AW(ColourBits), .BW(ValueBits), .Signed(1'b0)) u_lit (
    .clk_i, .phase_i(phase_i[Cosine*Every +: Every]), .a_i(s15_diffuse), .b_i(s15_cosine_i),
    .p_o(s15_matte));

  rc_mul_held #(.AW(ColourBits), .BW(ValueBits), .Signed(1'b0)) u_gloss (
    .clk_i, .phase_i(phase_i[Phong*Every +: Every]), .a_i(s24_highlight), .b_i(s24_phong),
    .p_o(s24_gloss));

  always_ff @(posedge clk_i) begin
    if (valid_i[Cosine]) begin
      s16_double_q <= {s15_double, 1'b0};
      s16_mirror_q <= s15_mirror_i;
      s16_matte_q  <= s15_matte;
      s16_albedo   <= s15_albedo;
    end
    if (valid_i[Cosine+1])
      s17_phong_q <= s16_phong < 0 ? '0
                   : s16_phong[PhongW-2:UnitBits] != '0 ? rc_pkg::ValueOne
                   : {1'b0, s16_phong[UnitBits-1:0]};
    if (valid_i[Phong]) s25_gloss_q <= s24_gloss;
  end

  rc_power u_power (
    .clk_i, .valid_i(Every == 1 ? valid_i[Power] : phase_i[Power*Every]), .c_i(s17_phong_q),
    .n_i(s17_shine), .power_o(s24_phong));

  assign s25_rounded = s25_gloss_q + GlossHalf;

  // s26: matte and gloss. s28: both in the light's colour, U1.16.
  logic [3*ValueBits-1:0] s17_matte, s25_matte;

  rc_stage_delay #(.Width(3 * ValueBits), .Stages(Phong + 1 - Power)) u_matte (
    .clk_i, .rst_ni, .enter_i(valid_i[Power]), .leave_i(valid_i[Phong+1]), .data_i(s17_matte),
    .data_o(s25_matte));

  logic [3*TintedW-1:0] s16_product;
  logic [3*ShareW-1:0]  s26_product;
  logic [3*LitW-1:0]    s26_lit;

  rc_mul_held #(.AW(ReflectedW), .BW(ColourBits), .Signed(1'b0), .Products(3)) u_matte_products (
    .clk_i, .phase_i(phase_i[(Cosine+1)*Every +: Every]), .a_i({3{s16_matte_q}}), .b_i(s16_albedo),
    .p_o(s16_product));

  rc_mul_held #(.AW(LitW), .BW(StrengthW), .Signed(1'b0), .Products(3)) u_share_products (
    .clk_i, .phase_i(phase_i[Lit*Every +: Every]), .a_i(s26_lit), .b_i(s26_strength),
    .p_o(s26_product));

  for (genvar k = 0; k < 3; k++) begin : gen_channel
    logic [TintedW-1:0]   s17_matte_q, s17_rounded;
    logic [LitW-1:0]      s26_lit_q;
    logic [ShareW-1:0]    s27_share_q;
    logic [ShareW:0]      s27_rounded;
    logic [ValueBits-1:0] s28_share_q;

    assign s26_lit[k*LitW +: LitW] = s26_lit_q;
    assign s17_rounded = s17_matte_q + MatteHalf;
    assign s17_matte[k*ValueBits +: ValueBits] = s17_rounded[MatteDrop +: ValueBits];
    assign s27_rounded = {1'b0, s27_share_q} + ShareHalf;

    always_ff @(posedge clk_i) begin
      if (valid_i[Cosine+1]) s17_matte_q <= s16_product[k*TintedW +: TintedW];
      if (valid_i[Phong+1])
        s26_lit_q <= {1'b0, s25_matte[k*ValueBits +: ValueBits]}
                   + {1'b0, s25_rounded[GlossDrop +: ValueBits]};
      if (valid_i[Lit]) s27_share_q <= s26_product[k*ShareW +: ShareW];
      // If a pass stays long, rc_pass_end reads the share at the end of s27.
      if (rc_pkg::PassCut != 0 || valid_i[Lit+1])
        s28_share_q <= s27_rounded[ShareW:ShareDrop+UnitBits] != '0 ? rc_pkg::ValueOne
                     : {1'b0, s27_rounded[ShareDrop +: UnitBits]};
    end

    assign s28_share_o[k*ValueBits +: ValueBits] = s28_share_q;

    logic unused;
    assign unused = ^{s17_rounded, s27_rounded};
  end

  logic unused;
  assign unused = ^{frame_i, s0_state_i, s1_place_q, s16_rounded, s25_rounded, valid_i, phase_i};
endmodule
`default_nettype wire

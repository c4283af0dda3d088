// The light that a light source adds to a point of a surface if nothing is in its way, and the
// shadow ray's direction.
//
// Part of rc_pass, which has the valid bits: valid_i[i] is set if stage i holds a pass for a light.
// A signal's prefix names its stage. Model: model/unit/shade/light.hpp.
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
  // Of the way to the light, signed.
  localparam int unsigned WayW       = LightBits + OriginBits + 1,
  localparam int unsigned Every = rc_pkg::ShadeInterval
) (
  input  logic                    clk_i,
  input  logic                    rst_ni,
  input  rc_pkg::shade_frame_t    frame_i,
  input  logic [28:0]             valid_i,
  input  logic [28*Every-1:0]     phase_i,     // the cycle of each stage
  // Light and surface
  input  logic [6:0]              s0_light_i,
  input  logic [3*PointWidth-1:0] s0_o_i,
  input  logic                    s0_far_i,    // beyond the lattice
  input  logic [ValueBits-1:0]    s0_weight_i,
  input  rc_pkg::shade_state_t    s0_state_i,
  output logic [3*WayW-1:0]       s5_to_o,     // from the point to the light
  // From rc_angles
  input  logic [3*AxisBits-1:0]   s13_unit_i,  // the same, normalised
  input  logic [ValueBits-1:0]    s15_cosine_i,
  input  logic signed [18:0]      s15_mirror_i,
  // Results
  output logic [3*RayDirBits-1:0] s15_d_o,     // the shadow ray's direction
  output logic                    s15_near_o,  // it comes from a light within the lattice,
  output logic [3*N-1:0]          s15_place_o, // from here; only if the chip has instances
  output logic [3*N-1:0]          s28_place_o,
  output logic                    s28_near_o,
  output logic                    s28_clear_o,
  output logic [3*ValueBits-1:0]  s28_share_o
);
  localparam int unsigned Lights = rc_pkg::Lights;

  // s1: the light.
  logic [Lights*3*LightBits-1:0] place;
  logic [Lights*3*ValueBits-1:0] colour;
  logic [Lights-1:0]             near, clear;

  assign place  = frame_i.place;
  assign colour = frame_i.colour;
  assign near   = frame_i.is_near;
  assign clear  = frame_i.is_clear;

  logic [3*LightBits-1:0] s0_place, s1_place_q;
  logic [3*ValueBits-1:0]     s0_colour, s1_colour_q;
  logic            s0_near, s1_near_q, s0_clear, s1_clear_q;

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
          s0_colour = colour[i*3*ValueBits +: 3*ValueBits];
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
  logic           s1_far;

  rc_shift_register #(.Width(3 * PointWidth + 18), .Stages(1)) u_o (
    .clk_i, .enable_i(valid_i[0]), .data_i({s0_o_i, s0_weight_i, s0_far_i}),
    .data_o({s1_o, s1_weight, s1_far}));

  // s2: the way to the light, in units of 2^-OriginBits; its colour times the ray's weight, U2.32.
  logic [3*WayW-1:0]       s2_to_q;
  logic [3*34-1:0]         s2_strength_q, s26_strength;
  logic [3*N-1:0]          s1_lattice;
  logic [3*RayDirBits-1:0] s2_from, s15_from;
  logic [3*AxisBits-1:0]     s15_unit;
  logic                     s15_near, s15_far;
  logic [3*RayDirBits-1:0]  s15_away;

  rc_shift_register #(.Width(3 * WayW), .Stages(3)) u_to (
    .clk_i, .enable_i(valid_i[4:2]), .data_i(s2_to_q), .data_o(s5_to_o));

  rc_stage_delay #(.Width(3 * 34), .Stages(24)) u_strength (
    .clk_i, .rst_ni, .enter_i(valid_i[2]), .leave_i(valid_i[26]), .data_i(s2_strength_q),
    .data_o(s26_strength));

  localparam int unsigned Out = rc_pkg::PassOutStage;   // then rc_pass_end has accepted it

  rc_stage_delay #(.Width(3 * N + 2), .Stages(Out - 1), .Parts(rc_pkg::PassParts)) u_place (
    .clk_i, .rst_ni, .enter_i(valid_i[1]), .leave_i(valid_i[Out]),
    .data_i({s1_lattice, s1_near_q, s1_clear_q}),
    .data_o({s28_place_o, s28_near_o, s28_clear_o}));

  rc_stage_delay #(.Width(2), .Stages(14)) u_near (
    .clk_i, .rst_ni, .enter_i(valid_i[1]), .leave_i(valid_i[15]), .data_i({s1_near_q, s1_far}),
    .data_o({s15_near, s15_far}));

  rc_stage_delay #(.Width(3 * RayDirBits), .Stages(13)) u_from (
    .clk_i, .rst_ni, .enter_i(valid_i[2]), .leave_i(valid_i[15]), .data_i(s2_from),
    .data_o(s15_from));

  rc_shift_register #(.Width(3 * AxisBits), .Stages(2)) u_unit (
    .clk_i, .enable_i(valid_i[14:13]), .data_i(s13_unit_i), .data_o(s15_unit));
  logic [3*2*ValueBits-1:0] s1_strength;

  rc_mul_held #(.AW(ValueBits), .BW(ValueBits), .Signed(1'b0), .Products(3)) u_strengths (
    .clk_i, .phase_i(phase_i[Every +: Every]), .a_i(s1_colour_q), .b_i({3{s1_weight}}),
    .p_o(s1_strength));

  // s15: the direction, from the light or to it.
  for (genvar k = 0; k < 3; k++) begin : gen_axis
    logic signed [WayW-1:0]       at, from;
    logic signed [M-1:0]          away;
    logic signed [RayDirBits-1:0] wide;

    assign at   = WayW'($signed(s1_place_q[k*LightBits +: LightBits])) <<< OriginBits;
    assign from = -$signed(s2_to_q[k*WayW +: WayW]);
    assign s1_lattice[k*N +: N]                = s1_place_q[k*LightBits +: N];
    assign s2_from[k*RayDirBits +: RayDirBits] = from[RayDirBits-1:0];

    always_ff @(posedge clk_i) begin
      if (valid_i[1]) begin
        s2_to_q[k*WayW +: WayW]   <= at - WayW'($signed(s1_o[k*PointWidth +: PointWidth]));
        s2_strength_q[k*34 +: 34] <= s1_strength[k*34 +: 34];
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
    rc_stage_delay #(.Width(3 * N), .Stages(14)) u_lattice (
      .clk_i, .rst_ni, .enter_i(valid_i[1]), .leave_i(valid_i[15]), .data_i(s1_lattice),
      .data_o(s15_place_o));
  end else begin : gen_no_place
    assign s15_place_o = '0;
  end

  assign s15_d_o = s15_near && !s15_far ? s15_from : s15_away;

  // Fields of the surface are delayed.
  logic [ValueBits-1:0] s15_cosine;
  localparam int unsigned ColourBits = rc_pkg::ColourBits;
  localparam int unsigned ShineBits  = rc_pkg::ShineBits;
  logic [ColourBits-1:0]   s15_diffuse, s15_highlight, s24_highlight;
  logic [ShineBits-1:0]    s15_shine, s17_shine;
  logic [3*ColourBits-1:0] s15_albedo, s16_albedo;

  rc_stage_delay #(.Width(ValueBits + 2 * ColourBits + ShineBits + 3 * ColourBits), .Stages(15))
  u_surface (
    .clk_i, .rst_ni, .enter_i(valid_i[0]), .leave_i(valid_i[15]),
    .data_i({s0_state_i.cosine, s0_state_i.diffuse, s0_state_i.highlight, s0_state_i.shine,
             s0_state_i.albedo}),
    .data_o({s15_cosine, s15_diffuse, s15_highlight, s15_shine, s15_albedo}));

  rc_stage_delay #(.Width(ColourBits), .Stages(9)) u_highlight (
    .clk_i, .rst_ni, .enter_i(valid_i[15]), .leave_i(valid_i[24]), .data_i(s15_highlight),
    .data_o(s24_highlight));

  rc_shift_register #(.Width(ShineBits), .Stages(2)) u_shine (
    .clk_i, .enable_i(valid_i[16:15]), .data_i(s15_shine), .data_o(s17_shine));

  // Half the last kept bit of products that drop 12, 24 and 28 fraction bits.
  localparam logic [29:0] GlossHalf = 30'd1 << (rc_pkg::ShareBits - 1);
  localparam logic [42:0] MatteHalf = 43'd1 << (2 * rc_pkg::ShareBits - 1);
  localparam logic [52:0] ShareHalf = 53'd1 << 27;

  // s17: R . V = 2 (N . L) (N . V) - L . V, clamped to 0..1. s24: that to the power of shine.
  logic [34:0]        s16_double_q;
  logic signed [18:0] s16_mirror_q;
  logic signed [20:0] s16_phong;
  logic [35:0]        s16_rounded;
  logic [29:0]        s16_matte_q, s25_gloss_q, s25_rounded;
  logic [ValueBits-1:0]        s17_phong_q, s24_phong;

  assign s16_rounded = {1'b0, s16_double_q} + 36'(rc_pkg::ProductHalf);
  assign s16_phong   = $signed({1'b0, s16_rounded[35:16]}) - 21'(s16_mirror_q);

  logic [33:0] s15_double;
  logic [29:0] s15_matte, s24_gloss;

  rc_mul_held #(.AW(ValueBits), .BW(ValueBits), .Signed(1'b0)) u_double (
    .clk_i, .phase_i(phase_i[15*Every +: Every]), .a_i(s15_cosine_i), .b_i(s15_cosine),
    .p_o(s15_double));

  rc_mul_held #(.AW(ColourBits), .BW(ValueBits), .Signed(1'b0)) u_lit (
    .clk_i, .phase_i(phase_i[15*Every +: Every]), .a_i(s15_diffuse), .b_i(s15_cosine_i),
    .p_o(s15_matte));

  rc_mul_held #(.AW(ColourBits), .BW(ValueBits), .Signed(1'b0)) u_gloss (
    .clk_i, .phase_i(phase_i[24*Every +: Every]), .a_i(s24_highlight), .b_i(s24_phong),
    .p_o(s24_gloss));

  always_ff @(posedge clk_i) begin
    if (valid_i[15]) begin
      s16_double_q <= {s15_double, 1'b0};
      s16_mirror_q <= s15_mirror_i;
      s16_matte_q  <= s15_matte;
      s16_albedo   <= s15_albedo;
    end
    if (valid_i[16])
      s17_phong_q <= s16_phong[20] ? '0 : s16_phong[19:16] != '0 ? rc_pkg::ValueOne
                   : {1'b0, s16_phong[15:0]};
    if (valid_i[24]) s25_gloss_q <= s24_gloss;
  end

  rc_power u_power (
    .clk_i, .valid_i(Every == 1 ? valid_i[17] : phase_i[17*Every]), .c_i(s17_phong_q),
    .n_i(s17_shine), .power_o(s24_phong));

  assign s25_rounded = s25_gloss_q + GlossHalf;

  // s26: matte and gloss. s28: both in the light's colour, U1.16.
  logic [3*ValueBits-1:0] s17_matte, s25_matte;

  rc_stage_delay #(.Width(3 * ValueBits), .Stages(8)) u_matte (
    .clk_i, .rst_ni, .enter_i(valid_i[17]), .leave_i(valid_i[25]), .data_i(s17_matte),
    .data_o(s25_matte));

  logic [3*43-1:0] s16_product;
  logic [3*52-1:0] s26_product;
  logic [3*18-1:0] s26_lit;

  rc_mul_held #(.AW(30), .BW(13), .Signed(1'b0), .Products(3)) u_matte_products (
    .clk_i, .phase_i(phase_i[16*Every +: Every]), .a_i({3{s16_matte_q}}), .b_i(s16_albedo),
    .p_o(s16_product));

  rc_mul_held #(.AW(18), .BW(34), .Signed(1'b0), .Products(3)) u_share_products (
    .clk_i, .phase_i(phase_i[26*Every +: Every]), .a_i(s26_lit), .b_i(s26_strength),
    .p_o(s26_product));

  for (genvar k = 0; k < 3; k++) begin : gen_channel
    logic [42:0] s17_matte_q, s17_rounded;
    logic [17:0] s26_lit_q;
    logic [51:0] s27_share_q;
    logic [52:0] s27_rounded;
    logic [ValueBits-1:0] s28_share_q;

    assign s26_lit[k*18 +: 18] = s26_lit_q;
    assign s17_rounded = s17_matte_q + MatteHalf;
    assign s17_matte[k*ValueBits +: ValueBits] = s17_rounded[40:24];
    assign s27_rounded = {1'b0, s27_share_q} + ShareHalf;

    always_ff @(posedge clk_i) begin
      if (valid_i[16]) s17_matte_q <= s16_product[k*43 +: 43];
      if (valid_i[25])
        s26_lit_q <= {1'b0, s25_matte[k*ValueBits +: ValueBits]} + {1'b0, s25_rounded[28:12]};
      if (valid_i[26]) s27_share_q <= s26_product[k*52 +: 52];
      // If a pass stays long, rc_pass_end reads the share at the end of s27.
      if (rc_pkg::PassCut != 0 || valid_i[27])
        s28_share_q <= s27_rounded[52:44] != '0 ? rc_pkg::ValueOne : {1'b0, s27_rounded[43:28]};
    end

    assign s28_share_o[k*ValueBits +: ValueBits] = s28_share_q;

    logic unused;
    assign unused = ^{s17_rounded[42:41], s17_rounded[23:0], s27_rounded[27:0]};
  end

  logic unused;
  assign unused = ^{frame_i, s0_state_i, s1_place_q, s16_rounded[15:0], s25_rounded[29],
                    s25_rounded[11:0], valid_i, phase_i};
endmodule
`default_nettype wire

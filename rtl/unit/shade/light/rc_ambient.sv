// The colour of a surface at the hit, and the contribution of ambient light. On a textured surface
// this contribution is 0 until the texture's colour arrives; the pass *texture* multiplies the
// colour. Part of rc_surf, which has the valid bits. The registers of s6 hold the colour, and the
// registers of s7 the light. Model: model/unit/shade/surface/surf.hpp.
`default_nettype none
module rc_ambient #(
  localparam int unsigned ValueBits  = rc_pkg::ValueBits,
  localparam int unsigned ColourBits = rc_pkg::ColourBits,
  localparam int unsigned Every      = rc_pkg::ShadeInterval
) (
  input  logic             clk_i,
  input  logic [6:0]       valid_i,
  input  logic [7*Every-1:0] phase_i,   // the cycle of each stage
  input  rc_pkg::surface_t        s0_surface_i,
  input  logic [ValueBits-1:0]    s0_weight_i,
  input  logic                    s0_odd_i,   // odd square of a checker
  input  logic                    s0_ends_i,  // beyond the range in which squares are distinct
  // The pass of a texture's colour: the surface's colour so far, its ambient share, the texture's
  input  logic                    s0_texture_i,
  input  logic [3*ColourBits-1:0] s0_albedo_i,
  input  logic [ColourBits-1:0]   s0_share_i,
  input  logic [3*ColourBits-1:0] s0_texel_i,
  output logic [3*ColourBits-1:0] s6_albedo_o,
  output logic [3*ValueBits-1:0]  s7_ambient_o
);

  logic                    s0_checkered, s5_checkered, s5_ends, s5_odd;
  logic [3*ColourBits-1:0] s0_colour, s0_other, s5_colour, s5_other;
  logic [ValueBits+ColourBits-1:0] s0_weighted, s6_weighted;

  assign s0_checkered = s0_surface_i.checkered && !s0_texture_i;
  assign s0_other     = s0_surface_i.other;

  // The ray's weight times the ambient share.
  logic [ColourBits-1:0] s0_ambient;

  if (rc_pkg::HasTextures) begin : gen_texture
    localparam int unsigned TintW = 2 * ColourBits;
    logic [3*TintW-1:0]      tint;
    logic [3*ColourBits-1:0] tinted, plain;

    rc_mul_held #(.AW(ColourBits), .BW(ColourBits), .Signed(1'b0), .Products(3)) u_tint (
      .clk_i, .phase_i(phase_i[Every-1:0]), .a_i(s0_albedo_i), .b_i(s0_texel_i), .p_o(tint));

    for (genvar k = 0; k < 3; k++) begin : gen_tinted
      logic [TintW-1:0] rounded;

      assign rounded = tint[k*TintW +: TintW] + TintW'(1 << (rc_pkg::ShareBits - 1));
      assign tinted[k*ColourBits +: ColourBits] = rounded[rc_pkg::ShareBits +: ColourBits];

      logic unused;
      assign unused = ^rounded;
    end

    assign plain      = s0_surface_i.colour;
    assign s0_colour  = s0_texture_i ? tinted : plain;
    assign s0_ambient = s0_texture_i ? s0_share_i
                      : s0_surface_i.record != '0 ? '0 : s0_surface_i.ambient;
  end else begin : gen_plain
    assign s0_colour  = s0_surface_i.colour;
    assign s0_ambient = s0_surface_i.ambient;

    logic unused;
    assign unused = ^{s0_albedo_i, s0_share_i, s0_texel_i};
  end

  rc_mul_held #(.AW(ValueBits), .BW(ColourBits), .Signed(1'b0)) u_weigh (
    .clk_i, .phase_i(phase_i[Every-1:0]), .a_i(s0_weight_i), .b_i(s0_ambient), .p_o(s0_weighted));

  rc_shift_register #(.Width(3 + 6 * ColourBits), .Stages(5)) u_colour (
    .clk_i, .enable_i(valid_i[4:0]),
    .data_i({s0_ends_i, s0_odd_i, s0_checkered, s0_colour, s0_other}),
    .data_o({s5_ends, s5_odd, s5_checkered, s5_colour, s5_other}));

  rc_shift_register #(.Width(ValueBits + ColourBits), .Stages(6)) u_weighted (
    .clk_i, .enable_i(valid_i[5:0]), .data_i(s0_weighted), .data_o(s6_weighted));

  localparam int unsigned ProductW = ValueBits + 2 * ColourBits;   // a product
  localparam int unsigned Drop     = 2 * rc_pkg::ShareBits;   // fraction bits that rounding drops
  localparam logic [ProductW-1:0] Half = ProductW'(1) << (Drop - 1);
  logic [3*ProductW-1:0] s6_product;

  rc_mul_held #(.AW(ValueBits + ColourBits), .BW(ColourBits), .Signed(1'b0), .Products(3))
  u_products (
    .clk_i, .phase_i(phase_i[6*Every +: Every]), .a_i({3{s6_weighted}}), .b_i(s6_albedo_o),
    .p_o(s6_product));

  // s6: the albedo; a checker has two colours, and their mean in the distance. s7: albedo times
  // weight.
  for (genvar k = 0; k < 3; k++) begin : gen_channel
    logic [ColourBits-1:0] colour, other;
    logic [ColourBits:0] between;
    logic [ProductW-1:0] s7_ambient_q, rounded;

    assign colour  = s5_colour[k*ColourBits +: ColourBits];
    assign other   = s5_other[k*ColourBits +: ColourBits];
    assign between = {1'b0, colour} + {1'b0, other};

    always_ff @(posedge clk_i) begin
      if (valid_i[5])
        s6_albedo_o[k*ColourBits +: ColourBits] <= !s5_checkered ? colour
                                                 : s5_ends ? between[ColourBits:1]
                                                 : s5_odd ? other : colour;
      if (valid_i[6]) s7_ambient_q <= s6_product[k*ProductW +: ProductW];
    end

    assign rounded = s7_ambient_q + Half;
    assign s7_ambient_o[k*ValueBits +: ValueBits] = rounded[Drop +: ValueBits];

    logic unused;
    assign unused = ^{between[0], rounded[ProductW-1:Drop+ValueBits], rounded[Drop-1:0]};
  end

  logic unused;
  assign unused = ^{s0_surface_i, phase_i};
endmodule
`default_nettype wire

// Computes the colour at a hit from a line of texels: a bilinear filter of four texels in linear
// light, rounded once. Weights of 0 give the nearest texel. Alpha is filtered in the same way.
// Where it is below the cut-off, the triangle has a hole.
//
// s1: the four texels. s2: their intensities. s3: filtered along the rows. s4: filtered along the
// column. Latency TexFilterStages, one hit per cycle, no stall. Model: filter_texels() in
// model/unit/tex/texel.hpp.
`default_nettype none
module rc_texel_filter #(
  localparam int unsigned RayBits = rc_pkg::RayBits
) (
  input  logic                        clk_i,
  input  logic                        rst_ni,
  input  logic                        valid_i,
  input  logic [RayBits-1:0]          ray_i,
  input  logic [rc_pkg::LineBits-1:0] line_i,
  input  rc_pkg::texel_place_t        place_i,
  output logic                        valid_o,
  output rc_pkg::tex_rsp_t            rsp_o
);
  localparam int unsigned Stages     = rc_pkg::TexFilterStages;
  localparam int unsigned ColourBits = rc_pkg::ColourBits;
  localparam int unsigned Frac       = rc_pkg::TexelFrac;
  localparam bit          Wide       = rc_pkg::Texels == rc_pkg::TexelsRgb888;
  localparam int unsigned TexelW     = Wide ? 32 : 17;
  localparam int unsigned RowTexels  = 5;              // of a line: tile and border
  localparam int unsigned Rows       = Wide ? 3 : 5;
  localparam int unsigned RowW       = RowTexels * TexelW;
  localparam int unsigned AlongW     = ColourBits + Frac;       // filtered along a row
  localparam int unsigned SumW       = ColourBits + 2 * Frac;   // along both

  if (Stages != 4) begin : gen_refuse
    $error("rc_texel_filter has 4 stages");
  end

  logic [Stages:1] valid_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) valid_q <= '0;
    else         valid_q <= {valid_q[Stages-1:1], valid_i};
  end

  assign valid_o = valid_q[Stages];

  logic [RayBits-1:0] ray;

  rc_shift_register #(.Width(RayBits), .Stages(Stages)) u_ray (
    .clk_i, .enable_i({valid_q[Stages-1:1], valid_i}), .data_i(ray_i), .data_o(ray));

  // ---- s1: the texels: above left, above right, below left, below right.
  logic [4*TexelW-1:0] s0_texels, s1_texels_q;
  logic [2*Frac-1:0]   s0_weights, s2_weights;
  logic [Frac-1:0]     s2_weight_x, s2_weight_y, s3_weight_y_q;

  for (genvar i = 0; i < 2; i++) begin : gen_row
    logic [RowW-1:0] row;

    always_comb begin
      row = line_i[i*RowW +: RowW];
      for (int k = 1; k + 1 < Rows; k++)
        if (place_i.y == 2'(k)) row = line_i[(k+i)*RowW +: RowW];
    end

    for (genvar j = 0; j < 2; j++) begin : gen_texel
      always_comb begin
        s0_texels[(2*i+j)*TexelW +: TexelW] = row[j*TexelW +: TexelW];
        for (int k = 1; k + 1 < RowTexels; k++)
          if (place_i.x == 2'(k)) s0_texels[(2*i+j)*TexelW +: TexelW] = row[(k+j)*TexelW +: TexelW];
      end
    end
  end

  assign s0_weights = {place_i.weight_x, place_i.weight_y};

  rc_shift_register #(.Width(2 * Frac), .Stages(2)) u_weights (
    .clk_i, .enable_i({valid_q[1], valid_i}), .data_i(s0_weights), .data_o(s2_weights));

  assign {s2_weight_x, s2_weight_y} = s2_weights;

  always_ff @(posedge clk_i) begin
    if (valid_i)    s1_texels_q   <= s0_texels;
    if (valid_q[2]) s3_weight_y_q <= s2_weight_y;
  end

  // ---- The channels: red in the highest bits of a texel, then green, blue, alpha.
  // The weights are those of the right and of the lower texels.
  logic [3*ColourBits-1:0] colour;

  for (genvar k = 0; k < 3; k++) begin : gen_channel
    logic [4*ColourBits-1:0] s2_value;
    logic [2*AlongW-1:0]     s3_along_q;
    logic [SumW-1:0]         s3_value, s3_sum;
    logic [ColourBits-1:0]   s4_colour_q;

    for (genvar i = 0; i < 4; i++) begin : gen_code
      logic [TexelW-1:0]     texel;
      logic [7:0]            code;
      // Each texel's code reads its own copy of the table, in block RAM.
      logic [ColourBits-1:0] table_mem [256];
      logic [ColourBits-1:0] value_q;
      initial for (int c = 0; c < 256; c++)
        table_mem[c] = rc_pkg::SrgbTable[c*ColourBits +: ColourBits];

      assign texel = s1_texels_q[i*TexelW +: TexelW];
      if (Wide) begin : gen_wide
        assign code = texel[24-8*k +: 8];
      end else if (k == 1) begin : gen_green
        assign code = {texel[11:6], texel[11:10]};
      end else begin : gen_red_or_blue
        localparam int unsigned At = k == 0 ? 12 : 1;
        assign code = {texel[At +: 5], texel[At+2 +: 3]};
      end

      always_ff @(posedge clk_i) if (valid_q[1]) value_q <= table_mem[code];
      assign s2_value[i*ColourBits +: ColourBits] = value_q;

      logic unused;
      assign unused = ^texel;
    end

    for (genvar i = 0; i < 2; i++) begin : gen_along
      logic [AlongW-1:0] s2_along;

      rc_lerp #(.Width(ColourBits), .Frac(Frac)) u_lerp (
        .a_i(s2_value[2*i*ColourBits +: ColourBits]),
        .b_i(s2_value[(2*i+1)*ColourBits +: ColourBits]),
        .weight_i(s2_weight_x), .value_o(s2_along));

      always_ff @(posedge clk_i) if (valid_q[2]) s3_along_q[i*AlongW +: AlongW] <= s2_along;
    end

    rc_lerp #(.Width(AlongW), .Frac(Frac)) u_lerp (
      .a_i(s3_along_q[0 +: AlongW]), .b_i(s3_along_q[AlongW +: AlongW]),
      .weight_i(s3_weight_y_q), .value_o(s3_value));

    assign s3_sum = s3_value + SumW'(1 << (2 * Frac - 1));

    always_ff @(posedge clk_i) if (valid_q[3]) s4_colour_q <= s3_sum[2*Frac +: ColourBits];

    assign colour[k*ColourBits +: ColourBits] = s4_colour_q;

    logic unused;
    assign unused = ^s3_sum;
  end

  // ---- Alpha. It is compared in s4, without rounding.
  localparam int unsigned AlphaW = 8 + 2 * Frac;   // filtered along both
  logic [31:0]           s2_alpha_q;
  logic [2*(8+Frac)-1:0] s3_alpha_q;
  logic [AlphaW-1:0]     s3_alpha;
  logic [7:0]            s3_cutoff;
  logic                  s4_hole_q;

  rc_shift_register #(.Width(8), .Stages(3)) u_cutoff (
    .clk_i, .enable_i({valid_q[2:1], valid_i}), .data_i(place_i.cutoff), .data_o(s3_cutoff));

  for (genvar i = 0; i < 4; i++) begin : gen_alpha
    always_ff @(posedge clk_i)
      if (valid_q[1])
        s2_alpha_q[i*8 +: 8] <= Wide ? s1_texels_q[i*TexelW +: 8] : {8{s1_texels_q[i*TexelW]}};
  end

  for (genvar i = 0; i < 2; i++) begin : gen_alpha_along
    logic [7+Frac:0] s2_along;

    rc_lerp #(.Width(8), .Frac(Frac)) u_lerp (
      .a_i(s2_alpha_q[2*i*8 +: 8]), .b_i(s2_alpha_q[(2*i+1)*8 +: 8]),
      .weight_i(s2_weight_x), .value_o(s2_along));

    always_ff @(posedge clk_i) if (valid_q[2]) s3_alpha_q[i*(8+Frac) +: 8+Frac] <= s2_along;
  end

  rc_lerp #(.Width(8 + Frac), .Frac(Frac)) u_alpha_lerp (
    .a_i(s3_alpha_q[0 +: 8+Frac]), .b_i(s3_alpha_q[8+Frac +: 8+Frac]),
    .weight_i(s3_weight_y_q), .value_o(s3_alpha));

  always_ff @(posedge clk_i)
    if (valid_q[3]) s4_hole_q <= s3_alpha < {s3_cutoff, {(2*Frac){1'b0}}};

  assign rsp_o.ray    = ray;
  assign rsp_o.hole   = s4_hole_q;
  assign rsp_o.colour = colour;

  logic unused;
  assign unused = ^line_i;
endmodule
`default_nettype wire

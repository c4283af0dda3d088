// Computes the line of a hit's texels, and their place in this line, from the hit and its texture
// record.
//
// s1: differences of the corners' coordinates, logarithms. s2: products with u and v. s3: the
// coordinates, and the level. s4: coordinates within the picture. s5: in texels of the level. s6:
// tile and place. s7: address.
//
// Latency TexAddressStages, one hit per cycle, no stall. Model: texel_place() in
// model/unit/tex/texel.hpp.
`default_nettype none
module rc_texel_address #(
  localparam int unsigned RayBits  = rc_pkg::RayBits,
  localparam int unsigned AddrBits = rc_pkg::AddrBits,
  localparam int unsigned HitW     = rc_pkg::TexReqW - RayBits - AddrBits
) (
  input  logic                        clk_i,
  input  logic                        rst_ni,
  input  logic                        valid_i,
  input  logic [RayBits-1:0]          ray_i,
  input  rc_pkg::frame_t              frame_i,
  input  logic [HitW-1:0]             hit_i,    // rc_pkg::tex_req_t from scale or path on
  input  logic [rc_pkg::LineBits-1:0] line_i,   // the record, in its lowest bits
  output logic                        valid_o,
  output logic [RayBits-1:0]          ray_o,
  output logic [AddrBits-1:0]         line_o,
  output rc_pkg::texel_place_t        place_o
);
  localparam int unsigned Stages    = rc_pkg::TexAddressStages;
  localparam int unsigned CoordBits = rc_pkg::CoordinateBits;
  localparam int unsigned Frac      = rc_pkg::CoordinateFrac;   // of a coordinate; one is a picture
  localparam int unsigned TexelFrac = rc_pkg::TexelFrac;
  localparam int unsigned SideBits  = rc_pkg::SideBits;
  localparam int unsigned UvBits    = rc_pkg::UvBits;
  localparam int unsigned PathBits  = rc_pkg::PathBits;
  localparam int unsigned ValueBits = rc_pkg::ValueBits;
  localparam int unsigned LevelBits = rc_pkg::LevelBits;
  localparam int unsigned LevelFrac = rc_pkg::LevelFrac;
  localparam int unsigned DiffW     = CoordBits + 1;
  localparam int unsigned ProductW  = DiffW + UvBits + 1;
  // In a chip with planes u and v are signed and have PlaneBits more whole bits.
  localparam bit          Planes    = rc_pkg::Planes;
  localparam int unsigned SumW      = CoordBits + 3 + (Planes ? rc_pkg::PlaneBits : 0);
  localparam int unsigned TexelW    = Frac;             // a coordinate in texels: 12.8 bits
  localparam int unsigned LogW      = 5 + LevelFrac;    // logarithm of a number of up to 32 bits
  localparam int unsigned LevelSumW = LevelBits + 3;
  localparam bit          Wide      = rc_pkg::Texels == rc_pkg::TexelsRgb888;
  // Logarithms of a tile's sides.
  localparam logic [SideBits-1:0] TileX = 2;
  localparam logic [SideBits-1:0] TileY = Wide ? 1 : 2;

  if (Stages != 7 || Frac != TexelFrac + 12) begin : gen_refuse
    $error("rc_texel_address has 7 stages, and sides of at most 2^12 texels");
  end

  logic [Stages:1] valid_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) valid_q <= '0;
    else         valid_q <= {valid_q[Stages-1:1], valid_i};
  end

  assign valid_o = valid_q[Stages];

  rc_shift_register #(.Width(RayBits), .Stages(Stages)) u_ray (
    .clk_i, .enable_i({valid_q[Stages-1:1], valid_i}), .data_i(ray_i), .data_o(ray_o));

  // ---- s0: the record.
  rc_pkg::tex_record_t                  s0;
  logic signed [LevelBits-1:0]          s0_density;
  logic [PathBits-1:0]                  s0_path;
  logic [ValueBits-1:0]                 s0_cosine;
  logic [UvBits-1:0]                    s0_u, s0_v;
  logic [3*CoordBits-1:0]               s0_s, s0_t;
  logic [rc_pkg::TexRecordW-1:0]        s0_record;
  logic [rc_pkg::LineBits-rc_pkg::TexRecordW-1:0] beyond;

  assign {beyond, s0_record}                = line_i;
  assign s0                                 = s0_record;

  // With two levels the density refers to mesh steps; the hit carries the instance's scale.
  logic signed [LevelBits:0] s0_dense;

  if (rc_pkg::HasHomes) begin : gen_scale
    logic signed [LevelBits-1:0] s0_scale;

    assign {s0_scale, s0_path, s0_cosine, s0_u, s0_v} = hit_i;
    assign s0_dense = (LevelBits+1)'(s0_density) + (LevelBits+1)'(s0_scale);
  end else begin : gen_one_scale
    assign {s0_path, s0_cosine, s0_u, s0_v} = hit_i;
    assign s0_dense = (LevelBits+1)'(s0_density);
  end

  assign s0_s                               = s0.s;
  assign s0_t                               = s0.t;

  // The fields of the record for later stages.
  logic [2*SideBits-1:0]        s0_sides, s3_sides, s5_sides;   // width, height
  logic [3:0]                   s0_wraps, s3_wraps, s4_wraps;   // of s, of t
  logic [SideBits-1:0]          s3_width, s3_height, s5_width, s5_height, s5_last;
  logic                         s4_nearest, s5_nearest;
  logic [7:0]                   s5_cutoff;
  logic [AddrBits-1:0]          s5_base;

  assign s0_sides = {s0.log_width, s0.log_height};
  assign s0_wraps = {s0.wrap_s, s0.wrap_t};

  rc_shift_register #(.Width(2 * SideBits + 4), .Stages(3)) u_kept_3 (
    .clk_i, .enable_i({valid_q[2:1], valid_i}), .data_i({s0_sides, s0_wraps}),
    .data_o({s3_sides, s3_wraps}));
  rc_shift_register #(.Width(4), .Stages(1)) u_wraps_4 (
    .clk_i, .enable_i(valid_q[3]), .data_i(s3_wraps), .data_o(s4_wraps));
  rc_shift_register #(.Width(1), .Stages(4)) u_nearest_4 (
    .clk_i, .enable_i({valid_q[3:1], valid_i}), .data_i(s0.nearest), .data_o(s4_nearest));
  rc_shift_register #(.Width(2 * SideBits), .Stages(2)) u_sides_5 (
    .clk_i, .enable_i(valid_q[4:3]), .data_i(s3_sides), .data_o(s5_sides));
  rc_shift_register #(.Width(1), .Stages(1)) u_nearest_5 (
    .clk_i, .enable_i(valid_q[4]), .data_i(s4_nearest), .data_o(s5_nearest));
  rc_shift_register #(.Width(AddrBits + SideBits + 8), .Stages(5)) u_base (
    .clk_i, .enable_i({valid_q[4:1], valid_i}), .data_i({s0.base, s0.last_level, s0.cutoff}),
    .data_o({s5_base, s5_last, s5_cutoff}));

  assign {s3_width, s3_height} = s3_sides;
  assign {s5_width, s5_height} = s5_sides;

  // ---- s1 to s3: the level.
  logic [LogW-1:0]               s0_log_path, s0_log_cosine, s1_log_path_q, s1_log_cosine_q;
  logic signed [LevelBits-1:0]   s0_spread;
  logic signed [LevelBits:0]     s1_density_q;
  logic signed [LevelSumW-1:0]   s1_slant, s2_level_q, s2_rounded;
  logic [SideBits-1:0]           s0_last, s2_last_q, s3_level_q;
  logic                          s2_ends;

  rc_log #(.Width(PathBits)) u_log_path (.x_i(s0_path), .log_o(s0_log_path));
  rc_log #(.Width(ValueBits)) u_log_cosine (.x_i(s0_cosine), .log_o(s0_log_cosine));

  assign s0_density = s0.density;
  assign s0_last    = s0_path == '0 ? '0 : s0.last_level;   // a path of 0 selects level 0

  rc_pkg::shade_frame_t      shade_frame;   // lowest in the frame
  logic [rc_pkg::FrameW-1:0] frame_flat;

  assign frame_flat  = frame_i;
  assign shade_frame = rc_pkg::ShadeFrameW'(frame_flat);

  if (rc_pkg::HasTextures) begin : gen_spread   // tools also parse a chip without textures
    logic signed [LevelBits-1:0] spread_q;


    always_ff @(posedge clk_i) spread_q <= shade_frame.spread;   // stable while rays are in flight

    assign s0_spread = spread_q;
  end else begin : gen_no_spread
    assign s0_spread = '0;
  end

  // Half the logarithm of 1 / cosine: at most 8.
  localparam logic [LogW-1:0] LogOfOne = LogW'(rc_pkg::UnitBits << LevelFrac);
  logic [LogW-1:0] s1_angle;

  assign s1_angle = s1_log_cosine_q < LogOfOne ? LogOfOne - s1_log_cosine_q : '0;
  assign s1_slant = LevelSumW'(s1_angle[LogW-1:1]);

  assign s2_rounded = s2_level_q + LevelSumW'(1 << (LevelFrac - 1));

  always_ff @(posedge clk_i) begin
    if (valid_i) begin
      s1_log_path_q   <= s0_log_path;
      s1_log_cosine_q <= s0_log_cosine;
      s1_density_q    <= s0_dense;
    end
    if (valid_q[1])
      s2_level_q <= LevelSumW'(s1_density_q) + LevelSumW'(s0_spread)
                  + $signed(LevelSumW'(s1_log_path_q)) + s1_slant;
    if (valid_q[2])
      s3_level_q <= s2_ends ? s2_last_q : s2_rounded < 0 ? '0
                  : (s2_rounded >>> LevelFrac) > $signed(LevelSumW'(s2_last_q)) ? s2_last_q
                  : s2_rounded[LevelFrac +: SideBits];
  end

  // Where a plane's u or v is saturated, the level is the last one.
  if (Planes) begin : gen_ends
    logic s0_ends;

    assign s0_ends = s0_u[UvBits-2:0] == {(UvBits-1){!s0_u[UvBits-1]}}
                  || s0_v[UvBits-2:0] == {(UvBits-1){!s0_v[UvBits-1]}};

    rc_shift_register #(.Width(1), .Stages(2)) u_ends (
      .clk_i, .enable_i({valid_q[1], valid_i}), .data_i(s0_ends), .data_o(s2_ends));
  end else begin : gen_no_ends
    assign s2_ends = 1'b0;
  end

  rc_shift_register #(.Width(SideBits), .Stages(2)) u_last (
    .clk_i, .enable_i({valid_q[1], valid_i}), .data_i(s0_last), .data_o(s2_last_q));

  // ---- The two coordinates: s, then t.
  logic [UvBits-1:0]   s1_u_q, s1_v_q;
  logic [SideBits-1:0] s3_log_width, s3_log_height, s4_log_width_q, s4_log_height_q;
  logic [SideBits-1:0] s4_level_q, s5_level_q;
  logic [SideBits-1:0] s5_log_width_q, s5_log_height_q;
  logic [TexelW-1:0]   s5_x_q, s5_y_q;

  assign s3_log_width  = s3_width > s3_level_q ? s3_width - s3_level_q : '0;
  assign s3_log_height = s3_height > s3_level_q ? s3_height - s3_level_q : '0;

  always_ff @(posedge clk_i) begin
    if (valid_i) begin
      s1_u_q <= s0_u;
      s1_v_q <= s0_v;
    end
    if (valid_q[3]) begin
      s4_log_width_q  <= s3_log_width;
      s4_log_height_q <= s3_log_height;
      s4_level_q      <= s3_level_q;
    end
    if (valid_q[4]) begin
      s5_log_width_q  <= s4_log_width_q;
      s5_log_height_q <= s4_log_height_q;
      s5_level_q      <= s4_level_q;
    end
  end

  for (genvar i = 0; i < 2; i++) begin : gen_coordinate
    logic [3*CoordBits-1:0]     corners;
    logic signed [DiffW-1:0]    s1_along_u_q, s1_along_v_q;
    logic signed [CoordBits-1:0] s0_corner, s2_corner;
    logic signed [ProductW-1:0] s2_u_q, s2_v_q;
    logic signed [ProductW:0]   s2_sum;
    logic signed [SumW-1:0]     s3_x_q;
    logic [1:0]                 s3_wrap, s4_wrap;
    logic [Frac-1:0]            s3_mirrored, s3_clamped, s3_within, s4_within_q;
    logic [SideBits-1:0]        s4_log_side;
    logic [TexelW-1:0]          s4_place, s4_moved, s4_mask, s4_x;
    logic                       s4_below;

    assign corners   = i == 0 ? s0_s : s0_t;
    assign s0_corner = corners[0 +: CoordBits];

    rc_shift_register #(.Width(CoordBits), .Stages(2)) u_corner (
      .clk_i, .enable_i({valid_q[1], valid_i}), .data_i(s0_corner), .data_o(s2_corner));

    assign s2_sum = (ProductW+1)'(s2_u_q) + (ProductW+1)'(s2_v_q);

    // Within the picture, by the wrap mode.
    assign s3_wrap     = i == 0 ? s3_wraps[3:2] : s3_wraps[1:0];
    assign s3_mirrored = s3_x_q[Frac] ? ~s3_x_q[Frac-1:0] : s3_x_q[Frac-1:0];
    assign s3_clamped  = s3_x_q < 0 ? '0 : s3_x_q[SumW-2:Frac] != '0 ? '1 : s3_x_q[Frac-1:0];
    assign s3_within   = s3_wrap == rc_pkg::WrapRepeat ? s3_x_q[Frac-1:0]
                       : s3_wrap == rc_pkg::WrapMirror ? s3_mirrored : s3_clamped;

    // In texels, and for a bilinear filter half a texel less.
    assign s4_wrap     = i == 0 ? s4_wraps[3:2] : s4_wraps[1:0];
    assign s4_log_side = i == 0 ? s4_log_width_q : s4_log_height_q;
    assign s4_place    = s4_within_q >> (SideBits'(12) - s4_log_side);
    assign s4_mask     = ~({TexelW{1'b1}} << (5'(s4_log_side) + 5'(TexelFrac)));
    assign {s4_below, s4_moved} = {1'b0, s4_place} - (TexelW+1)'(1 << (TexelFrac - 1));
    assign s4_x        = s4_nearest ? s4_place
                       : !s4_below ? s4_moved
                       : s4_wrap == rc_pkg::WrapRepeat ? s4_moved & s4_mask : '0;

    always_ff @(posedge clk_i) begin
      if (valid_i) begin
        s1_along_u_q <= DiffW'($signed(corners[CoordBits +: CoordBits])) - DiffW'(s0_corner);
        s1_along_v_q <= DiffW'($signed(corners[2*CoordBits +: CoordBits])) - DiffW'(s0_corner);
      end
      if (valid_q[1]) begin
        s2_u_q <= s1_along_u_q * $signed({Planes && s1_u_q[UvBits-1], s1_u_q});
        s2_v_q <= s1_along_v_q * $signed({Planes && s1_v_q[UvBits-1], s1_v_q});
      end
      if (valid_q[2]) s3_x_q <= SumW'(s2_corner) + SumW'(s2_sum >>> rc_pkg::BaryBits);
      if (valid_q[3]) s4_within_q <= s3_within;
      if (valid_q[4]) begin
        if (i == 0) s5_x_q <= s4_x;
        else        s5_y_q <= s4_x;
      end
    end
  end

  // ---- s6: the tile's number in its level, the level's first line, and the place in the tile.
  logic [11:0]          s5_column, s5_row;
  // Logarithms of the tiles in a row and in a column: of the level, of level 0.
  logic [SideBits-1:0]  s5_tiles_x, s5_tiles_y, s5_all_x, s5_all_y;
  logic [SideBits:0]    s5_lines, s5_all_lines;   // logarithms of lines: of the level, of level 0
  logic [SideBits-1:0]  s5_above;                 // levels that are smaller
  logic [AddrBits-1:0]  s5_tile, s5_offset, s6_tile_q, s6_offset_q, s6_base_q, s7_line_q;
  rc_pkg::texel_place_t s5_place;
  logic [rc_pkg::TexelPlaceW-1:0] s6_place_q, s7_place_q;

  assign s5_column    = s5_x_q[TexelW-1:TexelFrac];
  assign s5_row       = s5_y_q[TexelW-1:TexelFrac];
  assign s5_tiles_x   = s5_log_width_q > TileX ? s5_log_width_q - TileX : '0;
  assign s5_tiles_y   = s5_log_height_q > TileY ? s5_log_height_q - TileY : '0;
  assign s5_all_x     = s5_width > TileX ? s5_width - TileX : '0;
  assign s5_all_y     = s5_height > TileY ? s5_height - TileY : '0;
  assign s5_above     = s5_last - s5_level_q;
  assign s5_lines     = {1'b0, s5_tiles_x} + {1'b0, s5_tiles_y};
  assign s5_all_lines = {1'b0, s5_all_x} + {1'b0, s5_all_y};
  assign s5_tile      = (AddrBits'(s5_row[11:TileY]) << s5_tiles_x)
                      + AddrBits'(s5_column[11:TileX]);
  assign s5_offset    = s5_level_q == '0 ? '0
                      : (AddrBits'(1) << s5_all_lines)
                        + (s5_lines != '0 ? (AddrBits'(1) << s5_lines) + AddrBits'(2)
                                          : AddrBits'(s5_above));

  assign s5_place.x        = s5_column[TileX-1:0];
  assign s5_place.y        = 2'(s5_row[TileY-1:0]);
  assign s5_place.weight_x = s5_nearest ? '0 : s5_x_q[TexelFrac-1:0];
  assign s5_place.weight_y = s5_nearest ? '0 : s5_y_q[TexelFrac-1:0];
  assign s5_place.cutoff   = s5_cutoff;

  always_ff @(posedge clk_i) begin
    if (valid_q[5]) begin
      s6_tile_q   <= s5_tile;
      s6_offset_q <= s5_offset;
      s6_base_q   <= s5_base;
      s6_place_q  <= s5_place;
    end
    if (valid_q[6]) begin
      s7_line_q  <= s6_base_q + s6_offset_q + s6_tile_q;
      s7_place_q <= s6_place_q;
    end
  end

  assign line_o  = s7_line_q;
  assign place_o = s7_place_q;

  logic unused;
  assign unused = ^{beyond, s0_record, s1_angle, s2_rounded, frame_i,
                    shade_frame, frame_flat};
endmodule
`default_nettype wire

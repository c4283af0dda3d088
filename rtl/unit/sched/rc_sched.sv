// Assigns the pixels of its tiles, in Morton order, to free contexts. A pixel comes back when its
// ray is done or, if the chip shades, when its colour is complete; sched then adds its position.
// Holds two tiles.
//
// A pixel of a tile that lies outside the picture costs one idle cycle. After reset, contexts
// 0..Contexts-1 are used first; then the context that has been free longest. A new frame drops the
// rest of the old tiles: pixels outside the old picture.
//
// A tile's first pixel is offered one cycle after the tile came. A hit passes through in the same
// cycle and frees its context. Model: model/unit/sched/sched.hpp.
`default_nettype none
module rc_sched (
  input  logic             clk_i,
  input  logic             rst_ni,
  // From the host
  input  logic             start_i,
  input  rc_pkg::frame_t   frame_i,
  // From dispatch
  output logic             tile_ready_o,
  input  logic             tile_fires_i,
  input  rc_pkg::tile_t    tile_i,
  // To raygen
  output logic             slot_valid_o,
  input  logic             slot_ready_i,
  output rc_pkg::slot_t    slot_o,
  // From list, or shade
  input  logic             pixel_valid_i,
  output logic             pixel_ready_o,
  input  rc_pkg::pixel_t   pixel_i,
  // Picture
  output logic             hit_valid_o,
  input  logic             hit_ready_i,
  output rc_pkg::hit_t     hit_o,
  // What it did: rc_pkg::sched_cause_e
  output logic [rc_pkg::CauseBits-1:0] cause_o
);
  localparam int unsigned RayBits   = rc_pkg::RayBits;
  localparam int unsigned PixelBits = rc_pkg::PixelBits;
  localparam int unsigned Contexts  = rc_pkg::Contexts;
  localparam int unsigned TileBits  = rc_pkg::TileBits;
  localparam int unsigned InTileW   = TileBits == 0 ? 1 : 2 * TileBits;
  localparam logic [rc_pkg::CauseBits-1:0] Stalled =
      rc_pkg::IsStream ? rc_pkg::SchedStalledStream : rc_pkg::SchedStalledRaygen;

  // ---- The current pixel. at_q counts through the tile; its even bits are x, its odd bits are y.
  // The tile's position relative to the picture, inside or on the edge, is computed when the tile
  // comes. The pixel's position is computed one pixel ahead, because many cells depend on it.
  logic               tile_valid, last, in_frame, at_hand, pass, give;
  logic               tile_begins, begins;   // a tile's first pixel lies inside
  rc_pkg::tile_t      tile;
  logic [InTileW-1:0] at_q;

  // Where a tile lies on each axis: inside the picture, or at its last pixels. First the tile that
  // comes, then the current one.
  logic tile_x_inside, tile_x_at_edge, tile_y_inside, tile_y_at_edge;
  logic x_inside, x_at_edge, y_inside, y_at_edge;

  rc_fifo #(.Width(rc_pkg::TileW + 5), .Depth(2)) u_tiles (
    .clk_i, .rst_ni(rst_ni && !start_i), .valid_i(tile_fires_i), .ready_o(tile_ready_o),
    .data_i({tile_i, tile_x_inside, tile_x_at_edge, tile_y_inside, tile_y_at_edge, tile_begins}),
    .valid_o(tile_valid), .ready_i((give || pass) && last),
    .data_o({tile, x_inside, x_at_edge, y_inside, y_at_edge, begins}));

  logic [PixelBits-1:0] x, y;
  logic [InTileW-1:0]   next;      // the next pixel's place in the tile
  logic                 first_q, inside_q, next_inside;

  assign last = TileBits == 0 || at_q == '1;
  assign next = TileBits == 0 ? '0 : at_q + 1'b1;

  if (rc_pkg::IsStream) begin : gen_rays   // a tile holds rays in sequence; {y, x}: number
    logic [2*PixelBits-1:0] number, next_number, first_number;

    if (TileBits == 0) begin : gen_single
      assign number       = {tile.y, tile.x};
      assign next_number  = number;
      assign first_number = {tile_i.y, tile_i.x};
    end else begin : gen_group
      assign number       = {tile.y, tile.x, at_q};
      assign next_number  = {tile.y, tile.x, next};
      assign first_number = {tile_i.y, tile_i.x, {(2*TileBits){1'b0}}};
    end

    assign {y, x}      = number;
    assign tile_begins = first_number < frame_i.ray_count;
    assign next_inside = next_number < frame_i.ray_count;
    assign {tile_x_inside, tile_x_at_edge, tile_y_inside, tile_y_at_edge} = '0;

    logic unused;
    assign unused = ^{x_inside, x_at_edge, y_inside, y_at_edge};
  end else begin : gen_pixels
    logic [PixelBits:0] width, height;

    assign width          = frame_i.width;
    assign height         = frame_i.height;
    assign tile_x_inside  = {1'b0, tile_i.x} < width[PixelBits:TileBits];
    assign tile_x_at_edge = {1'b0, tile_i.x} == width[PixelBits:TileBits];
    assign tile_y_inside  = {1'b0, tile_i.y} < height[PixelBits:TileBits];
    assign tile_y_at_edge = {1'b0, tile_i.y} == height[PixelBits:TileBits];

    assign x[PixelBits-1:TileBits] = tile.x;
    assign y[PixelBits-1:TileBits] = tile.y;

    if (TileBits == 0) begin : gen_single
      assign tile_begins = tile_x_inside && tile_y_inside;
      assign next_inside = 1'b0;   // a tile has one pixel

      logic unused;
      assign unused = ^{x_inside, x_at_edge, y_inside, y_at_edge};
    end else begin : gen_morton
      logic [TileBits-1:0] next_x, next_y;

      for (genvar i = 0; i < TileBits; i++) begin : gen_bit
        assign x[i]      = at_q[2*i];
        assign y[i]      = at_q[2*i+1];
        assign next_x[i] = next[2*i];
        assign next_y[i] = next[2*i+1];
      end

      assign tile_begins = (tile_x_inside || (tile_x_at_edge && width[TileBits-1:0] != '0))
                        && (tile_y_inside || (tile_y_at_edge && height[TileBits-1:0] != '0));
      assign next_inside = (x_inside || (x_at_edge && next_x < width[TileBits-1:0]))
                        && (y_inside || (y_at_edge && next_y < height[TileBits-1:0]));
    end
  end

  assign in_frame = first_q ? begins : inside_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni || start_i) first_q <= 1'b1;
    else if (give || pass)  first_q <= last;
    if (give || pass)       inside_q <= next_inside;
  end

  assign at_hand  = tile_valid && in_frame && !start_i;
  assign pass     = tile_valid && !in_frame;

  always_ff @(posedge clk_i) begin
    if (!rst_ni || start_i) at_q <= '0;
    else if (give || pass)  at_q <= last ? '0 : at_q + 1'b1;
  end

  // ---- Its context: a fresh one, or the one that has been free longest.
  logic [RayBits:0]   started_q;  // contexts used so far, 0..Contexts
  logic               fresh, freed, free_valid;
  logic [RayBits-1:0] free_ray, slot_ray;

  assign fresh        = started_q != (RayBits+1)'(Contexts);
  assign slot_valid_o = at_hand && (fresh || free_valid);
  assign slot_ray     = fresh ? started_q[RayBits-1:0] : free_ray;
  assign slot_o.ray   = slot_ray;
  assign slot_o.x     = x;
  assign slot_o.y     = y;
  assign give         = slot_valid_o && slot_ready_i;
  assign freed        = hit_valid_o && hit_ready_i;

  always_ff @(posedge clk_i) begin
    if (!rst_ni)            started_q <= '0;
    else if (give && fresh) started_q <= started_q + 1'b1;
  end

  rc_queue #(.Width(RayBits), .Depth(Contexts)) u_free (
    .clk_i, .rst_ni, .push_i(freed), .data_i(pixel_i.ray),
    .valid_o(free_valid), .pop_i(give && !fresh), .data_o(free_ray));

  // ---- Finished pixels get their position.
  logic [2*PixelBits-1:0] place;

  rc_ram #(.Width(2 * PixelBits), .Depth(Contexts)) u_pixel (
    .clk_i, .write_i(give), .write_addr_i(slot_ray), .write_data_i({x, y}),
    .read_addr_i(pixel_i.ray), .read_data_o(place));

  assign hit_valid_o   = pixel_valid_i;
  assign pixel_ready_o = hit_ready_i;
  assign hit_o         = {place, pixel_i};

  assign cause_o = give ? rc_pkg::SchedBusyWork : slot_valid_o ? Stalled
                 : at_hand ? rc_pkg::SchedStarvedContexts : rc_pkg::SchedStarvedDispatch;

  logic [rc_pkg::FrameW-1:0] frame_flat;
  logic                      unused;
  assign frame_flat = frame_i;
  assign unused     = ^{frame_flat, at_q, next};
endmodule
`default_nettype wire

// Distributes the picture in tiles of 2^TileBits x 2^TileBits pixels, row by row, one tile per
// cycle. The pipelines that have room for a tile get one in turn. With a stream a tile is a group
// of 4^TileBits rays in sequence.
//
// A frame begins in the cycle after start_i. The user holds frame_i until the frame is done. Model:
// model/unit/sched/dispatch.hpp.
`default_nettype none
module rc_dispatch (
  input  logic                         clk_i,
  input  logic                         rst_ni,
  // From the host
  input  logic                         start_i,
  input  rc_pkg::frame_t               frame_i,
  // To the pipelines' sched; tile_ready_i: has room for a tile
  input  logic [rc_pkg::Pipelines-1:0] tile_ready_i,
  output logic [rc_pkg::Pipelines-1:0] tile_fires_o,
  output rc_pkg::tile_t                tile_o,
  // What it did: rc_pkg::dispatch_cause_e
  output logic [rc_pkg::CauseBits-1:0] cause_o
);
  localparam int unsigned Pipelines     = rc_pkg::Pipelines;
  localparam int unsigned PipelineIdW   = Pipelines < 2 ? 1 : $clog2(Pipelines);
  localparam int unsigned TileCoordBits = rc_pkg::TileCoordBits;
  localparam int unsigned SideW         = rc_pkg::PixelBits + 1;  // side of a picture

  // Next tile, and the next pipeline in turn.
  logic [TileCoordBits-1:0] x_q, y_q;
  logic                     more_q;
  logic [PipelineIdW-1:0]   next_q;  // the pipeline that is first in turn

  // Pipeline that gets the tile: the last assignment wins, so the first in turn is tested last.
  logic                   give;
  logic [PipelineIdW-1:0] to;

  always_comb begin
    to = next_q;
    for (int i = Pipelines - 1; i >= 0; i--) begin
      if (tile_ready_i[PipelineIdW'(next_q + PipelineIdW'(i))])
        to = PipelineIdW'(next_q + PipelineIdW'(i));
    end
  end

  assign give         = more_q && tile_ready_i != '0;
  assign tile_fires_o = {{(Pipelines-1){1'b0}}, give} << to;
  assign tile_o.x     = x_q;
  assign tile_o.y     = y_q;
  assign cause_o      = give ? rc_pkg::DispatchBusyWork
                      : more_q ? rc_pkg::DispatchStalledSched : rc_pkg::DispatchStarvedFrame;

  // Position of the next tile.
  logic [TileCoordBits:0] x_after, y_after;
  logic                   last_x, last;

  assign x_after = {1'b0, x_q} + 1'b1;
  assign y_after = {1'b0, y_q} + 1'b1;

  if (rc_pkg::IsStream) begin : gen_rays   // {y_q, x_q} counts groups of 4^TileBits rays
    logic [2*TileCoordBits:0] after;

    assign after  = {1'b0, y_q, x_q} + 1'b1;
    assign last_x = x_q == '1;
    assign last   = {after, {(2*rc_pkg::TileBits){1'b0}}}
                  >= (2*rc_pkg::PixelBits+1)'(frame_i.ray_count);
  end else begin : gen_picture
    logic last_y;

    assign last_x = SideW'(x_after) << rc_pkg::TileBits >= frame_i.width;
    assign last_y = SideW'(y_after) << rc_pkg::TileBits >= frame_i.height;
    assign last   = last_x && last_y;
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      more_q <= 1'b0;
      next_q <= '0;
    end else if (start_i) begin
      more_q <= 1'b1;
    end else if (give) begin
      next_q <= (to + 1'b1) & PipelineIdW'(Pipelines - 1);
      more_q <= !last;
    end
    if (start_i) begin
      x_q <= '0;
      y_q <= '0;
    end else if (give) begin
      x_q <= last_x ? '0 : x_after[TileCoordBits-1:0];
      if (last_x) y_q <= y_after[TileCoordBits-1:0];
    end
  end

  logic [rc_pkg::FrameW-1:0] frame_flat;
  logic                      unused;
  assign frame_flat = frame_i;
  assign unused     = ^{frame_flat, x_after, y_after};
endmodule
`default_nettype wire

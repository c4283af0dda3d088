// Answers to memory: packs the answers of a stream's rays into records, gathers them into lines of
// 64 bytes, and offers each line to memory. It exists only in a chip that writes hits
// (docs/guide/streams.md).
//
// It accepts one answer per cycle. In cycle c of a frame only pipeline c mod Pipelines may send it.
// A line is offered in the cycle after its last record came, and the unit accepts no answer until
// memory has accepted the line. The line with the frame's last record may be partly empty; unused
// places are 0. The user sets start_i as in rc_top.sv. Model: model/unit/hits/hits.hpp.
`default_nettype none
module rc_hits (
  input  logic                                      clk_i,
  input  logic                                      rst_ni,
  // From the host
  input  logic                                      start_i,
  input  rc_pkg::frame_t                            frame_i,
  // From the pipelines
  input  logic [rc_pkg::Pipelines-1:0]              hit_valid_i,
  output logic [rc_pkg::Pipelines-1:0]              hit_ready_o,
  input  logic [rc_pkg::Pipelines*rc_pkg::HitW-1:0] hit_i,
  // To memory
  output logic                                      line_valid_o,
  input  logic                                      line_ready_i,
  output logic [rc_pkg::AddrBits-1:0]               line_addr_o,
  output logic [rc_pkg::LineBits-1:0]               line_o,
  // To the host: one bit for each record of a line that memory accepts
  output logic [rc_pkg::HitsOfLine-1:0]             written_o,
  // What the unit did: rc_pkg::hits_cause_e
  output logic [rc_pkg::CauseBits-1:0]              cause_o
);
  localparam int unsigned Pipelines  = rc_pkg::Pipelines;
  localparam int unsigned HitW       = rc_pkg::HitW;
  localparam int unsigned RecordW    = rc_pkg::LineBits / rc_pkg::HitsOfLine;   // in memory
  localparam int unsigned TurnW      = Pipelines > 1 ? $clog2(Pipelines) : 1;
  localparam int unsigned NumberBits = 2 * rc_pkg::PixelBits;                   // of a ray

  // ---- The pipeline that may send an answer, and its answer.
  logic [TurnW-1:0] turn;
  logic             ready, hit_fires, line_fires;
  logic [HitW-1:0]  hit;   // rc_pkg::hit_t

  for (genvar p = 0; p < Pipelines; p++) begin : gen_ready
    assign hit_ready_o[p] = ready && turn == TurnW'(p);
  end
  assign hit_fires = (hit_valid_i & hit_ready_o) != '0;
  assign hit       = hit_i[turn*HitW +: HitW];

  if (Pipelines > 1) begin : gen_turns
    logic [TurnW-1:0] turn_q;

    always_ff @(posedge clk_i)
      turn_q <= start_i ? '0 : turn_q + 1'b1;   // Pipelines is a power of two
    assign turn = turn_q;
  end else begin : gen_one
    assign turn = '0;
  end

  // ---- The record, and the host's settings. Tools also parse a chip that does not write hits.
  logic [RecordW-1:0]          record;
  logic [rc_pkg::AddrBits-1:0] first_line;
  logic [NumberBits-1:0]       rays;

  if (rc_pkg::WritesHits) begin : gen_record
    assign record = RecordW'({1'b1, hit});   // rc_pkg::hit_record_t
    assign {first_line, rays} = {frame_i.hits, frame_i.ray_count};
  end else begin : gen_none
    assign {record, first_line, rays} = '0;
  end

  // ---- The line, and its address.
  rc_gather #(.Records(rc_pkg::HitsOfLine), .Width(RecordW), .TotalBits(NumberBits)) u_line (
    .clk_i, .rst_ni, .start_i, .total_i(rays), .valid_i(hit_fires), .ready_o(ready),
    .data_i(record), .line_valid_o, .line_ready_i, .line_o, .accepted_o(written_o));

  logic [rc_pkg::AddrBits-1:0] addr_q;

  assign line_fires = line_valid_o && line_ready_i;
  always_ff @(posedge clk_i) begin
    if (start_i)         addr_q <= first_line;
    else if (line_fires) addr_q <= addr_q + 1'b1;
  end

  assign line_addr_o = addr_q;
  assign cause_o     = hit_fires || line_fires ? rc_pkg::HitsBusyWork
                     : line_valid_o            ? rc_pkg::HitsStalledMemory
                                               : rc_pkg::HitsStarvedSched;

  logic [rc_pkg::FrameW-1:0] frame_flat;
  logic                      unused;
  assign frame_flat = frame_i;
  assign unused     = ^{frame_flat, hit};
endmodule
`default_nettype wire

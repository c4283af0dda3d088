// Rays from memory: an rc_cache of the two halves of a memory word, with the context as the id. A
// context that gets the number of a ray from sched requests the ray's record. It exists only in a
// chip whose rays come from a stream (docs/guide/streams.md).
//
// Latency 3 for a hit, one request per cycle. A line of the cache is one burst of the memory.
// rc_cache.sv has the other latencies and the rules for the user. Model: model/mem/cache.hpp with
// stream_cache_shape(), Pipeline::record_addr().
`default_nettype none
module rc_stream (
  input  logic                 clk_i,
  input  logic                 rst_ni,
  // From the host
  input  rc_pkg::frame_t       frame_i,
  // From sched: a context, and the number of its ray
  input  logic                 slot_valid_i,
  output logic                 slot_ready_o,
  input  rc_pkg::slot_t        slot_i,
  // To raygen
  output logic                 record_valid_o,
  input  logic                 record_ready_i,
  output rc_pkg::record_t      record_o,
  // To and from memory
  output logic                 miss_valid_o,
  input  logic                 miss_ready_i,
  output rc_pkg::stream_miss_t miss_o,
  input  logic                 fill_fires_i,
  input  rc_pkg::stream_fill_t fill_i,
  // Whether lines are in flight, and what the cache did: rc_pkg::cache_outcome_e
  output logic                 waits_o,
  output logic [rc_pkg::CauseBits-1:0] outcome_o
);
  localparam int unsigned RayBits  = rc_pkg::RayBits;
  localparam int unsigned AddrBits = rc_pkg::AddrBits;
  localparam int unsigned RayW     = rc_pkg::RecordW - RayBits;      // width of a record in memory
  localparam int unsigned RestW    = rc_pkg::LineBits / 2 - RayW;

  // The half line of the record. The host ensures that the memory holds all rays.
  logic [2*rc_pkg::PixelBits-1:0] number;
  logic [AddrBits:0]              addr;

  assign number = {slot_i.y, slot_i.x};

  if (rc_pkg::IsStream) begin : gen_addr   // tools also parse a chip without streams
    assign addr = {frame_i.rays, 1'b0} + (AddrBits+1)'(number);
  end else begin : gen_none
    assign addr = '0;
  end

  logic [RayW-1:0]  upper, lower;    // a record takes the lowest bits of half a word
  logic [RestW-1:0] beyond_upper, beyond_lower;

  assign {beyond_upper, upper, beyond_lower, lower} = fill_i.line;

  logic               next_fires;   // unused: raygen reads no memory at the next answer's id
  logic [RayBits-1:0] next_ray;

  rc_cache #(
    .IdBits(RayBits), .AddrBits(AddrBits), .Parts(2), .PartW(RayW),
    .Sets(rc_pkg::StreamSets), .Ways(rc_pkg::StreamWays), .Words(rc_pkg::StreamWords),
    .Mshrs(rc_pkg::StreamMshrs), .Queue(rc_pkg::CacheQueue)
  ) u_cache (
    .clk_i, .rst_ni, .req_valid_i(slot_valid_i), .req_ready_o(slot_ready_o),
    .req_i({slot_i.ray, addr}), .rsp_valid_o(record_valid_o), .rsp_ready_i(record_ready_i),
    .rsp_o(record_o), .next_fires_o(next_fires), .next_id_o(next_ray),
    .miss_valid_o, .miss_ready_i, .miss_o, .fill_fires_i, .fill_id_i(fill_i.id),
    .fill_word_i({upper, lower}), .waits_o, .outcome_o);

  logic [rc_pkg::FrameW-1:0] frame_flat;
  logic                      unused;
  assign frame_flat = frame_i;
  assign unused     = ^{beyond_upper, beyond_lower, next_fires, next_ray, frame_flat, number};
endmodule
`default_nettype wire

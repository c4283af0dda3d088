// Cache of surfaces: an rc_cache of the surface's part of a memory word, with the ray as the id. It
// exists only if the chip shades.
//
// Latency 3 for a hit, one request per cycle. rc_cache.sv has the other latencies and the rules for
// the user. Model: model/mem/cache.hpp with surf_cache_shape().
`default_nettype none
module rc_surf_cache (
  input  logic               clk_i,
  input  logic               rst_ni,
  // From and to shade
  input  logic               req_valid_i,
  output logic               req_ready_o,
  input  rc_pkg::surf_req_t  req_i,
  output logic               rsp_valid_o,
  input  logic               rsp_ready_i,
  output rc_pkg::surf_rsp_t  rsp_o,
  // To and from memory
  output logic               miss_valid_o,
  input  logic               miss_ready_i,
  output rc_pkg::surf_miss_t miss_o,
  input  logic               fill_fires_i,
  input  rc_pkg::surf_fill_t fill_i,
  // Whether lines are in flight, and what the cache did: rc_pkg::cache_outcome_e
  output logic               waits_o,
  output logic [rc_pkg::CauseBits-1:0] outcome_o
);
  localparam int unsigned SurfaceW = rc_pkg::SurfaceW;
  logic [SurfaceW-1:0]                      word;     // a surface takes the lowest bits of a word
  logic [rc_pkg::LineBits-SurfaceW-1:0]     beyond;

  assign {beyond, word} = fill_i.line;

  logic                       next_fires;   // unused: shade reads no memory by the next answer
  logic [rc_pkg::RayBits-1:0] next_ray;

  rc_cache #(
    .IdBits(rc_pkg::RayBits), .AddrBits(rc_pkg::AddrBits), .Parts(1), .PartW(SurfaceW),
    .Sets(rc_pkg::SurfSets), .Ways(rc_pkg::SurfWays), .Words(rc_pkg::SurfWords),
    .Mshrs(rc_pkg::SurfMshrs), .Queue(rc_pkg::CacheQueue)
  ) u_cache (
    .clk_i, .rst_ni, .req_valid_i, .req_ready_o, .req_i, .rsp_valid_o, .rsp_ready_i, .rsp_o,
    .next_fires_o(next_fires), .next_id_o(next_ray),
    .miss_valid_o, .miss_ready_i, .miss_o, .fill_fires_i, .fill_id_i(fill_i.id),
    .fill_word_i(word), .waits_o, .outcome_o);

  logic unused;
  assign unused = ^{beyond, next_fires, next_ray};
endmodule
`default_nettype wire

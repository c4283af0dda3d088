// The cache that all pipelines share, between their caches' misses and memory: an rc_cache of whole
// memory words. It exists only if L2Sets is above 0.
//
// Latency 3 for a hit, one request per cycle. rc_cache.sv has the other latencies and the rules for
// the user. Model: model/mem/cache.hpp with l2_shape().
`default_nettype none
module rc_l2 (
  input  logic             clk_i,
  input  logic             rst_ni,
  // From the arbiter
  input  logic             req_valid_i,
  output logic             req_ready_o,
  input  rc_pkg::l2_req_t  req_i,
  // To the pipelines
  output logic             rsp_valid_o,
  input  logic             rsp_ready_i,
  output rc_pkg::l2_rsp_t  rsp_o,
  // To and from memory
  output logic             miss_valid_o,
  input  logic             miss_ready_i,
  output rc_pkg::l2_miss_t miss_o,
  input  logic             fill_fires_i,
  input  rc_pkg::mem_rsp_t fill_i,
  // Whether lines are in flight, and what the cache did: rc_pkg::cache_outcome_e
  output logic             waits_o,
  output logic [rc_pkg::CauseBits-1:0] outcome_o
);
  logic                            next_fires;   // unused
  logic [rc_pkg::ClientIdBits-1:0] next_id;

  rc_cache #(
    .IdBits(rc_pkg::ClientIdBits), .AddrBits(rc_pkg::AddrBits), .Parts(1),
    .PartW(rc_pkg::LineBits), .Sets(rc_pkg::L2Sets < 1 ? 1 : rc_pkg::L2Sets),
    .Ways(rc_pkg::L2Ways), .Words(rc_pkg::L2Words), .Mshrs(rc_pkg::L2Mshrs),
    .Queue(rc_pkg::CacheQueue)
  ) u_cache (
    .clk_i, .rst_ni, .req_valid_i, .req_ready_o, .req_i, .rsp_valid_o, .rsp_ready_i, .rsp_o,
    .next_fires_o(next_fires), .next_id_o(next_id),
    .miss_valid_o, .miss_ready_i, .miss_o, .fill_fires_i, .fill_id_i(fill_i.id),
    .fill_word_i(fill_i.line), .waits_o, .outcome_o);

  logic unused;
  assign unused = ^{next_fires, next_id};
endmodule
`default_nettype wire

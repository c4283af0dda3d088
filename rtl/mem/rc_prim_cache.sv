// Cache of primitives: an rc_cache of the two halves of a memory word, with the ray as the id. A
// request addresses half a word.
//
// Latency 3 for a hit, one request per cycle. rc_cache.sv has the other latencies and the rules for
// the user. Model: model/mem/cache.hpp with prim_cache_shape().
`default_nettype none
module rc_prim_cache (
  input  logic               clk_i,
  input  logic               rst_ni,
  // From list
  input  logic               req_valid_i,
  output logic               req_ready_o,
  input  rc_pkg::prim_req_t  req_i,
  // To tri
  output logic               rsp_valid_o,
  input  logic               rsp_ready_i,
  output rc_pkg::prim_rsp_t  rsp_o,
  output logic               next_fires_o,   // in a fast chip: an answer comes to the head
  output logic [rc_pkg::RayBits-1:0] next_ray_o,
  // To and from memory
  output logic               miss_valid_o,
  input  logic               miss_ready_i,
  output rc_pkg::prim_miss_t miss_o,
  input  logic               fill_fires_i,
  input  rc_pkg::prim_fill_t fill_i,
  // Whether lines are in flight, and what the cache did: rc_pkg::cache_outcome_e
  output logic               waits_o,
  output logic [rc_pkg::CauseBits-1:0] outcome_o
);
  localparam int unsigned PrimW = rc_pkg::PrimitiveW;
  localparam int unsigned RestW = rc_pkg::LineBits / 2 - PrimW;

  logic [PrimW-1:0] upper, lower;    // a primitive takes the lowest bits of half a word
  logic [RestW-1:0] beyond_upper, beyond_lower;

  assign {beyond_upper, upper, beyond_lower, lower} = fill_i.line;

  rc_cache #(
    .IdBits(rc_pkg::RayBits), .AddrBits(rc_pkg::AddrBits), .Parts(2), .PartW(PrimW),
    .Sets(rc_pkg::PrimSets), .Ways(rc_pkg::PrimWays), .Words(rc_pkg::PrimWords),
    .Mshrs(rc_pkg::PrimMshrs), .Queue(rc_pkg::CacheQueue)
  ) u_cache (
    .clk_i, .rst_ni, .req_valid_i, .req_ready_o, .req_i, .rsp_valid_o, .rsp_ready_i, .rsp_o,
    .next_fires_o, .next_id_o(next_ray_o),
    .miss_valid_o, .miss_ready_i, .miss_o, .fill_fires_i, .fill_id_i(fill_i.id),
    .fill_word_i({upper, lower}), .waits_o, .outcome_o);

  logic unused;
  assign unused = ^{beyond_upper, beyond_lower};
endmodule
`default_nettype wire

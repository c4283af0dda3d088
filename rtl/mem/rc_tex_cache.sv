// Cache of texture records and texels: an rc_cache of whole memory words, with the ray as the id.
// It exists only in a chip with textures.
//
// Latency 3 for a hit, one request per cycle. rc_cache.sv has the other latencies and the rules
// for the user. Model: model/mem/cache.hpp with tex_cache_shape().
`default_nettype none
module rc_tex_cache (
  input  logic               clk_i,
  input  logic               rst_ni,
  // From and to tex
  input  logic               req_valid_i,
  output logic               req_ready_o,
  input  rc_pkg::texel_req_t req_i,
  output logic               rsp_valid_o,
  input  logic               rsp_ready_i,
  output rc_pkg::texel_rsp_t rsp_o,
  // To and from memory
  output logic               miss_valid_o,
  input  logic               miss_ready_i,
  output rc_pkg::tex_miss_t  miss_o,
  input  logic               fill_fires_i,
  input  rc_pkg::tex_fill_t  fill_i,
  // Whether lines are in flight, and the cache's outcome: rc_pkg::cache_outcome_e
  output logic               waits_o,
  output logic [rc_pkg::CauseBits-1:0] outcome_o
);
  logic                       next_fires;   // unused: tex needs no early id
  logic [rc_pkg::RayBits-1:0] next_ray;

  rc_cache #(
    .IdBits(rc_pkg::RayBits), .AddrBits(rc_pkg::AddrBits), .Parts(1), .PartW(rc_pkg::LineBits),
    .Sets(rc_pkg::TexSets), .Ways(rc_pkg::TexWays), .Words(rc_pkg::TexWords),
    .Mshrs(rc_pkg::TexMshrs), .Queue(rc_pkg::CacheQueue)
  ) u_cache (
    .clk_i, .rst_ni, .req_valid_i, .req_ready_o, .req_i, .rsp_valid_o, .rsp_ready_i, .rsp_o,
    .next_fires_o(next_fires), .next_id_o(next_ray),
    .miss_valid_o, .miss_ready_i, .miss_o, .fill_fires_i, .fill_id_i(fill_i.id),
    .fill_word_i(fill_i.line), .waits_o, .outcome_o);

  logic unused;
  assign unused = ^{next_fires, next_ray};
endmodule
`default_nettype wire

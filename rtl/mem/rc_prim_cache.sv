// Cache of triangles: rc_cache with the triangles' parts of a memory word, of which there are
// two, and all rays as ids. A request's address is that of half a word.
//
// Latency 3 for a hit, one request per cycle; the rest and the user's duties: rc_cache.sv.
// Model: model/mem/cache.hpp with prim_cache_shape().
`default_nettype none
module rc_prim_cache (
  input  logic               clk_i,
  input  logic               rst_ni,
  input  logic               req_valid_i,
  output logic               req_ready_o,
  input  rc_pkg::prim_req_t  req_i,
  output logic               rsp_valid_o,
  input  logic               rsp_ready_i,
  output rc_pkg::prim_rsp_t  rsp_o,
  output logic               miss_valid_o,
  input  logic               miss_ready_i,
  output rc_pkg::prim_miss_t miss_o,
  input  logic               fill_fires_i,
  input  rc_pkg::prim_fill_t fill_i,
  output logic               waits_o,
  output logic [2:0]         deed_o
);
  localparam int unsigned HalfW = rc_pkg::LineBits / 2;
  localparam int unsigned PrimW = rc_pkg::PrimRspW - rc_pkg::RayBits;
  logic [rc_pkg::LineBits-1:0] line;
  assign line = fill_i.line;
  rc_cache #(
    .IdBits(rc_pkg::RayBits), .AddrBits(rc_pkg::AddrBits), .Parts(2), .PartW(PrimW),
    .Sets(rc_pkg::PrimSets), .Ways(rc_pkg::PrimWays), .Words(rc_pkg::PrimWords),
    .Mshrs(rc_pkg::PrimMshrs), .Queue(rc_pkg::CacheQueue)
  ) u_cache (
    .clk_i, .rst_ni, .req_valid_i, .req_ready_o, .req_i, .rsp_valid_o, .rsp_ready_i, .rsp_o,
    .miss_valid_o, .miss_ready_i, .miss_o, .fill_fires_i, .fill_id_i(fill_i.id),
    .fill_word_i({line[HalfW +: PrimW], line[0 +: PrimW]}), .waits_o, .deed_o);

  logic unused;   // what is beyond a triangle
  assign unused = ^{line >> (HalfW + PrimW), line[PrimW +: HalfW-PrimW]};
endmodule
`default_nettype wire

// Cache of nodes: an rc_cache of the node's part of a memory word, with the ray as the id.
//
// Latency 3 for a hit, one request per cycle. rc_cache.sv has the other latencies and the rules for
// the user. Model: model/mem/cache.hpp with node_cache_shape().
`default_nettype none
module rc_node_cache (
  input  logic               clk_i,
  input  logic               rst_ni,
  // From trav
  input  logic               req_valid_i,
  output logic               req_ready_o,
  input  rc_pkg::node_req_t  req_i,
  // To the node unit
  output logic               rsp_valid_o,
  input  logic               rsp_ready_i,
  output rc_pkg::node_rsp_t  rsp_o,
  output logic               next_fires_o,   // in a fast chip: an answer comes to the head
  output logic [rc_pkg::RayBits-1:0] next_ray_o,
  // To and from memory
  output logic               miss_valid_o,
  input  logic               miss_ready_i,
  output rc_pkg::node_miss_t miss_o,
  input  logic               fill_fires_i,
  input  rc_pkg::node_fill_t fill_i,
  // Whether lines are in flight, and what the cache did: rc_pkg::cache_outcome_e
  output logic               waits_o,
  output logic [rc_pkg::CauseBits-1:0] outcome_o
);
  // A node takes the lowest bits of a word, or all of them. With two levels the highest bits hold
  // the kind of the line.
  localparam int unsigned NodeW = rc_pkg::NodePartBits;
  localparam int unsigned LowW  = rc_pkg::Levels == 1 ? NodeW : NodeW - rc_pkg::LineKindBits;

  logic [rc_pkg::LineBits-1:0] line;
  logic [NodeW-1:0]            word;

  assign line = fill_i.line;

  if (rc_pkg::Levels == 1) begin : gen_node
    assign word = line[LowW-1:0];
  end else begin : gen_what
    assign word = {line[rc_pkg::LineBits-1 -: rc_pkg::LineKindBits], line[LowW-1:0]};
  end

  rc_cache #(
    .IdBits(rc_pkg::RayBits), .AddrBits(rc_pkg::AddrBits), .Parts(1), .PartW(NodeW),
    .Sets(rc_pkg::NodeSets), .Ways(rc_pkg::NodeWays), .Words(rc_pkg::NodeWords),
    .Mshrs(rc_pkg::NodeMshrs), .Queue(rc_pkg::CacheQueue)
  ) u_cache (
    .clk_i, .rst_ni, .req_valid_i, .req_ready_o, .req_i, .rsp_valid_o, .rsp_ready_i, .rsp_o,
    .next_fires_o, .next_id_o(next_ray_o),
    .miss_valid_o, .miss_ready_i, .miss_o, .fill_fires_i, .fill_id_i(fill_i.id),
    .fill_word_i(word), .waits_o, .outcome_o);

  logic unused;
  assign unused = ^line;
endmodule
`default_nettype wire

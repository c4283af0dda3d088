// The last stages of every node unit: sorts the children that the ray meets, and queues the
// answers for trav.
//
// Stages count like the unit's valid bits. A node's ray, base and kinds come with stage In. The
// children that are met, and their distances, come with stage Latency - RankStages - 1. Model:
// node_answer() in model/engine/node_answer.hpp.
`default_nettype none
module rc_node_answer #(
  parameter  int unsigned Latency = rc_pkg::BoxLatency,   // of the unit, without its queue
  parameter  bit          Exits   = 1'b0,                 // of rc_child_offsets
  localparam int unsigned NodeWidth  = rc_pkg::NodeWidth,
  localparam int unsigned TBits      = rc_pkg::TBits,
  localparam int unsigned CountBits  = rc_pkg::CountBits,
  localparam int unsigned OffsetBits = rc_pkg::OffsetBits,
  localparam int unsigned RayBits    = rc_pkg::RayBits,
  localparam int unsigned AddrBits   = rc_pkg::AddrBits,
  localparam int unsigned GroupBits  = rc_pkg::GroupBits
) (
  input  logic                           clk_i,
  input  logic                           rst_ni,
  input  logic [Latency-1:0]             enable_i,   // enable_i[i]: stage i + 1 accepts its input
  // The node, at stage In
  input  logic [RayBits-1:0]             ray_i,
  input  logic [AddrBits-1:0]            base_i,
  input  logic [NodeWidth*CountBits-1:0] kind_i,
  // Its children, at the stage before the sorting
  input  logic [NodeWidth-1:0]           met_i,
  input  logic [NodeWidth*TBits-1:0]     near_i,
  // At the end: a node is there; then the answer, to trav
  input  logic                           end_valid_i,
  output logic                           rsp_valid_o,
  input  logic                           rsp_ready_i,
  output logic [rc_pkg::NodeAnswerW-1:0] rsp_o
);
  localparam int unsigned EntryW = TBits + OffsetBits + CountBits;
  localparam int unsigned In     = rc_pkg::PathCut;
  localparam int unsigned Rank   = Latency - rc_pkg::RankStages;

  // Ray and base wait until the end, the kinds until rc_child_offsets needs them.
  logic [RayBits+AddrBits-1:0]     end_whose;   // {ray, base}
  logic [NodeWidth*CountBits-1:0]  late_kind, rank_count;
  logic [NodeWidth*OffsetBits-1:0] rank_offset;
  logic [NodeWidth-1:0]            there, rank_leaf;

  rc_shift_register #(.Width(RayBits + AddrBits), .Stages(Latency - In)) u_whose (
    .clk_i, .enable_i(enable_i[Latency-1:In]), .data_i({ray_i, base_i}), .data_o(end_whose));

  rc_shift_register #(.Width(NodeWidth * CountBits), .Stages(Rank - 2 - In)) u_kind (
    .clk_i, .enable_i(enable_i[Rank-3:In]), .data_i(kind_i), .data_o(late_kind));

  rc_child_offsets #(.Exits(Exits)) u_places (
    .clk_i, .enable_i(enable_i[Rank-1:Rank-2]), .kind_i(late_kind), .there_o(there),
    .leaf_o(rank_leaf), .offset_o(rank_offset), .count_o(rank_count));

  // The children that are met.
  logic [NodeWidth-1:0]       hit_q;
  logic [NodeWidth*TBits-1:0] near_q;

  for (genvar i = 0; i < NodeWidth; i++) begin : gen_child
    always_ff @(posedge clk_i) begin
      if (enable_i[Rank-1]) begin
        hit_q[i]                 <= met_i[i] && there[i];
        near_q[i*TBits +: TBits] <= near_i[i*TBits +: TBits];
      end
    end
  end

  // Sorting.
  logic [GroupBits-1:0]        end_inner, end_leaves;
  logic [NodeWidth*EntryW-1:0] end_entries;

  rc_rank u_rank (
    .clk_i, .enable_i(enable_i[Latency-1:Rank]), .s0_hit_i(hit_q), .s0_near_i(near_q),
    .s0_leaf_i(rank_leaf), .s0_offset_i(rank_offset), .s0_count_i(rank_count),
    .inner_o(end_inner), .leaves_o(end_leaves), .entries_o(end_entries));

  // Result queue.
  logic                       queue_ready;
  logic [rc_pkg::NodeAnswerW-1:0] queue_data;

  assign queue_data = {end_whose, end_inner, end_leaves, end_entries};

  rc_fifo #(.Width(rc_pkg::NodeAnswerW), .Depth(rc_pkg::BoxQueue)) u_queue (
    .clk_i, .rst_ni, .valid_i(end_valid_i), .ready_o(queue_ready), .data_i(queue_data),
    .valid_o(rsp_valid_o), .ready_i(rsp_ready_i), .data_o(rsp_o));

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) if (rst_ni && end_valid_i)
    a_never_dropped: assert (queue_ready)
    else $error("an answer met a full queue");
`endif

  logic unused;
  assign unused = ^{queue_ready, enable_i};
endmodule
`default_nettype wire

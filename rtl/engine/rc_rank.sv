// Sorts the children that are met: inner children first, then leaves, each by (t_near, offset).
// Entries after the last child are zero. Offsets differ, so the order is total.
//
// Part of rc_node_answer. Hits, distances and places come with enable_i[0]; sorted entries come
// rc_pkg::RankStages later.
//
// It is a bitonic network (Batcher 1968), with six levels for eight children. A relaxed chip has
// three levels in a stage, a fast chip one. Model: node_answer() in
// model/engine/node_answer.cpp.
`default_nettype none
module rc_rank #(
  localparam int unsigned NodeWidth  = rc_pkg::NodeWidth,
  localparam int unsigned TBits      = rc_pkg::TBits,
  localparam int unsigned CountBits  = rc_pkg::CountBits,
  localparam int unsigned OffsetBits = rc_pkg::OffsetBits,
  localparam int unsigned GroupBits  = rc_pkg::GroupBits,
  localparam int unsigned Stages     = rc_pkg::RankStages
) (
  input  logic                                              clk_i,
  // enable_i[i]: stage i holds a node, or the chip is fast
  input  logic [Stages-1:0]                                 enable_i,
  // Children
  input  logic [NodeWidth-1:0]                              s0_hit_i,
  input  logic [NodeWidth*TBits-1:0]                        s0_near_i,
  input  logic [NodeWidth-1:0]                              s0_leaf_i,
  input  logic [NodeWidth*OffsetBits-1:0]                   s0_offset_i,
  input  logic [NodeWidth*CountBits-1:0]                    s0_count_i,
  // Sorted
  output logic [GroupBits-1:0]                              inner_o,
  output logic [GroupBits-1:0]                              leaves_o,
  output logic [NodeWidth*(TBits+OffsetBits+CountBits)-1:0] entries_o
);
  // {missed, leaf, t_near, offset, count}
  localparam int unsigned KeyW   = 2 + TBits + OffsetBits + CountBits;
  localparam int unsigned Levels = NodeWidth == 2 ? 1 : NodeWidth == 4 ? 3 : 6;
  localparam int unsigned Middle = NodeWidth == 2 ? 0 : 2; // level with a register in every chip
  localparam int unsigned Cut    = rc_pkg::PathCut;

  // In a simulation of a relaxed chip, invalid keys cost no work. Silicon has no such condition.
  logic computes;

`ifdef SYNTHESIS
  assign computes = 1'b1;
`else
  assign computes = Cut != 0 || enable_i[0];
`endif

  // Number of inner children and of leaves that are met.
  logic [GroupBits-1:0] s0_inners, s0_leaves;

  always_comb begin
    s0_inners = '0;
    s0_leaves = '0;
    if (computes) begin
      for (int i = 0; i < NodeWidth; i++) begin
        s0_leaves = s0_leaves + {{(GroupBits-1){1'b0}}, s0_hit_i[i] && s0_leaf_i[i]};
        s0_inners = s0_inners + {{(GroupBits-1){1'b0}}, s0_hit_i[i] && !s0_leaf_i[i]};
      end
    end
  end

  // A level exchanges keys i and i ^ Step if their order is wrong for blocks of Block keys.
  for (genvar l = 0; l < Levels; l++) begin : gen_level
    localparam int unsigned Block = l == 0 ? 2 : l < 3 ? 4 : 8;
    localparam int unsigned Step  = l == 3 ? 4 : l == 1 || l == 4 ? 2 : 1;
    logic holds;
    assign holds = Cut != 0 || enable_i[l > Middle ? 1 : 0];

    for (genvar i = 0; i < NodeWidth; i++) begin : gen_key
      logic [KeyW-1:0] key, put, late;

      if (l == 0) begin : gen_first
        rc_path_register #(.Width(KeyW)) u_key (
          .clk_i, .data_i(computes ? {!s0_hit_i[i], s0_leaf_i[i], s0_near_i[i*TBits +: TBits],
                                  s0_offset_i[i*OffsetBits +: OffsetBits],
                                  s0_count_i[i*CountBits +: CountBits]} : '0),
          .data_o(key));
      end else begin : gen_next
        assign key = gen_level[l-1].gen_key[i].late;
      end

      if ((i & Step) == 0) begin : gen_compare
        logic [KeyW-1:0] other, here, there;
        assign other = gen_level[l].gen_key[i ^ Step].key;
        always_comb begin
          here  = key;
          there = other;
          if (holds && (key > other) == ((i & Block) == 0 || Block == NodeWidth)) begin
            here  = other;
            there = key;
          end
        end
        assign put = here;
      end else begin : gen_follow
        assign put = gen_level[l].gen_key[i ^ Step].gen_compare.there;
      end

      if (l == Middle) begin : gen_middle
        logic [KeyW-1:0] key_q;
        always_ff @(posedge clk_i) if (enable_i[Cut*(l+1)]) key_q <= put;
        assign late = key_q;
      end else begin : gen_cut
        rc_path_register #(.Width(KeyW)) u_key (.clk_i, .data_i(put), .data_o(late));
      end
    end
  end

  // Entries: zero for children that are missed.
  logic [NodeWidth*TBits-1:0]      t_q;
  logic [NodeWidth*OffsetBits-1:0] offset_q;
  logic [NodeWidth*CountBits-1:0]  count_q;

  for (genvar i = 0; i < NodeWidth; i++) begin : gen_entry
    logic [KeyW-1:0] last;
    assign last = gen_level[Levels-1].gen_key[i].late;
    always_ff @(posedge clk_i)
      if (enable_i[Stages-1])
        {t_q[i*TBits +: TBits], offset_q[i*OffsetBits +: OffsetBits],
         count_q[i*CountBits +: CountBits]} <=
          last[KeyW-1] ? '0 : last[TBits+OffsetBits+CountBits-1:0];

    logic unused;
    assign unused = last[KeyW-2];
  end
  assign entries_o = {t_q, offset_q, count_q};

  rc_shift_register #(.Width(2 * GroupBits), .Stages(Stages)) u_counts (
    .clk_i, .enable_i, .data_i({s0_inners, s0_leaves}), .data_o({inner_o, leaves_o}));
endmodule
`default_nettype wire

// Puts the children that were hit in order: inner children first, then leaves, each by
// (t_near, offset); entries beyond are zero. Part of rc_box: hits and distances in s4,
// ordered entries from the registers of s6. Offsets differ, so the order is total.
// Model: the end of box_children() in model/trav/box.cpp.
`default_nettype none
module rc_rank #(
  localparam int unsigned W      = rc_pkg::NodeWidth,
  localparam int unsigned T      = rc_pkg::TBits,
  localparam int unsigned C      = rc_pkg::CountBits,
  localparam int unsigned O      = rc_pkg::OffsetBits,
  localparam int unsigned G      = rc_pkg::GroupBits,
  localparam int unsigned KeyW   = 1 + T + O,
  localparam int unsigned RankW  = rc_pkg::SlotBits
) (
  input  logic               clk_i,
  input  logic               s4_valid_i,
  input  logic               s5_valid_i,
  input  logic [W-1:0]       s4_hit_i,
  input  logic [W*T-1:0]     s4_near_i,
  input  logic [W*C-1:0]     s4_kind_i,
  output logic [G-1:0]       s6_inner_o,
  output logic [G-1:0]       s6_leaves_o,
  output logic [W*(T+O+C)-1:0] s6_entries_o
);
  // s4: where each child lies in the block, and its key {leaf, t_near, offset}.
  logic [W-1:0]      s4_leaf;
  logic [W*KeyW-1:0] s4_key;
  logic [W*C-1:0]    s4_count;
  logic [O-1:0]      s4_triangles, s4_inner;
  always_comb begin
    s4_inner     = '0;
    s4_triangles = '0;
    s4_leaf      = '0;
    s4_count     = '0;
    s4_key       = '0;
    for (int i = 0; i < W; i++) if (s4_kind_i[i*C +: C] == C'(1)) s4_inner = s4_inner + O'(2);
    for (int i = 0; i < W; i++) begin
      s4_leaf[i] = s4_kind_i[i*C +: C] > C'(1);
      if (s4_leaf[i]) s4_count[i*C +: C] = s4_kind_i[i*C +: C] - C'(1);
      s4_key[i*KeyW +: KeyW] = {s4_leaf[i], s4_near_i[i*T +: T],
                                s4_leaf[i] ? s4_inner + s4_triangles : O'(2 * i)};
      s4_triangles = s4_triangles + {{(O-C){1'b0}}, s4_count[i*C +: C]};
    end
  end

  // s5: how many go before each.
  logic [W-1:0]       s5_hit_q;
  logic [W*KeyW-1:0]  s5_key_q;
  logic [W*C-1:0]     s5_count_q;
  logic [W*RankW-1:0] s4_rank, s5_rank_q;
  logic [G-1:0]       s4_inners, s4_leaves, s5_inner_q, s5_leaves_q;
  always_comb begin
    s4_rank   = '0;
    s4_inners = '0;
    s4_leaves = '0;
    for (int i = 0; i < W; i++) begin
      for (int j = 0; j < W; j++)
        if (j != i && s4_hit_i[j] && s4_key[j*KeyW +: KeyW] < s4_key[i*KeyW +: KeyW])
          s4_rank[i*RankW +: RankW] = s4_rank[i*RankW +: RankW] + RankW'(1);
      if (s4_hit_i[i] && s4_leaf[i])  s4_leaves = s4_leaves + G'(1);
      if (s4_hit_i[i] && !s4_leaf[i]) s4_inners = s4_inners + G'(1);
    end
  end
  always_ff @(posedge clk_i) begin
    if (s4_valid_i) begin
      s5_hit_q    <= s4_hit_i;
      s5_key_q    <= s4_key;
      s5_count_q  <= s4_count;
      s5_rank_q   <= s4_rank;
      s5_inner_q  <= s4_inners;
      s5_leaves_q <= s4_leaves;
    end
  end

  // s6: each to its place.
  logic [W*T-1:0] s5_t, s6_t_q;
  logic [W*O-1:0] s5_offset, s6_offset_q;
  logic [W*C-1:0] s5_count, s6_count_q;
  always_comb begin
    s5_t      = '0;
    s5_offset = '0;
    s5_count  = '0;
    for (int p = 0; p < W; p++)
      for (int i = 0; i < W; i++)
        if (s5_hit_q[i] && s5_rank_q[i*RankW +: RankW] == RankW'(p)) begin
          s5_t[p*T +: T]      = s5_key_q[i*KeyW + O +: T];
          s5_offset[p*O +: O] = s5_key_q[i*KeyW +: O];
          s5_count[p*C +: C]  = s5_count_q[i*C +: C];
        end
  end
  always_ff @(posedge clk_i) begin
    if (s5_valid_i) begin
      s6_t_q      <= s5_t;
      s6_offset_q <= s5_offset;
      s6_count_q  <= s5_count;
      s6_inner_o  <= s5_inner_q;
      s6_leaves_o <= s5_leaves_q;
    end
  end
  assign s6_entries_o = {s6_t_q, s6_offset_q, s6_count_q};
endmodule
`default_nettype wire

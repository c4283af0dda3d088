// Puts the children that were hit in order: inner children first, then leaves, each by
// (t_near, offset); entries beyond are zero. Part of rc_box: hits and distances in s4,
// ordered entries from the registers of s6. Offsets differ, so the order is total.
//
// A bitonic network (Batcher 1968) of six levels for eight children, three a stage.
// Model: the end of box_children() in model/bvh/box.cpp.
`default_nettype none
module rc_rank #(
  localparam int unsigned W      = rc_pkg::NodeWidth,
  localparam int unsigned T      = rc_pkg::TBits,
  localparam int unsigned C      = rc_pkg::CountBits,
  localparam int unsigned O      = rc_pkg::OffsetBits,
  localparam int unsigned G      = rc_pkg::GroupBits,
  localparam int unsigned KeyW   = 2 + T + O + C,  // {missed, leaf, t_near, offset, count}
  localparam int unsigned PadW   = 64              // a key's place in a vector
) (
  input  logic                 clk_i,
  input  logic                 s4_valid_i,
  input  logic                 s5_valid_i,
  input  logic [W-1:0]         s4_hit_i,
  input  logic [W*T-1:0]       s4_near_i,
  input  logic [W*C-1:0]       s4_kind_i,
  output logic [G-1:0]         s6_inner_o,
  output logic [G-1:0]         s6_leaves_o,
  output logic [W*(T+O+C)-1:0] s6_entries_o
);
  // A level exchanges entries i and i ^ J where they stand in the wrong order for blocks
  // of K; levels are written out, since the subset has no functions on arrays.

  // s4: where each child lies in the block, its key, and how many of each kind are hit.
  (* mem2reg *) logic [KeyW-1:0] s4_key [W];
  logic [W*PadW-1:0]             s5_keys;
  logic [KeyW-1:0] s4_swap;
  logic [O-1:0]    s4_inner, s4_triangles;
  logic [C-1:0]    s4_count;
  logic            s4_leaf;
  logic [G-1:0]    s4_inners, s4_leaves, s5_inner_q, s5_leaves_q;
  always_comb begin
    s4_inner     = '0;
    s4_triangles = '0;
    s4_inners    = '0;
    s4_leaves    = '0;
    s4_swap      = '0;
    s4_count     = '0;
    s4_leaf      = 1'b0;
    for (int i = 0; i < W; i++) s4_key[i] = '0;
    if (s4_valid_i) begin
      for (int i = 0; i < W; i++) if (s4_kind_i[i*C +: C] == C'(1)) s4_inner = s4_inner + O'(2);
      for (int i = 0; i < W; i++) begin
        s4_leaf   = s4_kind_i[i*C +: C] > C'(1);
        s4_count  = s4_leaf ? s4_kind_i[i*C +: C] - C'(1) : '0;
        s4_key[i] = {!s4_hit_i[i], s4_leaf, s4_near_i[i*T +: T],
                     s4_leaf ? s4_inner + s4_triangles : O'(2 * i), s4_count};
        s4_triangles = s4_triangles + {{(O-C){1'b0}}, s4_count};
        s4_leaves    = s4_leaves + {{(G-1){1'b0}}, s4_hit_i[i] && s4_leaf};
        s4_inners    = s4_inners + {{(G-1){1'b0}}, s4_hit_i[i] && !s4_leaf};
      end
      for (int i = 0; i < W; i++)
        if ((i ^ 1) > i && (s4_key[i] > s4_key[i ^ 1]) == ((i & 2) == 0 || W == 2)) begin
          s4_swap       = s4_key[i];
          s4_key[i]     = s4_key[i ^ 1];
          s4_key[i ^ 1] = s4_swap;
        end
      for (int i = 0; i < W; i++)
        if (W > 2 && (i ^ 2) > i && (s4_key[i] > s4_key[(i ^ 2) % W])
            == ((i & 4) == 0 || W == 4)) begin
          s4_swap             = s4_key[i];
          s4_key[i]           = s4_key[(i ^ 2) % W];
          s4_key[(i ^ 2) % W] = s4_swap;
        end
      for (int i = 0; i < W; i++)
        if (W > 2 && (i ^ 1) > i && (s4_key[i] > s4_key[i ^ 1]) == ((i & 4) == 0 || W == 4)) begin
          s4_swap       = s4_key[i];
          s4_key[i]     = s4_key[i ^ 1];
          s4_key[i ^ 1] = s4_swap;
        end
    end
  end
  always_ff @(posedge clk_i) begin
    if (s4_valid_i) begin
      s5_inner_q  <= s4_inners;
      s5_leaves_q <= s4_leaves;
    end
  end

  for (genvar i = 0; i < W; i++) begin : gen_key
    logic [KeyW-1:0] s5_key_q;
    always_ff @(posedge clk_i) if (s4_valid_i) s5_key_q <= s4_key[i];
    assign s5_keys[i*PadW +: PadW] = {{(PadW-KeyW){1'b0}}, s5_key_q};
  end

  // s5: the other half of the network, needed for eight children.
  (* mem2reg *) logic [KeyW-1:0] s5_key [W];
  logic [KeyW-1:0] s5_swap;
  always_comb begin
    s5_swap = '0;
    for (int i = 0; i < W; i++) s5_key[i] = s5_keys[i*PadW +: KeyW];
    if (W == 8 && s5_valid_i) begin
      for (int i = 0; i < W; i++)
        if ((i ^ 4) > i && s5_key[i] > s5_key[(i ^ 4) % W]) begin
          s5_swap             = s5_key[i];
          s5_key[i]           = s5_key[(i ^ 4) % W];
          s5_key[(i ^ 4) % W] = s5_swap;
        end
      for (int i = 0; i < W; i++)
        if ((i ^ 2) > i && s5_key[i] > s5_key[(i ^ 2) % W]) begin
          s5_swap             = s5_key[i];
          s5_key[i]           = s5_key[(i ^ 2) % W];
          s5_key[(i ^ 2) % W] = s5_swap;
        end
      for (int i = 0; i < W; i++)
        if ((i ^ 1) > i && s5_key[i] > s5_key[i ^ 1]) begin
          s5_swap       = s5_key[i];
          s5_key[i]     = s5_key[i ^ 1];
          s5_key[i ^ 1] = s5_swap;
        end
    end
  end

  // s6: entries, zero for children that are missed.
  logic [W*T-1:0] s6_t_q;
  logic [W*O-1:0] s6_offset_q;
  logic [W*C-1:0] s6_count_q;
  always_ff @(posedge clk_i) begin
    if (s5_valid_i) begin
      for (int i = 0; i < W; i++)
        {s6_t_q[i*T +: T], s6_offset_q[i*O +: O], s6_count_q[i*C +: C]} <=
          s5_key[i][KeyW-1] ? '0 : s5_key[i][T+O+C-1:0];
      s6_inner_o  <= s5_inner_q;
      s6_leaves_o <= s5_leaves_q;
    end
  end
  assign s6_entries_o = {s6_t_q, s6_offset_q, s6_count_q};

  logic unused;
  assign unused = ^{s5_key[0][KeyW-2], s5_keys};
endmodule
`default_nettype wire

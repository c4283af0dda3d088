// Property of rc_tags with Cut: for a valid request it answers as rc_tags without Cut does. Both
// instances get the same look-ups. The one with Cut reads and compares its tags while the request
// waits as `next` and as `head`, moved as rc_cache moves them. If a way is allocated or a tree
// changes while a request waits there, its look-up sees the change.
//
// The proof uses two sets of two ways.
module tags_ahead #(
  parameter  int unsigned TagW = 2,
  localparam int unsigned Sets = 2,
  localparam int unsigned Ways = 2
) (
  input logic            clk_i,
  input logic            rst_ni,
  input logic            next_valid_i,
  input logic            next_set_i,
  input logic [TagW-1:0] next_tag_i,
  input logic            pop_i,
  input logic [Ways-1:0] waiting_i
);
  // Reset is held once, for as many cycles as there are sets.
  logic [1:0] begun_q = 2'd0;
  always @(posedge clk_i) if (begun_q != Sets) begun_q <= begun_q + 1'b1;
  always @* assume (rst_ni == (begun_q == Sets));

  // ---- The request that is looked up and the one ahead, as in rc_cache.
  logic            valid_q, head_valid_q, head_set_q, set_q, load, next_load, take;
  logic [TagW-1:0] head_tag_q, tag_q;
  assign load      = !valid_q || pop_i;
  assign next_load = !head_valid_q || load;
  always @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_q      <= 1'b0;
      head_valid_q <= 1'b0;
    end else begin
      valid_q      <= head_valid_q || !load;
      head_valid_q <= !next_load || next_valid_i;
    end
    if (load)      {set_q, tag_q}           <= {head_set_q, head_tag_q};
    if (next_load) {head_set_q, head_tag_q} <= {next_set_i, next_tag_i};
  end

  logic            hit, conflict, hit_o, conflict_o, found, found_o, way, way_o;
  logic [Ways-1:0] hits, hits_o;
  rc_tags #(.TagW(TagW), .Sets(Sets), .Ways(Ways), .Cut(0)) u_now (
    .clk_i(clk_i), .rst_ni(rst_ni), .next_load_i(1'b0), .next_set_i(set_q), .load_i(1'b0),
    .ahead_set_i(set_q),
    .ahead_tag_i(tag_q), .set_i(set_q), .tag_i(tag_q), .waiting_i(waiting_i), .hits_o(hits),
    .hit_o(hit), .found_o(found),
    .conflict_o(conflict), .way_o(way), .touch_i(pop_i), .take_i(take));
  rc_tags #(.TagW(TagW), .Sets(Sets), .Ways(Ways), .Cut(1)) u_dut (
    .clk_i(clk_i), .rst_ni(rst_ni), .next_load_i(next_load), .next_set_i(next_set_i), .load_i(load),
    .ahead_set_i(head_set_q),
    .ahead_tag_i(head_tag_q), .set_i(set_q), .tag_i(tag_q), .waiting_i(waiting_i), .hits_o(hits_o),
    .hit_o(hit_o),
    .found_o(found_o), .conflict_o(conflict_o), .way_o(way_o), .touch_i(pop_i), .take_i(take));
  assign take = pop_i && !hit;
  always @* if (rst_ni) assume (!pop_i || (valid_q && (hit || !conflict)));
  always @* if (!rst_ni) assume (!pop_i);

  always @* if (rst_ni && valid_q) begin
    a_hits:     assert (hits_o == hits && hit_o == hit);
    a_found:    assert (!hit || found_o == found);
    a_conflict: assert (conflict_o == conflict);
    a_way:      assert (way_o == way);
  end

  // ---- Ties to the inside, as an induction needs them. First the tags: {way 1, way 0} of set 1,
  // the same of set 0.
  localparam int unsigned EntryW = TagW + 1;
  (* hierconn *) wire [TagW:0] \u_now.gen_way[0].gen_memory.u_tag.mem[0] ,
      \u_now.gen_way[0].gen_memory.u_tag.mem[1] ;
  (* hierconn *) wire [TagW:0] \u_now.gen_way[1].gen_memory.u_tag.mem[0] ,
      \u_now.gen_way[1].gen_memory.u_tag.mem[1] ;
  (* hierconn *) wire [TagW:0] \u_dut.gen_way[0].gen_block.u_tag.mem[0] ,
      \u_dut.gen_way[0].gen_block.u_tag.mem[1] ;
  (* hierconn *) wire [TagW:0] \u_dut.gen_way[1].gen_block.u_tag.mem[0] ,
      \u_dut.gen_way[1].gen_block.u_tag.mem[1] ;
  (* hierconn *) wire [TagW:0] \u_dut.gen_way[0].gen_block.u_tag.read_q ,
      \u_dut.gen_way[1].gen_block.u_tag.read_q ;
  (* hierconn *) wire          \u_dut.gen_way[0].gen_ahead.took_q ,
      \u_dut.gen_way[1].gen_ahead.took_q ;
  (* hierconn *) wire [TagW:0] \u_dut.gen_late.late_q ;   // {set, tag}
  logic [4*EntryW-1:0] now, held;
  logic [2*EntryW-1:0] entry;
  logic [1:0]          took;
  logic [EntryW-1:0]   seen;   // of a way, what the request ahead will be compared with
  logic                late_set, tags_ok;
  assign now   = {\u_now.gen_way[1].gen_memory.u_tag.mem[1] ,
      \u_now.gen_way[0].gen_memory.u_tag.mem[1] ,
                  \u_now.gen_way[1].gen_memory.u_tag.mem[0] ,
                      \u_now.gen_way[0].gen_memory.u_tag.mem[0] };
  assign held  = {\u_dut.gen_way[1].gen_block.u_tag.mem[1] ,
      \u_dut.gen_way[0].gen_block.u_tag.mem[1] ,
                  \u_dut.gen_way[1].gen_block.u_tag.mem[0] ,
                      \u_dut.gen_way[0].gen_block.u_tag.mem[0] };
  assign entry = {\u_dut.gen_way[1].gen_block.u_tag.read_q ,
      \u_dut.gen_way[0].gen_block.u_tag.read_q };
  assign took  = {\u_dut.gen_way[1].gen_ahead.took_q , \u_dut.gen_way[0].gen_ahead.took_q };
  assign late_set = \u_dut.gen_late.late_q [TagW];
  always @* begin
    tags_ok = now == held;
    for (int w = 0; w < Ways; w++) begin
      seen = took[w] && late_set == head_set_q ? {1'b1, \u_dut.gen_late.late_q [TagW-1:0]}
          : entry[w*EntryW +: EntryW];
      if (head_valid_q && seen != now[(2*head_set_q + w)*EntryW +: EntryW]) tags_ok = 1'b0;
    end
  end

  // The trees: the one that was changed in the cycle before is not yet written.
  (* hierconn *) wire [Ways-1:0] \u_now.gen_tree.u_recent.mem[0] , \u_now.gen_tree.u_recent.mem[1] ;
  (* hierconn *) wire [Ways-1:0] \u_dut.gen_tree.u_recent.mem[0] , \u_dut.gen_tree.u_recent.mem[1] ;
  (* hierconn *) wire [Ways-1:0] \u_dut.gen_tree.late_recent , \u_dut.gen_tree.gen_ahead.recent_q ;
  (* hierconn *) wire            \u_dut.gen_tree.gen_ahead.touched_q ;
  logic [2*Ways-1:0] tree, kept;
  logic              trees_ok;
  assign tree = {\u_now.gen_tree.u_recent.mem[1] , \u_now.gen_tree.u_recent.mem[0] };
  assign kept = {\u_dut.gen_tree.u_recent.mem[1] , \u_dut.gen_tree.u_recent.mem[0] };
  always @* begin
    trees_ok = !valid_q || \u_dut.gen_tree.gen_ahead.recent_q [1] == tree[2*set_q + 1];
    for (int s = 0; s < Sets; s++)
      if (tree[2*s + 1] !=
          (\u_dut.gen_tree.gen_ahead.touched_q && late_set == s
              ? \u_dut.gen_tree.late_recent [1] : kept[2*s + 1]))
        trees_ok = 1'b0;
  end
  always @* if (rst_ni) begin
    t_tags:  assert (tags_ok);
    t_trees: assert (trees_ok);
  end
endmodule

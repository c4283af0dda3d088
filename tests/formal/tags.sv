// Properties of rc_tags, if a way is allocated only for a line that is not in the set, and only if
// not all ways wait:
// - an allocated line is found in its way until the way is allocated again, and no other line is
//   found;
// - no line has two ways;
// - a way that waits is not replaced;
// - the way that was used last is not the next one to be replaced, unless all others wait.
//
// The proof uses two sets of four ways. It tracks every way's line, and which way of a set was used
// last.
module tags #(
  parameter  int unsigned TagW = 2,
  localparam int unsigned Sets = 2,
  localparam int unsigned Ways = 4
) (
  input logic            clk_i,
  input logic            rst_ni,
  input logic            set_i,
  input logic [TagW-1:0] tag_i,
  input logic [Ways-1:0] waiting_i,
  input logic            touch_i,
  input logic            take_i
);
  logic       hit_o, conflict_o;
  logic [1:0] way_o, found_o;
  logic [3:0] hits_o;
  rc_tags #(.TagW(TagW), .Sets(Sets), .Ways(Ways)) u_dut (
    .clk_i(clk_i), .rst_ni(rst_ni), .next_load_i(1'b0), .next_set_i(set_i), .load_i(1'b0),
    .ahead_set_i(set_i), .ahead_tag_i(tag_i), .set_i(set_i), .tag_i(tag_i), .waiting_i(waiting_i),
    .hits_o(hits_o), .hit_o(hit_o), .found_o(found_o),
    .conflict_o(conflict_o), .way_o(way_o), .touch_i(touch_i), .take_i(take_i));

  // Reset is held once, for as many cycles as there are sets.
  logic [1:0] begun_q = 2'd0;
  always @(posedge clk_i) if (begun_q != Sets) begun_q <= begun_q + 1'b1;
  always @* assume (rst_ni == (begun_q == Sets));

  // ---- What should be the case: [Ways * set + way].
  localparam int unsigned Places = Sets * Ways;
  logic [Places-1:0]      valid_q;
  logic [TagW*Places-1:0] tag_q;
  logic [2*Sets-1:0]      last_q;
  logic [Sets-1:0]        used_q;
  logic [2:0]             place;
  assign place = {set_i, way_o};
  always @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_q <= '0;
      used_q  <= '0;
    end else begin
      if (take_i) begin
        valid_q[place] <= 1'b1;
        tag_q[TagW*place +: TagW] <= tag_i;
      end
      if (touch_i) begin
        used_q[set_i] <= 1'b1;
        last_q[2*set_i +: 2] <= way_o;
      end
    end
  end
  always @* if (rst_ni) begin
    assume (!take_i || (touch_i && !hit_o && !conflict_o));
    assume (!touch_i || hit_o || take_i);
  end

  logic [Ways-1:0] has;   // ways of the set that have the line
  logic            apart;
  always @* begin
    apart = 1'b1;
    for (int w = 0; w < Ways; w++) begin
      has[w] = valid_q[Ways*set_i + w] && tag_q[TagW*(Ways*set_i + w) +: TagW] == tag_i;
      for (int s = 0; s < Sets; s++)
        for (int v = 0; v < w; v++)
          if (valid_q[Ways*s + v] && valid_q[Ways*s + w] &&
              tag_q[TagW*(Ways*s + v) +: TagW] == tag_q[TagW*(Ways*s + w) +: TagW])
            apart = 1'b0;
    end
  end
  always @* if (rst_ni) begin
    a_hit:      assert (hit_o == (has != '0) && (!hit_o || has[way_o]));
    a_apart:    assert (apart);
    a_conflict: assert (conflict_o == (&waiting_i));
    a_waits:    assert (hit_o || conflict_o || !waiting_i[way_o]);
    a_found:    assert (!hit_o || (found_o == way_o && hits_o == 4'd1 << way_o));
    a_last:     assert (hit_o || waiting_i != '0 || !used_q[set_i] ||
        way_o != last_q[2*set_i +: 2]);
  end

  // ---- Ties to the inside, as an induction needs them.
  (* hierconn *) wire [TagW:0] \u_dut.gen_way[0].gen_memory.u_tag.mem[0] ,
      \u_dut.gen_way[0].gen_memory.u_tag.mem[1] ;
  (* hierconn *) wire [TagW:0] \u_dut.gen_way[1].gen_memory.u_tag.mem[0] ,
      \u_dut.gen_way[1].gen_memory.u_tag.mem[1] ;
  (* hierconn *) wire [TagW:0] \u_dut.gen_way[2].gen_memory.u_tag.mem[0] ,
      \u_dut.gen_way[2].gen_memory.u_tag.mem[1] ;
  (* hierconn *) wire [TagW:0] \u_dut.gen_way[3].gen_memory.u_tag.mem[0] ,
      \u_dut.gen_way[3].gen_memory.u_tag.mem[1] ;
  (* hierconn *) wire [Ways-1:0] \u_dut.gen_tree.u_recent.mem[0] , \u_dut.gen_tree.u_recent.mem[1] ;
  logic [(TagW+1)*Places-1:0] in_tag;
  assign in_tag = {
    \u_dut.gen_way[3].gen_memory.u_tag.mem[1] , \u_dut.gen_way[2].gen_memory.u_tag.mem[1] ,
        \u_dut.gen_way[1].gen_memory.u_tag.mem[1] ,
    \u_dut.gen_way[0].gen_memory.u_tag.mem[1] , \u_dut.gen_way[3].gen_memory.u_tag.mem[0] ,
        \u_dut.gen_way[2].gen_memory.u_tag.mem[0] ,
    \u_dut.gen_way[1].gen_memory.u_tag.mem[0] , \u_dut.gen_way[0].gen_memory.u_tag.mem[0] };
  logic same;
  always @* begin
    same = 1'b1;
    for (int p = 0; p < Places; p++) begin
      if (in_tag[(TagW+1)*p + TagW] != valid_q[p]) same = 1'b0;
      if (valid_q[p] && in_tag[(TagW+1)*p +: TagW] != tag_q[TagW*p +: TagW]) same = 1'b0;
    end
  end
  always @* if (rst_ni) begin
    t_same: assert (same);
    t_tree: assert ((!used_q[0] || \u_dut.gen_tree.u_recent.mem[0] [1] != last_q[1]) &&
                    (!used_q[1] || \u_dut.gen_tree.u_recent.mem[1] [1] != last_q[3]));
  end
endmodule

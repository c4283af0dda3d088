// Properties of rc_mshr, if it is used as rc_cache uses it:
// - each waiting request is answered once, with the place of its own line, and requests to one line
//   in their order;
// - no request is answered before all words of the line have arrived;
// - an MSHR is free exactly after the last request of its chain.
//
// The proof uses two MSHRs and four ids. It tracks which request waits, for which MSHR, and at
// which position of the chain. It also tracks which lines are in flight, their destination, and how
// many of their words have arrived. The invariants compare the chains' heads, tails and links, and
// the queue of filled lines, with this record.
module mshr #(
  parameter  int unsigned Words = 2,   // 1 or 2
  localparam int unsigned IdBits = 2,
  localparam int unsigned Ids    = 4,
  localparam int unsigned Mshrs  = 2
) (
  input logic       clk_i,
  input logic       rst_ni,
  input logic [1:0] id_i,
  input logic       set_i,
  input logic       way_i,
  input logic       take_i,
  input logic       merge_i,
  input logic       fill_fires_i,
  input logic       fill_mshr_i,
  input logic       drain_i
);
  logic [1:0] waiting_o, drain_id_o;
  logic       full_o, waits_o, free_o, fill_set_o, fill_way_o, drain_valid_o, drain_set_o,
      drain_way_o;
  rc_mshr #(.IdBits(IdBits), .SetW(1), .Ways(2), .Words(Words), .Mshrs(Mshrs)) u_dut (
    .clk_i(clk_i), .rst_ni(rst_ni), .id_i(id_i), .set_i(set_i), .load_i(1'b0), .ahead_set_i(set_i),
    .waiting_o(waiting_o), .full_o(full_o), .waits_o(waits_o),
    .free_o(free_o), .way_i(way_i), .take_i(take_i), .line_way_i(way_i), .merge_i(merge_i),
    .fill_fires_i(fill_fires_i),
    .fill_mshr_i(fill_mshr_i), .fill_set_o(fill_set_o), .fill_way_o(fill_way_o),
    .drain_valid_o(drain_valid_o),
    .drain_id_o(drain_id_o), .drain_set_o(drain_set_o), .drain_way_o(drain_way_o),
    .drain_i(drain_i));

  logic begun_q = 1'b0;
  always @(posedge clk_i) begun_q <= 1'b1;
  always @* if (!begun_q) assume (!rst_ni);

  // ---- What should be the case.
  logic [Ids-1:0]     waits_q, own_q;     // an id waits; for which MSHR
  logic [2*Ids-1:0]   turn_q;             // and how many go before it
  logic [Mshrs-1:0]   busy_q, filled_q, set_q, way_q, words_q;
  logic [3*Mshrs-1:0] count;              // how many wait for an MSHR
  logic               joined;             // the MSHR of {set_i, way_i}
  logic               drained;            // the MSHR of the id that is answered
  assign drained = own_q[drain_id_o];
  always @* begin
    joined = 1'b0;
    for (int m = 0; m < Mshrs; m++) begin
      count[3*m +: 3] = '0;
      for (int i = 0; i < Ids; i++) count[3*m +: 3] = count[3*m +: 3] + (waits_q[i] &&
          own_q[i] == m);
      if (busy_q[m] && set_q[m] == set_i && way_q[m] == way_i) joined = m;
    end
  end
  always @(posedge clk_i) begin
    if (!rst_ni) begin
      waits_q  <= '0;
      busy_q   <= '0;
      filled_q <= '0;
      words_q  <= '0;
    end else begin
      if (take_i || merge_i) begin
        waits_q[id_i] <= 1'b1;
        own_q[id_i]   <= take_i ? free_o : joined;
        turn_q[2*id_i +: 2] <= take_i ? 2'd0 : count[3*joined +: 2];
      end
      if (take_i) begin
        busy_q[free_o] <= 1'b1;
        set_q[free_o]  <= set_i;
        way_q[free_o]  <= way_i;
      end
      if (fill_fires_i) begin
        words_q[fill_mshr_i] <= Words == 2 && !words_q[fill_mshr_i];
        if (Words == 1 || words_q[fill_mshr_i]) filled_q[fill_mshr_i] <= 1'b1;
      end
      if (drain_i) begin
        waits_q[drain_id_o] <= 1'b0;
        for (int i = 0; i < Ids; i++)
          if (waits_q[i] && own_q[i] == drained && i != drain_id_o)
            turn_q[2*i +: 2] <= turn_q[2*i +: 2] - 1'b1;
        if (count[3*drained +: 3] == 3'd1) begin
          busy_q[drained]   <= 1'b0;
          filled_q[drained] <= 1'b0;
        end
      end
    end
  end

  // ---- How rc_cache uses it: rc_tags gives a way that does not wait, and while a filled line is
  // answered nothing is looked up.
  always @* if (rst_ni) begin
    assume ({1'b0, take_i} + merge_i + drain_i <= 2'd1);
    assume (!(take_i || merge_i) || (!waits_q[id_i] && !drain_valid_o));
    assume (!take_i || (!full_o && !waiting_o[way_i]));
    assume (!merge_i || waiting_o[way_i]);
    assume (!drain_i || drain_valid_o);
    assume (!fill_fires_i || (busy_q[fill_mshr_i] && !filled_q[fill_mshr_i]));
  end

  // ---- What it promises.
  always @* if (begun_q && rst_ni) begin
    a_full:    assert (full_o == (&busy_q) && waits_o == (|busy_q));
    a_free:    assert (full_o || !busy_q[free_o]);
    a_drain:   assert (drain_valid_o == (|filled_q));
    a_answer:  assert (!drain_valid_o || (waits_q[drain_id_o] && filled_q[drained]));
    a_in_turn: assert (!drain_valid_o || turn_q[2*drain_id_o +: 2] == '0);
    a_place:   assert (!drain_valid_o ||
        (drain_set_o == set_q[drained] && drain_way_o == way_q[drained]));
    a_fill:    assert (!fill_fires_i ||
        (fill_set_o == set_q[fill_mshr_i] && fill_way_o == way_q[fill_mshr_i]));
    a_waiting: assert (waiting_o == ({1'b0, busy_q[0] && set_q[0] == set_i} << way_q[0] |
                                     {1'b0, busy_q[1] && set_q[1] == set_i} << way_q[1]));
    a_kept:    assert (busy_q[0] == (count[2:0] != '0) && busy_q[1] == (count[5:3] != '0));
  end

  // ---- Ties to the inside, as an induction needs them.
  (* hierconn *) wire \u_dut.gen_mshr[0].busy_q , \u_dut.gen_mshr[1].busy_q ;
  (* hierconn *) wire \u_dut.gen_mshr[0].set_q , \u_dut.gen_mshr[1].set_q ;
  (* hierconn *) wire \u_dut.gen_mshr[0].way_q , \u_dut.gen_mshr[1].way_q ;
  (* hierconn *) wire [1:0] \u_dut.u_head.mem[0] , \u_dut.u_head.mem[1] , \u_dut.u_tail.mem[0] ,
      \u_dut.u_tail.mem[1] ;
  (* hierconn *) wire [1:0] \u_dut.u_last.mem[0] , \u_dut.u_last.mem[1] ;
  (* hierconn *) wire [1:0] \u_dut.u_next.mem[0] , \u_dut.u_next.mem[1] , \u_dut.u_next.mem[2] ,
      \u_dut.u_next.mem[3] ;
  (* hierconn *) wire [1:0] \u_dut.u_place.mem[0] , \u_dut.u_place.mem[1] ;
  (* hierconn *) wire [1:0] \u_dut.u_filled.u_fifo.u_fifo.head_q ,
      \u_dut.u_filled.u_fifo.u_fifo.tail_q ;
  (* hierconn *) wire [2:0] \u_dut.u_filled.u_fifo.u_fifo.mem[0] ,
      \u_dut.u_filled.u_fifo.u_fifo.mem[1] ;
  logic [1:0] in_busy, in_set, in_way, in_words, in_count, in_queue;
  logic [3:0] in_head, in_tail, in_place;
  logic [7:0] in_next;
  logic [5:0] in_filled;
  assign in_busy   = {\u_dut.gen_mshr[1].busy_q , \u_dut.gen_mshr[0].busy_q };
  assign in_set    = {\u_dut.gen_mshr[1].set_q , \u_dut.gen_mshr[0].set_q };
  assign in_way    = {\u_dut.gen_mshr[1].way_q , \u_dut.gen_mshr[0].way_q };
  assign in_head   = {\u_dut.u_head.mem[1] , \u_dut.u_head.mem[0] };
  assign in_tail   = {\u_dut.u_tail.mem[1] , \u_dut.u_tail.mem[0] };
  assign in_next   = {\u_dut.u_next.mem[3] , \u_dut.u_next.mem[2] , \u_dut.u_next.mem[1] ,
      \u_dut.u_next.mem[0] };
  assign in_place  = {\u_dut.u_place.mem[1] , \u_dut.u_place.mem[0] };
  assign in_filled = {\u_dut.u_filled.u_fifo.u_fifo.mem[1] , \u_dut.u_filled.u_fifo.u_fifo.mem[0] };
  assign in_count  = \u_dut.u_filled.u_fifo.u_fifo.tail_q - \u_dut.u_filled.u_fifo.u_fifo.head_q ;
`ifdef Words_1
  assign in_words = words_q;
`else
  (* hierconn *) wire \u_dut.gen_words.words_q[0] , \u_dut.gen_words.words_q[1] ;
  assign in_words = {\u_dut.gen_words.words_q[1] , \u_dut.gen_words.words_q[0] };
`endif

  // The filled lines, first to last: {mshr, set, way}.
  logic [2:0] first, second;
  logic       top;
  assign top    = \u_dut.u_filled.u_fifo.u_fifo.head_q [0];
  assign first  = in_filled[3*top +: 3];
  assign second = in_filled[3*!top +: 3];
  always @* if (begun_q && rst_ni) begin
    t_busy: assert (in_busy == busy_q && (words_q & (filled_q | ~busy_q)) == '0 &&
        in_words == words_q);
    t_apart: assert (!(&busy_q) || set_q[0] != set_q[1] || way_q[0] != way_q[1]);
    t_filled: assert ((filled_q & ~busy_q) == '0 && in_count == {1'b0, filled_q[0]} + filled_q[1]);
    t_first:  assert (in_count == '0 ||
        (filled_q[first[2]] && first[1:0] == {set_q[first[2]], way_q[first[2]]}));
    t_second: assert (in_count < 2'd2 ||
        (second[2] != first[2] && second[1:0] == {set_q[second[2]], way_q[second[2]]}));
    t_last:   assert (!busy_q[0] || \u_dut.u_last.mem[0] == \u_dut.u_tail.mem[0] );
    t_last_1: assert (!busy_q[1] || \u_dut.u_last.mem[1] == \u_dut.u_tail.mem[1] );
    t_line:   assert (line_ok);
    t_owner:  assert (owner_ok);
    t_ends:   assert (ends_ok);
    t_order:  assert (order_ok);
    t_next:   assert (next_ok);
  end

  // Chains: each waiting requester has a line and a turn of its own; first, last and next are as
  // the turns say.
  logic line_ok, owner_ok, ends_ok, order_ok, next_ok;
  always @* begin
    {line_ok, owner_ok, ends_ok, order_ok, next_ok} = '1;
    for (int m = 0; m < Mshrs; m++) if (busy_q[m]) begin
      if (in_set[m] != set_q[m] || in_way[m] != way_q[m] ||
          in_place[2*m +: 2] != {set_q[m], way_q[m]}) line_ok = 1'b0;
    end
    for (int i = 0; i < Ids; i++) if (waits_q[i]) begin
      if (!busy_q[own_q[i]] || turn_q[2*i +: 2] >= count[3*own_q[i] +: 3]) owner_ok = 1'b0;
      if (turn_q[2*i +: 2] == '0 && in_head[2*own_q[i] +: 2] != i) ends_ok = 1'b0;
      if (turn_q[2*i +: 2] + 3'd1 == count[3*own_q[i] +: 3] && in_tail[2*own_q[i] +: 2] != i)
        ends_ok = 1'b0;
      for (int j = 0; j < Ids; j++) if (i != j && waits_q[j] && own_q[i] == own_q[j]) begin
        if (turn_q[2*i +: 2] == turn_q[2*j +: 2]) order_ok = 1'b0;
        if (turn_q[2*i +: 2] + 3'd1 == turn_q[2*j +: 2] && in_next[2*i +: 2] != j) next_ok = 1'b0;
      end
    end
  end
endmodule

// Properties of the whole rc_cache for all time, if ids in use are not given again and memory sends
// each requested word once, in any order and at any time:
// - every request is in exactly one place until it is answered, once, with the word at its address;
// - a way that waits for a line keeps it, and a line is requested once;
// - nothing is dropped;
// - the cache makes progress while it holds a request, unless memory owes a word or answers are not
//   accepted.
//
// The proof uses the smallest cache in which lines are evicted, requests merge into a line in
// flight, and ways and MSHRs run out: one set of two ways, two MSHRs, four ids, queues of two, and
// a memory of four lines of one bit each with arbitrary content (`memory_i`).
module cache_always (
  input logic       clk_i,
  input logic       rst_ni,
  input logic [3:0] memory_i,
  input logic       req_valid_i,
  input logic [1:0] req_id_i,
  input logic [1:0] req_addr_i,
  input logic       rsp_ready_i,
  input logic       miss_ready_i,
  input logic       fill_fires_i,
  input logic       fill_id_i
);
  localparam int unsigned Ids = 4;
  logic       req_ready_o, rsp_valid_o, rsp_bit, miss_valid_o, miss_id, waits_o;
  logic [1:0] rsp_id, miss_addr;
  logic [2:0] outcome_o;
  logic [3:0] line_q;   // of each MSHR
  rc_cache #(.IdBits(2), .AddrBits(2), .Parts(1), .PartW(1), .Sets(1), .Ways(2), .Words(1),
      .Mshrs(2), .Queue(2)) u_dut (
    .clk_i(clk_i), .rst_ni(rst_ni), .req_valid_i(req_valid_i), .req_ready_o(req_ready_o),
    .req_i({req_id_i, req_addr_i}), .rsp_valid_o(rsp_valid_o), .rsp_ready_i(rsp_ready_i),
    .rsp_o({rsp_id, rsp_bit}),
    .miss_valid_o(miss_valid_o), .miss_ready_i(miss_ready_i), .miss_o({miss_id, miss_addr}),
    .fill_fires_i(fill_fires_i), .fill_id_i(fill_id_i),
    .fill_word_i(memory_i[asked_q[2*fill_id_i +: 2]]),
    .waits_o(waits_o), .outcome_o(outcome_o));

  logic       begun_q = 1'b0;
  logic [3:0] memory_q;
  always @(posedge clk_i) begin
    begun_q  <= 1'b1;
    memory_q <= memory_i;
  end
  always @* begin
    assume (rst_ni == begun_q);
    assume (!begun_q || memory_i == memory_q);
  end

  // ---- What should be the case: requests, lines on their way, words that memory owes.
  (* hierconn *) wire       \u_dut.hit , \u_dut.merge , \u_dut.miss , \u_dut.drain , \u_dut.pop ;
  (* hierconn *) wire       \u_dut.way , \u_dut.free ;
  (* hierconn *) wire [1:0] \u_dut.id , \u_dut.addr , \u_dut.drain_id ;
  logic [Ids-1:0]   open_q, waits_q, own_q;
  logic [2*Ids-1:0] wants_q, turn_q;
  logic [1:0]       busy_q, filled_q, way_q, owed_q;
  logic [3:0]       asked_q;
  logic [5:0]       count;
  logic             joined, drained;
  assign drained = own_q[\u_dut.drain_id ];
  assign joined  = busy_q[1] && way_q[1] == \u_dut.way ;
  always @* for (int m = 0; m < 2; m++) begin
    count[3*m +: 3] = '0;
    for (int i = 0; i < Ids; i++) count[3*m +: 3] = count[3*m +: 3] + (waits_q[i] && own_q[i] == m);
  end
  always @(posedge clk_i) begin
    if (!rst_ni) begin
      open_q   <= '0;
      waits_q  <= '0;
      busy_q   <= '0;
      filled_q <= '0;
      owed_q   <= '0;
    end else begin
      if (rsp_valid_o && rsp_ready_i) open_q[rsp_id] <= 1'b0;
      if (req_valid_i && req_ready_o) begin
        open_q[req_id_i] <= 1'b1;
        wants_q[2*req_id_i +: 2] <= req_addr_i;
      end
      if (\u_dut.miss || \u_dut.merge ) begin
        waits_q[\u_dut.id ] <= 1'b1;
        own_q[\u_dut.id ]   <= \u_dut.miss ? \u_dut.free : joined;
        turn_q[2*\u_dut.id +: 2] <= \u_dut.miss ? 2'd0 : count[3*joined +: 2];
      end
      if (\u_dut.miss ) begin
        busy_q[\u_dut.free ] <= 1'b1;
        way_q[\u_dut.free ]  <= \u_dut.way ;
        line_q[2*\u_dut.free +: 2] <= \u_dut.addr ;
      end
      if (miss_valid_o && miss_ready_i) begin
        owed_q[miss_id] <= 1'b1;
        asked_q[2*miss_id +: 2] <= miss_addr;
      end
      if (fill_fires_i) begin
        owed_q[fill_id_i]   <= 1'b0;
        filled_q[fill_id_i] <= 1'b1;
      end
      if (\u_dut.drain ) begin
        waits_q[\u_dut.drain_id ] <= 1'b0;
        for (int i = 0; i < Ids; i++)
          if (waits_q[i] && own_q[i] == drained && i != \u_dut.drain_id )
            turn_q[2*i +: 2] <= turn_q[2*i +: 2] - 1'b1;
        if (count[3*drained +: 3] == 3'd1) begin
          busy_q[drained]   <= 1'b0;
          filled_q[drained] <= 1'b0;
        end
      end
    end
  end
  always @* if (rst_ni) begin
    assume (!req_valid_i || !open_q[req_id_i]);
    assume (!fill_fires_i || owed_q[fill_id_i]);
  end

  // ---- What it promises.
  always @* if (rst_ni) begin
    a_asked: assert (!rsp_valid_o || open_q[rsp_id]);
    a_right: assert (!rsp_valid_o || rsp_bit == memory_i[wants_q[2*rsp_id +: 2]]);
    a_once:  assert (!miss_valid_o || (busy_q[miss_id] && !owed_q[miss_id] && !filled_q[miss_id]));
    a_line:  assert (!miss_valid_o || miss_addr == line_q[2*miss_id +: 2]);
    a_apart: assert (!(&busy_q) || (way_q[0] != way_q[1] && line_q[1:0] != line_q[3:2]));
    a_kept:  assert (!\u_dut.miss ||
        !((busy_q[0] && way_q[0] == \u_dut.way ) || (busy_q[1] && way_q[1] == \u_dut.way )));
    a_place: assert (places_ok);
    a_moves: assert (open_q == '0 || owed_q != '0 || miss_valid_o || !rsp_ready_i || \u_dut.pop ||
        \u_dut.drain || s1_valid ||
                     rsp_valid_o);
  end

  // ---- Ties to the inside, as an induction needs them. First the queues, each first to last.
  (* hierconn *) wire [1:0] \u_dut.gen_at_once.u_in.u_fifo.head_q ,
      \u_dut.gen_at_once.u_in.u_fifo.tail_q , \u_dut.u_answers.head_q , \u_dut.u_answers.tail_q ;
  (* hierconn *) wire [3:0] \u_dut.gen_at_once.u_in.u_fifo.mem[0] ,
      \u_dut.gen_at_once.u_in.u_fifo.mem[1] ;
  (* hierconn *) wire [2:0] \u_dut.u_answers.mem[0] , \u_dut.u_answers.mem[1] ;
  (* hierconn *) wire [1:0] \u_dut.u_misses.u_fifo.u_fifo.head_q ,
      \u_dut.u_misses.u_fifo.u_fifo.tail_q ;
  (* hierconn *) wire [2:0] \u_dut.u_misses.u_fifo.u_fifo.mem[0] ,
      \u_dut.u_misses.u_fifo.u_fifo.mem[1] ;
  (* hierconn *) wire [1:0] \u_dut.u_mshr.u_filled.u_fifo.u_fifo.head_q ,
      \u_dut.u_mshr.u_filled.u_fifo.u_fifo.tail_q ;
  (* hierconn *) wire [2:0] \u_dut.u_mshr.u_filled.u_fifo.u_fifo.mem[0] ,
      \u_dut.u_mshr.u_filled.u_fifo.u_fifo.mem[1] ;
  logic [1:0] in_n, ans_n, miss_n, fill_n;
  logic [7:0] in_q;
  logic [5:0] ans_q, miss_q, fill_q;
  assign in_n   = \u_dut.gen_at_once.u_in.u_fifo.tail_q - \u_dut.gen_at_once.u_in.u_fifo.head_q ;
  assign ans_n  = \u_dut.u_answers.tail_q - \u_dut.u_answers.head_q ;
  assign miss_n = \u_dut.u_misses.u_fifo.u_fifo.tail_q - \u_dut.u_misses.u_fifo.u_fifo.head_q ;
  assign fill_n = \u_dut.u_mshr.u_filled.u_fifo.u_fifo.tail_q -
      \u_dut.u_mshr.u_filled.u_fifo.u_fifo.head_q ;
  assign in_q   = \u_dut.gen_at_once.u_in.u_fifo.head_q [0]
      ? {\u_dut.gen_at_once.u_in.u_fifo.mem[0] , \u_dut.gen_at_once.u_in.u_fifo.mem[1] }
      : {\u_dut.gen_at_once.u_in.u_fifo.mem[1] , \u_dut.gen_at_once.u_in.u_fifo.mem[0] };
  assign ans_q  = \u_dut.u_answers.head_q [0]
      ? {\u_dut.u_answers.mem[0] , \u_dut.u_answers.mem[1] }
      : {\u_dut.u_answers.mem[1] , \u_dut.u_answers.mem[0] };
  assign miss_q = \u_dut.u_misses.u_fifo.u_fifo.head_q [0]
      ? {\u_dut.u_misses.u_fifo.u_fifo.mem[0] , \u_dut.u_misses.u_fifo.u_fifo.mem[1] }
      : {\u_dut.u_misses.u_fifo.u_fifo.mem[1] , \u_dut.u_misses.u_fifo.u_fifo.mem[0] };
  assign fill_q = \u_dut.u_mshr.u_filled.u_fifo.u_fifo.head_q [0]
      ? {\u_dut.u_mshr.u_filled.u_fifo.u_fifo.mem[0] , \u_dut.u_mshr.u_filled.u_fifo.u_fifo.mem[1] }
      : {\u_dut.u_mshr.u_filled.u_fifo.u_fifo.mem[1] ,
          \u_dut.u_mshr.u_filled.u_fifo.u_fifo.mem[0] };

  // Every open request is in one place: queue, chain, s1 or answers; with the right address or
  // data.
  (* hierconn *) wire       \u_dut.s1_valid_q , \u_dut.gen_part[0].u_data.read_q ;
  (* hierconn *) wire [1:0] \u_dut.s1_id_q , \u_dut.u_credits.in_flight_q ;
  logic       places_ok, s1_valid;
  logic [2:0] places;
  assign s1_valid = \u_dut.s1_valid_q ;
  always @* begin
    places_ok = 1'b1;
    for (int i = 0; i < Ids; i++) begin
      places = {2'd0, waits_q[i]} + (s1_valid && \u_dut.s1_id_q == i);
      for (int p = 0; p < 2; p++) begin
        if (p < in_n && in_q[4*p+2 +: 2] == i) begin
          places = places + 1'b1;
          if (in_q[4*p +: 2] != wants_q[2*i +: 2]) places_ok = 1'b0;
        end
        if (p < ans_n && ans_q[3*p+1 +: 2] == i) begin
          places = places + 1'b1;
          if (ans_q[3*p] != memory_i[wants_q[2*i +: 2]]) places_ok = 1'b0;
        end
      end
      if (waits_q[i] && line_q[2*own_q[i] +: 2] != wants_q[2*i +: 2]) places_ok = 1'b0;
      if (s1_valid && \u_dut.s1_id_q == i &&
          \u_dut.gen_part[0].u_data.read_q != memory_i[wants_q[2*i +: 2]])
        places_ok = 1'b0;
      if (places != {2'd0, open_q[i]}) places_ok = 1'b0;
    end
  end

  // Lines in flight: requested or waiting for their request until they are filled, then in the
  // queue of filled lines.
  logic lines_ok;
  always @* begin
    lines_ok = 1'b1;
    for (int m = 0; m < 2; m++) begin
      if (busy_q[m] != (count[3*m +: 3] != '0)) lines_ok = 1'b0;
      if ((owed_q[m] || filled_q[m]) && !busy_q[m]) lines_ok = 1'b0;
      if (owed_q[m] && (filled_q[m] || asked_q[2*m +: 2] != line_q[2*m +: 2])) lines_ok = 1'b0;
      if ((busy_q[m] && !owed_q[m] && !filled_q[m]) !=
          ((miss_n > 0 && miss_q[2] == m) || (miss_n > 1 && miss_q[5] == m))) lines_ok = 1'b0;
      if (filled_q[m] != ((fill_n > 0 && fill_q[2] == m) || (fill_n > 1 && fill_q[5] == m)))
        lines_ok = 1'b0;
    end
    for (int p = 0; p < 2; p++) begin
      if (p < miss_n && miss_q[3*p +: 2] != line_q[2*miss_q[3*p+2] +: 2]) lines_ok = 1'b0;
      if (p < fill_n && fill_q[3*p +: 2] != {1'b0, way_q[fill_q[3*p+2]]}) lines_ok = 1'b0;
    end
    if ((miss_n > 1 && miss_q[2] == miss_q[5]) || (fill_n > 1 && fill_q[2] == fill_q[5]))
      lines_ok = 1'b0;
  end

  // Chains, as in mshr.sv.
  (* hierconn *) wire \u_dut.u_mshr.gen_mshr[0].busy_q , \u_dut.u_mshr.gen_mshr[1].busy_q ;
  (* hierconn *) wire \u_dut.u_mshr.gen_mshr[0].set_q , \u_dut.u_mshr.gen_mshr[1].set_q ;
  (* hierconn *) wire \u_dut.u_mshr.gen_mshr[0].way_q , \u_dut.u_mshr.gen_mshr[1].way_q ;
  (* hierconn *) wire [1:0] \u_dut.u_mshr.u_head.mem[0] , \u_dut.u_mshr.u_head.mem[1] ;
  (* hierconn *) wire [1:0] \u_dut.u_mshr.u_tail.mem[0] , \u_dut.u_mshr.u_tail.mem[1] ;
  (* hierconn *) wire [1:0] \u_dut.u_mshr.u_place.mem[0] , \u_dut.u_mshr.u_place.mem[1] ;
  (* hierconn *) wire [1:0] \u_dut.u_mshr.u_next.mem[0] , \u_dut.u_mshr.u_next.mem[1] ;
  (* hierconn *) wire [1:0] \u_dut.u_mshr.u_next.mem[2] , \u_dut.u_mshr.u_next.mem[3] ;
  logic [3:0] head, tail, place;
  logic [7:0] next;
  logic       chains_ok;
  assign head  = {\u_dut.u_mshr.u_head.mem[1] , \u_dut.u_mshr.u_head.mem[0] };
  assign tail  = {\u_dut.u_mshr.u_tail.mem[1] , \u_dut.u_mshr.u_tail.mem[0] };
  assign place = {\u_dut.u_mshr.u_place.mem[1] , \u_dut.u_mshr.u_place.mem[0] };
  assign next  = {\u_dut.u_mshr.u_next.mem[3] , \u_dut.u_mshr.u_next.mem[2] ,
      \u_dut.u_mshr.u_next.mem[1] ,
                  \u_dut.u_mshr.u_next.mem[0] };
  always @* begin
    chains_ok = {\u_dut.u_mshr.gen_mshr[1].busy_q , \u_dut.u_mshr.gen_mshr[0].busy_q } == busy_q;
    if (busy_q[0] && {\u_dut.u_mshr.gen_mshr[0].set_q , \u_dut.u_mshr.gen_mshr[0].way_q } !=
        {1'b0, way_q[0]}) chains_ok = 1'b0;
    if (busy_q[1] && {\u_dut.u_mshr.gen_mshr[1].set_q , \u_dut.u_mshr.gen_mshr[1].way_q } !=
        {1'b0, way_q[1]}) chains_ok = 1'b0;
    for (int m = 0; m < 2; m++) if (busy_q[m] && place[2*m +: 2] != {1'b0, way_q[m]})
      chains_ok = 1'b0;
    for (int i = 0; i < Ids; i++) if (waits_q[i]) begin
      if (turn_q[2*i +: 2] >= count[3*own_q[i] +: 3]) chains_ok = 1'b0;
      if (turn_q[2*i +: 2] == '0 && head[2*own_q[i] +: 2] != i) chains_ok = 1'b0;
      if (turn_q[2*i +: 2] + 3'd1 == count[3*own_q[i] +: 3] && tail[2*own_q[i] +: 2] != i)
        chains_ok = 1'b0;
      for (int j = 0; j < Ids; j++) if (i != j && waits_q[j] && own_q[i] == own_q[j]) begin
        if (turn_q[2*i +: 2] == turn_q[2*j +: 2]) chains_ok = 1'b0;
        if (turn_q[2*i +: 2] + 3'd1 == turn_q[2*j +: 2] && next[2*i +: 2] != j) chains_ok = 1'b0;
      end
    end
  end

  // What is stored: a way whose line is there has its bit; one that waits has its tag.
  (* hierconn *) wire [2:0] \u_dut.u_tags.gen_way[0].gen_memory.u_tag.mem[0] ,
      \u_dut.u_tags.gen_way[1].gen_memory.u_tag.mem[0] ;
  (* hierconn *) wire       \u_dut.gen_part[0].u_data.mem[0] , \u_dut.gen_part[0].u_data.mem[1] ;
  logic [5:0] tags;
  logic [1:0] data, coming;   // ways for which a line is on its way and not filled
  logic       store_ok;
  assign tags = {\u_dut.u_tags.gen_way[1].gen_memory.u_tag.mem[0] ,
      \u_dut.u_tags.gen_way[0].gen_memory.u_tag.mem[0] };
  assign data = {\u_dut.gen_part[0].u_data.mem[1] , \u_dut.gen_part[0].u_data.mem[0] };
  always @* begin
    store_ok = !(tags[2] && tags[5] && tags[1:0] == tags[4:3]);
    coming   = '0;
    for (int m = 0; m < 2; m++) if (busy_q[m]) begin
      if (tags[3*way_q[m] +: 3] != {1'b1, line_q[2*m +: 2]}) store_ok = 1'b0;
      if (!filled_q[m]) coming[way_q[m]] = 1'b1;
    end
    for (int w = 0; w < 2; w++)
      if (tags[3*w+2] && !coming[w] && data[w] != memory_i[tags[3*w +: 2]]) store_ok = 1'b0;
  end
  always @* if (rst_ni) begin
    t_queues: assert (in_n <= 2 && ans_n <= 2 && miss_n <= 2 && fill_n <= 2);
    t_door:   assert ({1'b0, \u_dut.u_credits.in_flight_q } == {1'b0, ans_n} + s1_valid &&
        \u_dut.u_credits.in_flight_q <= 2'd2);
    t_lines:  assert (lines_ok);
    t_chains: assert (chains_ok);
    t_store:  assert (store_ok);
  end
endmodule

// Non-blocking, set-associative cache of read-only memory: the common part of all caches and of
// rc_stream.
//
// A request waits in a queue of two. The head of the queue is looked up, one request per cycle:
// - A hit is answered 3 cycles after the request was accepted.
// - A miss allocates a free MSHR and a way of its set (rc_tags), and requests the line's words one
//   by one. The first request leaves 2 cycles after the miss was accepted. Each has the id {MSHR,
//   word}. Words may come in any order and are always accepted.
// - A request for a line in flight joins the chain of that line, which may have any length
//   (rc_mshr).
// - A look-up that cannot proceed stays at the head of the queue.
//
// After the last word of a line, the line's requests are answered before the next look-up.
// The first answer leaves 3 cycles after that word, the others follow one per cycle. outcome_o
// reports the outcome of a cycle.
//
// With Cut the latency is two cycles longer. Tags are read when a request comes to the head. The
// head is compared with them in a separate cycle, and waits for its look-up in a register. The data
// passes through another register.
//
// The user holds reset for at least Sets cycles (rc_tags). It reuses an id only after the answer
// was accepted, and sends each requested word once. Memory never changes. Model:
// model/mem/cache.hpp. Proof: tests/formal/cache.sv.
`default_nettype none
module rc_cache #(
  parameter  int unsigned IdBits   = 6,    // of a request's id
  parameter  int unsigned AddrBits = 24,   // of a word's address
  parameter  int unsigned Parts    = 1,    // of a word, 1 or 2; the lowest address bit selects one
  parameter  int unsigned PartW    = 8,    // bits of a part
  parameter  int unsigned Sets     = 64,   // Sets, Ways, Words, Mshrs: powers of two, 1 or more
  parameter  int unsigned Ways     = 4,
  parameter  int unsigned Words    = 1,    // of a line
  parameter  int unsigned Mshrs    = 8,    // lines in flight at most
  parameter  int unsigned Queue    = 4,    // answers that may wait, 2 or more
  parameter  int unsigned Cut      = rc_pkg::PathCut,
  localparam int unsigned PartB    = $clog2(Parts),
  localparam int unsigned WordB    = $clog2(Words),
  localparam int unsigned MissIdW  = (Mshrs < 2 ? 1 : $clog2(Mshrs)) + WordB
) (
  input  logic                             clk_i,
  input  logic                             rst_ni,
  // From the unit that reads
  input  logic                             req_valid_i,
  output logic                             req_ready_o,
  input  logic [IdBits+AddrBits+PartB-1:0] req_i,          // {id, address}
  // To the unit that uses the data
  output logic                             rsp_valid_o,
  input  logic                             rsp_ready_i,
  output logic [IdBits+PartW-1:0]          rsp_o,          // {id, part of a word}
  // In a fast chip: an answer comes to the head of the queue, and its id
  output logic                             next_fires_o,
  output logic [IdBits-1:0]                next_id_o,
  // To and from memory
  output logic                             miss_valid_o,
  input  logic                             miss_ready_i,
  output logic [MissIdW+AddrBits-1:0]      miss_o,         // {id, address of a word}
  input  logic                             fill_fires_i,
  input  logic [MissIdW-1:0]               fill_id_i,
  input  logic [Parts*PartW-1:0]           fill_word_i,
  // Whether lines are in flight, and what the cache did: rc_pkg::cache_outcome_e
  output logic                             waits_o,        // lines are in flight
  output logic [rc_pkg::CauseBits-1:0]     outcome_o
);
  if (Parts < 1 || Parts > 2) begin : gen_refuse
    $error("rc_cache: Parts must be 1 or 2");
  end
  if (IdBits < 1 || PartW < 1) begin : gen_refuse_widths
    $error("rc_cache: IdBits and PartW must be at least 1");
  end
  if (Queue < 2) begin : gen_refuse_queue
    $error("rc_cache: Queue must be at least 2");
  end
  if (AddrBits <= WordB + $clog2(Sets)) begin : gen_refuse_address
    $error("rc_cache: AddrBits must leave a tag");
  end

  // An address field of zero bits is one bit that is always 0.
  localparam int unsigned SetB  = $clog2(Sets);
  localparam int unsigned WayB  = $clog2(Ways);
  localparam int unsigned SetW  = Sets < 2 ? 1 : SetB;
  localparam int unsigned WayW  = Ways < 2 ? 1 : WayB;
  localparam int unsigned SelB  = WordB + PartB;
  localparam int unsigned SelW  = SelB < 1 ? 1 : SelB;   // {word, part}
  localparam int unsigned MshrW = MissIdW - WordB;
  localparam int unsigned ReqAW = AddrBits + PartB;
  localparam int unsigned LineW = AddrBits - WordB;
  localparam int unsigned TagW  = LineW - SetB;
  localparam int unsigned DataD = Sets * Ways * Words;
  localparam int unsigned DataA = DataD < 2 ? 1 : $clog2(DataD);
  localparam int unsigned WordW = Words < 2 ? 1 : WordB;

  // ---- Request at the head, and request in the look-up: the same request, unless Cut puts a
  // register between them.
  logic              load, valid, pop;
  logic [IdBits-1:0] id;
  logic [ReqAW-1:0]  addr;
  logic              next_load;   // with Cut: tags are read for the request that comes to the head
  logic [LineW-1:0]  line, ahead_line, next_line;

  if (Cut == 0) begin : gen_at_once
    rc_fifo #(.Width(IdBits + ReqAW), .Depth(2), .Cut(0)) u_in (
      .clk_i, .rst_ni, .valid_i(req_valid_i), .ready_o(req_ready_o), .data_i(req_i),
      .valid_o(valid), .ready_i(load), .data_o({id, addr}));
    assign load       = pop;
    assign ahead_line = line;
    assign next_load  = 1'b0;
    assign next_line  = line;
  end else begin : gen_ahead   // the queue's two entries, and the request in the look-up
    logic                    valid_q, head_valid_q, back_valid_q, comes;
    logic [IdBits+ReqAW-1:0] request_q, head_q, back_q, next;

    assign valid       = valid_q;
    assign load        = !valid_q || pop;
    assign {id, addr}  = request_q;

    assign ahead_line  = head_q[ReqAW-1 -: LineW];
    assign req_ready_o = !back_valid_q;
    assign comes       = req_valid_i && req_ready_o;
    assign next        = back_valid_q ? back_q : req_i;
    assign next_load   = !head_valid_q || load;
    assign next_line   = next[ReqAW-1 -: LineW];

    always_ff @(posedge clk_i) begin
      if (!rst_ni) begin
        valid_q      <= 1'b0;
        head_valid_q <= 1'b0;
        back_valid_q <= 1'b0;
      end else begin
        valid_q      <= head_valid_q || !load;
        head_valid_q <= !next_load || back_valid_q || comes;
        back_valid_q <= !next_load && (back_valid_q || comes);
      end
      if (load)          request_q <= head_q;
      if (next_load)     head_q    <= next;
      if (!back_valid_q) back_q    <= req_i;
    end
  end

  // Fields of the addresses.
  logic [SetW-1:0]  set, ahead_set, next_set;
  logic [SelW-1:0]  select;

  assign line       = addr[ReqAW-1 -: LineW];
  assign set        = line[SetW-1:0] & SetW'(Sets - 1);
  assign ahead_set  = ahead_line[SetW-1:0] & SetW'(Sets - 1);
  assign next_set   = next_line[SetW-1:0] & SetW'(Sets - 1);
  assign select     = addr[SelW-1:0] & SelW'((1 << SelB) - 1);

  // ---- Action of this cycle.
  logic            open, draining, lookup, drain, found, full, conflict;
  logic            hit, merge, miss, joins;
  logic [WayW-1:0] way, line_way;
  logic [Ways-1:0] waiting, hits;

  assign joins  = (hits & waiting) != '0;
  assign drain  = draining && open;
  assign lookup = valid && !draining && open;
  assign hit    = lookup && found && !joins;
  assign merge  = lookup && found && joins;
  assign miss   = lookup && !found && !full && !conflict;
  assign pop    = lookup && (found || (!full && !conflict));   // one of the three

  always_comb begin
    if (!draining && !valid) outcome_o = rc_pkg::CacheStarved;
    else if (!open)          outcome_o = rc_pkg::CacheAnswers;
    else if (draining)       outcome_o = rc_pkg::CacheDrain;
    else if (found)          outcome_o = joins ? rc_pkg::CacheMerge : rc_pkg::CacheHit;
    else if (full)           outcome_o = rc_pkg::CacheMshrs;
    else                     outcome_o = conflict ? rc_pkg::CacheConflict : rc_pkg::CacheMiss;
  end

  // Tags of the sets.
  rc_tags #(.TagW(TagW), .Sets(Sets), .Ways(Ways), .Cut(Cut)) u_tags (
    .clk_i, .rst_ni, .next_load_i(next_load), .next_set_i(next_set),
    .load_i(load), .ahead_set_i(ahead_set), .ahead_tag_i(ahead_line[LineW-1 -: TagW]), .set_i(set),
    .tag_i(line[LineW-1 -: TagW]), .waiting_i(waiting),
    .hits_o(hits), .hit_o(found), .found_o(line_way), .conflict_o(conflict), .way_o(way),
    .touch_i(pop), .take_i(miss));

  // Lines in flight.
  logic [MshrW-1:0]  free;
  logic [IdBits-1:0] drain_id;
  logic [SetW-1:0]   fill_set, drain_set;
  logic [WayW-1:0]   fill_way, drain_way;

  rc_mshr #(.IdBits(IdBits), .SetW(SetW), .Ways(Ways), .Words(Words), .Mshrs(Mshrs),
    .Cut(Cut)) u_mshr (
    .clk_i, .rst_ni,
    .id_i(id), .set_i(set), .load_i(load), .ahead_set_i(ahead_set), .waiting_o(waiting),
    .full_o(full), .waits_o, .free_o(free),
    .way_i(way), .take_i(miss), .line_way_i(line_way), .merge_i(merge),
    .fill_fires_i, .fill_mshr_i(fill_id_i[MissIdW-1 -: MshrW]),
    .fill_set_o(fill_set), .fill_way_o(fill_way),
    .drain_valid_o(draining), .drain_id_o(drain_id), .drain_set_o(drain_set),
    .drain_way_o(drain_way), .drain_i(drain));

  // ---- Misses: requests for words, line by line.
  logic             line_requested;
  logic [MshrW-1:0] miss_mshr;
  logic [LineW-1:0] miss_line;

  rc_queue #(.Width(MshrW + LineW), .Depth(Mshrs)) u_misses (
    .clk_i, .rst_ni, .push_i(miss), .data_i({free, line}),
    .valid_o(miss_valid_o), .pop_i(line_requested), .data_o({miss_mshr, miss_line}));

  if (Words == 1) begin : gen_miss_line
    assign line_requested = miss_valid_o && miss_ready_i;
    assign miss_o         = {miss_mshr, miss_line};
  end else begin : gen_miss_word
    logic [WordW-1:0] word_q;
    assign line_requested = miss_valid_o && miss_ready_i && word_q == WordW'(Words - 1);
    assign miss_o         = {miss_mshr, word_q, miss_line, word_q};

    always_ff @(posedge clk_i) begin
      if (!rst_ni) word_q <= '0;
      else if (miss_valid_o && miss_ready_i) word_q <= word_q + 1'b1;
    end
  end

  // ---- Word and part of a waiting request: stored until its line is there.
  logic [SelW-1:0] drain_select, read_select;
  if (SelB == 0) begin : gen_no_select
    assign drain_select = '0;
  end else begin : gen_select
    rc_ram #(.Width(SelB), .Depth(1 << IdBits)) u_select (
      .clk_i, .write_i(merge || miss), .write_addr_i(id), .write_data_i(select),
      .read_addr_i(drain_id), .read_data_o(drain_select));
  end

  assign read_select = draining ? drain_select : select;

  // ---- s1: data of a hit, or of a waiting request. The credit counter reserves its place in the
  // queue.
  function automatic logic [DataA-1:0] place(input logic [SetW-1:0] s, input logic [WayW-1:0] w,
      input logic [WordW-1:0] word);
    place = DataA'(s) << (WayB + WordB) | DataA'(w) << WordB | DataA'(word);
  endfunction

  logic              admit, s1_valid_q, end_valid, rsp_place;
  logic [DataA-1:0]  read_at, fill_at;
  logic [IdBits-1:0] s1_id_q;
  logic [WordW-1:0]  read_word;

  assign admit     = hit || drain;
  assign read_word = WordW'(read_select >> PartB);
  assign read_at   = draining ? place(drain_set, drain_way, read_word)
                              : place(set, line_way, read_word);
  assign fill_at   = place(fill_set, fill_way, fill_id_i[WordW-1:0] & WordW'(Words - 1));

  rc_credit_counter #(.Credits(Queue)) u_credits (
    .clk_i, .rst_ni, .admit_i(admit), .leave_i(rsp_valid_o && rsp_ready_i), .open_o(open));

  always_ff @(posedge clk_i) begin
    if (!rst_ni) s1_valid_q <= 1'b0;
    else         s1_valid_q <= admit;
    if (admit) s1_id_q <= draining ? drain_id : id;
  end

  // Each part has its own memory, and only the requested part is read. With Cut every part is read
  // in every cycle, because the admission is known late; its valid bit follows the data.
  logic [PartW-1:0] s1_data;

  for (genvar p = 0; p < Parts; p++) begin : gen_part
    logic [PartW-1:0] data;
    rc_ram_sync #(.Width(PartW), .Depth(DataD)) u_data (
      .clk_i, .write_i(fill_fires_i), .write_addr_i(fill_at),
      .write_data_i(fill_word_i[p*PartW +: PartW]),
      .read_i(Cut != 0 || (admit && (Parts == 1 || read_select[0] == (p == 1)))),
      .read_addr_i(read_at),
      .read_data_o(data));
  end

  if (Parts == 1) begin : gen_whole
    assign s1_data = gen_part[0].data;
  end else begin : gen_half
    logic s1_part_q;
    always_ff @(posedge clk_i) if (admit) s1_part_q <= read_select[0];
    assign s1_data = s1_part_q ? gen_part[1].data : gen_part[0].data;
  end

  // ---- Answers.
  logic [IdBits+PartW-1:0] end_answer;

  rc_path_register #(.Width(IdBits + PartW), .Stages(Cut)) u_answer (
    .clk_i, .data_i({s1_id_q, s1_data}), .data_o(end_answer));

  if (Cut == 0) begin : gen_answer_now
    assign end_valid = s1_valid_q;
  end else begin : gen_answer_late
    logic end_valid_q;
    always_ff @(posedge clk_i) begin
      if (!rst_ni) end_valid_q <= 1'b0;
      else         end_valid_q <= s1_valid_q;
    end
    assign end_valid = end_valid_q;
  end

  logic [IdBits+PartW-1:0] next_answer;

  rc_fifo_peek #(.Width(IdBits + PartW), .Depth(Queue)) u_answers (
    .clk_i, .rst_ni, .valid_i(end_valid), .ready_o(rsp_place), .data_i(end_answer),
    .valid_o(rsp_valid_o), .ready_i(rsp_ready_i), .data_o(rsp_o), .next_fires_o,
    .next_o(next_answer));

  assign next_id_o = next_answer[PartW +: IdBits];

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) if (rst_ni && end_valid)
    a_answer_never_dropped: assert (rsp_place)
    else $error("an answer met a full queue");

  always_ff @(posedge clk_i) if (rst_ni && admit && fill_fires_i)
    a_word_is_there: assert (read_at != fill_at)
    else $error("a word is read while it comes");

  logic [(1<<IdBits)-1:0] pending_q;   // ids between request and answer
  always_ff @(posedge clk_i) begin
    if (!rst_ni) pending_q <= '0;
    else begin
      if (rsp_valid_o && rsp_ready_i) pending_q[rsp_o[PartW +: IdBits]] <= 1'b0;
      if (req_valid_i && req_ready_o) pending_q[req_i[ReqAW +: IdBits]] <= 1'b1;
    end
  end
  always_ff @(posedge clk_i) if (rst_ni && req_valid_i && req_ready_o)
    a_id_is_free: assert (!pending_q[req_i[ReqAW +: IdBits]])
    else $error("a request with the id of one that is not answered");
`endif

  logic unused;
  assign unused = ^{rsp_place, next_line, next_answer};
endmodule
`default_nettype wire

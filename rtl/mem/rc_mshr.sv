// The lines of a cache that are in flight, and the requests that wait for them. Part of rc_cache.
//
// Each line in flight has a miss status holding register (MSHR) with its set and way. Its waiting
// requests form a chain through their ids, first to last. A request allocates a free MSHR, or joins
// the chain of the line that line_way_i waits for.
//
// Words come in any order. The last word fills the line, and from the next cycle on its chain is
// answered, one request per drain_i. In those cycles no request may allocate or merge. The MSHR is
// free after the last answer.
//
// Model: Mshr, ask() and drain() in model/mem/cache.cpp. Proof: tests/formal/mshr.sv.
`default_nettype none
module rc_mshr #(
  parameter  int unsigned IdBits = 6,
  parameter  int unsigned SetW   = 6,
  parameter  int unsigned Ways   = 4,
  parameter  int unsigned Words  = 1,   // of a line
  parameter  int unsigned Mshrs  = 8,
  parameter  int unsigned Cut    = 0,   // 1: sets are compared one cycle earlier, as in rc_tags
  localparam int unsigned WayW   = Ways < 2 ? 1 : $clog2(Ways),
  localparam int unsigned WordW  = Words < 2 ? 1 : $clog2(Words),
  localparam int unsigned MshrW  = Mshrs < 2 ? 1 : $clog2(Mshrs)
) (
  input  logic              clk_i,
  input  logic              rst_ni,
  // Request in the look-up
  input  logic [IdBits-1:0] id_i,
  input  logic [SetW-1:0]   set_i,
  input  logic              load_i,        // with Cut: the request ahead is the next one
  input  logic [SetW-1:0]   ahead_set_i,   // without Cut: the same as set_i
  output logic [Ways-1:0]   waiting_o,     // ways of its set that wait for a line
  output logic              full_o,        // all MSHRs are busy
  output logic              waits_o,       // at least one MSHR is busy
  output logic [MshrW-1:0]  free_o,        // the lowest free MSHR
  input  logic [WayW-1:0]   way_i,
  input  logic              take_i,        // allocates the free MSHR: way_i waits from now on
  input  logic [WayW-1:0]   line_way_i,
  input  logic              merge_i,       // line_way_i waits already: joins the chain
  // Word from memory, and the place of its line
  input  logic              fill_fires_i,
  input  logic [MshrW-1:0]  fill_mshr_i,
  output logic [SetW-1:0]   fill_set_o,
  output logic [WayW-1:0]   fill_way_o,
  // Request to be answered, and the place of its line
  output logic              drain_valid_o,
  output logic [IdBits-1:0] drain_id_o,
  output logic [SetW-1:0]   drain_set_o,
  output logic [WayW-1:0]   drain_way_o,
  input  logic              drain_i
);
  if (Words < 1 || (Words & (Words - 1)) != 0) begin : gen_refuse
    $error("rc_mshr: Words and Mshrs must be powers of two");
  end
  if (Cut > 1) begin : gen_refuse_cut
    $error("rc_mshr: Cut must be 0 or 1");
  end
  if (Mshrs < 1 || (Mshrs & (Mshrs - 1)) != 0) begin : gen_refuse_mshrs
    $error("rc_mshr: Words and Mshrs must be powers of two");
  end

  logic [MshrW-1:0] drained;   // MSHR at the head of the filled ones
  logic             is_last;   // no other request waits for it
  logic [MshrW-1:0] joined;    // MSHR of line_way_i
  logic [Mshrs-1:0] busy;

  // Registers. Each MSHR compares its set, and the results are combined from the lowest MSHR up.
  for (genvar m = 0; m < Mshrs; m++) begin : gen_mshr
    logic            busy_q, takes, is_free;   // is_free: the lowest free one
    assign busy[m] = busy_q;

    logic [SetW-1:0] set_q;
    logic [WayW-1:0] way_q;

    assign takes = take_i && is_free;

    always_ff @(posedge clk_i) begin
      if (!rst_ni) busy_q <= 1'b0;
      else if (takes) busy_q <= 1'b1;
      else if (drain_i && is_last && drained == MshrW'(m)) busy_q <= 1'b0;
      if (takes) begin
        set_q <= set_i;
        way_q <= way_i;
      end
    end

    // Combined over this MSHR and those below.
    logic             here, some;
    logic [Ways-1:0]  waiting;
    logic [MshrW-1:0] free, match;

    if (Cut == 0) begin : gen_at_once
      assign here = busy_q && set_q == set_i;
    end else begin : gen_ahead
      logic same_set_q;
      always_ff @(posedge clk_i)
        if (load_i)
          same_set_q <= takes ? set_i == ahead_set_i : set_q == ahead_set_i;
      assign here = busy_q && same_set_q;
    end

    if (m == 0) begin : gen_first
      assign is_free = !busy_q;
      assign some    = busy_q;
      assign waiting = here ? Ways'(1) << way_q : '0;
      assign free    = '0;
      assign match   = '0;
    end else begin : gen_next
      assign is_free = !busy_q && &busy[m-1:0];
      assign some    = busy_q || gen_mshr[m-1].some;
      assign waiting = (here ? Ways'(1) << way_q : '0) | gen_mshr[m-1].waiting;
      assign free    = (is_free ? MshrW'(m) : '0) | gen_mshr[m-1].free;
      assign match   = here && way_q == line_way_i ? MshrW'(m) : gen_mshr[m-1].match;
    end
  end

  assign full_o    = &busy;
  assign waits_o   = gen_mshr[Mshrs-1].some;
  assign waiting_o = gen_mshr[Mshrs-1].waiting;
  assign free_o    = gen_mshr[Mshrs-1].free;
  assign joined    = gen_mshr[Mshrs-1].match;

  // Chains. The tail of a chain is stored twice, for two reads in one cycle. So the chain that a
  // request joins does not affect which request is answered.
  logic [IdBits-1:0] head, tail, last, next;

  rc_ram #(.Width(IdBits), .Depth(Mshrs)) u_head (
    .clk_i, .write_i(take_i || drain_i), .write_addr_i(take_i ? free_o : drained),
    .write_data_i(take_i ? id_i : next), .read_addr_i(drained), .read_data_o(head));
  rc_ram #(.Width(IdBits), .Depth(Mshrs)) u_tail (
    .clk_i, .write_i(take_i || merge_i), .write_addr_i(take_i ? free_o : joined),
    .write_data_i(id_i), .read_addr_i(joined), .read_data_o(tail));
  rc_ram #(.Width(IdBits), .Depth(Mshrs)) u_last (
    .clk_i, .write_i(take_i || merge_i), .write_addr_i(take_i ? free_o : joined),
    .write_data_i(id_i), .read_addr_i(drained), .read_data_o(last));
  rc_ram #(.Width(IdBits), .Depth(1 << IdBits)) u_next (
    .clk_i, .write_i(merge_i), .write_addr_i(tail), .write_data_i(id_i),
    .read_addr_i(head), .read_data_o(next));

  assign is_last    = head == last;
  assign drain_id_o = head;

  // Words received, modulo Words: 0 again when the line is filled.
  logic filled;
  if (Words == 1) begin : gen_word
    assign filled = fill_fires_i;
  end else begin : gen_words
    (* mem2reg *) logic [WordW-1:0] words_q [Mshrs < 2 ? 2 : Mshrs];
    logic [WordW-1:0] words;

    assign words  = words_q[fill_mshr_i];
    assign filled = fill_fires_i && words == WordW'(Words - 1);

    always_ff @(posedge clk_i) begin
      if (!rst_ni) begin
        for (int m = 0; m < (Mshrs < 2 ? 2 : Mshrs); m++) words_q[m] <= '0;
      end else if (fill_fires_i) begin
        words_q[fill_mshr_i] <= words + 1'b1;
      end
    end
  end

  // Place of each line, and the queue of filled lines.
  rc_ram #(.Width(SetW + WayW), .Depth(Mshrs)) u_place (
    .clk_i, .write_i(take_i), .write_addr_i(free_o), .write_data_i({set_i, way_i}),
    .read_addr_i(fill_mshr_i), .read_data_o({fill_set_o, fill_way_o}));
  rc_queue #(.Width(MshrW + SetW + WayW), .Depth(Mshrs)) u_filled (
    .clk_i, .rst_ni, .push_i(filled), .data_i({fill_mshr_i, fill_set_o, fill_way_o}),
    .valid_o(drain_valid_o), .pop_i(drain_i && is_last),
    .data_o({drained, drain_set_o, drain_way_o}));

  logic unused;
  assign unused = ^{load_i, ahead_set_i};

`ifndef SYNTHESIS
  logic [Mshrs-1:0] awaits_q;   // words of its line are in flight

  always_ff @(posedge clk_i) begin
    if (!rst_ni) awaits_q <= '0;
    else begin
      if (take_i) awaits_q[free_o] <= 1'b1;
      if (filled) awaits_q[fill_mshr_i] <= 1'b0;
    end
  end

  always_ff @(posedge clk_i) if (rst_ni && fill_fires_i)
    a_fill_is_awaited: assert (awaits_q[fill_mshr_i])
    else $error("a word came for a line that is not on its way");

  always_ff @(posedge clk_i) if (rst_ni)
    a_one_thing: assert ($onehot0({take_i, merge_i, drain_i}))
    else $error("a request and a filled line at the chains in one cycle");

  always_ff @(posedge clk_i) if (rst_ni && take_i) a_take_is_free: assert (!full_o)
    else $error("no free MSHR to take");

  always_ff @(posedge clk_i) if (rst_ni && merge_i)
    a_merge_has_line: assert (waiting_o[line_way_i])
    else $error("merged with a line that is not on its way");
`endif
endmodule
`default_nettype wire

// Tags of a cache, and the replacement order of each set (tree-PLRU). Part of rc_cache.
//
// Finds the way of a line. If the line is missing, selects the way to replace: the set's
// pseudo-least-recently-used way. If that way waits for a line, selects the lowest way that does
// not wait. The look-up takes one cycle, and the next one includes touch_i and take_i.
//
// With Cut the tags are in a block RAM. They are read when a request moves ahead (next_*,
// accepted with next_load_i) and compared one cycle before the look-up (ahead_*, accepted with
// load_i). The comparison includes the changes that earlier requests make in these cycles.
//
// Each way's tags are in a separate memory, so a new line writes one memory. Reset clears the sets
// one by one: the user must hold it for at least Sets cycles. Model: look_up() and touched() in
// model/mem/cache.hpp, victim() in model/mem/cache.cpp. Proof: tests/formal/tags.sv.
`default_nettype none
module rc_tags #(
  parameter  int unsigned TagW = 18,
  parameter  int unsigned Sets = 64,   // powers of two, 1 or more
  parameter  int unsigned Ways = 4,
  parameter  int unsigned Cut  = 0,    // 1: a register after the comparison
  localparam int unsigned SetW = Sets < 2 ? 1 : $clog2(Sets),
  localparam int unsigned WayW = Ways < 2 ? 1 : $clog2(Ways)
) (
  input  logic            clk_i,
  input  logic            rst_ni,
  // Request ahead
  input  logic            next_load_i, // with Cut: tags are read for the request that moves ahead
  input  logic [SetW-1:0] next_set_i,
  input  logic            load_i,      // with Cut: the request ahead is the next one
  input  logic [SetW-1:0] ahead_set_i, // without Cut: the same as set_i, tag_i
  input  logic [TagW-1:0] ahead_tag_i,
  // Request in the look-up
  input  logic [SetW-1:0] set_i,
  input  logic [TagW-1:0] tag_i,
  input  logic [Ways-1:0] waiting_i,   // ways of the set that wait for a line
  output logic [Ways-1:0] hits_o,      // the way that has the line
  output logic            hit_o,       // a way has the line
  output logic            conflict_o,  // all ways wait
  output logic [WayW-1:0] found_o,     // the way that has the line
  output logic [WayW-1:0] way_o,       // found_o, or the way to replace
  input  logic            touch_i,     // way_o is used
  input  logic            take_i       // way_o is allocated to this line
);
  if (TagW < 1) begin : gen_refuse
    $error("rc_tags: TagW must be at least 1");
  end
  if (Sets < 1 || (Sets & (Sets - 1)) != 0) begin : gen_refuse_sets
    $error("rc_tags: Sets and Ways must be powers of two");
  end
  if (Ways < 1 || (Ways & (Ways - 1)) != 0) begin : gen_refuse_ways
    $error("rc_tags: Sets and Ways must be powers of two");
  end
  if (Cut > 1) begin : gen_refuse_cut
    $error("rc_tags: Cut must be 0 or 1");
  end

  localparam int unsigned Levels = $clog2(Ways);

  // Set to clear. It may start anywhere, but a simulator with unknown values needs a defined start.
  logic [SetW-1:0] clear_q = '0;
  logic [SetW-1:0] write_set;

  always_ff @(posedge clk_i) if (!rst_ni) clear_q <= clear_q + 1'b1;

  assign write_set = rst_ni ? set_i : clear_q & SetW'(Sets - 1);

  // With Cut the request of the cycle before. Its changes bypass the memories: a line that arrives
  // while tags are read, and the tree, which is written one cycle late.
  logic [SetW-1:0] late_set;
  logic [TagW-1:0] late_tag;
  logic            same_late;   // the request before and the one ahead have the same set

  if (Cut == 0) begin : gen_now
    assign {late_set, late_tag} = {set_i, tag_i};
  end else begin : gen_late
    logic [SetW+TagW-1:0] late_q;
    always_ff @(posedge clk_i) if (next_load_i) late_q <= {set_i, tag_i};
    assign {late_set, late_tag} = late_q;
  end

  logic [TagW:0] new_entry, late_entry, ahead_entry;

  assign same_late   = late_set == ahead_set_i;
  assign ahead_entry = {1'b1, ahead_tag_i};
  assign new_entry   = {1'b1, tag_i};
  assign late_entry  = {1'b1, late_tag};

  logic            same_set;   // the request and the one ahead have the same set
  logic [WayW-1:0] victim;     // the way to replace

  assign same_set = set_i == ahead_set_i;

  // Ways.
  for (genvar w = 0; w < Ways; w++) begin : gen_way
    logic [TagW:0] entry;   // {valid, tag}
    logic          takes;

    assign takes = take_i && victim == WayW'(w);

    if (Cut == 0) begin : gen_memory
      rc_ram #(.Width(TagW + 1), .Depth(Sets)) u_tag (
        .clk_i, .write_i(!rst_ni || takes), .write_addr_i(write_set),
        .write_data_i(rst_ni ? {1'b1, tag_i} : '0), .read_addr_i(ahead_set_i),
        .read_data_o(entry));
    end else begin : gen_block
      rc_ram_sync #(.Width(TagW + 1), .Depth(Sets)) u_tag (
        .clk_i, .write_i(!rst_ni || takes), .write_addr_i(write_set),
        .write_data_i(rst_ni ? {1'b1, tag_i} : '0), .read_i(next_load_i),
        .read_addr_i(next_set_i), .read_data_o(entry));
    end

    // Combined over this way and those below: one has the line; all wait; the way that has it; the
    // lowest that does not wait.
    logic            mine, hit, full;
    logic [WayW-1:0] found, lowest;

    if (Cut == 0) begin : gen_at_once
      assign mine = entry == ahead_entry;
    end else begin : gen_ahead
      // Data of a block RAM arrives late. So this cycle compares pairs of bits, and the look-up
      // combines them. took_q: the way was allocated to another line while its tags were read.
      localparam int unsigned Pairs = (TagW + 2) / 2;
      logic             took_q;
      logic [Pairs-1:0] mine_q, same_new, same_took, same_entry;

      for (genvar p = 0; p < Pairs; p++) begin : gen_pair
        localparam int unsigned Bits = 2 * p + 1 < TagW + 1 ? 2 : 1;
        assign same_new[p]   = new_entry[2*p +: Bits] == ahead_entry[2*p +: Bits];
        assign same_took[p]  = late_entry[2*p +: Bits] == ahead_entry[2*p +: Bits];
        assign same_entry[p] = entry[2*p +: Bits] == ahead_entry[2*p +: Bits];
      end

      always_ff @(posedge clk_i) begin
        if (next_load_i) took_q <= takes;
        if (load_i)
          mine_q <= takes && same_set ? same_new : took_q && same_late ? same_took : same_entry;
      end

      assign mine = &mine_q;
    end

    assign hits_o[w] = mine;
    if (w == 0) begin : gen_first
      assign hit    = mine;
      assign full   = waiting_i[0];
      assign found  = '0;
      assign lowest = '0;
    end else begin : gen_next
      assign hit    = mine || gen_way[w-1].hit;
      assign full   = waiting_i[w] && gen_way[w-1].full;
      assign found  = mine ? WayW'(w) : gen_way[w-1].found;
      assign lowest = gen_way[w-1].full ? WayW'(w) : gen_way[w-1].lowest;
    end
  end

  // Results.
  assign hit_o      = gen_way[Ways-1].hit;
  assign found_o    = gen_way[Ways-1].found;
  assign conflict_o = gen_way[Ways-1].full;

  // The replacement tree. Bit n points to the half of node n's ways that was used longer ago. Node
  // 1 is the root; the children of n are 2n and 2n + 1.
  logic [WayW-1:0] oldest;
  if (Ways == 1) begin : gen_no_tree
    assign oldest = '0;
    logic unused;
    assign unused = touch_i;
  end else begin : gen_tree
    logic            touched;
    logic [SetW-1:0] tree_set;

    assign tree_set = rst_ni ? late_set : clear_q & SetW'(Sets - 1);

    logic [Ways-1:0] recent, recent_d, stored, late_recent;

    rc_ram #(.Width(Ways), .Depth(Sets)) u_recent (
      .clk_i, .write_i(!rst_ni || touched), .write_addr_i(tree_set),
      .write_data_i(rst_ni ? late_recent : '0), .read_addr_i(ahead_set_i),
      .read_data_o(stored));

    rc_path_register #(.Width(Ways), .Stages(Cut)) u_recent_late (
      .clk_i, .data_i(recent_d), .data_o(late_recent));

    if (Cut == 0) begin : gen_at_once
      assign recent  = stored;
      assign touched = touch_i;

    end else begin : gen_ahead
      logic            touched_q;
      logic [Ways-1:0] recent_q;

      always_ff @(posedge clk_i) begin
        if (!rst_ni) touched_q <= 1'b0;
        else         touched_q <= touch_i;
        if (load_i)
          recent_q <= touch_i && same_set ? recent_d
                    : touched_q && same_late ? late_recent : stored;
      end

      assign recent  = recent_q;
      assign touched = touched_q;
    end

    always_comb begin
      oldest = '0;
      for (int l = 0; l < Levels; l++) oldest = oldest << 1 | WayW'(recent[WayW'(1 << l) | oldest]);
    end
    always_comb begin
      recent_d = recent;
      for (int l = 0; l < Levels; l++)
        recent_d[WayW'(1 << l) | way_o >> (Levels - l)] = !way_o[Levels-1-l];
    end
  end

  assign victim = waiting_i[oldest] ? gen_way[Ways-1].lowest : oldest;
  assign way_o  = hit_o ? found_o : victim;

  logic unused;
  assign unused = ^{load_i, same_set, same_late, new_entry, late_entry, next_load_i, next_set_i};

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) if (rst_ni && take_i)
    a_way_is_free: assert (!hit_o && !waiting_i[way_o])
    else $error("a way was given away that waits for a line");
`endif
endmodule
`default_nettype wire

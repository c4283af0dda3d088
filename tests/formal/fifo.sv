// Properties of rc_fifo_peek, and so of rc_fifo, for any traffic on both sides: each entry leaves
// once, in order and unchanged, and nothing else leaves. ready and an offer stay until they are
// used.
//
// The proof follows one arbitrary entry: `pick_i` selects it, and `ahead_q` entries leave before
// it. The induction needs invariants of the inside: the pointers agree with the number of entries,
// and the followed entry is at its place.
module fifo #(
  parameter  int unsigned Depth  = 4,   // 2 or 4
  parameter  int unsigned Width  = 2,
  parameter  int unsigned Cut    = 0,   // 0 or 1
  parameter  bit          Second = 0,
  localparam int unsigned IndexW = $clog2(Depth)
) (
  input logic             clk_i,
  input logic             rst_ni,
  input logic             valid_i,
  input logic [Width-1:0] data_i,
  input logic             ready_i,
  input logic             pick_i
);
  logic             ready_o, valid_o;
  logic [Width-1:0] data_o, next_data;
  logic             next_fires;
  rc_fifo_peek #(.Width(Width), .Depth(Depth), .Cut(Cut), .Second(Second)) u_dut (
    .clk_i(clk_i), .rst_ni(rst_ni), .valid_i(valid_i), .ready_o(ready_o), .data_i(data_i),
    .valid_o(valid_o), .ready_i(ready_i), .data_o(data_o), .next_fires_o(next_fires),
    .next_o(next_data));
  (* hierconn *) wire [IndexW:0] \u_dut.head_q ;
  (* hierconn *) wire [IndexW:0] \u_dut.tail_q ;

`ifdef Cut_1
  (* hierconn *) wire [IndexW:0] \u_dut.gen_ahead.next_q ;
  wire [IndexW:0] next = \u_dut.gen_ahead.next_q - \u_dut.head_q ;
`else
  wire [IndexW:0] next = 1;
`endif

  logic begun_q = 1'b0;
  always @(posedge clk_i) begun_q <= 1'b1;
  always @* if (!begun_q) assume (!rst_ni);

  logic [IndexW:0] inside;
  assign inside = \u_dut.tail_q - \u_dut.head_q ;

  // told ahead; no head stayed
  logic             enters, leaves, follows_q, stalled_q, open_q, told_q, gone_q;
  logic [Width-1:0] told_data_q;
  logic [IndexW:0]  count_q, ahead_q;
  logic [Width-1:0] token_q, shown_q;
  assign enters = valid_i && ready_o;
  assign leaves = valid_o && ready_i;
  always @(posedge clk_i) begin
    if (!rst_ni) begin
      count_q   <= '0;
      follows_q <= 1'b0;
      stalled_q <= 1'b0;
      open_q    <= 1'b0;
    end else begin
      count_q   <= count_q + enters - leaves;
      stalled_q <= valid_o && !ready_i;
      open_q    <= ready_o && !valid_i;
      if (!follows_q && enters && pick_i) begin
        follows_q <= 1'b1;
        ahead_q   <= count_q - leaves;
        token_q   <= data_i;
      end else if (follows_q && leaves) begin
        if (ahead_q == '0) follows_q <= 1'b0;
        ahead_q <= ahead_q - 1'b1;
      end
    end
    shown_q <= data_o;
    told_q  <= rst_ni && next_fires;
    gone_q  <= rst_ni && (!valid_o || ready_i);
    told_data_q <= next_data;
  end

`ifdef Cut_1
  (* hierconn *) wire \u_dut.gen_ahead.many_q ;
  wire many = \u_dut.gen_ahead.many_q ;
`else
  wire many = count_q > 1;
`endif

  // The followed entry's place.
  (* hierconn *) wire [Width-1:0] \u_dut.mem[0] , \u_dut.mem[1] ;
`ifdef Depth_2
  wire [Width-1:0] \u_dut.mem[2] = '0, \u_dut.mem[3] = '0;
`else
  (* hierconn *) wire [Width-1:0] \u_dut.mem[2] , \u_dut.mem[3] ;
`endif
  logic [IndexW-1:0]  place;
  logic [Width-1:0]   kept;
  logic [4*Width-1:0] all;
  assign place = \u_dut.head_q [IndexW-1:0] + ahead_q[IndexW-1:0];
  assign all   = {\u_dut.mem[3] , \u_dut.mem[2] , \u_dut.mem[1] , \u_dut.mem[0] };
  assign kept  = all[place*Width +: Width];

`ifdef Second_1
  (* hierconn *) wire [Width-1:0] \u_dut.gen_ahead.gen_second.second_q ;
  logic [IndexW-1:0] behind;
  assign behind = \u_dut.head_q [IndexW-1:0] + 1'b1;
  wire keeps = \u_dut.gen_ahead.gen_second.second_q == all[behind*Width +: Width];
`else
  wire keeps = 1'b1;
`endif

  always @* if (begun_q && rst_ni) begin
    a_count:   assert (count_q <= Depth && count_q == inside);
    a_valid:   assert (valid_o == (count_q != '0));
    a_ready:   assert (ready_o == (count_q != Depth));
    a_ahead:   assert (!follows_q || ahead_q < count_q);
    a_kept:    assert (!follows_q || kept == token_q);
    a_token:   assert (!follows_q || ahead_q != '0 || data_o == token_q);
    a_offer:   assert (!stalled_q || (valid_o && data_o == shown_q));
    a_next:    assert (next == 1'b1);
    a_many:    assert (many == (count_q > 1));
    a_second:  assert (!many || keeps);
    a_open:    assert (!open_q || ready_o);
`ifdef Cut_1
    a_told:    assert (!told_q || (valid_o && data_o == told_data_q));
    a_tells:   assert (told_q || !gone_q || !valid_o);
`endif
  end
endmodule

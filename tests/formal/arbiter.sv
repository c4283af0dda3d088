// Properties of rc_arbiter, assuming that each source holds its offer until it is accepted:
// - at most one grant, only to a source that offers, and that source's data on the output;
// - the output holds an offer until it is accepted;
// - a source that offers is served after at most Sources - 1 others;
// - after reset the round begins behind source 0.
//
// The proof follows one arbitrary source: `whom_i` is constant. The third property needs two
// invariants of internal state: the distance of the round from the followed source, and that only
// an offer already on the output may be out of turn.
module arbiter #(
  parameter  int unsigned Sources = 4,
  parameter  int unsigned Width   = 2,
  localparam int unsigned IndexW  = $clog2(Sources)
) (
  input logic                     clk_i,
  input logic                     rst_ni,
  input logic [Sources-1:0]       valid_i,
  input logic [Sources*Width-1:0] data_i,
  input logic                     ready_i,
  input logic [IndexW-1:0]        whom_i
);
  logic [Sources-1:0] ready_o;
  logic               valid_o;
  logic [IndexW-1:0]  source_o;
  logic [Width-1:0]   data_o;
  rc_arbiter #(.Sources(Sources), .Width(Width)) u_dut (
    .clk_i(clk_i), .rst_ni(rst_ni), .valid_i(valid_i), .ready_o(ready_o), .data_i(data_i),
    .valid_o(valid_o),
    .ready_i(ready_i), .source_o(source_o), .data_o(data_o));
  (* hierconn *) wire              \u_dut.held_q ;
  (* hierconn *) wire [IndexW-1:0] \u_dut.last_q ;
  (* hierconn *) wire [IndexW-1:0] \u_dut.held_source_q ;

  logic begun_q = 1'b0;
  always @(posedge clk_i) begun_q <= 1'b1;
  always @* if (!begun_q) assume (!rst_ni);

  logic [Sources-1:0]       waits_q;
  logic [Sources*Width-1:0] data_q;
  logic                     stalled_q;
  logic [IndexW-1:0]        source_q;
  logic [Width-1:0]         shown_q;
  always @(posedge clk_i) begin
    waits_q   <= rst_ni ? valid_i & ~ready_o : '0;
    data_q    <= data_i;
    stalled_q <= rst_ni && valid_o && !ready_i;
    source_q  <= source_o;
    shown_q   <= data_o;
  end
  for (genvar s = 0; s < Sources; s++) begin : gen_source
    always @* if (rst_ni && waits_q[s])
      assume (valid_i[s] && data_i[s*Width +: Width] == data_q[s*Width +: Width]);
  end

  // Grants to others since the followed source began to wait.
  logic [IndexW-1:0] whom_q, turns, held_turns;
  logic [IndexW:0]   passed_q;
  always @(posedge clk_i) begin
    whom_q <= whom_i;
    if (!rst_ni || !valid_i[whom_i] || ready_o[whom_i]) passed_q <= '0;
    else if (ready_o != '0) passed_q <= passed_q + 1'b1;
  end
  always @* if (begun_q) assume (whom_i == whom_q);
  logic fresh_q;   // no source has been served since reset
  always @(posedge clk_i) begin
    if (!rst_ni) fresh_q <= 1'b1;
    else if (ready_o != '0) fresh_q <= 1'b0;
  end
  assign turns      = whom_i - \u_dut.last_q - 1'b1;                  // sources before it in turn
  // the one on show: sources before it
  assign held_turns = \u_dut.held_source_q - \u_dut.last_q - 1'b1;

  always @* if (begun_q && rst_ni) begin
    a_offer:   assert (valid_o == (valid_i != '0));
    a_one:     assert ((ready_o & (ready_o - 1'b1)) == '0);
    a_asked:   assert ((ready_o & ~valid_i) == '0);
    a_taken:   assert ((ready_o != '0) == (valid_o && ready_i));
    a_told:    assert (ready_o == '0 || ready_o[source_o]);
    a_data:    assert (!valid_o || data_o == data_i[source_o*Width +: Width]);
    a_stays:   assert (!stalled_q || (valid_o && source_o == source_q && data_o == shown_q));
    a_held:    assert (\u_dut.held_q == stalled_q &&
        (!stalled_q || (\u_dut.held_source_q == source_q && waits_q[source_q])));
    a_bounded: assert (passed_q <= Sources - 1);
    a_turn:    assert (passed_q == '0 || !waits_q[whom_i] || passed_q + turns <= Sources - 1);
    a_in_turn: assert (passed_q == '0 || !waits_q[whom_i] || !stalled_q || held_turns <= turns);
    a_begins:  assert (!fresh_q || \u_dut.last_q == '0);   // the turn begins behind source 0
    a_passed:  assert (passed_q == '0 || waits_q[whom_i]);
  end
endmodule

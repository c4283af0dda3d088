// Properties of rc_priority_merge, if an offer stays until it is accepted: the output carries the
// offer of one source, and only that source sees the acceptance. The first source goes before the
// second, but an offer on the output stays until accepted.
module priority_merge #(
  parameter int unsigned Width = 2
) (
  input logic             clk_i,
  input logic             rst_ni,
  input logic             first_valid_i,
  input logic [Width-1:0] first_i,
  input logic             second_valid_i,
  input logic [Width-1:0] second_i,
  input logic             ready_i
);
  logic             first_ready_o, second_ready_o, valid_o;
  logic [Width-1:0] data_o;
  rc_priority_merge #(.Width(Width)) u_dut (
    .clk_i(clk_i), .rst_ni(rst_ni), .first_valid_i(first_valid_i), .first_ready_o(first_ready_o),
    .first_i(first_i),
    .second_valid_i(second_valid_i), .second_ready_o(second_ready_o), .second_i(second_i),
    .valid_o(valid_o), .ready_i(ready_i), .data_o(data_o));
  (* hierconn *) wire \u_dut.held_q , \u_dut.held_second_q ;

  logic begun_q = 1'b0;
  always @(posedge clk_i) begun_q <= 1'b1;
  always @* if (!begun_q) assume (!rst_ni);

  logic             first_fires, second_fires, stalled_q, first_waits_q, second_waits_q;
  logic [Width-1:0] shown_q, first_q, second_q;
  assign first_fires  = first_valid_i && first_ready_o;
  assign second_fires = second_valid_i && second_ready_o;
  always @(posedge clk_i) begin
    stalled_q      <= rst_ni && valid_o && !ready_i;
    first_waits_q  <= rst_ni && first_valid_i && !first_fires;
    second_waits_q <= rst_ni && second_valid_i && !second_fires;
    shown_q        <= data_o;
    first_q        <= first_i;
    second_q       <= second_i;
  end
  always @* if (rst_ni) begin
    assume (!first_waits_q || (first_valid_i && first_i == first_q));
    assume (!second_waits_q || (second_valid_i && second_i == second_q));
  end
  always @* if (begun_q && rst_ni) begin
    a_offer:  assert (valid_o == (first_valid_i || second_valid_i));
    a_one:    assert (!(first_ready_o && second_ready_o));
    a_taken:  assert ((valid_o && ready_i) == (first_fires || second_fires));
    a_first:  assert (!first_fires || data_o == first_i);
    a_second: assert (!second_fires || data_o == second_i);
    a_before: assert (stalled_q || !first_valid_i || !second_ready_o);
    a_stays:  assert (!stalled_q || (valid_o && data_o == shown_q));
    a_held:   assert (\u_dut.held_q == stalled_q);
    a_shown:  assert (!\u_dut.held_q || (\u_dut.held_second_q ? second_waits_q : first_waits_q));
  end
endmodule

// A unit box whose answers leave out of order across rays: it keeps an answer until the next one
// has passed, or for seven cycles.
`default_nettype none
module rc_box (
  input  logic             clk_i,
  input  logic             rst_ni,
  // From trav
  input  logic             req_valid_i,
  output logic             req_ready_o,
  input  rc_pkg::box_req_t req_i,
  output logic             occupied_o,
  // To trav
  output logic             rsp_valid_o,
  input  logic             rsp_ready_i,
  output rc_pkg::node_answer_t rsp_o
);
  logic             own_valid, own_ready;
  rc_pkg::node_answer_t own, kept_q;
  logic [3:0]       age_q;     // 0: nothing is kept
  logic             leaves;    // the kept answer is offered

  rc_box_own u_own (
    .clk_i, .rst_ni, .req_valid_i, .req_ready_o, .req_i, .occupied_o,
    .rsp_valid_o(own_valid), .rsp_ready_i(own_ready), .rsp_o(own));

  assign leaves      = age_q == 4'd8;
  assign rsp_valid_o = leaves || (age_q != 0 && own_valid);
  assign rsp_o       = leaves ? kept_q : own;
  assign own_ready   = age_q == 0 || (!leaves && rsp_ready_i);

  always_ff @(posedge clk_i) begin
    if (!rst_ni)                age_q <= '0;
    else if (age_q == 0)        age_q <= {3'd0, own_valid};
    else if (leaves)            age_q <= rsp_ready_i ? 4'd0 : age_q;
    else if (own_valid)         age_q <= rsp_ready_i ? 4'd8 : age_q;   // the next one has passed
    else                        age_q <= age_q + 4'd1;
    if (age_q == 0) kept_q <= own;
  end
endmodule
`default_nettype wire

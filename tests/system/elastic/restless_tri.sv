// Faulty: withdraws each answer for a cycle if it is not accepted at once. Its values are right.
`default_nettype none
module rc_tri (
  input  logic             clk_i,
  input  logic             rst_ni,
  input  logic             req_valid_i,
  output logic             req_ready_o,
  input  rc_pkg::tri_req_t req_i,
  output logic             occupied_o,
  output logic             rsp_valid_o,
  input  logic             rsp_ready_i,
  output rc_pkg::tri_rsp_t rsp_o
);
  logic own_valid, stalled_q;

  rc_tri_own u_own (
    .clk_i, .rst_ni, .req_valid_i, .req_ready_o, .req_i, .occupied_o, .rsp_valid_o(own_valid),
    .rsp_ready_i(rsp_ready_i && !stalled_q), .rsp_o);

  assign rsp_valid_o = own_valid && !stalled_q;

  always_ff @(posedge clk_i) stalled_q <= rst_ni && rsp_valid_o && !rsp_ready_i;
endmodule
`default_nettype wire

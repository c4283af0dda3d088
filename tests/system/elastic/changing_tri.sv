// Faulty: inverts its answer as long as it is not accepted. Its accepted values are right.
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
  rc_pkg::tri_rsp_t own;

  rc_tri_own u_own (
    .clk_i, .rst_ni, .req_valid_i, .req_ready_o, .req_i, .occupied_o, .rsp_valid_o, .rsp_ready_i,
    .rsp_o(own));

  assign rsp_o = rsp_ready_i ? own : ~own;
endmodule
`default_nettype wire

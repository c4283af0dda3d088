// Faulty: gives its last answer a second time, 300 cycles after its last request, when the frame is
// done.
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
  localparam logic [8:0] Pause = 9'd300;

  rc_pkg::tri_rsp_t own, last_q;
  logic             own_valid, has_last_q, again;
  logic [8:0]       idle_q;   // cycles

  rc_tri_own u_own (
    .clk_i, .rst_ni, .req_valid_i, .req_ready_o, .req_i, .occupied_o, .rsp_valid_o(own_valid),
    .rsp_ready_i,
    .rsp_o(own));

  assign again       = has_last_q && idle_q == Pause && !own_valid;
  assign rsp_valid_o = own_valid || again;
  assign rsp_o       = own_valid ? own : last_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni || req_valid_i || own_valid) idle_q <= '0;
    else if (idle_q != Pause)                idle_q <= idle_q + 9'd1;

    if (!rst_ni || (again && rsp_ready_i)) has_last_q <= 1'b0;
    else if (own_valid && rsp_ready_i)     has_last_q <= 1'b1;

    if (own_valid) last_q <= own;
  end
endmodule
`default_nettype wire

// A unit tri that accepts a primitive in every third cycle only: the project's unit behind a
// counter.
`default_nettype none
module rc_tri (
  input  logic             clk_i,
  input  logic             rst_ni,
  // From prim_cache, with the ray from list
  input  logic             req_valid_i,
  output logic             req_ready_o,
  input  rc_pkg::tri_req_t req_i,
  output logic             occupied_o,
  // To list
  output logic             rsp_valid_o,
  input  logic             rsp_ready_i,
  output rc_pkg::tri_rsp_t rsp_o
);
  logic       own_ready, own_occupied;
  logic [1:0] pause_q;   // cycles until the next primitive

  rc_tri_own u_own (
    .clk_i, .rst_ni, .req_valid_i(req_valid_i && pause_q == 0), .req_ready_o(own_ready), .req_i,
    .occupied_o(own_occupied), .rsp_valid_o, .rsp_ready_i, .rsp_o);

  assign req_ready_o = own_ready && pause_q == 0;
  assign occupied_o  = own_occupied || pause_q != 0;

  always_ff @(posedge clk_i) begin
    if (!rst_ni)                         pause_q <= '0;
    else if (req_valid_i && req_ready_o) pause_q <= 2'd2;
    else if (pause_q != 0)               pause_q <= pause_q - 2'd1;
  end
endmodule
`default_nettype wire

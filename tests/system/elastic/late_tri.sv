// A unit tri whose answers come five cycles later: the project's unit, and five registers behind
// it.
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
  localparam int unsigned Width = rc_pkg::TriRspW;
  localparam int unsigned More  = 5;

  logic             own_valid;
  rc_pkg::tri_rsp_t own;

  // The registers move together, as long as the last one is free or its answer leaves.
  logic                  moves;
  logic [More-1:0]       valid_q;
  logic [More*Width-1:0] data_q;

  rc_tri_own u_own (
    .clk_i, .rst_ni, .req_valid_i, .req_ready_o, .req_i, .occupied_o,
    .rsp_valid_o(own_valid), .rsp_ready_i(moves), .rsp_o(own));

  assign rsp_valid_o = valid_q[More-1];
  assign rsp_o       = data_q[More*Width-1 -: Width];
  assign moves       = !rsp_valid_o || rsp_ready_i;

  always_ff @(posedge clk_i) begin
    if (!rst_ni)    valid_q <= '0;
    else if (moves) valid_q <= {valid_q[More-2:0], own_valid};
    if (moves) data_q <= {data_q[(More-1)*Width-1:0], own};
  end
endmodule
`default_nettype wire

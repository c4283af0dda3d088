// A unit tri that leaves ones in the fields of an answer that is not closer.
`default_nettype none
module rc_tri (
  input  logic             clk_i,
  input  logic             rst_ni,
  // From prim_cache, with the ray from list
  input  logic             req_valid_i,
  output logic             req_ready_o,
  input  rc_pkg::tri_req_t req_i,
  output logic             occupied_o,    // accepts nothing: the last products are being made
  // To list
  output logic             rsp_valid_o,
  input  logic             rsp_ready_i,
  output rc_pkg::tri_rsp_t rsp_o
);
  rc_pkg::tri_rsp_t own;

  rc_tri_own u_own (
    .clk_i, .rst_ni, .req_valid_i, .req_ready_o, .req_i, .occupied_o,
    .rsp_valid_o, .rsp_ready_i, .rsp_o(own));

  always_comb begin
    rsp_o = own;
    if (!own.closer) begin
      rsp_o        = '1;
      rsp_o.ray    = own.ray;
      rsp_o.closer = 1'b0;
    end
  end
endmodule
`default_nettype wire

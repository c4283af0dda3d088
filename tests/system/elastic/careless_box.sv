// A unit box that leaves ones in the entries of an answer beyond its children.
`default_nettype none
module rc_box (
  input  logic             clk_i,
  input  logic             rst_ni,
  // From trav
  input  logic             req_valid_i,
  output logic             req_ready_o,
  input  rc_pkg::box_req_t req_i,
  output logic             occupied_o,    // accepts no node: the last node's children are in test
  // To trav
  output logic             rsp_valid_o,
  input  logic             rsp_ready_i,
  output rc_pkg::node_answer_t rsp_o
);
  rc_pkg::node_answer_t own;

  rc_box_own u_own (
    .clk_i, .rst_ni, .req_valid_i, .req_ready_o, .req_i, .occupied_o,
    .rsp_valid_o, .rsp_ready_i, .rsp_o(own));

  localparam int unsigned NodeWidth  = rc_pkg::NodeWidth;
  localparam int unsigned TBits      = rc_pkg::TBits;
  localparam int unsigned OffsetBits = rc_pkg::OffsetBits;
  localparam int unsigned CountBits  = rc_pkg::CountBits;

  always_comb begin
    rsp_o = own;
    for (int i = 0; i < NodeWidth; i++) begin
      if (i >= int'(own.inner) + int'(own.leaves)) begin
        rsp_o.t_near[i*TBits +: TBits]           = '1;
        rsp_o.offset[i*OffsetBits +: OffsetBits] = '1;
        rsp_o.count[i*CountBits +: CountBits]    = '1;
      end
    end
  end
endmodule
`default_nettype wire

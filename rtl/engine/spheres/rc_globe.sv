// Finds and sorts the globes (bounding spheres) of a node that a ray meets.
//
// Latency rc_pkg::GlobeLatency + 1 (result queue), throughput 1 node per cycle, answers in order.
//
// Conservative: it reports every globe that holds a point of the ray, and t_near never exceeds the
// time of such a point. Model: model/engine/spheres/globe.hpp, which has the formulas.
`default_nettype none
module rc_globe (
  input  logic               clk_i,
  input  logic               rst_ni,
  // From trav
  input  logic               req_valid_i,
  output logic               req_ready_o,
  input  rc_pkg::globe_req_t req_i,
  // To trav
  output logic               rsp_valid_o,
  input  logic               rsp_ready_i,
  output rc_pkg::globe_rsp_t rsp_o
);
  localparam int unsigned NodeWidth = rc_pkg::NodeWidth;
  localparam int unsigned GlobeBits = rc_pkg::GlobeBits;
  localparam int unsigned TBits     = rc_pkg::TBits;
  localparam int unsigned Latency   = rc_pkg::GlobeLatency;
  localparam int unsigned Cut       = rc_pkg::PathCut;
  localparam int unsigned In        = Cut;

  // Admission: an answer has a place in the result queue. valid[i]: stage i holds a node.
  logic               admit;
  logic [Latency-1:0] valid_q;
  logic [Latency:0]   valid;

  assign valid = {valid_q, admit};

  rc_credited_pipeline #(.Credits(rc_pkg::BoxQueue), .Stages(Latency)) u_stages (
    .clk_i, .rst_ni, .req_valid_i, .req_ready_o, .occupied_i(1'b0),
    .leave_i(rsp_valid_o && rsp_ready_i), .admit_o(admit), .valid_q_o(valid_q));

  // enable[i]: the register after stage i accepts its input (rtl/README.md, Relaxed and fast).
  logic [Latency:0] enable;
  assign enable = valid | {(Latency+1){Cut != 0}};

  // The node, unpacked.
  rc_pkg::globe_req_t           in;
  logic [rc_pkg::GlobeReqW-1:0] in_flat;

  rc_path_register #(.Width(rc_pkg::GlobeReqW)) u_in (.clk_i, .data_i(req_i), .data_o(in_flat));
  assign in = in_flat;

  // The part of the test that all globes of the node share.
  localparam int unsigned N           = rc_pkg::CoordBits;
  localparam int unsigned TowardBits  = rc_pkg::TowardBits;
  localparam int unsigned GlobeStages = rc_pkg::GlobeStages;

  logic [3*(N+TowardBits+2)-1:0] moment;
  logic [3*TowardBits-1:0]       toward;
  logic [N+6:0]                  way;
  logic [N+3:0]                  slack;
  logic [TowardBits-1:0]         square;
  logic [16:0]                   inverse;
  logic [5:0]                    right;

  rc_globe_moment u_globe_moment (
    .clk_i, .enable_i(enable[In +: GlobeStages]), .s0_o_i(in.o), .s0_org_i(in.org),
    .s0_exp_i(in.exp),
    .s0_toward_i(in.toward), .s0_len_i(in.len), .toward_o(toward), .moment_o(moment), .way_o(way),
    .slack_o(slack), .square_o(square), .inverse_o(inverse), .right_o(right));

  // The part of each globe.
  logic [3*NodeWidth*GlobeBits-1:0] in_centre;
  logic [NodeWidth*GlobeBits-1:0]   in_radius;
  logic [NodeWidth-1:0]             met;
  logic [NodeWidth*TBits-1:0]       near;

  assign in_centre = in.centre;
  assign in_radius = in.radius;

  for (genvar i = 0; i < NodeWidth; i++) begin : gen_child
    rc_chord u_chord (
      .clk_i, .enable_i(enable[In +: GlobeStages]),
      .s0_centre_i(in_centre[3*i*GlobeBits +: 3*GlobeBits]),
      .s0_radius_i(in_radius[i*GlobeBits +: GlobeBits]), .toward_i(toward), .moment_i(moment),
      .way_i(way), .slack_i(slack), .square_i(square), .inverse_i(inverse), .right_i(right),
      .met_o(met[i]), .near_o(near[i*TBits +: TBits]));
  end

  // Their order, and the result queue.
  logic [rc_pkg::GlobeRspW-1:0] rsp;

  rc_node_answer #(.Latency(Latency)) u_answer (
    .clk_i, .rst_ni, .enable_i(enable[Latency-1:0]), .ray_i(in.ray), .base_i(in.base),
    .kind_i(in.kind), .met_i(met), .near_i(near), .end_valid_i(valid_q[Latency-1]),
    .rsp_valid_o, .rsp_ready_i, .rsp_o(rsp));

  assign rsp_o = rsp;

  logic unused;
  assign unused = ^{valid[Latency], enable[Latency]};
endmodule
`default_nettype wire

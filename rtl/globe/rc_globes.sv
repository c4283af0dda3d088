// The engine that walks a ray through a hierarchy of globes (bounding spheres, structure=spheres):
// only wiring of trav and globe. Its face is that of every engine (rtl/README.md), and what trav
// and its stack do with globes is what they do with boxes. Model: model/globe.
`default_nettype none
module rc_globes (
  input  logic              clk_i,
  input  logic              rst_ni,
  input  rc_pkg::frame_t    frame_i,
  // A ray starts; from raygen
  input  logic              start_fires_i,
  input  rc_pkg::start_t    start_i,
  input  logic              ray_valid_i,
  output logic              ray_ready_o,
  input  rc_pkg::ray_t      ray_i,
  // To and from node_cache
  output logic              node_req_valid_o,
  input  logic              node_req_ready_i,
  output rc_pkg::node_req_t node_req_o,
  input  logic              node_rsp_valid_i,
  output logic              node_rsp_ready_o,
  input  rc_pkg::node_rsp_t node_rsp_i,
  input  logic              node_waits_i,
  // To and from list
  output logic              leaves_fires_o,
  output rc_pkg::leaves_t   leaves_o,
  input  logic              tested_valid_i,
  output logic              tested_ready_o,
  input  rc_pkg::tested_t   tested_i,
  output logic              done_valid_o,
  input  logic              done_ready_i,
  output rc_pkg::done_t     done_o,
  // What its units did; rc_pkg::trav_cause_e, globe_cause_e
  output logic [2:0]        trav_cause_o,
  output logic [2:0]        globe_cause_o
);
  logic                           globe_req_valid, globe_req_ready;
  logic [rc_pkg::NodeReqBits-1:0] node_req_flat;
  rc_pkg::globe_req_t           globe_req;
  logic                           globe_rsp_valid, globe_rsp_ready;
  rc_pkg::globe_rsp_t           globe_rsp;
  assign globe_req = node_req_flat;

  rc_trav u_trav (
    .clk_i, .rst_ni, .frame_i, .start_fires_i, .start_i, .ray_valid_i, .ray_ready_o, .ray_i,
    .node_req_valid_o, .node_req_ready_i, .node_req_o,
    .node_rsp_valid_i, .node_rsp_ready_o, .node_rsp_i,
    .box_req_valid_o(globe_req_valid), .box_req_ready_i(globe_req_ready),
    .box_req_o(node_req_flat), .box_rsp_valid_i(globe_rsp_valid),
    .box_rsp_ready_o(globe_rsp_ready), .box_rsp_i(globe_rsp),
    .leaves_fires_o, .leaves_o, .tested_valid_i, .tested_ready_o, .tested_i,
    .done_valid_o, .done_ready_i, .done_o, .cause_o(trav_cause_o));

  rc_globe u_globe (
    .clk_i, .rst_ni,
    .req_valid_i(globe_req_valid), .req_ready_o(globe_req_ready), .req_i(globe_req),
    .rsp_valid_o(globe_rsp_valid), .rsp_ready_i(globe_rsp_ready), .rsp_o(globe_rsp));

  always_comb begin
    if (globe_req_valid)
      globe_cause_o = globe_req_ready ? rc_pkg::GlobeBusyWork : rc_pkg::GlobeStalledTrav;
    else
      globe_cause_o = node_waits_i ? rc_pkg::GlobeStarvedMemory : rc_pkg::GlobeStarvedTrav;
  end
endmodule
`default_nettype wire

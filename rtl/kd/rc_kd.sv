// The engine that walks a ray through a kd-tree: only wiring of trav and treelet.
//
// Its face is that of every engine (rtl/README.md). What trav and its stack do with exits is what
// they do with boxes: those met come in order, leaves go to list, inner ones wait. That a ray ends
// early, when its hit lies before a cell, follows from the exits' t_near. Model: model/kd.
`default_nettype none
module rc_kd (
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
  // What its units did; rc_pkg::trav_cause_e, treelet_cause_e
  output logic [2:0]        trav_cause_o,
  output logic [2:0]        treelet_cause_o
);
  logic                           treelet_req_valid, treelet_req_ready;
  logic [rc_pkg::NodeReqBits-1:0] node_req_flat;
  rc_pkg::treelet_req_t           treelet_req;
  logic                           treelet_rsp_valid, treelet_rsp_ready;
  rc_pkg::treelet_rsp_t           treelet_rsp;
  assign treelet_req = node_req_flat;

  rc_trav u_trav (
    .clk_i, .rst_ni, .frame_i, .start_fires_i, .start_i, .ray_valid_i, .ray_ready_o, .ray_i,
    .node_req_valid_o, .node_req_ready_i, .node_req_o,
    .node_rsp_valid_i, .node_rsp_ready_o, .node_rsp_i,
    .box_req_valid_o(treelet_req_valid), .box_req_ready_i(treelet_req_ready),
    .box_req_o(node_req_flat), .box_rsp_valid_i(treelet_rsp_valid),
    .box_rsp_ready_o(treelet_rsp_ready), .box_rsp_i(treelet_rsp),
    .leaves_fires_o, .leaves_o, .tested_valid_i, .tested_ready_o, .tested_i,
    .done_valid_o, .done_ready_i, .done_o, .cause_o(trav_cause_o));

  rc_treelet u_treelet (
    .clk_i, .rst_ni,
    .req_valid_i(treelet_req_valid), .req_ready_o(treelet_req_ready), .req_i(treelet_req),
    .rsp_valid_o(treelet_rsp_valid), .rsp_ready_i(treelet_rsp_ready), .rsp_o(treelet_rsp));

  always_comb begin
    if (treelet_req_valid)
      treelet_cause_o = treelet_req_ready ? rc_pkg::TreeletBusyWork : rc_pkg::TreeletStalledTrav;
    else
      treelet_cause_o = node_waits_i ? rc_pkg::TreeletStarvedMemory : rc_pkg::TreeletStarvedTrav;
  end
endmodule
`default_nettype wire

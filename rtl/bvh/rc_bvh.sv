// The engine that walks a ray through a tree of bounding boxes: only wiring of trav and box.
//
// Its face is that of every such engine. It takes rays, gives their leaves to list, gets
// told when they are tested, asks for its nodes in memory, and says when nothing that is left
// can matter to a ray. What a node is, in which order children are visited, and what is kept
// for later are its own affair. Model: model/bvh.
`default_nettype none
module rc_bvh (
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
  // What its units did; rc_pkg::trav_cause_e, box_cause_e
  output logic [2:0]        trav_cause_o,
  output logic [2:0]        box_cause_o,
  // With two levels: a ray changed, to list; rc_pkg::xform_cause_e
  output logic              change_fires_o,
  output rc_pkg::change_t   change_o,
  output logic [2:0]        xform_cause_o
);
  logic             box_req_valid, box_req_ready;
  logic [rc_pkg::NodeReqBits-1:0] box_req_flat;
  rc_pkg::box_req_t box_req;
  logic             box_rsp_valid, box_rsp_ready;
  rc_pkg::box_rsp_t box_rsp;
  logic               xform_req_valid, xform_req_ready;
  rc_pkg::xform_req_t xform_req;
  logic               change_fires;
  rc_pkg::change_t    change;

  assign box_req = box_req_flat;

  rc_trav u_trav (
    .clk_i, .rst_ni, .frame_i, .start_fires_i, .start_i, .ray_valid_i, .ray_ready_o, .ray_i,
    .node_req_valid_o, .node_req_ready_i, .node_req_o,
    .node_rsp_valid_i, .node_rsp_ready_o, .node_rsp_i,
    .box_req_valid_o(box_req_valid), .box_req_ready_i(box_req_ready), .box_req_o(box_req_flat),
    .box_rsp_valid_i(box_rsp_valid), .box_rsp_ready_o(box_rsp_ready), .box_rsp_i(box_rsp),
    .leaves_fires_o, .leaves_o, .tested_valid_i, .tested_ready_o, .tested_i,
    .done_valid_o, .done_ready_i, .done_o, .cause_o(trav_cause_o),
    .xform_req_valid_o(xform_req_valid), .xform_req_ready_i(xform_req_ready),
    .xform_req_o(xform_req), .change_fires_i(change_fires), .change_i(change));

  if (rc_pkg::Levels == 1) begin : gen_one_level
    assign {xform_req_ready, change_fires, change, xform_cause_o} = '0;
    logic unused;
    assign unused = ^{xform_req_valid, xform_req};
  end else begin : gen_xform
    logic rests;
    rc_xform u_xform (
      .clk_i, .rst_ni,
      .req_valid_i(xform_req_valid), .req_ready_o(xform_req_ready), .req_i(xform_req),
      .rests_o(rests), .change_fires_o(change_fires), .change_o(change));
    always_comb begin
      if (xform_req_valid || rests) xform_cause_o = rc_pkg::XformBusyWork;
      else xform_cause_o = node_waits_i ? rc_pkg::XformStarvedMemory : rc_pkg::XformStarvedTrav;
    end
  end
  assign change_fires_o = change_fires;
  assign change_o       = change;

  rc_box u_box (
    .clk_i, .rst_ni,
    .req_valid_i(box_req_valid), .req_ready_o(box_req_ready), .req_i(box_req),
    .rsp_valid_o(box_rsp_valid), .rsp_ready_i(box_rsp_ready), .rsp_o(box_rsp));

  always_comb begin
    if (box_req_valid) box_cause_o = box_req_ready ? rc_pkg::BoxBusyWork : rc_pkg::BoxStalledTrav;
    else box_cause_o = node_waits_i ? rc_pkg::BoxStarvedMemory : rc_pkg::BoxStarvedTrav;
  end
endmodule
`default_nettype wire

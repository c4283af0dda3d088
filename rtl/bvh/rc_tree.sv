// The engine that walks a ray through a tree: only wiring of trav and of the unit that decides
// nodes, which depends on what a node is (rc_pkg::Structure).
//
// Its face is that of every engine (rtl/README.md). It takes rays, gives their leaves to list, gets
// told when they are tested, asks for its nodes in memory, and says when nothing that is left can
// matter to a ray. What a node is, in which order children are visited, and what is kept for later
// are its own affair. What trav and its stack do with a kd-tree's exits or with globes is what they
// do with boxes: those met come in order, leaves go to list, inner ones wait. That a ray in a
// kd-tree ends early, when its hit lies before a cell, follows from the exits' t_near. Outside,
// decide_req and decide_rsp have the names of the unit's links (model/core/links.hpp). Model:
// model/bvh, model/kd, model/globe, model/bsp.
`default_nettype none
module rc_tree (
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
  // What its units did; rc_pkg::trav_cause_e, decide_cause_e
  output logic [2:0]        trav_cause_o,
  output logic [2:0]        decide_cause_o,
  // With two levels: a ray changed, to list; rc_pkg::xform_cause_e
  output logic              change_fires_o,
  output rc_pkg::change_t   change_o,
  output logic [2:0]        xform_cause_o
);
  logic                           decide_req_valid, decide_req_ready;
  logic [rc_pkg::NodeReqBits-1:0] decide_req;
  logic                           decide_rsp_valid, decide_rsp_ready;
  rc_pkg::box_rsp_t               decide_rsp;   // the form of all such units' answers
  logic                           xform_req_valid, xform_req_ready, change_fires;
  rc_pkg::xform_req_t             xform_req;
  rc_pkg::change_t                change;

  rc_trav u_trav (
    .clk_i, .rst_ni, .frame_i, .start_fires_i, .start_i, .ray_valid_i, .ray_ready_o, .ray_i,
    .node_req_valid_o, .node_req_ready_i, .node_req_o,
    .node_rsp_valid_i, .node_rsp_ready_o, .node_rsp_i,
    .decide_req_valid_o(decide_req_valid), .decide_req_ready_i(decide_req_ready),
    .decide_req_o(decide_req), .decide_rsp_valid_i(decide_rsp_valid),
    .decide_rsp_ready_o(decide_rsp_ready), .decide_rsp_i(decide_rsp),
    .leaves_fires_o, .leaves_o, .tested_valid_i, .tested_ready_o, .tested_i,
    .done_valid_o, .done_ready_i, .done_o, .cause_o(trav_cause_o),
    .xform_req_valid_o(xform_req_valid), .xform_req_ready_i(xform_req_ready),
    .xform_req_o(xform_req), .change_fires_i(change_fires), .change_i(change));

  // What decides a node; a further structure has a branch here. Only box may take a node every few
  // cycles, and rest in between.
  logic decide_rests;
  if (rc_pkg::Structure != rc_pkg::StructureBvh) begin : gen_never_rests
    assign decide_rests = 1'b0;
  end
  if (rc_pkg::Structure == rc_pkg::StructureKd) begin : gen_treelet
    rc_treelet u_treelet (
      .clk_i, .rst_ni, .req_valid_i(decide_req_valid), .req_ready_o(decide_req_ready),
      .req_i(decide_req), .rsp_valid_o(decide_rsp_valid), .rsp_ready_i(decide_rsp_ready),
      .rsp_o(decide_rsp));
  end else if (rc_pkg::Structure == rc_pkg::StructureSpheres) begin : gen_globe
    rc_globe u_globe (
      .clk_i, .rst_ni, .req_valid_i(decide_req_valid), .req_ready_o(decide_req_ready),
      .req_i(decide_req), .rsp_valid_o(decide_rsp_valid), .rsp_ready_i(decide_rsp_ready),
      .rsp_o(decide_rsp));
  end else if (rc_pkg::Structure == rc_pkg::StructureBsp) begin : gen_slant
    rc_slant u_slant (
      .clk_i, .rst_ni, .req_valid_i(decide_req_valid), .req_ready_o(decide_req_ready),
      .req_i(decide_req), .rsp_valid_o(decide_rsp_valid), .rsp_ready_i(decide_rsp_ready),
      .rsp_o(decide_rsp));
  end else begin : gen_box
    rc_box u_box (
      .clk_i, .rst_ni, .req_valid_i(decide_req_valid), .req_ready_o(decide_req_ready),
      .req_i(decide_req), .rests_o(decide_rests), .rsp_valid_o(decide_rsp_valid),
      .rsp_ready_i(decide_rsp_ready), .rsp_o(decide_rsp));
  end

  // What takes an instance, if there are two levels.
  if (rc_pkg::Levels == 1) begin : gen_one_level
    assign {xform_req_ready, change_fires, change, xform_cause_o} = '0;
    logic unused;
    assign unused = ^{xform_req_valid, xform_req};
  end else begin : gen_xform
    logic rests;
    rc_xform u_xform (
      .clk_i, .rst_ni, .req_valid_i(xform_req_valid), .req_ready_o(xform_req_ready),
      .req_i(xform_req), .rests_o(rests), .change_fires_o(change_fires), .change_o(change));
    always_comb begin
      if (xform_req_valid || rests) xform_cause_o = rc_pkg::XformBusyWork;
      else xform_cause_o = node_waits_i ? rc_pkg::XformStarvedMemory : rc_pkg::XformStarvedTrav;
    end
  end
  assign change_fires_o = change_fires;
  assign change_o       = change;

  always_comb begin
    if (decide_rests) decide_cause_o = rc_pkg::DecideBusyWork;
    else if (decide_req_valid)
      decide_cause_o = decide_req_ready ? rc_pkg::DecideBusyWork : rc_pkg::DecideStalledTrav;
    else
      decide_cause_o = node_waits_i ? rc_pkg::DecideStarvedMemory : rc_pkg::DecideStarvedTrav;
  end
endmodule
`default_nettype wire

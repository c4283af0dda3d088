// The engine that walks a ray through a tree: wires trav, the node unit (chosen by
// rc_pkg::Structure) and, with two levels, xform.
//
// With two levels meshes may have another structure (rc_pkg::MeshStructure). Then there are two
// node units, and one of them gets a node per cycle. The faster unit's answers are delayed to the
// slower unit's latency, so one answer comes per cycle.
//
// It has the interface of every engine (rtl/README.md). It accepts rays, sends their leaves to
// list, and requests nodes from memory. It reports when a ray is done. The node format, the order
// of the children and the stored state are its own decisions.
//
// trav and its stack treat the exits of a kd-tree, and globes, like boxes. Those that are met come
// in order; leaves go to list, and inner ones wait. A ray in a kd-tree ends early if its hit lies
// before a cell; this follows from the exits' t_near.
//
// In traces, node_unit_req, node_unit_rsp, mesh_req and mesh_rsp have the names of the unit's links
// (model/machine/links.hpp). Model: model/engine.
`default_nettype none
module rc_tree (
  input  logic              clk_i,
  input  logic              rst_ni,
  input  rc_pkg::frame_t    frame_i,
  // From raygen: a ray starts, and a ray arrives
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
  input  logic              node_next_fires_i,   // in a fast chip: the next one comes, and its ray
  input  logic [rc_pkg::RayBits-1:0] node_next_i,
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
  output logic              done_next_fires_o,   // in a fast chip: the next one comes
  output rc_pkg::done_t     done_next_o,
  // What its units did: rc_pkg::trav_cause_e, node_unit_cause_e
  output logic [rc_pkg::CauseBits-1:0] trav_cause_o,
  output logic [rc_pkg::CauseBits-1:0] node_unit_cause_o,
  output logic [rc_pkg::CauseBits-1:0] mesh_cause_o,    // from the meshes' node unit
  // With two levels: a transformed ray, to list; rc_pkg::xform_cause_e
  output logic              change_fires_o,
  output rc_pkg::change_t   change_o,
  output logic [rc_pkg::CauseBits-1:0] xform_cause_o
);
  // Links.
  logic                           node_unit_req_valid, node_unit_req_ready;
  logic [rc_pkg::NodeReqBits-1:0] node_unit_req;
  logic                           node_unit_rsp_valid, node_unit_rsp_ready;
  rc_pkg::node_answer_t           node_unit_rsp, mesh_rsp, rsp;
  logic                           mesh_req_valid, mesh_req_ready;
  logic [rc_pkg::MeshReqBits-1:0] mesh_req;
  logic                           mesh_rsp_valid, mesh_rsp_ready;
  logic                           xform_req_valid, xform_req_ready, change_fires;
  rc_pkg::xform_req_t             xform_req;
  rc_pkg::change_t                change;

  rc_trav u_trav (
    .clk_i, .rst_ni, .frame_i, .start_fires_i, .start_i, .ray_valid_i, .ray_ready_o, .ray_i,
    .node_req_valid_o, .node_req_ready_i, .node_req_o,
    .node_rsp_valid_i, .node_rsp_ready_o, .node_rsp_i, .node_next_fires_i, .node_next_i,
    .node_unit_req_valid_o(node_unit_req_valid), .node_unit_req_ready_i(node_unit_req_ready),
    .node_unit_req_o(node_unit_req), .node_unit_rsp_valid_i(node_unit_rsp_valid || mesh_rsp_valid),
    .node_unit_rsp_ready_o(node_unit_rsp_ready), .node_unit_rsp_i(rsp),
    .mesh_req_valid_o(mesh_req_valid), .mesh_req_ready_i(mesh_req_ready), .mesh_req_o(mesh_req),
    .leaves_fires_o, .leaves_o, .tested_valid_i, .tested_ready_o, .tested_i,
    .done_valid_o, .done_ready_i, .done_o, .done_next_fires_o, .done_next_o,
    .cause_o(trav_cause_o),
    .xform_req_valid_o(xform_req_valid), .xform_req_ready_i(xform_req_ready),
    .xform_req_o(xform_req), .change_fires_i(change_fires), .change_i(change));

  // The node unit. Two node units share a credit counter that counts all nodes in flight,
  // so their own counters never close.
  logic open;

  rc_node_unit #(.Pad(rc_pkg::NodePad)) u_node_unit (
    .clk_i, .rst_ni, .req_valid_i(node_unit_req_valid), .req_ready_o(node_unit_req_ready),
    .req_i(node_unit_req), .open_i(open), .rsp_valid_o(node_unit_rsp_valid), .rsp_o(node_unit_rsp),
    .node_waits_i, .cause_o(node_unit_cause_o));

  if (rc_pkg::MeshStructure == rc_pkg::Structure) begin : gen_one_structure
    assign open                                                                     = 1'b1;
    assign rsp                                                                      = node_unit_rsp;
    assign {mesh_req_ready, mesh_rsp_valid, mesh_rsp_ready, mesh_rsp, mesh_cause_o} = '0;

    logic unused;
    assign unused = ^{mesh_req_valid, mesh_req, mesh_rsp_ready, mesh_rsp, node_unit_rsp_ready};
  end else begin : gen_two_structures
    rc_node_unit #(
      .Structure(rc_pkg::MeshStructure), .ReqW(rc_pkg::MeshReqBits),
      .Pad(rc_pkg::MeshPad)
    ) u_mesh (
      .clk_i, .rst_ni, .req_valid_i(mesh_req_valid), .req_ready_o(mesh_req_ready),
      .req_i(mesh_req), .open_i(open), .rsp_valid_o(mesh_rsp_valid), .rsp_o(mesh_rsp),
      .node_waits_i, .cause_o(mesh_cause_o));

    assign mesh_rsp_ready = node_unit_rsp_ready;
    assign rsp            = mesh_rsp_valid ? mesh_rsp : node_unit_rsp;

    rc_credit_counter #(.Credits(rc_pkg::BoxQueue)) u_credits (
      .clk_i, .rst_ni,
      .admit_i((node_unit_req_valid && node_unit_req_ready) || (mesh_req_valid && mesh_req_ready)),
      .leave_i(node_unit_rsp_valid || mesh_rsp_valid), .open_o(open));

`ifndef SYNTHESIS
    always_ff @(posedge clk_i) if (rst_ni)
      a_one_answer: assert (!(node_unit_rsp_valid && mesh_rsp_valid))
      else $error("two nodes are decided in one cycle");
`endif

    logic unused;
    assign unused = mesh_rsp_ready;
  end

  // The unit that transforms rays for instances, with two levels.
  if (rc_pkg::Levels == 1) begin : gen_one_level
    assign {xform_req_ready, change_fires, change, xform_cause_o} = '0;

    logic unused;
    assign unused = ^{xform_req_valid, xform_req};
  end else begin : gen_xform
    logic occupied;

    rc_xform u_xform (
      .clk_i, .rst_ni, .req_valid_i(xform_req_valid), .req_ready_o(xform_req_ready),
      .req_i(xform_req), .occupied_o(occupied), .change_fires_o(change_fires), .change_o(change));

    always_comb begin
      if (xform_req_valid || occupied) xform_cause_o = rc_pkg::XformBusyWork;
      else xform_cause_o = node_waits_i ? rc_pkg::XformStarvedMemory : rc_pkg::XformStarvedTrav;
    end
  end

  assign change_fires_o = change_fires;
  assign change_o       = change;
endmodule
`default_nettype wire

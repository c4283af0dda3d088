// The ray tracer: only wiring, in the order a ray meets the units.
//
// Reads the memory image over two ports (nodes of 64 bytes, triangles of 32), answers
// matched by ray number in any order, and gives out one hit per pixel of frame_i, in
// the order in which rays end. frame_i is set before reset is released and kept.
// Model: model/machine.hpp.
`default_nettype none
module rc_top (
  input  logic              clk_i,
  input  logic              rst_ni,
  input  rc_pkg::frame_t    frame_i,
  output logic              node_req_valid_o,
  input  logic              node_req_ready_i,
  output rc_pkg::node_req_t node_req_o,
  input  logic              node_rsp_valid_i,
  output logic              node_rsp_ready_o,
  input  rc_pkg::node_rsp_t node_rsp_i,
  output logic              prim_req_valid_o,
  input  logic              prim_req_ready_i,
  output rc_pkg::prim_req_t prim_req_o,
  input  logic              prim_rsp_valid_i,
  output logic              prim_rsp_ready_o,
  input  rc_pkg::prim_rsp_t prim_rsp_i,
  output logic              hit_valid_o,
  input  logic              hit_ready_i,
  output rc_pkg::hit_t      hit_o
);
  logic             slot_valid, slot_ready;
  rc_pkg::slot_t    slot;
  logic             ray_valid, ray_ready;
  rc_pkg::ray_t     ray;
  logic             box_req_valid, box_req_ready;
  rc_pkg::box_req_t box_req;
  logic             box_rsp_valid, box_rsp_ready;
  rc_pkg::box_rsp_t box_rsp;
  logic             tri_req_valid, tri_req_ready;
  rc_pkg::tri_req_t tri_req;
  logic             tri_rsp_valid, tri_rsp_ready;
  rc_pkg::tri_rsp_t tri_rsp;
  logic             step_valid, step_ready;
  rc_pkg::step_t    step;
  logic             done_valid, done_ready;
  rc_pkg::done_t    done;
  logic             closest_valid, closest_ready;
  rc_pkg::closest_t closest;

  rc_sched u_sched (
    .clk_i, .rst_ni, .frame_i,
    .slot_valid_o(slot_valid), .slot_ready_i(slot_ready), .slot_o(slot),
    .closest_valid_i(closest_valid), .closest_ready_o(closest_ready), .closest_i(closest),
    .hit_valid_o, .hit_ready_i, .hit_o);

  rc_raygen u_raygen (
    .clk_i, .rst_ni, .frame_i,
    .slot_valid_i(slot_valid), .slot_ready_o(slot_ready), .slot_i(slot),
    .ray_valid_o(ray_valid), .ray_ready_i(ray_ready), .ray_o(ray));

  rc_trav u_trav (
    .clk_i, .rst_ni, .frame_i,
    .ray_valid_i(ray_valid), .ray_ready_o(ray_ready), .ray_i(ray),
    .step_valid_i(step_valid), .step_ready_o(step_ready), .step_i(step),
    .node_req_valid_o, .node_req_ready_i, .node_req_o,
    .node_rsp_valid_i, .node_rsp_ready_o, .node_rsp_i,
    .box_req_valid_o(box_req_valid), .box_req_ready_i(box_req_ready), .box_req_o(box_req),
    .done_valid_o(done_valid), .done_ready_i(done_ready), .done_o(done));

  rc_box u_box (
    .clk_i, .rst_ni,
    .req_valid_i(box_req_valid), .req_ready_o(box_req_ready), .req_i(box_req),
    .rsp_valid_o(box_rsp_valid), .rsp_ready_i(box_rsp_ready), .rsp_o(box_rsp));

  rc_list u_list (
    .clk_i, .rst_ni, .ray_fires_i(ray_valid && ray_ready), .ray_i(ray),
    .box_rsp_valid_i(box_rsp_valid), .box_rsp_ready_o(box_rsp_ready), .box_rsp_i(box_rsp),
    .prim_req_valid_o, .prim_req_ready_i, .prim_req_o,
    .prim_rsp_valid_i, .prim_rsp_ready_o, .prim_rsp_i,
    .tri_req_valid_o(tri_req_valid), .tri_req_ready_i(tri_req_ready), .tri_req_o(tri_req),
    .tri_rsp_valid_i(tri_rsp_valid), .tri_rsp_ready_o(tri_rsp_ready), .tri_rsp_i(tri_rsp),
    .step_valid_o(step_valid), .step_ready_i(step_ready), .step_o(step),
    .done_valid_i(done_valid), .done_ready_o(done_ready), .done_i(done),
    .closest_valid_o(closest_valid), .closest_ready_i(closest_ready), .closest_o(closest));

  rc_tri u_tri (
    .clk_i, .rst_ni,
    .req_valid_i(tri_req_valid), .req_ready_o(tri_req_ready), .req_i(tri_req),
    .rsp_valid_o(tri_rsp_valid), .rsp_ready_i(tri_rsp_ready), .rsp_o(tri_rsp));
endmodule
`default_nettype wire

// One pipeline: only wiring, in the order a ray meets the units, and what each unit did.
//
// Takes tiles of the picture, reads nodes and triangles through two caches, and gives
// out one hit per pixel, in the order in which rays end. Answers of memory come by id,
// in any order. frame_i is kept while rays are under way. Model: model/pipeline.hpp.
`default_nettype none
module rc_pipeline (
  input  logic               clk_i,
  input  logic               rst_ni,
  input  logic               start_i,
  input  rc_pkg::frame_t     frame_i,
  output logic               tile_ready_o,
  input  logic               tile_fires_i,
  input  rc_pkg::tile_t      tile_i,
  output logic               node_miss_valid_o,
  input  logic               node_miss_ready_i,
  output rc_pkg::node_miss_t node_miss_o,
  input  logic               node_fill_fires_i,
  input  rc_pkg::node_fill_t node_fill_i,
  output logic               prim_miss_valid_o,
  input  logic               prim_miss_ready_i,
  output rc_pkg::prim_miss_t prim_miss_o,
  input  logic               prim_fill_fires_i,
  input  rc_pkg::prim_fill_t prim_fill_i,
  output logic               surf_miss_valid_o,   // this and what follows: if the chip shades
  input  logic               surf_miss_ready_i,
  output rc_pkg::surf_miss_t surf_miss_o,
  input  logic               surf_fill_fires_i,
  input  rc_pkg::surf_fill_t surf_fill_i,
  output logic               hit_valid_o,
  input  logic               hit_ready_i,
  output rc_pkg::hit_t       hit_o,
  output logic [3*rc_pkg::PipelineUnits-1:0] causes_o   // what each unit did, sched lowest
);
  logic              slot_valid, slot_ready;
  rc_pkg::slot_t     slot;
  logic              spawn_valid, spawn_ready;
  rc_pkg::spawn_t    spawn;
  logic              ray_valid, ray_ready;
  rc_pkg::ray_t      ray;
  logic              node_req_valid, node_req_ready;
  rc_pkg::node_req_t node_req;
  logic              node_rsp_valid, node_rsp_ready;
  rc_pkg::node_rsp_t node_rsp;
  logic              box_req_valid, box_req_ready;
  rc_pkg::box_req_t  box_req;
  logic              box_rsp_valid, box_rsp_ready;
  rc_pkg::box_rsp_t  box_rsp;
  logic              prim_req_valid, prim_req_ready;
  rc_pkg::prim_req_t prim_req;
  logic              prim_rsp_valid, prim_rsp_ready;
  rc_pkg::prim_rsp_t prim_rsp;
  logic              tri_req_valid, tri_req_ready;
  rc_pkg::tri_req_t  tri_req;
  logic              tri_rsp_valid, tri_rsp_ready;
  rc_pkg::tri_rsp_t  tri_rsp;
  logic              step_valid, step_ready;
  rc_pkg::step_t     step;
  logic              done_valid, done_ready;
  rc_pkg::done_t     done;
  logic              closest_valid, closest_ready;
  rc_pkg::closest_t  closest;
  logic              surf_req_valid, surf_req_ready;
  rc_pkg::surf_req_t surf_req;
  logic              surf_rsp_valid, surf_rsp_ready;
  rc_pkg::surf_rsp_t surf_rsp;
  logic              pixel_valid, pixel_ready;
  rc_pkg::pixel_t    pixel;
  logic              node_waits, prim_waits;
  logic [2:0]        sched_cause, raygen_cause, trav_cause, node_cause, box_cause, list_cause;
  logic [2:0]        prim_cause, tri_cause, surf_cause, shade_cause;

  rc_sched u_sched (
    .clk_i, .rst_ni, .start_i, .frame_i, .tile_ready_o, .tile_fires_i, .tile_i,
    .slot_valid_o(slot_valid), .slot_ready_i(slot_ready), .slot_o(slot),
    .pixel_valid_i(pixel_valid), .pixel_ready_o(pixel_ready), .pixel_i(pixel),
    .hit_valid_o, .hit_ready_i, .hit_o, .cause_o(sched_cause));

  rc_raygen u_raygen (
    .clk_i, .rst_ni, .frame_i,
    .spawn_valid_i(spawn_valid), .spawn_ready_o(spawn_ready), .spawn_i(spawn),
    .slot_valid_i(slot_valid), .slot_ready_o(slot_ready), .slot_i(slot),
    .ray_valid_o(ray_valid), .ray_ready_i(ray_ready), .ray_o(ray));

  rc_trav u_trav (
    .clk_i, .rst_ni, .frame_i,
    .ray_valid_i(ray_valid), .ray_ready_o(ray_ready), .ray_i(ray),
    .step_valid_i(step_valid), .step_ready_o(step_ready), .step_i(step),
    .node_req_valid_o(node_req_valid), .node_req_ready_i(node_req_ready), .node_req_o(node_req),
    .node_rsp_valid_i(node_rsp_valid), .node_rsp_ready_o(node_rsp_ready), .node_rsp_i(node_rsp),
    .box_req_valid_o(box_req_valid), .box_req_ready_i(box_req_ready), .box_req_o(box_req),
    .done_valid_o(done_valid), .done_ready_i(done_ready), .done_o(done));

  rc_node_cache u_node_cache (
    .clk_i, .rst_ni,
    .req_valid_i(node_req_valid), .req_ready_o(node_req_ready), .req_i(node_req),
    .rsp_valid_o(node_rsp_valid), .rsp_ready_i(node_rsp_ready), .rsp_o(node_rsp),
    .miss_valid_o(node_miss_valid_o), .miss_ready_i(node_miss_ready_i), .miss_o(node_miss_o),
    .fill_fires_i(node_fill_fires_i), .fill_i(node_fill_i),
    .waits_o(node_waits), .deed_o(node_cause));

  rc_box u_box (
    .clk_i, .rst_ni,
    .req_valid_i(box_req_valid), .req_ready_o(box_req_ready), .req_i(box_req),
    .rsp_valid_o(box_rsp_valid), .rsp_ready_i(box_rsp_ready), .rsp_o(box_rsp));

  rc_list u_list (
    .clk_i, .rst_ni, .ray_fires_i(ray_valid && ray_ready), .ray_i(ray),
    .box_rsp_valid_i(box_rsp_valid), .box_rsp_ready_o(box_rsp_ready), .box_rsp_i(box_rsp),
    .prim_req_valid_o(prim_req_valid), .prim_req_ready_i(prim_req_ready), .prim_req_o(prim_req),
    .prim_rsp_valid_i(prim_rsp_valid), .prim_rsp_ready_o(prim_rsp_ready), .prim_rsp_i(prim_rsp),
    .tri_req_valid_o(tri_req_valid), .tri_req_ready_i(tri_req_ready), .tri_req_o(tri_req),
    .tri_rsp_valid_i(tri_rsp_valid), .tri_rsp_ready_o(tri_rsp_ready), .tri_rsp_i(tri_rsp),
    .step_valid_o(step_valid), .step_ready_i(step_ready), .step_o(step),
    .done_valid_i(done_valid), .done_ready_o(done_ready), .done_i(done),
    .closest_valid_o(closest_valid), .closest_ready_i(closest_ready), .closest_o(closest));

  rc_prim_cache u_prim_cache (
    .clk_i, .rst_ni,
    .req_valid_i(prim_req_valid), .req_ready_o(prim_req_ready), .req_i(prim_req),
    .rsp_valid_o(prim_rsp_valid), .rsp_ready_i(prim_rsp_ready), .rsp_o(prim_rsp),
    .miss_valid_o(prim_miss_valid_o), .miss_ready_i(prim_miss_ready_i), .miss_o(prim_miss_o),
    .fill_fires_i(prim_fill_fires_i), .fill_i(prim_fill_i),
    .waits_o(prim_waits), .deed_o(prim_cause));

  rc_tri u_tri (
    .clk_i, .rst_ni,
    .req_valid_i(tri_req_valid), .req_ready_o(tri_req_ready), .req_i(tri_req),
    .rsp_valid_o(tri_rsp_valid), .rsp_ready_i(tri_rsp_ready), .rsp_o(tri_rsp));

  if (rc_pkg::Shading == 0) begin : gen_hits   // a pixel is what its ray hit
    assign pixel_valid   = closest_valid;
    assign closest_ready = pixel_ready;
    assign pixel         = closest;
    assign {spawn_valid, surf_req_valid, surf_req_ready, surf_rsp_valid, surf_rsp_ready} = '0;
    assign {spawn, surf_req, surf_rsp, surf_miss_valid_o, surf_miss_o} = '0;
    assign {surf_cause, shade_cause} = '0;
    logic unused;
    assign unused = ^{spawn_ready, surf_req_valid, surf_req_ready, surf_req, surf_rsp_valid,
        surf_rsp_ready, surf_rsp, surf_miss_ready_i, surf_fill_fires_i, surf_fill_i};
  end else begin : gen_shade
    logic surf_waits;
    rc_surf_cache u_surf_cache (
      .clk_i, .rst_ni,
      .req_valid_i(surf_req_valid), .req_ready_o(surf_req_ready), .req_i(surf_req),
      .rsp_valid_o(surf_rsp_valid), .rsp_ready_i(surf_rsp_ready), .rsp_o(surf_rsp),
      .miss_valid_o(surf_miss_valid_o), .miss_ready_i(surf_miss_ready_i), .miss_o(surf_miss_o),
      .fill_fires_i(surf_fill_fires_i), .fill_i(surf_fill_i),
      .waits_o(surf_waits), .deed_o(surf_cause));
    rc_shade u_shade (
      .clk_i, .rst_ni, .frame_i, .slot_fires_i(slot_valid && slot_ready), .slot_i(slot),
      .ray_fires_i(ray_valid && ray_ready), .ray_i(ray),
      .closest_valid_i(closest_valid), .closest_ready_o(closest_ready), .closest_i(closest),
      .surf_req_valid_o(surf_req_valid), .surf_req_ready_i(surf_req_ready), .surf_req_o(surf_req),
      .surf_rsp_valid_i(surf_rsp_valid), .surf_rsp_ready_o(surf_rsp_ready), .surf_rsp_i(surf_rsp),
      .surf_waits_i(surf_waits),
      .spawn_valid_o(spawn_valid), .spawn_ready_i(spawn_ready), .spawn_o(spawn),
      .pixel_valid_o(pixel_valid), .pixel_ready_i(pixel_ready), .pixel_o(pixel),
      .cause_o(shade_cause));
  end

  // What each unit did in this cycle; codes in model/core/accounts.hpp.
  assign raygen_cause = !ray_valid ? 3'd1 : ray_ready ? 3'd0 : 3'd2;
  assign trav_cause   = step_valid ? (step_ready ? 3'd0 : 3'd2) : {2'b00, step_ready};
  assign box_cause    = box_req_valid ? (box_req_ready ? 3'd0 : 3'd3) : node_waits ? 3'd1 : 3'd2;
  assign list_cause   = {2'b00, !box_rsp_valid && !tri_rsp_valid};
  assign tri_cause    = tri_req_valid ? (tri_req_ready ? 3'd0 : 3'd3) : prim_waits ? 3'd1 : 3'd2;
  assign causes_o     = {shade_cause, surf_cause, tri_cause, prim_cause, list_cause, box_cause,
                         node_cause, trav_cause, raygen_cause, sched_cause};
endmodule
`default_nettype wire

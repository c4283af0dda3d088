// One pipeline: wires its units in the order in which a ray meets them, and reports each unit's
// cause.
//
// It accepts tiles of the picture and returns one hit per pixel, in the order in which rays end. It
// reads nodes and primitives through two caches. A chip that shades reads surfaces through a third
// cache, and textures through a fourth. A chip for ray streams gets its rays from memory, through a
// third cache as well.
// Memory answers by id, in any order. The user holds frame_i while rays are in flight.
// Model: model/machine/pipeline.hpp.
`default_nettype none
module rc_pipeline (
  input  logic               clk_i,
  input  logic               rst_ni,
  // From the host
  input  logic               start_i,
  input  rc_pkg::frame_t     frame_i,
  // From dispatch
  output logic               tile_ready_o,
  input  logic               tile_fires_i,
  input  rc_pkg::tile_t      tile_i,
  // To and from memory, through the arbiter: nodes, primitives, surfaces if the chip shades; below
  // also textures and recorded rays
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
  output logic               surf_miss_valid_o,
  input  logic               surf_miss_ready_i,
  output rc_pkg::surf_miss_t surf_miss_o,
  input  logic               surf_fill_fires_i,
  input  rc_pkg::surf_fill_t surf_fill_i,
  // Texture records and texels, if the chip has textures
  output logic               tex_miss_valid_o,
  input  logic               tex_miss_ready_i,
  output rc_pkg::tex_miss_t  tex_miss_o,
  input  logic               tex_fill_fires_i,
  input  rc_pkg::tex_fill_t  tex_fill_i,
  // Records, if the chip's rays come from a stream
  output logic               stream_miss_valid_o,
  input  logic               stream_miss_ready_i,
  output rc_pkg::stream_miss_t stream_miss_o,
  input  logic               stream_fill_fires_i,
  input  rc_pkg::stream_fill_t stream_fill_i,
  // Picture
  output logic               hit_valid_o,
  input  logic               hit_ready_i,
  output rc_pkg::hit_t       hit_o,
  // What each unit did, sched lowest
  output logic [rc_pkg::PipelineUnits*rc_pkg::CauseBits-1:0] causes_o
);
  localparam int unsigned CauseBits = rc_pkg::CauseBits;

  // Links, in the order in which a ray meets them.
  logic              slot_valid, slot_ready;
  rc_pkg::slot_t     slot;
  logic              spawn_valid, spawn_ready;
  rc_pkg::spawn_t    spawn;
  logic              record_valid, record_ready;
  rc_pkg::record_t   record;
  logic              ray_valid, ray_ready;
  rc_pkg::ray_t      ray;
  logic              node_req_valid, node_req_ready;
  rc_pkg::node_req_t node_req;
  logic              node_rsp_valid, node_rsp_ready;
  rc_pkg::node_rsp_t node_rsp;
  logic              start_fires;
  rc_pkg::start_t    start;
  logic              change_fires;
  rc_pkg::change_t   change;
  logic              leaves_fires;
  rc_pkg::leaves_t   leaves;
  logic              prim_req_valid, prim_req_ready;
  rc_pkg::prim_req_t prim_req;
  logic              prim_rsp_valid, prim_rsp_ready;
  rc_pkg::prim_rsp_t prim_rsp;
  logic              tri_req_valid, tri_req_ready;
  rc_pkg::tri_req_t  tri_req;
  logic              tri_occupied, raygen_occupied, raygen_begins;
  logic              tri_rsp_valid, tri_rsp_ready;
  rc_pkg::tri_rsp_t  tri_rsp;
  logic              tested_valid, tested_ready;
  rc_pkg::tested_t   tested;
  logic              done_valid, done_ready;
  rc_pkg::done_t     done;
  logic              closest_valid, closest_ready;
  rc_pkg::closest_t  closest;
  logic              surf_req_valid, surf_req_ready;
  rc_pkg::surf_req_t surf_req;
  logic              surf_rsp_valid, surf_rsp_ready;
  rc_pkg::surf_rsp_t surf_rsp;
  logic              tex_req_valid, tex_req_ready;
  rc_pkg::tex_req_t  tex_req;
  logic              texel_req_valid, texel_req_ready;
  rc_pkg::texel_req_t texel_req;
  logic              texel_rsp_valid, texel_rsp_ready;
  rc_pkg::texel_rsp_t texel_rsp;
  logic              tex_rsp_fires;
  rc_pkg::tex_rsp_t  tex_rsp;
  logic              pixel_valid, pixel_ready;
  rc_pkg::pixel_t    pixel;
  logic              node_waits, prim_waits;

  // In a fast chip: an answer comes to the head of its queue, and the ray it belongs to.
  logic              node_next_fires, prim_next_fires, done_next_fires;
  logic [rc_pkg::RayBits-1:0] node_next, prim_next;
  rc_pkg::done_t     done_next;

  logic [CauseBits-1:0]     sched_cause, raygen_cause, trav_cause, node_cause, node_unit_cause;
  logic [CauseBits-1:0]     list_cause;
  logic [CauseBits-1:0]     prim_cause, tri_cause, surf_cause, shade_cause, xform_cause, mesh_cause;
  logic [CauseBits-1:0]     stream_cause, tex_cause, texels_cause;

  // Each unit has its own reset register.
  logic sched_rst_n, raygen_rst_n, tree_rst_n, list_rst_n, prim_rst_n, tri_rst_n;

  rc_reset_register u_sched_reset (.clk_i, .rst_ni, .rst_no(sched_rst_n));
  rc_reset_register u_raygen_reset (.clk_i, .rst_ni, .rst_no(raygen_rst_n));
  rc_reset_register u_tree_reset (.clk_i, .rst_ni, .rst_no(tree_rst_n));
  rc_reset_register u_list_reset (.clk_i, .rst_ni, .rst_no(list_rst_n));
  rc_reset_register u_prim_reset (.clk_i, .rst_ni, .rst_no(prim_rst_n));
  rc_reset_register u_tri_reset (.clk_i, .rst_ni, .rst_no(tri_rst_n));

  rc_sched u_sched (
    .clk_i, .rst_ni(sched_rst_n), .start_i, .frame_i, .tile_ready_o, .tile_fires_i, .tile_i,
    .slot_valid_o(slot_valid), .slot_ready_i(slot_ready), .slot_o(slot),
    .pixel_valid_i(pixel_valid), .pixel_ready_o(pixel_ready), .pixel_i(pixel),
    .hit_valid_o, .hit_ready_i, .hit_o, .cause_o(sched_cause));

  // Rays from the camera and shade, or from memory.
  if (!rc_pkg::IsStream) begin : gen_raygen
    rc_raygen u_raygen (
      .clk_i, .rst_ni(raygen_rst_n), .frame_i,
      .spawn_valid_i(spawn_valid), .spawn_ready_o(spawn_ready), .spawn_i(spawn),
      .slot_valid_i(slot_valid), .slot_ready_o(slot_ready), .slot_i(slot),
      .ray_valid_o(ray_valid), .ray_ready_i(ray_ready), .ray_o(ray), .occupied_o(raygen_occupied));

    assign raygen_begins = (slot_valid && slot_ready) || (spawn_valid && spawn_ready);
    assign raygen_cause  = raygen_occupied || raygen_begins ? rc_pkg::RaygenBusyWork
                         : slot_valid || spawn_valid     ? rc_pkg::RaygenStalledTrav
                                                         : rc_pkg::RaygenStarvedSched;

    assign {record_valid, record_ready, record, stream_cause} = '0;
    assign {stream_miss_valid_o, stream_miss_o} = '0;

    logic unused;
    assign unused = ^{record_valid, record_ready, record, stream_miss_ready_i, stream_fill_fires_i,
        stream_fill_i};
  end else begin : gen_stream
    logic stream_waits, stream_rst_n;
    rc_reset_register u_stream_reset (.clk_i, .rst_ni, .rst_no(stream_rst_n));

    rc_stream u_stream (
      .clk_i, .rst_ni(stream_rst_n), .frame_i,
      .slot_valid_i(slot_valid), .slot_ready_o(slot_ready), .slot_i(slot),
      .record_valid_o(record_valid), .record_ready_i(record_ready), .record_o(record),
      .miss_valid_o(stream_miss_valid_o), .miss_ready_i(stream_miss_ready_i),
      .miss_o(stream_miss_o), .fill_fires_i(stream_fill_fires_i), .fill_i(stream_fill_i),
      .waits_o(stream_waits), .outcome_o(stream_cause));

    rc_raygen_stream u_raygen (
      .clk_i, .rst_ni(raygen_rst_n),
      .record_valid_i(record_valid), .record_ready_o(record_ready), .record_i(record),
      .ray_valid_o(ray_valid), .ray_ready_i(ray_ready), .ray_o(ray), .occupied_o(raygen_occupied));

    assign raygen_begins = record_valid && record_ready;
    assign raygen_cause  = raygen_occupied || raygen_begins ? rc_pkg::RaygenBusyWork
                         : record_valid                  ? rc_pkg::RaygenStalledTrav
                                                         : rc_pkg::RaygenStarvedStream;
    assign spawn_ready = 1'b0;

    logic unused;
    assign unused = ^{stream_waits, spawn_valid, spawn_ready, spawn};
  end

  // A ray starts in the cycle in which its engine accepts it.
  assign start_fires = ray_valid && ray_ready;
  if (rc_pkg::HasTextures) begin : gen_start_of_holes
    assign start = {ray.ray, ray.kind, ray.holes};
  end else if (rc_pkg::Shading) begin : gen_start
    assign start = {ray.ray, ray.kind};
  end else begin : gen_camera_start
    assign start = ray.ray;
  end

  // Engine: exactly one is built.
  if (rc_pkg::Structure == rc_pkg::StructureNone) begin : gen_none
    rc_none u_none (
      .clk_i, .rst_ni(tree_rst_n), .frame_i,
      .ray_valid_i(ray_valid), .ray_ready_o(ray_ready), .ray_i(ray),
      .leaves_fires_o(leaves_fires), .leaves_o(leaves),
      .tested_valid_i(tested_valid), .tested_ready_o(tested_ready), .tested_i(tested),
      .done_valid_o(done_valid), .done_ready_i(done_ready), .done_o(done),
      .done_next_fires_o(done_next_fires), .done_next_o(done_next), .trav_cause_o(trav_cause));

    assign {node_req_valid, node_req_ready, node_req} = '0;
    assign {node_rsp_valid, node_rsp_ready, node_rsp, node_waits} = '0;
    assign {node_next_fires, node_next} = '0;
    assign {node_miss_valid_o, node_miss_o, node_cause} = '0;
    assign {node_unit_cause, mesh_cause, xform_cause, change_fires, change} = '0;

    logic unused;
    assign unused = ^{node_req_valid, node_req_ready, node_req, node_rsp_valid, node_rsp_ready,
        node_rsp, node_waits, node_next_fires, node_next, node_miss_ready_i,
        node_fill_fires_i, node_fill_i};
  end else begin : gen_tree
    rc_tree u_tree (
      .clk_i, .rst_ni(tree_rst_n), .frame_i, .start_fires_i(start_fires), .start_i(start),
      .ray_valid_i(ray_valid), .ray_ready_o(ray_ready), .ray_i(ray),
      .node_req_valid_o(node_req_valid), .node_req_ready_i(node_req_ready), .node_req_o(node_req),
      .node_rsp_valid_i(node_rsp_valid), .node_rsp_ready_o(node_rsp_ready), .node_rsp_i(node_rsp),
      .node_next_fires_i(node_next_fires), .node_next_i(node_next),
      .node_waits_i(node_waits),
      .leaves_fires_o(leaves_fires), .leaves_o(leaves),
      .tested_valid_i(tested_valid), .tested_ready_o(tested_ready), .tested_i(tested),
      .done_valid_o(done_valid), .done_ready_i(done_ready), .done_o(done),
      .done_next_fires_o(done_next_fires), .done_next_o(done_next),
      .trav_cause_o(trav_cause), .node_unit_cause_o(node_unit_cause), .mesh_cause_o(mesh_cause),
      .change_fires_o(change_fires), .change_o(change), .xform_cause_o(xform_cause));
  end

  if (rc_pkg::Structure != rc_pkg::StructureNone) begin : gen_nodes
    logic node_rst_n;
    rc_reset_register u_node_reset (.clk_i, .rst_ni, .rst_no(node_rst_n));

    rc_node_cache u_node_cache (
      .clk_i, .rst_ni(node_rst_n),
      .req_valid_i(node_req_valid), .req_ready_o(node_req_ready), .req_i(node_req),
      .rsp_valid_o(node_rsp_valid), .rsp_ready_i(node_rsp_ready), .rsp_o(node_rsp),
      .next_fires_o(node_next_fires), .next_ray_o(node_next),
      .miss_valid_o(node_miss_valid_o), .miss_ready_i(node_miss_ready_i), .miss_o(node_miss_o),
      .fill_fires_i(node_fill_fires_i), .fill_i(node_fill_i),
      .waits_o(node_waits), .outcome_o(node_cause));
  end

  rc_list u_list (
    .clk_i, .rst_ni(list_rst_n), .start_fires_i(start_fires), .start_i(start),
    .ray_fires_i(ray_valid && ray_ready), .ray_i(ray),
    .change_fires_i(change_fires), .change_i(change),
    .leaves_fires_i(leaves_fires), .leaves_i(leaves),
    .prim_req_valid_o(prim_req_valid), .prim_req_ready_i(prim_req_ready), .prim_req_o(prim_req),
    .prim_rsp_valid_i(prim_rsp_valid), .prim_rsp_ready_o(prim_rsp_ready), .prim_rsp_i(prim_rsp),
    .prim_next_fires_i(prim_next_fires), .prim_next_i(prim_next),
    .tri_req_valid_o(tri_req_valid), .tri_req_ready_i(tri_req_ready), .tri_req_o(tri_req),
    .tri_rsp_valid_i(tri_rsp_valid), .tri_rsp_ready_o(tri_rsp_ready), .tri_rsp_i(tri_rsp),
    .tested_valid_o(tested_valid), .tested_ready_i(tested_ready), .tested_o(tested),
    .done_valid_i(done_valid), .done_ready_o(done_ready), .done_i(done),
    .done_next_fires_i(done_next_fires), .done_next_i(done_next),
    .closest_valid_o(closest_valid), .closest_ready_i(closest_ready), .closest_o(closest));

  rc_prim_cache u_prim_cache (
    .clk_i, .rst_ni(prim_rst_n),
    .req_valid_i(prim_req_valid), .req_ready_o(prim_req_ready), .req_i(prim_req),
    .rsp_valid_o(prim_rsp_valid), .rsp_ready_i(prim_rsp_ready), .rsp_o(prim_rsp),
    .next_fires_o(prim_next_fires), .next_ray_o(prim_next),
    .miss_valid_o(prim_miss_valid_o), .miss_ready_i(prim_miss_ready_i), .miss_o(prim_miss_o),
    .fill_fires_i(prim_fill_fires_i), .fill_i(prim_fill_i),
    .waits_o(prim_waits), .outcome_o(prim_cause));

  rc_tri u_tri (
    .clk_i, .rst_ni(tri_rst_n),
    .req_valid_i(tri_req_valid), .req_ready_o(tri_req_ready), .req_i(tri_req),
    .occupied_o(tri_occupied),
    .rsp_valid_o(tri_rsp_valid), .rsp_ready_i(tri_rsp_ready), .rsp_o(tri_rsp));

  if (!rc_pkg::HasShade) begin : gen_hits   // list's hits are the pixels
    assign pixel_valid   = closest_valid;
    assign closest_ready = pixel_ready;
    assign pixel         = closest;
    assign {spawn_valid, surf_req_valid, surf_req_ready, surf_rsp_valid, surf_rsp_ready} = '0;
    assign {spawn, surf_req, surf_rsp, surf_miss_valid_o, surf_miss_o} = '0;
    assign {surf_cause, shade_cause} = '0;
    assign {tex_req_valid, tex_req} = '0;

    logic unused;
    assign unused = ^{surf_req_valid, surf_req_ready, surf_req, surf_rsp_valid,
        surf_rsp_ready, surf_rsp, surf_miss_ready_i, surf_fill_fires_i, surf_fill_i};
  end else begin : gen_shade
    logic surf_waits, surf_rst_n, shade_rst_n;
    rc_reset_register u_surf_reset (.clk_i, .rst_ni, .rst_no(surf_rst_n));
    rc_reset_register u_shade_reset (.clk_i, .rst_ni, .rst_no(shade_rst_n));

    rc_surf_cache u_surf_cache (
      .clk_i, .rst_ni(surf_rst_n),
      .req_valid_i(surf_req_valid), .req_ready_o(surf_req_ready), .req_i(surf_req),
      .rsp_valid_o(surf_rsp_valid), .rsp_ready_i(surf_rsp_ready), .rsp_o(surf_rsp),
      .miss_valid_o(surf_miss_valid_o), .miss_ready_i(surf_miss_ready_i), .miss_o(surf_miss_o),
      .fill_fires_i(surf_fill_fires_i), .fill_i(surf_fill_i),
      .waits_o(surf_waits), .outcome_o(surf_cause));

    rc_shade u_shade (
      .clk_i, .rst_ni(shade_rst_n), .frame_i,
      .slot_fires_i(slot_valid && slot_ready), .slot_i(slot),
      .ray_fires_i(ray_valid && ray_ready), .ray_i(ray),
      .closest_valid_i(closest_valid), .closest_ready_o(closest_ready), .closest_i(closest),
      .surf_req_valid_o(surf_req_valid), .surf_req_ready_i(surf_req_ready), .surf_req_o(surf_req),
      .surf_rsp_valid_i(surf_rsp_valid), .surf_rsp_ready_o(surf_rsp_ready), .surf_rsp_i(surf_rsp),
      .surf_waits_i(surf_waits),
      .tex_req_valid_o(tex_req_valid), .tex_req_ready_i(tex_req_ready), .tex_req_o(tex_req),
      .tex_rsp_fires_i(tex_rsp_fires), .tex_rsp_i(tex_rsp),
      .spawn_valid_o(spawn_valid), .spawn_ready_i(spawn_ready), .spawn_o(spawn),
      .pixel_valid_o(pixel_valid), .pixel_ready_i(pixel_ready), .pixel_o(pixel),
      .cause_o(shade_cause));
  end

  if (rc_pkg::HasTextures) begin : gen_tex
    logic texels_wait, tex_rst_n;
    rc_reset_register u_tex_reset (.clk_i, .rst_ni, .rst_no(tex_rst_n));

    rc_tex u_tex (
      .clk_i, .rst_ni(tex_rst_n), .frame_i,
      .req_valid_i(tex_req_valid), .req_ready_o(tex_req_ready), .req_i(tex_req),
      .texel_req_valid_o(texel_req_valid), .texel_req_ready_i(texel_req_ready),
      .texel_req_o(texel_req),
      .texel_rsp_valid_i(texel_rsp_valid), .texel_rsp_ready_o(texel_rsp_ready),
      .texel_rsp_i(texel_rsp), .texels_wait_i(texels_wait),
      .rsp_fires_o(tex_rsp_fires), .rsp_o(tex_rsp), .cause_o(tex_cause));

    rc_tex_cache u_tex_cache (
      .clk_i, .rst_ni(tex_rst_n),
      .req_valid_i(texel_req_valid), .req_ready_o(texel_req_ready), .req_i(texel_req),
      .rsp_valid_o(texel_rsp_valid), .rsp_ready_i(texel_rsp_ready), .rsp_o(texel_rsp),
      .miss_valid_o(tex_miss_valid_o), .miss_ready_i(tex_miss_ready_i), .miss_o(tex_miss_o),
      .fill_fires_i(tex_fill_fires_i), .fill_i(tex_fill_i),
      .waits_o(texels_wait), .outcome_o(texels_cause));
  end else begin : gen_no_tex
    assign {tex_req_ready, tex_rsp_fires, tex_rsp, tex_cause, texels_cause} = '0;
    assign {texel_req_valid, texel_req_ready, texel_req} = '0;
    assign {texel_rsp_valid, texel_rsp_ready, texel_rsp, tex_miss_valid_o, tex_miss_o} = '0;

    logic unused;
    assign unused = ^{tex_req_valid, tex_req_ready, tex_req, tex_rsp_fires, tex_rsp,
        texel_req_valid, texel_req_ready, texel_req, texel_rsp_valid, texel_rsp_ready, texel_rsp,
        tex_miss_ready_i, tex_fill_fires_i, tex_fill_i};
  end

  // What each unit did in this cycle; codes in model/machine/units.hpp.
  assign list_cause   = leaves_fires || tri_rsp_valid ? rc_pkg::ListBusyWork
                                                      : rc_pkg::ListStarvedTrav;

  always_comb begin
    if (tri_occupied) tri_cause = rc_pkg::TriBusyWork;
    else if (tri_req_valid) begin
      tri_cause = tri_req_ready ? rc_pkg::TriBusyWork : rc_pkg::TriStalledList;
    end else begin
      tri_cause = prim_waits ? rc_pkg::TriStarvedMemory : rc_pkg::TriStarvedList;
    end
  end

  // Each unit's cause has its own place. The chip has one or two node units; with
  // one, both constants are the same and mesh_cause is 0.
  always_comb begin
    causes_o = '0;
    causes_o[rc_pkg::SchedUnit*CauseBits +: CauseBits]     = sched_cause;
    causes_o[rc_pkg::RaygenUnit*CauseBits +: CauseBits]    = raygen_cause;
    causes_o[rc_pkg::TravUnit*CauseBits +: CauseBits]      = trav_cause;
    causes_o[rc_pkg::NodeCacheUnit*CauseBits +: CauseBits] = node_cause;
    causes_o[rc_pkg::NodeUnit*CauseBits +: CauseBits]      = node_unit_cause;
    causes_o[rc_pkg::MeshUnit*CauseBits +: CauseBits]      =
        causes_o[rc_pkg::MeshUnit*CauseBits +: CauseBits] | mesh_cause;
    causes_o[rc_pkg::XformUnit*CauseBits +: CauseBits]     = xform_cause;
    causes_o[rc_pkg::ListUnit*CauseBits +: CauseBits]      = list_cause;
    causes_o[rc_pkg::PrimCacheUnit*CauseBits +: CauseBits] = prim_cause;
    causes_o[rc_pkg::TriUnit*CauseBits +: CauseBits]       = tri_cause;
    causes_o[rc_pkg::SurfCacheUnit*CauseBits +: CauseBits] = surf_cause;
    causes_o[rc_pkg::ShadeUnit*CauseBits +: CauseBits]     = shade_cause;
    causes_o[rc_pkg::TexUnit*CauseBits +: CauseBits]       = tex_cause;
    causes_o[rc_pkg::TexCacheUnit*CauseBits +: CauseBits]  = texels_cause;
    causes_o[rc_pkg::StreamUnit*CauseBits +: CauseBits]    = stream_cause;
  end
endmodule
`default_nettype wire

// Shading: accepts a finished ray's answer, and returns the context's next ray or its finished
// pixel. rc_pass computes, rc_contexts stores the state of each context.
//
// A camera ray or bounce that has hit something waits for its surface, which this module requests.
// With two levels it requests the instance first, whose line has the address of the surfaces. An
// instance is always accepted.
//
// A textured hit goes to tex, and makes its next pass when the colour has arrived.
//
// A pass enters every ShadeInterval cycles. Passes whose surface is there go first, then contexts
// that need another pass, then contexts whose texture colour has arrived, then answers of other
// rays. Latency rc_pkg::ShadeLatency + 1 from a pass to its output, more if the context passes
// again. closest_i is always accepted; slot_i and ray_i are observed. The user holds frame_i while
// rays are in flight. Model: model/unit/shade/shade.hpp (timing), model/unit/shade/pass/pass.hpp
// (values).
`default_nettype none
module rc_shade (
  input  logic              clk_i,
  input  logic              rst_ni,
  input  rc_pkg::frame_t    frame_i,
  // Observed: a context begins a pixel (sched to raygen), and a ray starts (raygen to trav)
  input  logic              slot_fires_i,
  input  rc_pkg::slot_t     slot_i,
  input  logic              ray_fires_i,
  input  rc_pkg::ray_t      ray_i,
  // From list
  input  logic              closest_valid_i,
  output logic              closest_ready_o,
  input  rc_pkg::closest_t  closest_i,
  // To and from surf_cache
  output logic              surf_req_valid_o,
  input  logic              surf_req_ready_i,
  output rc_pkg::surf_req_t surf_req_o,
  input  logic              surf_rsp_valid_i,
  output logic              surf_rsp_ready_o,
  input  rc_pkg::surf_rsp_t surf_rsp_i,
  input  logic              surf_waits_i,      // the cache waits for memory
  // To and from tex
  output logic              tex_req_valid_o,
  input  logic              tex_req_ready_i,
  output rc_pkg::tex_req_t  tex_req_o,
  input  logic              tex_rsp_fires_i,
  input  rc_pkg::tex_rsp_t  tex_rsp_i,
  // To raygen
  output logic              spawn_valid_o,
  input  logic              spawn_ready_i,
  output rc_pkg::spawn_t    spawn_o,
  // To sched
  output logic              pixel_valid_o,
  input  logic              pixel_ready_i,
  output rc_pkg::pixel_t    pixel_o,
  // What it did: rc_pkg::shade_cause_e
  output logic [rc_pkg::CauseBits-1:0] cause_o
);
  localparam int unsigned RayBits  = rc_pkg::RayBits;
  localparam int unsigned Contexts = rc_pkg::Contexts;
  localparam int unsigned AddrBits = rc_pkg::AddrBits;
  localparam int unsigned PrimBits = rc_pkg::PrimBits;
  localparam int unsigned Every    = rc_pkg::ShadeInterval;
  localparam int unsigned SpawnDataW = rc_pkg::SpawnW - RayBits;
  localparam int unsigned PixelDataW = rc_pkg::PixelW - RayBits;

  logic [rc_pkg::FrameW-1:0]      frame_flat;
  rc_pkg::shade_frame_t           shade_frame;   // lowest in the frame

  assign frame_flat  = frame_i;
  assign shade_frame = rc_pkg::ShadeFrameW'(frame_flat);

  // ---- Answers. A hit of a camera ray or bounce waits for its surface; others enter a pass.
  logic [RayBits-1:0]  closest_ray;
  logic [PrimBits-1:0] closest_prim;
  logic                requests_surface;
  logic                ends_at_any, any_hit;   // any hit ends ray_i; any hit ended the answered ray
  logic [1:0]          kind;                   // of ray_i

  assign closest_ready_o = 1'b1;

  // In a fast chip the answer is one cycle in flight, and then one cycle here.
  localparam int unsigned Late = rc_pkg::PathCut + rc_pkg::FarPathCut;

  logic                answers, way_found, way_requests;
  logic [RayBits-1:0]  way_ray;
  logic [PrimBits-1:0] way_prim;
  logic [AddrBits-1:0] closest_place;

  if (rc_pkg::HasHomes) begin : gen_place_of_hit
    rc_path_register #(.Width(AddrBits), .Stages(Late)) u_place_of_hit (
      .clk_i, .data_i(closest_i.place), .data_o(closest_place));
  end else begin : gen_no_place_of_hit
    assign closest_place = '0;
  end

  rc_path_register #(.Width(RayBits + PrimBits + 1), .Stages(rc_pkg::FarPathCut)) u_way (
    .clk_i, .data_i({closest_i.ray, closest_i.prim, closest_i.found}),
    .data_o({way_ray, way_prim, way_found}));

  rc_path_register #(.Width(RayBits + PrimBits + 1)) u_answer (
    .clk_i, .data_i({way_ray, way_prim, way_requests}),
    .data_o({closest_ray, closest_prim, requests_surface}));

  // A cut-out in the way to a light needs its texture, so its surface is fetched too.
  if (rc_pkg::HasTextures) begin : gen_cutout
    logic way_cutout;

    rc_path_register #(.Width(1), .Stages(rc_pkg::FarPathCut)) u_way_cutout (
      .clk_i, .data_i(closest_i.cutout), .data_o(way_cutout));
    assign way_requests = way_found && (!any_hit || way_cutout);
  end else begin : gen_no_cutout
    assign way_requests = way_found && !any_hit;
  end

  rc_pulse_register #(.Stages(Late)) u_answers (
    .clk_i, .rst_ni, .fires_i(closest_valid_i), .fires_o(answers));

  assign ends_at_any     = kind == rc_pkg::RayShadow || kind == rc_pkg::RayAway;

  // The kind of a ray. A fast chip writes it one cycle later, next to the memory.
  logic               starts, starts_any;
  logic [RayBits-1:0] starts_ray;

  rc_path_register #(.Width(RayBits + 1)) u_starts (
    .clk_i, .data_i({ray_i.ray, ends_at_any}), .data_o({starts_ray, starts_any}));

  rc_ram #(.Width(1), .Depth(Contexts)) u_any (
    .clk_i, .write_i(starts), .write_addr_i(starts_ray), .write_data_i(starts_any),
    .read_addr_i(way_ray), .read_data_o(any_hit));

  rc_pulse_register u_ray_starts (.clk_i, .rst_ni, .fires_i(ray_fires_i), .fires_o(starts));

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) if (rst_ni && closest_valid_i && starts)
    a_not_at_once: assert (closest_i.ray != starts_ray)
    else $error("a ray's answer came before it was known what the ray is");
`endif

  // ---- Surfaces, and with two levels the instances before them. A line of memory is an instance,
  // the material of an instance, or a surface.
  logic line_is_instance;    // the line is an instance or its material
  logic stores_instance;     // the line is the instance of a hit, not of a cut-out before a light
  logic instance_accepted;   // the line is the instance of either
  logic line_accepted;       // the line is an instance or its material
  logic surface_arrived;     // the line is a surface
  logic [rc_pkg::SurfRspW-1:0] surf_rsp;
  rc_pkg::surface_t            surface_found;    // with its instance's material
  rc_pkg::surface_t            surface_line;     // the line, read as a surface
  rc_pkg::placement_t          instance_line;    // the line, read as an instance
  rc_pkg::shade_place_t        place_data, place;

  assign surf_rsp      = surf_rsp_i;
  assign surface_line  = rc_pkg::SurfaceW'(surf_rsp);
  assign instance_line = rc_pkg::PlacementW'(surf_rsp);

  // The material of an instance, for all its primitives.
  localparam int unsigned MaterialW = rc_pkg::SurfaceMaterialW;
  rc_pkg::surface_material_t new_material, material;
  logic [MaterialW-1:0]      material_flat;
  logic                      has_material;   // the surface's instance has a material

  assign new_material.schlick   = surface_line.schlick;
  assign new_material.colour    = surface_line.colour;
  assign new_material.other     = surface_line.other;
  assign new_material.ambient   = surface_line.ambient;
  assign new_material.diffuse   = surface_line.diffuse;
  assign new_material.highlight = surface_line.highlight;
  assign new_material.mirror    = surface_line.mirror;
  assign new_material.transmit  = surface_line.transmit;
  assign new_material.r0        = surface_line.r0;
  assign new_material.shine     = surface_line.shine;
  assign new_material.enter     = surface_line.enter;
  assign new_material.leave     = surface_line.leave;
  assign material               = material_flat;

  logic                 arrived_valid, arrived_pop;
  logic [RayBits-1:0]   arrived_ray;

  if (!rc_pkg::HasHomes) begin : gen_fetch
    logic [AddrBits-1:0]         surfaces, addr;
    logic [RayBits+AddrBits-1:0] fetch;

    assign surfaces = shade_frame.surfaces;
    assign addr     = surfaces + AddrBits'(closest_prim);

    rc_queue #(.Width(RayBits + AddrBits), .Depth(Contexts)) u_fetch (
      .clk_i, .rst_ni, .push_i(answers && requests_surface),
      .data_i({closest_ray, addr}), .valid_o(surf_req_valid_o),
      .pop_i(surf_req_valid_o && surf_req_ready_i), .data_o(fetch));

    assign surf_req_o        = fetch;
    assign line_is_instance  = 1'b0;
    assign stores_instance   = 1'b0;
    assign instance_accepted = 1'b0;
    assign line_accepted     = 1'b0;
    assign place_data        = '0;
    assign material_flat     = '0;
    assign has_material      = 1'b0;

    logic unused;
    assign unused = ^{instance_line, line_accepted, closest_place, new_material};
  end else begin : gen_fetch_twice
    logic [Contexts-1:0]         awaits_instance_q, awaits_material_q;
    logic [Contexts-1:0]         has_material_q;   // the context's last instance has a material
    logic [RayBits-1:0]          line_ray;
    logic                        line_is_material;
    logic [AddrBits-1:0]         prim, surface_addr, stored_addr, next_addr;
    logic                        place_valid, place_ready, fetch_valid, fetch_ready;
    logic [RayBits+AddrBits-1:0] place_next, fetch_next, fetch;

    assign line_ray          = surf_rsp_i.ray;
    assign surface_addr      = instance_line.surfaces + prim;
    assign line_is_material  = awaits_material_q[line_ray];
    assign line_is_instance  = awaits_instance_q[line_ray] || line_is_material;
    assign instance_accepted = surf_rsp_valid_i && awaits_instance_q[line_ray];
    assign line_accepted     = surf_rsp_valid_i && line_is_instance;
    assign next_addr         = line_is_material ? stored_addr
                             : instance_line.material != '0 ? instance_line.material
                             : surface_addr;

    // Line 0: the ray is the same in the instance.
    assign place_data.here = instance_line.is_same ? '0 : instance_line.here;
    assign place_data.a    = instance_line.a;
    assign place_data.b    = instance_line.b;

    if (rc_pkg::HasTextures) begin : gen_texel_scale
      logic to_light;

      assign place_data.texel_scale = instance_line.texel_scale;

      rc_ram #(.Width(1), .Depth(Contexts)) u_to_light (
        .clk_i, .write_i(starts), .write_addr_i(starts_ray), .write_data_i(starts_any),
        .read_addr_i(line_ray), .read_data_o(to_light));
      assign stores_instance = instance_accepted && !to_light;
    end else begin : gen_no_texel_scale
      assign stores_instance = instance_accepted;
    end

    always_ff @(posedge clk_i) begin
      if (instance_accepted) awaits_instance_q[line_ray]    <= 1'b0;
      if (answers)           awaits_instance_q[closest_ray] <= requests_surface;

      if (line_accepted) begin
        awaits_material_q[line_ray] <= instance_accepted && instance_line.material != '0;
        has_material_q[line_ray]    <= line_is_material || instance_line.material != '0;
      end
      if (answers) awaits_material_q[closest_ray] <= 1'b0;
    end

    rc_ram #(.Width(AddrBits), .Depth(Contexts)) u_surface_addr (
      .clk_i, .write_i(instance_accepted), .write_addr_i(line_ray), .write_data_i(surface_addr),
      .read_addr_i(line_ray), .read_data_o(stored_addr));

    rc_ram #(.Width(MaterialW), .Depth(Contexts)) u_material (
      .clk_i, .write_i(line_accepted && line_is_material), .write_addr_i(line_ray),
      .write_data_i(new_material), .read_addr_i(line_ray), .read_data_o(material_flat));

    assign has_material = has_material_q[line_ray];

    rc_ram #(.Width(AddrBits), .Depth(Contexts)) u_prim (
      .clk_i, .write_i(answers), .write_addr_i(closest_ray),
      .write_data_i(AddrBits'(closest_prim)), .read_addr_i(line_ray), .read_data_o(prim));

    rc_queue #(.Width(RayBits + AddrBits), .Depth(Contexts)) u_place (
      .clk_i, .rst_ni, .push_i(answers && requests_surface),
      .data_i({closest_ray, closest_place}), .valid_o(place_valid),
      .pop_i(place_valid && place_ready), .data_o(place_next));

    rc_queue #(.Width(RayBits + AddrBits), .Depth(Contexts)) u_fetch (
      .clk_i, .rst_ni, .push_i(line_accepted), .data_i({line_ray, next_addr}),
      .valid_o(fetch_valid),
      .pop_i(fetch_valid && fetch_ready), .data_o(fetch_next));

    rc_priority_merge #(.Width(RayBits + AddrBits)) u_surf_req (
      .clk_i, .rst_ni,
      .first_valid_i(fetch_valid), .first_ready_o(fetch_ready), .first_i(fetch_next),
      .second_valid_i(place_valid), .second_ready_o(place_ready), .second_i(place_next),
      .valid_o(surf_req_valid_o), .ready_i(surf_req_ready_i), .data_o(fetch));

    assign surf_req_o = fetch;

    logic unused;
    assign unused = ^{instance_line, shade_frame};
  end

  assign surface_arrived = surf_rsp_valid_i && !line_is_instance;

  // An instance's material replaces the surface's own, and its texture: Surface::with_material() in
  // model/core/lines.hpp.
  rc_pkg::surface_t with_material;

  always_comb begin
    with_material = surface_line;
    if (has_material) begin
      with_material.schlick   = material.schlick;
      with_material.colour    = material.colour;
      with_material.other     = material.other;
      with_material.ambient   = material.ambient;
      with_material.diffuse   = material.diffuse;
      with_material.highlight = material.highlight;
      with_material.mirror    = material.mirror;
      with_material.transmit  = material.transmit;
      with_material.r0        = material.r0;
      with_material.shine     = material.shine;
      with_material.enter     = material.enter;
      with_material.leave     = material.leave;
    end
  end

  if (rc_pkg::HasTextures) begin : gen_without_texture
    always_comb begin
      surface_found = with_material;
      if (has_material) surface_found.record = '0;
    end
  end else begin : gen_no_texture
    assign surface_found = with_material;
  end

  // Rays that need no surface.
  rc_queue #(.Width(RayBits), .Depth(Contexts)) u_arrived (
    .clk_i, .rst_ni, .push_i(answers && !requests_surface), .data_i(closest_ray),
    .valid_o(arrived_valid), .pop_i(arrived_pop), .data_o(arrived_ray));

  // ---- Admission: a pass has a place in the output queue.
  logic         open, room, occupied, enters, again_valid, again_pop, end_valid, out_valid,
                out_ready;
  logic [RayBits-1:0] again_ray, ray;

  rc_credit_counter #(.Credits(rc_pkg::ShadeQueue)) u_credits (
    .clk_i, .rst_ni, .admit_i(enters), .leave_i(out_valid), .open_o(room));

  assign open             = room && !occupied;
  assign surf_rsp_ready_o = open || line_is_instance;

  logic               textured_valid, textured_pop;
  logic [RayBits-1:0] textured_ray;

  assign enters       = open && (surface_arrived || again_valid || textured_valid || arrived_valid);
  assign again_pop    = open && !surface_arrived && again_valid;
  assign textured_pop = open && !surface_arrived && !again_valid && textured_valid;
  assign arrived_pop  = open && !surface_arrived && !again_valid && !textured_valid
                     && arrived_valid;
  assign ray          = surface_arrived ? surf_rsp_i.ray : again_valid ? again_ray
                      : textured_valid ? textured_ray : arrived_ray;

  if (Every == 1) begin : gen_never_occupied
    assign occupied = 1'b0;
  end else begin : gen_occupied
    localparam int unsigned Closed = Every - 1;   // cycles without another pass

    logic [Closed-1:0] entered_q;   // the last cycles in which a pass entered
    always_ff @(posedge clk_i) begin
      if (!rst_ni) entered_q <= '0;
      else         entered_q <= Closed'({entered_q, enters});
    end
    assign occupied = |entered_q;
  end

  always_comb begin
    if (occupied)
      cause_o = rc_pkg::ShadeBusyWork;
    else if (surface_arrived || again_valid || textured_valid || arrived_valid)
      cause_o = open ? rc_pkg::ShadeBusyWork : rc_pkg::ShadeStalledQueue;
    else
      cause_o = surf_waits_i ? rc_pkg::ShadeStarvedMemory : rc_pkg::ShadeStarvedList;
  end

  // ---- Pass. Every payload begins with the context's number, so its data lies lowest. rc_contexts
  // answers ShadeRead cycles after a pass enters; the surface of that cycle is held until then.
  rc_pkg::shade_hit_t                hit, closest_hit;
  logic [3*rc_pkg::OriginWidth-1:0]  o;
  logic [3*rc_pkg::DirBits-1:0]      d;
  rc_pkg::shade_state_t              state, end_state;
  rc_pkg::waiting_t                  top, pushed;
  logic [RayBits-1:0]                end_ray, material_ray;
  logic                              material_valid;
  rc_pkg::material_t                 hit_material;
  rc_pkg::shade_changes_t            changes;
  rc_pkg::texel_t                    new_texel, texel;   // from tex, and as stored
  logic [RayBits-1:0]                texel_ray;
  logic [1:0]                        leave;
  logic                              push;
  rc_pkg::spawn_t                    spawn;
  rc_pkg::pixel_t                    pixel;
  rc_pkg::tex_req_t                  tex_req;
  logic                              passes;     // the state from rc_contexts is ready
  logic [RayBits-1:0]                pass_ray;
  rc_pkg::surface_t                  surface;

  assign texel_ray        = tex_rsp_i.ray;
  assign new_texel.hole   = tex_rsp_i.hole;
  assign new_texel.colour = tex_rsp_i.colour;

  if (Every == 1) begin : gen_at_once
    assign pass_ray = ray;
    assign surface  = surface_found;
  end else begin : gen_read
    logic [RayBits-1:0]          ray_q;
    logic [rc_pkg::SurfaceW-1:0] surface_q;

    always_ff @(posedge clk_i) begin
      if (enters) ray_q     <= ray;
      if (enters) surface_q <= surface_found;
    end
    assign pass_ray = ray_q;
    assign surface  = surface_q;
  end

  assign closest_hit.found = closest_i.found;
  assign closest_hit.prim  = closest_i.prim;
  assign closest_hit.t     = closest_i.t;
  assign closest_hit.u     = closest_i.u;
  assign closest_hit.v     = closest_i.v;

  if (rc_pkg::Shading) begin : gen_side   // always, but tools read this without
    assign closest_hit.back = closest_i.back;
  end

  if (rc_pkg::HasTextures) begin : gen_cutout_of_hit
    assign closest_hit.cutout = closest_i.cutout;
  end

  rc_contexts u_contexts (
    .clk_i, .rst_ni, .slot_fires_i, .slot_i, .ray_fires_i, .ray_i, .kind_o(kind),
    .closest_fires_i(closest_valid_i), .closest_ray_i(closest_i.ray),
    .closest_hit_i(closest_hit), .read_valid_i(enters), .read_ray_i(ray), .state_valid_o(passes),
    .place_fires_i(stores_instance), .scale_fires_i(instance_accepted),
    .place_ray_i(surf_rsp_i.ray), .place_i(place_data),
    .texel_fires_i(tex_rsp_fires_i), .texel_ray_i(texel_ray), .texel_i(new_texel),
    .texel_o(texel),
    .hit_o(hit), .o_o(o), .d_o(d), .state_o(state), .top_o(top), .place_o(place),
    .material_valid_i(material_valid), .material_ray_i(material_ray), .material_i(hit_material),
    .write_valid_i(end_valid), .write_ray_i(end_ray), .changes_i(changes),
    .write_state_i(end_state),
    .push_i(push), .pushed_i(pushed));

  rc_pass u_pass (
    .clk_i, .rst_ni, .frame_i(shade_frame), .valid_i(passes), .ray_i(pass_ray), .state_i(state),
    .hit_i(hit), .o_i(o), .d_i(d), .surface_i(surface), .top_i(top), .place_i(place),
    .texel_i(texel),
    .material_valid_o(material_valid), .material_ray_o(material_ray), .material_o(hit_material),
    .end_valid_o(end_valid), .end_ray_o(end_ray), .end_state_o(end_state), .changes_o(changes),
    .leave_o(leave), .spawn_o(spawn), .pixel_o(pixel), .tex_req_o(tex_req),
    .push_o(push), .pushed_o(pushed));

  // ---- Output: another pass, a ray or the pixel. Data of rays and pixels waits in memories by
  // context, or, with an interval above 1, in the queues.
  logic [RayBits-1:0] out_ray, spawn_ray, pixel_ray;
  logic [1:0]         out_leave;

  rc_fifo #(.Width(RayBits + 2), .Depth(rc_pkg::ShadeQueue)) u_out (
    .clk_i, .rst_ni, .valid_i(end_valid), .ready_o(out_ready), .data_i({end_ray, leave}),
    .valid_o(out_valid), .ready_i(1'b1), .data_o({out_ray, out_leave}));

  rc_queue #(.Width(RayBits), .Depth(Contexts)) u_again (
    .clk_i, .rst_ni, .push_i(out_valid && out_leave == rc_pkg::LeaveAgain), .data_i(out_ray),
    .valid_o(again_valid), .pop_i(again_pop), .data_o(again_ray));

  logic [SpawnDataW-1:0] spawn_data;
  logic [PixelDataW-1:0] pixel_data;
  logic                  spawns, colours;

  assign spawns  = out_valid && out_leave == rc_pkg::LeaveSpawn;
  assign colours = out_valid && out_leave == rc_pkg::LeavePixel;

  if (Every == 1) begin : gen_beside
    rc_queue #(.Width(RayBits), .Depth(Contexts)) u_spawn (
      .clk_i, .rst_ni, .push_i(spawns), .data_i(out_ray), .valid_o(spawn_valid_o),
      .pop_i(spawn_valid_o && spawn_ready_i), .data_o(spawn_ray));

    rc_queue #(.Width(RayBits), .Depth(Contexts)) u_pixel (
      .clk_i, .rst_ni, .push_i(colours), .data_i(out_ray), .valid_o(pixel_valid_o),
      .pop_i(pixel_valid_o && pixel_ready_i), .data_o(pixel_ray));

    rc_ram #(.Width(SpawnDataW), .Depth(Contexts)) u_spawn_data (
      .clk_i, .write_i(end_valid && leave == rc_pkg::LeaveSpawn), .write_addr_i(end_ray),
      .write_data_i(SpawnDataW'(spawn)), .read_addr_i(spawn_ray), .read_data_o(spawn_data));

    rc_ram #(.Width(PixelDataW), .Depth(Contexts)) u_pixel_data (
      .clk_i, .write_i(end_valid && leave == rc_pkg::LeavePixel), .write_addr_i(end_ray),
      .write_data_i(PixelDataW'(pixel)), .read_addr_i(pixel_ray), .read_data_o(pixel_data));
  end else begin : gen_queued   // in the queues themselves, which are block RAM in a fast chip
    logic [SpawnDataW-1:0] spawn_then;
    logic [PixelDataW-1:0] pixel_then;

    if (rc_pkg::PassCut == 0) begin : gen_register
      always_ff @(posedge clk_i) begin
        if (end_valid) begin
          spawn_then <= SpawnDataW'(spawn);
          pixel_then <= PixelDataW'(pixel);
        end
      end
    end else begin : gen_no_register   // rc_pass_end holds them
      assign spawn_then = SpawnDataW'(spawn);
      assign pixel_then = PixelDataW'(pixel);
    end

    rc_queue #(.Width(rc_pkg::SpawnW), .Depth(Contexts)) u_spawn (
      .clk_i, .rst_ni, .push_i(spawns), .data_i({out_ray, spawn_then}), .valid_o(spawn_valid_o),
      .pop_i(spawn_valid_o && spawn_ready_i), .data_o({spawn_ray, spawn_data}));

    rc_queue #(.Width(rc_pkg::PixelW), .Depth(Contexts)) u_pixel (
      .clk_i, .rst_ni, .push_i(colours), .data_i({out_ray, pixel_then}), .valid_o(pixel_valid_o),
      .pop_i(pixel_valid_o && pixel_ready_i), .data_o({pixel_ray, pixel_data}));
  end

  // ---- Textures: hits that wait for tex, and contexts whose texture colour has arrived.
  if (rc_pkg::HasTextures) begin : gen_textures
    localparam int unsigned TexDataW = rc_pkg::TexReqW - RayBits;
    logic [RayBits-1:0]  tex_ray;
    logic [TexDataW-1:0] tex_data;
    logic                texture_leaves;

    assign texture_leaves = out_valid && out_leave == rc_pkg::LeaveTexture;

    rc_queue #(.Width(RayBits), .Depth(Contexts)) u_texture (
      .clk_i, .rst_ni, .push_i(texture_leaves), .data_i(out_ray), .valid_o(tex_req_valid_o),
      .pop_i(tex_req_valid_o && tex_req_ready_i), .data_o(tex_ray));

    rc_ram #(.Width(TexDataW), .Depth(Contexts)) u_texture_data (
      .clk_i, .write_i(end_valid && leave == rc_pkg::LeaveTexture), .write_addr_i(end_ray),
      .write_data_i(TexDataW'(tex_req)), .read_addr_i(tex_ray), .read_data_o(tex_data));

    always_comb begin
      tex_req_o     = rc_pkg::TexReqW'(tex_data);
      tex_req_o.ray = tex_ray;
    end

    rc_queue #(.Width(RayBits), .Depth(Contexts)) u_textured (
      .clk_i, .rst_ni, .push_i(tex_rsp_fires_i), .data_i(texel_ray),
      .valid_o(textured_valid), .pop_i(textured_pop), .data_o(textured_ray));
  end else begin : gen_no_textures
    assign {tex_req_valid_o, tex_req_o, textured_valid, textured_ray} = '0;

    logic unused;
    assign unused = ^{tex_req_ready_i, tex_rsp_fires_i, textured_pop, tex_req};
  end

  always_comb begin
    spawn_o     = rc_pkg::SpawnW'(spawn_data);
    spawn_o.ray = spawn_ray;
    pixel_o     = rc_pkg::PixelW'(pixel_data);
    pixel_o.ray = pixel_ray;
  end

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) if (rst_ni && end_valid)
    a_never_dropped: assert (out_ready)
    else $error("an answer met a full queue");
`endif

  logic unused;
  assign unused = ^{frame_flat, closest_prim, out_ready, closest_i, spawn, pixel, surf_rsp,
                    tex_req};
endmodule
`default_nettype wire

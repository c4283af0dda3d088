// The state that shade stores for each context. It consists of the camera ray or bounce, the last
// answer, the state between two passes, and the refracted rays that wait. Part of rc_shade, which
// never has two passes of a context in flight.
//
// read_valid_i reads all state of read_ray_i. The state is ready ShadeRead cycles later, with
// state_valid_o. If that is not the same cycle, top_o is ready one cycle later.
//
// The state is wide, and is written and read in ShadeParts parts (rc_context_ram). A pass writes
// only what it has changed: a surface's material when it begins, other groups when it ends.
`default_nettype none
module rc_contexts #(
  localparam int unsigned RayBits     = rc_pkg::RayBits,
  localparam int unsigned Contexts    = rc_pkg::Contexts,
  localparam int unsigned M           = rc_pkg::DirBits,
  localparam int unsigned OriginWidth = rc_pkg::OriginWidth,
  localparam int unsigned RayDirBits  = rc_pkg::RayDirBits,
  localparam int unsigned HitW        = rc_pkg::ShadeHitW
) (
  input  logic                         clk_i,
  input  logic                         rst_ni,
  // Observed: a context begins a pixel, a ray starts, and an answer comes
  input  logic                         slot_fires_i,
  input  rc_pkg::slot_t                slot_i,
  input  logic                         ray_fires_i,
  input  rc_pkg::ray_t                 ray_i,
  output logic [1:0]                   kind_o,         // kind of ray_i
  input  logic                         closest_fires_i,
  input  logic [RayBits-1:0]           closest_ray_i,
  input  rc_pkg::shade_hit_t           closest_hit_i,
  // The instance that was hit: its line, a, b. With textures also the texel scale: of this
  // instance, or of the instance of a cut-out in the way to a light
  input  logic                         place_fires_i,
  input  logic                         scale_fires_i,
  input  logic [RayBits-1:0]           place_ray_i,
  input  rc_pkg::shade_place_t         place_i,
  // With textures: whether a texture has a hole, and its colour
  input  logic                         texel_fires_i,
  input  logic [RayBits-1:0]           texel_ray_i,
  input  rc_pkg::texel_t               texel_i,
  // To rc_pass
  input  logic                         read_valid_i,
  input  logic [RayBits-1:0]           read_ray_i,
  output logic                         state_valid_o,
  output rc_pkg::shade_hit_t           hit_o,
  output logic [3*OriginWidth-1:0]     o_o,
  output logic [3*M-1:0]               d_o,
  output rc_pkg::shade_state_t         state_o,
  output rc_pkg::waiting_t             top_o,
  output rc_pkg::shade_place_t         place_o,
  output rc_pkg::texel_t               texel_o,
  // From rc_pass: a pass has begun with a surface that has this material
  input  logic                         material_valid_i,
  input  logic [RayBits-1:0]           material_ray_i,
  input  rc_pkg::material_t            material_i,
  // From rc_pass: a pass has ended. It has changed these groups, and the group that every pass
  // changes
  input  logic                         write_valid_i,
  input  logic [RayBits-1:0]           write_ray_i,
  input  rc_pkg::shade_changes_t       changes_i,
  input  rc_pkg::shade_state_t         write_state_i,
  input  logic                         push_i,
  input  rc_pkg::waiting_t             pushed_i
);

  // ---- Reads and writes. A fast chip whose passes are rare has registers in front of the
  // memories' ports: the prefix s1 names a signal behind such a register. The data of a pass stays
  // stable for that time.
  localparam int unsigned Parts = rc_pkg::PassParts;

  logic               s1_read_valid;
  logic [RayBits-1:0] s1_read_ray;

  rc_path_register #(.Width(RayBits), .Stages(rc_pkg::PassCut)) u_s1_read_ray (
    .clk_i, .data_i(read_ray_i), .data_o(s1_read_ray));

  rc_pulse_register #(.Stages(rc_pkg::PassCut)) u_s1_read_valid (
    .clk_i, .rst_ni, .fires_i(read_valid_i), .fires_o(s1_read_valid));

  rc_pulse_register #(.Stages(rc_pkg::PassReadCycles)) u_state_valid (
    .clk_i, .rst_ni, .fires_i(read_valid_i), .fires_o(state_valid_o));

  logic                         s1_material_valid, s1_write_valid;
  logic [RayBits-1:0]           s1_material_ray;
  logic [rc_pkg::MaterialW-1:0] s1_material;

  rc_path_register #(.Width(RayBits + rc_pkg::MaterialW), .Stages(rc_pkg::PassCut)) u_s1_material (
    .clk_i, .data_i({material_ray_i, material_i}), .data_o({s1_material_ray, s1_material}));

  rc_pulse_register #(.Stages(rc_pkg::PassCut)) u_s1_material_valid (
    .clk_i, .rst_ni, .fires_i(material_valid_i), .fires_o(s1_material_valid));

  rc_pulse_register #(.Stages(rc_pkg::PassCut)) u_s1_write_valid (
    .clk_i, .rst_ni, .fires_i(write_valid_i), .fires_o(s1_write_valid));

  // ---- Rays, except shadow rays and rays away to a light.
  logic [rc_pkg::RayW-1:0] ray;
  logic [3*RayDirBits-1:0] ray_d;
  logic [3*M-1:0]          d;
  logic                    stores_ray;

  assign ray        = ray_i;
  assign ray_d      = ray_i.d;
  assign stores_ray = kind_o == rc_pkg::RayCamera || kind_o == rc_pkg::RayBounce;

  if (rc_pkg::Shading) begin : gen_kind
    assign kind_o = ray_i.kind;
  end else begin : gen_camera   // never built, but tools read it
    assign kind_o = rc_pkg::RayCamera;
  end

  for (genvar k = 0; k < 3; k++) begin : gen_axis
    assign d[k*M +: M] = ray_d[k*RayDirBits +: M];
  end

  rc_context_ram #(.Width(3 * OriginWidth + 3 * M), .Depth(Contexts)) u_ray (
    .clk_i, .rst_ni, .write_i(ray_fires_i && stores_ray), .write_addr_i(ray_i.ray),
    .write_data_i({ray_i.o, d}), .read_i(s1_read_valid), .read_addr_i(s1_read_ray),
    .read_data_o({o_o, d_o}));

  // ---- Answers, as late as in rc_shade.
  localparam int unsigned Late = rc_pkg::PathCut + rc_pkg::FarPathCut;
  logic               answers;
  logic [RayBits-1:0] answer_ray;
  logic [HitW-1:0]    answer;

  rc_path_register #(.Width(RayBits + HitW), .Stages(Late)) u_answer (
    .clk_i, .data_i({closest_ray_i, closest_hit_i}), .data_o({answer_ray, answer}));

  rc_pulse_register #(.Stages(Late)) u_answers (
    .clk_i, .rst_ni, .fires_i(closest_fires_i), .fires_o(answers));

  rc_context_ram #(.Width(HitW), .Depth(Contexts)) u_hit (
    .clk_i, .rst_ni, .write_i(answers), .write_addr_i(answer_ray),
    .write_data_i(answer), .read_i(s1_read_valid), .read_addr_i(s1_read_ray), .read_data_o(hit_o));

  // ---- The instance that was hit last.
  rc_pkg::instance_map_t           new_map, map;
  logic [rc_pkg::InstanceMapW-1:0] map_flat;

  assign new_map.here = place_i.here;
  assign new_map.a    = place_i.a;
  assign new_map.b    = place_i.b;

  if (rc_pkg::HasHomes) begin : gen_place
    rc_context_ram #(.Width(rc_pkg::InstanceMapW), .Depth(Contexts)) u_place (
      .clk_i, .rst_ni, .write_i(place_fires_i), .write_addr_i(place_ray_i), .write_data_i(new_map),
      .read_i(s1_read_valid), .read_addr_i(s1_read_ray), .read_data_o(map_flat));
  end else begin : gen_no_place
    assign map_flat = '0;

    logic unused;
    assign unused = ^{place_fires_i, place_ray_i, new_map};
  end

  assign map          = map_flat;
  assign place_o.here = map.here;
  assign place_o.a    = map.a;
  assign place_o.b    = map.b;

  if (rc_pkg::HasHomes && rc_pkg::HasTextures) begin : gen_texel_scale
    rc_context_ram #(.Width(rc_pkg::LevelBits), .Depth(Contexts)) u_scale (
      .clk_i, .rst_ni, .write_i(scale_fires_i), .write_addr_i(place_ray_i),
      .write_data_i(place_i.texel_scale), .read_i(s1_read_valid), .read_addr_i(s1_read_ray),
      .read_data_o(place_o.texel_scale));
  end else if (rc_pkg::HasTextures) begin : gen_one_scale
    assign place_o.texel_scale = '0;

    logic unused;
    assign unused = ^{scale_fires_i, place_i};
  end else begin : gen_no_texel_scale
    logic unused;
    assign unused = scale_fires_i;
  end

  // ---- State, in the groups of model/unit/shade/state.hpp. A pass writes the groups that it has
  // changed when it ends, and the groups of the material when it begins.
  localparam int unsigned PixelW   = rc_pkg::ShadePixelW;
  localparam int unsigned EveryW   = rc_pkg::ShadeEveryW;
  localparam int unsigned PointW   = rc_pkg::ShadePointW;
  localparam int unsigned FaceW    = rc_pkg::ShadeFaceW;
  localparam int unsigned AlbedoW  = rc_pkg::ShadeAlbedoW;
  localparam int unsigned ShareW   = rc_pkg::ShadeShareW;
  localparam int unsigned SamplesW = rc_pkg::ShadeSamplesW;
  localparam int unsigned WaitsW   = rc_pkg::ShadeWaitsW;
  localparam int unsigned LookW    = rc_pkg::ShadeLookW;   // of all materials
  localparam int unsigned BendW    = rc_pkg::ShadeBendW;   // for refraction
  localparam int unsigned SelfW    = rc_pkg::ShadeSelfW;   // for spheres

  rc_pkg::shade_groups_t    new_groups, stored_groups;
  rc_pkg::material_groups_t new_material;
  rc_pkg::shade_changes_t   s1_changes;   // groups that are written now

  assign new_groups        = write_state_i;
  assign new_material      = s1_material;
  assign s1_changes.point  = changes_i.point && s1_write_valid;
  assign s1_changes.inner  = changes_i.inner && s1_write_valid;
  assign s1_changes.face   = changes_i.face && s1_write_valid;
  assign s1_changes.albedo = changes_i.albedo && s1_write_valid;
  assign s1_changes.share  = changes_i.share && s1_write_valid;

  // A pixel starts. A fast chip writes it one cycle later; the pixel's passes come much later.
  logic                 s1_slot_valid;
  logic [RayBits-1:0]   s1_slot_ray;
  rc_pkg::shade_pixel_t slot_pixel;
  logic [PixelW-1:0]    s1_slot_pixel;

  assign slot_pixel.x = slot_i.x;
  assign slot_pixel.y = slot_i.y;

  rc_path_register #(.Width(RayBits + PixelW)) u_s1_slot (
    .clk_i, .data_i({slot_i.ray, slot_pixel}), .data_o({s1_slot_ray, s1_slot_pixel}));

  rc_pulse_register u_s1_slot_valid (
    .clk_i, .rst_ni, .fires_i(slot_fires_i), .fires_o(s1_slot_valid));

  // Memories of the groups.
  logic [PixelW-1:0]   pixel;
  logic [EveryW-1:0]   every;
  logic [PointW-1:0]   point;
  logic [FaceW-1:0]    face;
  logic [AlbedoW-1:0]  albedo;
  logic [ShareW-1:0]   share;
  logic [SamplesW-1:0] samples;
  logic [WaitsW-1:0]   waits;
  logic [LookW-1:0]    look;
  logic [BendW-1:0]    bend;
  logic [SelfW-1:0]    self;

  rc_context_ram #(.Width(PixelW), .Depth(Contexts)) u_pixel (
    .clk_i, .rst_ni, .write_i(s1_slot_valid), .write_addr_i(s1_slot_ray),
    .write_data_i(s1_slot_pixel), .read_i(s1_read_valid), .read_addr_i(s1_read_ray),
    .read_data_o(pixel));

  if (rc_pkg::Refraction) begin : gen_bend
    rc_context_ram #(.Width(EveryW + WaitsW), .Depth(Contexts), .Parts(Parts)) u_every (
      .clk_i, .rst_ni, .write_i(s1_write_valid), .write_addr_i(write_ray_i),
      .write_data_i({new_groups.every, new_groups.waits}), .read_i(s1_read_valid),
      .read_addr_i(s1_read_ray), .read_data_o({every, waits}));

    rc_context_ram #(.Width(LookW + BendW), .Depth(Contexts), .Parts(Parts)) u_look (
      .clk_i, .rst_ni, .write_i(s1_material_valid), .write_addr_i(s1_material_ray),
      .write_data_i({new_material.look, new_material.bend}), .read_i(s1_read_valid),
      .read_addr_i(s1_read_ray), .read_data_o({look, bend}));
  end else begin : gen_no_bend
    rc_context_ram #(.Width(EveryW), .Depth(Contexts), .Parts(Parts)) u_every (
      .clk_i, .rst_ni, .write_i(s1_write_valid), .write_addr_i(write_ray_i),
      .write_data_i(new_groups.every), .read_i(s1_read_valid), .read_addr_i(s1_read_ray),
      .read_data_o(every));

    rc_context_ram #(.Width(LookW), .Depth(Contexts), .Parts(Parts)) u_look (
      .clk_i, .rst_ni, .write_i(s1_material_valid), .write_addr_i(s1_material_ray),
      .write_data_i(new_material.look), .read_i(s1_read_valid), .read_addr_i(s1_read_ray),
      .read_data_o(look));

    assign waits = '0;
    assign bend  = '0;
  end

  rc_context_ram #(.Width(PointW), .Depth(Contexts), .Parts(Parts)) u_point (
    .clk_i, .rst_ni, .write_i(s1_changes.point), .write_addr_i(write_ray_i),
    .write_data_i(new_groups.point), .read_i(s1_read_valid), .read_addr_i(s1_read_ray),
    .read_data_o(point));

  // A texture changes only the albedo.
  if (rc_pkg::HasTextures) begin : gen_albedo
    logic [rc_pkg::TexelW-1:0] texel;

    rc_context_ram #(.Width(FaceW), .Depth(Contexts), .Parts(Parts)) u_face (
      .clk_i, .rst_ni, .write_i(s1_changes.face), .write_addr_i(write_ray_i),
      .write_data_i(new_groups.face), .read_i(s1_read_valid), .read_addr_i(s1_read_ray),
      .read_data_o(face));

    rc_context_ram #(.Width(AlbedoW), .Depth(Contexts), .Parts(Parts)) u_albedo (
      .clk_i, .rst_ni, .write_i(s1_changes.albedo), .write_addr_i(write_ray_i),
      .write_data_i(new_groups.albedo), .read_i(s1_read_valid), .read_addr_i(s1_read_ray),
      .read_data_o(albedo));

    rc_context_ram #(.Width(rc_pkg::TexelW), .Depth(Contexts)) u_texel (
      .clk_i, .rst_ni, .write_i(texel_fires_i), .write_addr_i(texel_ray_i),
      .write_data_i(texel_i), .read_i(s1_read_valid), .read_addr_i(s1_read_ray),
      .read_data_o(texel));

    assign texel_o = texel;
  end else begin : gen_no_albedo
    rc_context_ram #(.Width(FaceW + AlbedoW), .Depth(Contexts), .Parts(Parts)) u_face (
      .clk_i, .rst_ni, .write_i(s1_changes.face), .write_addr_i(write_ray_i),
      .write_data_i({new_groups.face, new_groups.albedo}), .read_i(s1_read_valid),
      .read_addr_i(s1_read_ray), .read_data_o({face, albedo}));

    assign texel_o = '0;

    logic unused;
    assign unused = ^{s1_changes.albedo, texel_fires_i, texel_ray_i, texel_i};
  end

  rc_context_ram #(.Width(ShareW), .Depth(Contexts), .Parts(Parts)) u_share (
    .clk_i, .rst_ni, .write_i(s1_changes.share), .write_addr_i(write_ray_i),
    .write_data_i(new_groups.share), .read_i(s1_read_valid), .read_addr_i(s1_read_ray),
    .read_data_o(share));

  if (rc_pkg::Supersampling) begin : gen_samples
    rc_context_ram #(.Width(SamplesW), .Depth(Contexts), .Parts(Parts)) u_samples (
      .clk_i, .rst_ni, .write_i(s1_write_valid), .write_addr_i(write_ray_i),
      .write_data_i(new_groups.samples), .read_i(s1_read_valid), .read_addr_i(s1_read_ray),
      .read_data_o(samples));
  end else begin : gen_no_samples
    assign samples = '0;
  end

  if (rc_pkg::Spheres) begin : gen_self
    rc_context_ram #(.Width(SelfW), .Depth(Contexts), .Parts(Parts)) u_self (
      .clk_i, .rst_ni, .write_i(s1_material_valid), .write_addr_i(s1_material_ray),
      .write_data_i(new_material.self), .read_i(s1_read_valid), .read_addr_i(s1_read_ray),
      .read_data_o(self));
  end else begin : gen_no_self
    assign self = '0;
  end

  if (rc_pkg::HasHomes) begin : gen_inner
    localparam int unsigned InnerW = 3 * OriginWidth;
    logic [InnerW-1:0] inner;

    rc_context_ram #(.Width(InnerW), .Depth(Contexts), .Parts(Parts)) u_inner (
      .clk_i, .rst_ni, .write_i(s1_changes.inner), .write_addr_i(write_ray_i),
      .write_data_i(new_groups.inner), .read_i(s1_read_valid), .read_addr_i(s1_read_ray),
      .read_data_o(inner));

    assign stored_groups.inner = inner;
  end else begin : gen_no_inner
    logic unused;
    assign unused = s1_changes.inner;
  end

  assign stored_groups.pixel   = pixel;
  assign stored_groups.every   = every;
  assign stored_groups.point   = point;
  assign stored_groups.face    = face;
  assign stored_groups.albedo  = albedo;
  assign stored_groups.share   = share;
  assign stored_groups.samples = samples;
  assign stored_groups.waits   = waits;
  assign stored_groups.look    = look;
  assign stored_groups.bend    = bend;
  assign stored_groups.self    = self;

  // State of a context that has just begun: a camera ray of full weight.
  logic [Contexts-1:0] all_fresh;
  logic                fresh;

  if (rc_pkg::ShadeInterval == 1) begin : gen_now
    assign fresh = all_fresh[s1_read_ray];
  end else begin : gen_next
    logic read_fresh_q;
    always_ff @(posedge clk_i) if (s1_read_valid) read_fresh_q <= all_fresh[s1_read_ray];
    assign fresh = read_fresh_q;
  end

  rc_pkg::shade_state_t state, first_state;

  assign state = stored_groups;

  always_comb begin
    first_state = state;
    if (fresh) begin
      first_state.next_event = rc_pkg::EventArrive;
      first_state.pending    = rc_pkg::PendingNone;
      first_state.colour     = '0;
      first_state.weight     = rc_pkg::ValueOne;
      first_state.depth      = '0;
      first_state.waiting    = '0;
      first_state.sample     = '0;
      first_state.sum        = '0;
      first_state.least      = {3{rc_pkg::ValueOne}};
      first_state.most       = '0;
    end
  end

  rc_pkg::shade_state_t first_state_path;

  if (rc_pkg::HasTextures) begin : gen_path
    always_comb begin
      first_state_path = first_state;
      if (fresh) first_state_path.path  = '0;
      if (fresh) first_state_path.holes = '0;
    end
  end else begin : gen_no_path
    assign first_state_path = first_state;
  end

  if (rc_pkg::Panes != 0) begin : gen_panes
    always_comb begin
      state_o = first_state_path;
      if (fresh) state_o.in_cell = '0;
    end
  end else begin : gen_no_panes
    assign state_o = first_state_path;
  end

  rc_flags #(.Flags(Contexts)) u_fresh (
    .clk_i, .rst_ni, .clear_i(write_valid_i), .clear_at_i(write_ray_i),
    .set_i(s1_slot_valid), .set_at_i(s1_slot_ray), .flags_o(all_fresh));

  // ---- Stack of waiting rays.
  logic [3:0] top_at, new_top_at;

  assign new_top_at = write_state_i.waiting - 4'd1;

  if (rc_pkg::Refraction) begin : gen_stack
    localparam int unsigned Up    = $clog2(rc_pkg::Bounces);
    localparam int unsigned AddrW = RayBits + Up;
    logic [RayBits-1:0] top_ray;   // with ShadeInterval above 1: one cycle after the state

    if (rc_pkg::ShadeInterval == 1) begin : gen_top_now
      assign top_ray = s1_read_ray;
    end else begin : gen_top_next
      logic [RayBits-1:0] top_ray_q;

      assign top_ray = top_ray_q;
      always_ff @(posedge clk_i) if (s1_read_valid) top_ray_q <= s1_read_ray;
    end

    logic [AddrW-1:0] write_at, read_at;

    assign top_at   = state.waiting - 4'd1;
    assign write_at = AddrW'(write_ray_i) << Up | AddrW'(new_top_at);
    assign read_at  = AddrW'(top_ray) << Up | (AddrW'(top_at) & AddrW'((1 << Up) - 1));

    rc_context_ram #(.Width(rc_pkg::WaitingW), .Depth(1 << AddrW)) u_stack (
      .clk_i, .rst_ni, .write_i(write_valid_i && push_i), .write_addr_i(write_at),
      .write_data_i(pushed_i), .read_i(state_valid_o), .read_addr_i(read_at), .read_data_o(top_o));
  end else begin : gen_no_stack
    assign top_o  = '0;
    assign top_at = '0;

    logic unused;
    assign unused = ^{push_i, pushed_i, top_at, new_top_at};
  end

  logic unused;
  assign unused = ^{ray, ray_d, slot_i, new_groups, new_material, place_i};
endmodule
`default_nettype wire

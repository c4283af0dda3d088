// The end of a pass: the context's new state, and the outputs. Part of rc_pass.
//
// It has no registers unless a pass stays long in a stage (rc_pkg::PassCut). In that case all
// inputs come early in the last stage and stay until its end. The decision takes several cycles,
// and take_i latches it. Inputs that wait in parts come two cycles before take_i (rc_stage_delay).
// So at most two registers may lie in a row.
//
// Model: pass() and its parts in model/unit/shade/pass/pass.cpp.
`default_nettype none
module rc_pass_end #(
  localparam int unsigned ValueBits   = rc_pkg::ValueBits,
  localparam int unsigned AxisBits    = rc_pkg::AxisBits,
  localparam int unsigned RayBits     = rc_pkg::RayBits,
  localparam int unsigned N           = rc_pkg::CoordBits,
  localparam int unsigned M           = rc_pkg::DirBits,
  localparam int unsigned OriginBits  = rc_pkg::OriginBits,
  localparam int unsigned OriginWidth = rc_pkg::OriginWidth,
  localparam int unsigned PointWidth  = rc_pkg::PointWidth,
  localparam int unsigned RayDirBits  = rc_pkg::RayDirBits,
  localparam int unsigned NormalBits  = rc_pkg::NormalBits
) (
  input  logic                 clk_i,
  input  logic                 take_i,
  input  rc_pkg::shade_frame_t frame_i,
  // The context's state at the start of the pass. Of its surface: the point, and whether
  // it mirrors and transmits
  input  logic [RayBits-1:0]   ray_i,
  input  rc_pkg::shade_state_t begin_state_i,
  input  logic                 mirrors_i,
  input  logic                 transmits_i,
  input  rc_pkg::waiting_t     top_i,
  // From rc_surf, rc_angles and rc_background
  input  logic                    surf_i,  // a surface has arrived
  input  logic [3*PointWidth-1:0] surf_o_i,
  input  logic [3*NormalBits-1:0] surf_n_i,
  input  logic [3*AxisBits-1:0]   surf_normal_i,
  input  logic [3*AxisBits-1:0]   surf_view_i,
  input  logic [ValueBits-1:0]    surf_cosine_i,
  input  logic                    surf_far_i,
  input  logic                    surf_lost_i,
  input  logic [3*rc_pkg::ColourBits-1:0] surf_albedo_i,
  input  logic [3*ValueBits-1:0]   surf_ambient_i,
  input  logic [3*ValueBits-1:0]   background_i,
  // With textures: the path's length, from rc_path_length or rc_far_path; the hit's u and v; for a
  // sphere the u and v from rc_octahedral
  input  logic [rc_pkg::PathBits-1:0] path_i,
  input  logic [rc_pkg::UvBits-1:0] u_i,
  input  logic [rc_pkg::UvBits-1:0] v_i,
  input  logic [rc_pkg::UvBits-1:0] round_u_i,
  input  logic [rc_pkg::UvBits-1:0] round_v_i,
  input  logic                     hole_i,   // the texture has a hole
  input  logic                     cutout_i,   // a shadow ray has met a cut-out: no event
  input  logic [rc_pkg::LevelBits-1:0] scale_i,   // with two levels: of the instance's texels
  // With two levels, from rc_instance_space: a surface was transformed; the ray in the mesh's space
  input  logic                     transform_i,
  input  logic [3*OriginWidth-1:0] transform_o_i,
  input  logic [rc_pkg::AddrBits-1:0] home_i,
  input  logic [3*OriginWidth-1:0] home_o_i,
  input  logic [3*RayDirBits-1:0]  home_d_i,
  // From rc_light
  input  logic                     light_near_i,
  input  logic                     light_clear_i,
  input  logic [3*N-1:0]           light_place_i,
  input  logic [3*ValueBits-1:0]   light_share_i,
  // For a shadow ray or bounce, from rc_normal_side, rc_angles and rc_approach
  input  logic                     above_i,     // the new ray is on that side of the surface
  input  logic                     below_i,
  input  logic                     positive_i,  // the light's cosine is positive
  input  logic [3*RayDirBits-1:0]  d_i,
  input  logic                     enters_i,    // from beyond the lattice: the point of entry
  input  logic [3*OriginWidth-1:0] entry_i,
  input  logic [2:0]               up_i,        // no entry: begin beyond the lattice
  // From rc_bounce
  input  logic [ValueBits-1:0] weight_i,
  input  logic                 total_i,
  // From rc_finish
  input  logic            more_i,  // another sample follows
  input  logic [3*rc_pkg::SumBits-1:0] sum_i,
  input  logic [3*ValueBits-1:0] least_i,
  input  logic [3*ValueBits-1:0] most_i,
  input  logic [3*ValueBits-1:0] mean_i,  // the pixel's colour, if it has several samples
  // The context's new state, and the outputs
  output logic [RayBits-1:0]                 ray_o,
  output rc_pkg::shade_state_t               state_o,
  output rc_pkg::shade_changes_t             changes_o,   // groups of state_o
  output logic                               push_o,
  output rc_pkg::waiting_t                   pushed_o,
  output logic [1:0]                         leave_o,     // rc_pkg::leave_e
  output rc_pkg::spawn_t                     spawn_o,
  output rc_pkg::pixel_t                     pixel_o,
  output rc_pkg::tex_req_t                   tex_req_o
);
  localparam int unsigned Cut = rc_pkg::PassCut;

  // ---- Event of the pass.
  logic [2:0] event_now;
  logic       waits;   // a refracted ray waits
  logic       is_arrive, is_light, is_refract, is_reflect, is_pop, is_end, is_next;
  logic       is_texture, texture_now;
  logic [7:0] events;

  assign texture_now = rc_pkg::HasTextures && event_now == rc_pkg::EventTexture;
  assign event_now = begin_state_i.next_event;
  assign waits     = rc_pkg::Refraction && begin_state_i.waiting != '0;

  assign events = {texture_now, event_now == rc_pkg::EventArrive, event_now == rc_pkg::EventLight,
                   rc_pkg::Refraction && event_now == rc_pkg::EventRefract,
                   event_now == rc_pkg::EventReflect, event_now == rc_pkg::EventPop && waits,
                   event_now == rc_pkg::EventPop && !waits,
                   event_now == rc_pkg::EventPop && !waits && more_i};

  rc_path_register #(.Width(8), .Stages(Cut)) u_event (
    .clk_i, .data_i(cutout_i ? '0 : events),
    .data_o({is_texture, is_arrive, is_light, is_refract, is_reflect, is_pop, is_end, is_next}));

  // ---- Colour.
  logic [3*ValueBits-1:0] begin_colour, added, colour;

  assign begin_colour = begin_state_i.colour;

  rc_path_register #(.Width(3 * ValueBits), .Stages(Cut)) u_added (
    .clk_i, .data_i(surf_i || texture_now ? surf_ambient_i : background_i), .data_o(added));

  for (genvar k = 0; k < 3; k++) begin : gen_channel
    rc_add_saturated u_sum (
      .a_i(begin_colour[k*ValueBits +: ValueBits]), .b_i(added[k*ValueBits +: ValueBits]),
      .sum_o(colour[k*ValueBits +: ValueBits]));
  end

  // ---- The next event, after a surface or a light.
  logic       far, starts;   // starts: a ray can start from the surface
  logic       beyond;        // or a bounce that passes by the lattice, for planes only
  logic       lit;           // another light follows
  logic [6:0] next_light, light;
  logic [2:0] follows, after;

  assign far        = begin_state_i.is_far;
  assign starts     = !far || (!begin_state_i.is_lost && enters_i);
  assign beyond     = rc_pkg::Horizon && far && !begin_state_i.is_lost && !enters_i;
  assign next_light = surf_i || transform_i || texture_now ? '0 : begin_state_i.light + 7'd1;
  assign follows    = begin_state_i.depth >= frame_i.depth ? rc_pkg::EventPop
                    : rc_pkg::Refraction && transmits_i ? rc_pkg::EventRefract
                    : mirrors_i ? rc_pkg::EventReflect : rc_pkg::EventPop;

  logic [2:0] unlit;

  rc_path_register #(.Width(11), .Stages(Cut)) u_after (
    .clk_i, .data_i({next_light, next_light < frame_i.lights, follows}),
    .data_o({light, lit, unlit}));

  assign after = lit ? rc_pkg::EventLight : unlit;

  // With two levels a refracted ray is sent only if a component of its direction reaches a quarter
  // of a unit vector: shortest_held() in model/unit/shade/bounce/bounce.hpp.
  logic held;
  if (rc_pkg::HasHomes) begin : gen_held
    localparam logic signed [RayDirBits-1:0] Quarter = RayDirBits'(1) <<< (M - 4);
    logic [2:0] holds;
    for (genvar k = 0; k < 3; k++) begin : gen_component
      logic signed [RayDirBits-1:0] d;

      assign d        = d_i[k*RayDirBits +: RayDirBits];
      assign holds[k] = d >= Quarter || d <= -Quarter;
    end

    assign held = holds != '0;
  end else begin : gen_all_held
    assign held = 1'b1;
  end

  // ---- Decisions: whether a light counts, and which rays start.
  logic [5:0] slack;   // bound on the rounding of a weight, in units of 2^-17
  logic lights, sends, heavy, refracted, reflected;
  logic counts, awaits_answer, to_point, shadows, pushes, reflects;
  logic escapes;   // the ray takes the background's colour

  assign lights = positive_i && (light_near_i ? below_i : above_i) && (!far || light_clear_i);
  assign sends  = light_near_i ? !begin_state_i.is_lost : starts;

  always_comb begin   // 3 (depth + 1), as a table: two additions before a comparison are long
    slack = '0;
    for (int i = 0; i < 1 << rc_pkg::DepthBits; i++)
      if (begin_state_i.depth == rc_pkg::DepthBits'(i)) slack = 6'(3 * i + 3);
  end

  rc_path_register #(.Width(1), .Stages(Cut)) u_heavy (
    .clk_i, .data_i({1'b0, weight_i, 1'b0} + 19'(slack) >= {1'b0, frame_i.threshold}),
    .data_o(heavy));

  assign refracted = is_refract && heavy && !total_i && below_i && held;
  assign reflected = is_reflect && heavy && above_i;

  rc_path_register #(.Width(7), .Stages(Cut)) u_decided (
    .clk_i,
    .data_i({lights, sends, light_near_i && !far, is_light && lights && sends,
             refracted && (starts || beyond), reflected && (starts || beyond),
             (refracted || reflected) && !starts && !beyond}),
    .data_o({counts, awaits_answer, to_point, shadows, pushes, reflects, escapes}));

  // A transformed point lies in the lattice. The result in the mesh's space is stored as well.
  logic [3*PointWidth-1:0]  turned_o, found_o;
  logic [3*OriginWidth-1:0] inner;

  assign found_o = begin_state_i.o;

  for (genvar k = 0; k < 3; k++) begin : gen_turned
    assign turned_o[k*PointWidth +: PointWidth] =
        PointWidth'($signed(transform_o_i[k*OriginWidth +: OriginWidth]));
    assign inner[k*OriginWidth +: OriginWidth]  = found_o[k*PointWidth +: OriginWidth];
  end

  // ---- New state. Groups that have not changed are not written, and are arbitrary.
  logic                   turned;
  rc_pkg::shade_changes_t changes;

  assign turned = transform_i && home_i != '0;   // otherwise the result in the scene's space stays

  assign changes.point  = surf_i || turned;
  assign changes.inner  = transform_i;
  assign changes.face   = surf_i;
  assign changes.albedo = surf_i || is_texture;
  assign changes.share  = is_light;

  // Through a hole the ray continues, at most 63 times.
  logic goes_on;

  if (rc_pkg::HasTextures) begin : gen_holes
    assign goes_on = is_texture && hole_i && begin_state_i.holes != '1;
  end else begin : gen_no_holes
    assign goes_on = 1'b0;
  end

  rc_pkg::shade_state_t next;

  always_comb begin
    next         = begin_state_i;
    next.o       = transform_i ? turned_o : surf_o_i;
    next.normal  = surf_normal_i;
    next.view    = surf_view_i;
    next.cosine  = surf_cosine_i;
    next.n       = surf_n_i;
    next.is_far  = surf_far_i;
    next.is_lost = surf_lost_i;
    next.albedo  = surf_albedo_i;
    next.share   = light_share_i;

    if (surf_i || transform_i) next.light = '0;

    if (is_arrive) begin
      next.next_event = !surf_i ? rc_pkg::EventPop
                      : rc_pkg::HasHomes ? rc_pkg::EventTransform : after;
    end

    if (transform_i) next.next_event = after;

    if (is_texture) begin
      next.light      = '0;
      next.next_event = goes_on ? rc_pkg::EventArrive : after;
    end

    if (is_arrive || escapes || (is_texture && !goes_on)) next.colour = colour;

    if (is_light) begin
      next.light      = light;
      next.next_event = after;
      next.pending    = !counts ? rc_pkg::PendingNone
                      : awaits_answer ? rc_pkg::PendingAnswer : rc_pkg::PendingSure;
    end

    if (is_refract) begin
      next.total      = total_i;
      next.next_event = rc_pkg::EventReflect;
      if (pushes) next.waiting = begin_state_i.waiting + 4'd1;
    end

    if (is_reflect) begin
      next.next_event = reflects ? rc_pkg::EventArrive : rc_pkg::EventPop;
      if (reflects) begin
        next.weight = weight_i;
        next.depth  = begin_state_i.depth + 4'd1;
      end
    end

    if (is_pop) begin
      next.waiting    = begin_state_i.waiting - 4'd1;
      next.weight     = top_i.weight;
      next.depth      = top_i.depth;
      next.next_event = rc_pkg::EventArrive;
    end

    if (is_end) begin
      next.sum   = sum_i;
      next.least = least_i;
      next.most  = most_i;
    end

    if (is_next) begin
      next.sample     = begin_state_i.sample + 6'd1;
      next.colour     = '0;
      next.weight     = rc_pkg::ValueOne;
      next.depth      = '0;
      next.next_event = rc_pkg::EventArrive;
    end
  end

  rc_pkg::shade_state_t textured, sided, now;
  logic [1:0]           leave;

  // A textured surface goes to tex; with two levels, after the pass *transform*.
  rc_pkg::tex_req_t tex_req;
  logic             requests_texture;   // for a surface or a cut-out in the way to a light
  logic             requests_cutout;

  if (rc_pkg::HasTextures) begin : gen_texture

    assign requests_texture = (cutout_i || (rc_pkg::HasHomes ? transform_i : surf_i))
                       && begin_state_i.record != '0;
    assign requests_cutout  = cutout_i && begin_state_i.record != '0;

    always_comb begin
      textured = next;
      if (requests_texture && !cutout_i) textured.next_event = rc_pkg::EventTexture;
      if (requests_cutout)  textured.pending    = rc_pkg::PendingTexture;
      if (surf_i)       textured.path       = path_i;
      if (is_pop)       textured.path       = top_i.path;
      if (is_next)      textured.path       = '0;
      if (goes_on)      textured.holes      = begin_state_i.holes + 1'b1;
      if (is_pop || is_next || reflects) textured.holes = '0;
    end

    assign tex_req.ray    = ray_i;
    assign tex_req.record = begin_state_i.record;
    assign tex_req.path   = surf_i ? path_i : begin_state_i.path;
    assign tex_req.cosine = cutout_i ? rc_pkg::ValueOne
                          : surf_i || turned ? surf_cosine_i : begin_state_i.cosine;

    if (rc_pkg::Spheres) begin : gen_round
      assign tex_req.u = begin_state_i.is_round && !cutout_i ? round_u_i : u_i;
      assign tex_req.v = begin_state_i.is_round && !cutout_i ? round_v_i : v_i;
    end else begin : gen_no_round
      assign tex_req.u = u_i;
      assign tex_req.v = v_i;

      logic unused;
      assign unused = ^{round_u_i, round_v_i};
    end

    if (rc_pkg::HasHomes) begin : gen_scale
      assign tex_req.scale = scale_i;
    end else begin : gen_no_scale
      logic unused;
      assign unused = ^scale_i;
    end
  end else begin : gen_no_texture
    assign textured         = next;
    assign requests_texture = 1'b0;
    assign requests_cutout  = 1'b0;
    assign tex_req          = '0;

    logic unused;
    assign unused = ^{path_i, u_i, v_i, round_u_i, round_v_i, hole_i, scale_i, requests_cutout};
  end

  if (rc_pkg::Panes != 0) begin : gen_cell
    always_comb begin
      sided = textured;
      if (is_pop) sided.in_cell = top_i.in_cell;
      if (is_next) sided.in_cell = '0;
    end
  end else begin : gen_no_cell
    assign sided = textured;
  end

  if (rc_pkg::HasHomes) begin : gen_inner
    always_comb begin
      now = sided;
      now.inner = inner;
    end
  end else begin : gen_no_inner
    assign now = sided;
  end

  assign leave   = requests_texture ? rc_pkg::LeaveTexture
                 : shadows || reflects || goes_on || is_pop || is_next ? rc_pkg::LeaveSpawn
                 : is_end ? rc_pkg::LeavePixel : rc_pkg::LeaveAgain;

  // ---- Rays. First the waiting ray, which rc_contexts pushes.
  logic [3*M-1:0] short_d, top_d;
  logic [3*PointWidth-1:0] begin_origin;
  logic [3*OriginWidth-1:0] start, top_o, spawn_place;
  logic [3*RayDirBits-1:0]  spawn_way;
  logic [3*OriginWidth-1:0] place;

  assign begin_origin = begin_state_i.o;
  assign top_o        = top_i.o;
  assign top_d        = top_i.d;

  // Start points and directions.
  for (genvar k = 0; k < 3; k++) begin : gen_axis
    assign short_d[k*M +: M]   = d_i[k*RayDirBits +: M];
    logic [OriginWidth-1:0] rough;

    assign rough =
        OriginWidth'($signed(begin_origin[k*PointWidth +: PointWidth]) >>> rc_pkg::FarDrop)
        + OriginWidth'(up_i[k]);

    assign start[k*OriginWidth +: OriginWidth]   = beyond ? rough
                                                 : far ? entry_i[k*OriginWidth +: OriginWidth]
                                                 : begin_origin[k*PointWidth +: OriginWidth];
    assign place[k*OriginWidth +: OriginWidth]   = OriginWidth'(light_place_i[k*N +: N])
                                                 << OriginBits;
    assign spawn_way[k*RayDirBits +: RayDirBits] = is_next ? '0
                                                 : is_pop ? RayDirBits'($signed(top_d[k*M +: M]))
                                                 : d_i[k*RayDirBits +: RayDirBits];
  end

  rc_pkg::waiting_t waiting;

  assign waiting.o         = start;
  assign waiting.d         = short_d;
  assign waiting.weight    = weight_i;
  assign waiting.depth     = begin_state_i.depth + 4'd1;
  assign waiting.self      = begin_state_i.self;
  assign waiting.is_inside = !begin_state_i.is_inside;

  if (rc_pkg::Panes != 0) begin : gen_waiting_cell
    assign waiting.in_cell = begin_state_i.across;
  end

  if (rc_pkg::HasTextures) begin : gen_waiting_path
    assign waiting.path = begin_state_i.path;
  end

  if (rc_pkg::Horizon) begin : gen_waiting_partial   // planes only
    assign waiting.is_partial = beyond;
  end

  // The ray that starts: a camera ray, a bounce, a shadow ray, a ray away to a light.
  logic [1:0]                 kind;

  assign kind   = is_next ? rc_pkg::RayCamera : !is_light ? rc_pkg::RayBounce
                : to_point ? rc_pkg::RayShadow : rc_pkg::RayAway;
  assign spawn_place = is_next ? '0 : is_pop ? top_o : is_light && light_near_i ? place : start;

  logic top_partial, partial;   // tests no planes; a bounce tests planes only
  if (rc_pkg::Horizon) begin : gen_top_partial
    assign top_partial = top_i.is_partial;
  end else begin : gen_top_whole
    assign top_partial = 1'b0;
  end

  assign partial = is_light ? !to_point && light_clear_i : is_pop ? top_partial
                 : is_reflect && beyond;

  rc_pkg::spawn_t spawn;

  assign spawn.ray    = ray_i;
  assign spawn.kind   = kind;
  assign spawn.x      = begin_state_i.x;
  assign spawn.y      = begin_state_i.y;
  assign spawn.sample = is_next ? begin_state_i.sample + 6'd1 : begin_state_i.sample;
  assign spawn.o      = spawn_place;
  assign spawn.d      = spawn_way;

  if (rc_pkg::HasTextures) begin : gen_light_holes
    assign spawn.holes = is_light ? begin_state_i.light_holes : '0;
  end

  if (rc_pkg::Planes) begin : gen_partial
    assign spawn.is_partial = partial;
  end else begin : gen_no_planes
    logic unused;
    assign unused = partial;
  end

  if (rc_pkg::Spheres) begin : gen_self
    assign spawn.self      = is_next ? '0 : is_pop ? top_i.self : begin_state_i.self;
    assign spawn.is_inside = is_next ? 1'b0 : is_pop ? top_i.is_inside : begin_state_i.is_inside;
  end

  if (rc_pkg::HasHomes) begin : gen_home
    logic [3*M-1:0]          short_home_d, top_home_d;
    logic [3*RayDirBits-1:0] top_way;

    assign top_home_d = top_i.home_d;
    for (genvar k = 0; k < 3; k++) begin : gen_axis
      assign short_home_d[k*M +: M]              = home_d_i[k*RayDirBits +: M];
      assign top_way[k*RayDirBits +: RayDirBits] = RayDirBits'($signed(top_home_d[k*M +: M]));
    end

    assign waiting.home   = home_i;
    assign waiting.home_o = home_o_i;
    assign waiting.home_d = short_home_d;
    assign spawn.home     = is_next ? '0 : is_pop ? top_i.home : home_i;
    assign spawn.home_o   = is_next ? '0 : is_pop ? top_i.home_o : home_o_i;
    assign spawn.home_d   = is_next ? '0 : is_pop ? top_way : home_d_i;
  end else begin : gen_no_home
    logic unused;
    assign unused = ^{home_i, home_o_i, home_d_i};
  end

  // ---- The finished pixel.
  rc_pkg::pixel_t pixel;

  assign pixel.ray   = ray_i;
  assign pixel.found = begin_state_i.found;
  assign pixel.prim  = begin_state_i.prim;
  assign pixel.t     = begin_state_i.t;
  assign pixel.u     = begin_state_i.u;
  assign pixel.v     = begin_state_i.v;

  if (rc_pkg::HasShade) begin : gen_colour   // tools also parse a chip without shade
    assign pixel.back   = 1'b0;
    assign pixel.colour = rc_pkg::Supersampling ? mean_i : begin_colour;
  end

  if (rc_pkg::HasHomes) begin : gen_pixel_of_instances
    assign pixel.place = '0;
  end

  if (rc_pkg::HasTextures) begin : gen_no_cutout_pixel
    assign pixel.cutout = 1'b0;
  end

  // ---- Outputs.
  if (Cut == 0) begin : gen_now
    assign ray_o     = ray_i;
    assign state_o   = now;
    assign changes_o = changes;
    assign push_o    = pushes;
    assign pushed_o  = waiting;
    assign leave_o   = leave;
    assign spawn_o   = spawn;
    assign pixel_o   = pixel;
    assign tex_req_o = tex_req;

    logic unused;
    assign unused = ^{clk_i, take_i};
  end else begin : gen_held_outputs
    always_ff @(posedge clk_i) begin
      if (take_i) begin
        ray_o     <= ray_i;
        state_o   <= now;
        changes_o <= changes;
        push_o    <= pushes;
        pushed_o  <= waiting;
        leave_o   <= leave;
        spawn_o   <= spawn;
        pixel_o   <= pixel;
        tex_req_o <= tex_req;
      end
    end
  end

  logic unused;
  assign unused = ^{frame_i, top_i, begin_origin, turned_o, inner, found_o, home_i};
endmodule
`default_nettype wire

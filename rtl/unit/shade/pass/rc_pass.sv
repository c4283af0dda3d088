// One pass of a context through shade. It adds the contribution of the last ray or surface to the
// sample's colour, computes the next ray or light, and decides the next event.
//
// Latency ShadeStages * ShadeInterval, one more with an interval above 1. One pass every
// ShadeInterval cycles, no stall. A pass handles one event, and only the parts that the event needs
// work on it. These are surf (s0 to s7), light (s0 to s28), bounce (s0 to s15) and finish (s0 to
// s4). They share unit vectors, cosines and the side of a direction.
//
// A pass stays in each stage for ShadeInterval cycles, and the registers before the stage hold its
// inputs. So products of a stage can share a multiplier (rc_mul_held). Model: pass() in
// model/unit/shade/pass/pass.hpp.
`default_nettype none
module rc_pass #(
  localparam int unsigned ValueBits   = rc_pkg::ValueBits,
  localparam int unsigned AxisBits    = rc_pkg::AxisBits,
  localparam int unsigned RayBits     = rc_pkg::RayBits,
  localparam int unsigned M           = rc_pkg::DirBits,
  localparam int unsigned OriginWidth = rc_pkg::OriginWidth,
  localparam int unsigned PointWidth  = rc_pkg::PointWidth,
  localparam int unsigned RayDirBits  = rc_pkg::RayDirBits,
  localparam int unsigned UvBits      = rc_pkg::UvBits,
  localparam int unsigned TBits       = rc_pkg::TBits,
  localparam int unsigned ColourBits  = rc_pkg::ColourBits,
  localparam int unsigned SumBits     = rc_pkg::SumBits
) (
  input  logic                     clk_i,
  input  logic                     rst_ni,
  input  rc_pkg::shade_frame_t     frame_i,
  // From rc_contexts and surf_cache
  input  logic                     valid_i,
  input  logic [RayBits-1:0]       ray_i,
  input  rc_pkg::shade_state_t     state_i,
  input  rc_pkg::shade_hit_t       hit_i,      // of the last ray
  input  logic [3*OriginWidth-1:0] o_i,        // of the last camera ray or bounce
  input  logic [3*M-1:0]           d_i,
  input  rc_pkg::surface_t         surface_i,  // if the ray arrives now and has hit something
  // Top of the waiting rays. If a pass stays for more than one cycle, it comes one cycle later.
  input  rc_pkg::waiting_t         top_i,
  // With two levels: the instance that was hit; line 0 if the ray is the same in it.
  input  rc_pkg::shade_place_t     place_i,
  input  rc_pkg::texel_t           texel_i,    // with textures: the answer of tex
  // To rc_contexts: the hit surface's material at the start of a pass, and the state at its end
  output logic                        material_valid_o,
  output logic [RayBits-1:0]          material_ray_o,
  output rc_pkg::material_t           material_o,
  output logic                        end_valid_o,
  output logic [RayBits-1:0]          end_ray_o,
  output rc_pkg::shade_state_t        end_state_o,
  output rc_pkg::shade_changes_t      changes_o,   // groups of end_state_o
  output logic                        push_o,      // a ray must wait
  output rc_pkg::waiting_t            pushed_o,
  // Outputs of the pass
  output logic [1:0]                  leave_o,     // rc_pkg::leave_e
  output rc_pkg::spawn_t              spawn_o,
  output rc_pkg::pixel_t              pixel_o,
  output rc_pkg::tex_req_t            tex_req_o
);
  localparam int unsigned Stages     = rc_pkg::ShadeStages;
  localparam int unsigned Every      = rc_pkg::ShadeInterval;
  localparam int unsigned N          = rc_pkg::CoordBits;
  localparam int unsigned NormalBits = rc_pkg::NormalBits;
  localparam int unsigned ToLightW   = rc_pkg::LightBits + rc_pkg::OriginBits + 1;
  // LongW: width of a vector to a light, or of a sum of corner normals.
  localparam int unsigned LongW      = ToLightW > NormalBits ? ToLightW : NormalBits;
  // TurnW: width of a normal that a map has turned to the scene's space; 0 with one level.
  localparam int unsigned TurnW      = rc_pkg::HasHomes ? rc_pkg::MapBits + AxisBits + 2 : 0;
  // UnitW: width of a vector that rc_angles makes a unit vector.
  localparam int unsigned UnitW      = LongW > TurnW ? LongW : TurnW;

  // The inputs of the end are ready before it. The end is computed in registers on the way.
  // rc_pass_end latches it at the end of the last stage; then the next inputs may come.
  localparam bit          Cut   = rc_pkg::PassCut != 0;
  localparam int unsigned Out   = rc_pkg::PassOutStage;

  // Stages in which a value is ready.
  localparam int unsigned Path    = 3;   // the length of the path, of a hit nearby
  localparam int unsigned Mean    = 4;   // the colour of a pixel with several samples
  localparam int unsigned Toward  = rc_pkg::StageToward;   // the point, and the vector to a light
  localparam int unsigned Albedo  = Toward + 1;
  localparam int unsigned Ambient = Toward + 2;
  localparam int unsigned FarPath = Toward + 3;   // the length of the path, of a hit far away
  localparam int unsigned Weight  = rc_pkg::StageWeight;   // of the next ray
  localparam int unsigned Unit    = rc_pkg::StageUnit;     // the unit vectors
  localparam int unsigned Cosine  = rc_pkg::StageCosine;   // and the direction of the next ray
  localparam int unsigned Home    = rc_pkg::StageHome;     // with two levels: this ray in its mesh
  localparam int unsigned Side  = rc_pkg::HasHomes ? Home : Cosine;   // stage in which n . d begins

  // ---- Input: held if a pass stays for more than one cycle.
  logic                       valid;
  logic [RayBits-1:0]         ray;
  rc_pkg::shade_state_t       context_state;   // as rc_contexts stores it
  rc_pkg::shade_state_t       state;           // for the event of the pass
  rc_pkg::shade_hit_t         hit;
  logic [3*OriginWidth-1:0]   o;
  logic [3*M-1:0]             d;
  rc_pkg::surface_t           surface;
  rc_pkg::waiting_t           s0_top;
  rc_pkg::shade_place_t       place;
  rc_pkg::texel_t             texel;

  if (Every == 1) begin : gen_as_it_comes
    assign valid         = valid_i;
    assign ray           = ray_i;
    assign context_state = state_i;
    assign hit           = hit_i;
    assign o             = o_i;
    assign d             = d_i;
    assign surface       = surface_i;
    assign s0_top        = top_i;
    assign place         = place_i;
    assign texel         = texel_i;
  end else begin : gen_held
    localparam int unsigned RayW = RayBits + rc_pkg::ShadeHitW + 3 * OriginWidth + 3 * M
                                 + rc_pkg::ShadePlaceW;

    always_ff @(posedge clk_i) valid <= rst_ni && valid_i;

    rc_shift_register #(.Width(RayW), .Stages(1)) u_ray (
      .clk_i, .enable_i(valid_i), .data_i({ray_i, hit_i, o_i, d_i, place_i}),
      .data_o({ray, hit, o, d, place}));

    rc_shift_register #(.Width(rc_pkg::ShadeStateW + rc_pkg::SurfaceW), .Stages(1)) u_state (
      .clk_i, .enable_i(valid_i), .data_i({state_i, surface_i}), .data_o({context_state, surface}));

    rc_shift_register #(.Width(rc_pkg::TexelW), .Stages(1)) u_texel (
      .clk_i, .enable_i(valid_i), .data_i(texel_i), .data_o(texel));

    rc_shift_register #(.Width(rc_pkg::WaitingW), .Stages(1)) u_s0_top (
      .clk_i, .enable_i(valid), .data_i(top_i), .data_o(s0_top));
  end

  // ---- s0: with textures, a shadow ray may have met a cut-out. Then the pass requests the texture
  // and handles no event. If the texture has a hole there, the next pass handles the same light
  // again, with a ray that ignores one more cut-out. After 63 holes the next one counts as opaque.
  logic met_cutout;

  if (rc_pkg::HasTextures) begin : gen_cutout
    logic repeats;

    assign met_cutout = context_state.pending == rc_pkg::PendingAnswer && hit.found && hit.cutout;
    assign repeats    = context_state.pending == rc_pkg::PendingTexture && texel.hole
                     && context_state.light_holes != '1;

    always_comb begin
      state = context_state;
      if (repeats) begin
        state.next_event  = rc_pkg::EventLight;
        state.light       = context_state.light - 7'd1;
        state.light_holes = context_state.light_holes + 1'b1;
      end else if (!met_cutout) begin
        state.light_holes = '0;
      end
    end
  end else begin : gen_no_cutout
    assign met_cutout = 1'b0;
    assign state      = context_state;
  end

  // Event of the pass.
  // ends[i]: a pass leaves stage i; the last bit: a pass is complete
  logic [Stages:0]             ends;
  logic                        back, s0_surf, s0_light, s0_refract, s0_bounce, s0_end, s0_transform;
  logic                        s0_texture, s0_cutout;
  logic [TBits-1:0]            t;
  logic [UvBits-1:0]           u, v;
  logic [3*ValueBits-1:0]      colour;
  rc_pkg::shade_state_t        s0_begin_state;   // after rc_pass_begin
  logic                        has_material;

  assign back = hit.back;
  assign t    = hit.t;
  assign u    = hit.u;
  assign v    = hit.v;

  rc_pass_begin u_begin (
    .valid_i(ends[0]), .cutout_i(met_cutout), .state_i(state), .hit_i(hit), .surface_i(surface),
    .surf_o(s0_surf), .light_o(s0_light), .bounce_o(s0_bounce), .refract_o(s0_refract),
    .transform_o(s0_transform), .texture_o(s0_texture), .end_o(s0_end), .colour_o(colour),
    .has_material_o(has_material), .material_o, .begin_state_o(s0_begin_state));

  // The material leaves at once: inputs of several cycles stay stable.
  assign material_valid_o = valid && has_material;
  assign material_ray_o   = ray;
  assign s0_cutout        = ends[0] && met_cutout;

  // phase: the cycle of each stage, s0 lowest. The pass is over in the first cycle after the last
  // stage.
  logic [Stages*Every:0] phase;
  logic [Stages*Every:1] phase_q;

  assign phase = {phase_q, valid};

  always_ff @(posedge clk_i) begin
    if (!rst_ni) phase_q <= '0;
    else         phase_q <= phase[Stages*Every-1:0];
  end

  for (genvar i = 0; i < Stages; i++) begin : gen_ends
    assign ends[i] = phase[i*Every+Every-1];
  end

  assign ends[Stages] = phase[Stages*Every];
  assign end_valid_o  = ends[Stages];

  // The events of the passes that leave their stages. face: with a surface or a transform. tone:
  // with a surface or a texture.
  logic [Stages:0] surf_at, light_at, bounce_at, end_at, transform_at, texture_at, face_at, tone_at;
  logic [Stages:0] sends_at;   // light, bounce or texture: a ray may start
  logic [Stages:0] cutout_at;
  logic [Stages:1] surf_q, light_q, bounce_q, end_q, transform_q, texture_q, cutout_q;

  always_ff @(posedge clk_i) begin
    for (int i = 0; i < Stages; i++)
      if (Every == 1 || ends[i]) begin
        surf_q[i+1]   <= surf_at[i];
        light_q[i+1]  <= light_at[i];
        bounce_q[i+1] <= bounce_at[i];
        end_q[i+1]    <= end_at[i];
        transform_q[i+1] <= transform_at[i];
        texture_q[i+1]      <= texture_at[i];
        cutout_q[i+1]       <= cutout_at[i];
      end
  end

  if (Every == 1) begin : gen_always_on
    assign surf_at      = {surf_q, s0_surf};
    assign light_at     = {light_q, s0_light};
    assign bounce_at    = {bounce_q, s0_bounce};
    assign end_at       = {end_q, s0_end};
    assign transform_at = {transform_q, s0_transform};
    assign texture_at   = {texture_q, s0_texture};
    assign cutout_at    = {cutout_q, s0_cutout};
  end else begin : gen_goes_on
    assign surf_at      = {surf_q & ends[Stages:1], s0_surf};
    assign light_at     = {light_q & ends[Stages:1], s0_light};
    assign bounce_at    = {bounce_q & ends[Stages:1], s0_bounce};
    assign end_at       = {end_q & ends[Stages:1], s0_end};
    assign transform_at = {transform_q & ends[Stages:1], s0_transform};
    assign texture_at   = {texture_q & ends[Stages:1], s0_texture};
    assign cutout_at    = {cutout_q & ends[Stages:1], s0_cutout};
  end

  assign face_at = surf_at | transform_at;
  assign tone_at = surf_at | texture_at;
  assign sends_at = light_at | bounce_at | texture_at;

  // ---- The state at the start of the pass, delayed to the end.
  logic                   goes_on, mirrors, transmits;  // goes_on: one cycle before the first stage
  logic [RayBits-1:0]     end_ray;                       // ends, with fewer loads
  rc_pkg::shade_state_t   begin_state;
  rc_pkg::waiting_t       top;

  assign goes_on = Every > 2 ? phase[Every < 2 ? 0 : Every-2] : ends[0];

  rc_pass_state u_begin_state (
    .clk_i, .rst_ni, .enter_i(goes_on), .leave_i(ends[Out]), .ray_i(ray),
    .s0_state_i(s0_begin_state), .ray_o(end_ray), .begin_state_o(begin_state),
    .mirrors_o(mirrors), .transmits_o(transmits));

  rc_stage_delay #(.Width(rc_pkg::WaitingW), .Stages(Stages), .Parts(rc_pkg::PassParts)) u_top (
    .clk_i, .rst_ni, .enter_i(goes_on), .leave_i(ends[Out]), .data_i(s0_top),
    .data_o(top));

  // Vectors that are needed on the way.
  logic [3*AxisBits-1:0]   s13_normal, s13_view;
  logic [3*NormalBits-1:0] side_n;

  // With two levels the pass *transform* finds a sphere's place in its picture. So the normal goes
  // through this pass too; it does not change.
  localparam bit Round = rc_pkg::HasTextures && rc_pkg::Spheres;

  rc_stage_delay #(.Width(6 * AxisBits), .Stages(Unit)) u_vectors (
    .clk_i, .rst_ni, .enter_i(s0_light || s0_bounce || (Round && s0_transform)),
    .leave_i(light_at[Unit] || bounce_at[Unit] || (Round && transform_at[Unit])),
    .data_i({state.normal, state.view}), .data_o({s13_normal, s13_view}));

  rc_stage_delay #(.Width(3 * NormalBits), .Stages(Side)) u_n (
    .clk_i, .rst_ni, .enter_i(s0_light || s0_bounce),
    .leave_i(light_at[Side] || bounce_at[Side]), .data_i(state.n), .data_o(side_n));

  // ---- Surface.
  logic [3*PointWidth-1:0] s5_o, surf_o;
  logic [3*NormalBits-1:0] s5_n, surf_n;
  logic [3*UnitW-1:0]      s5_toward, s5_target, s5_turned;
  logic                    s5_far, surf_far, s5_lost, surf_lost;
  logic [3*ColourBits-1:0] s6_albedo, surf_albedo;
  logic [3*ValueBits-1:0]  s7_ambient, surf_ambient;

  logic [3*ColourBits-1:0] albedo;
  logic [ColourBits-1:0]   share;   // of ambient light

  assign albedo = state.albedo;

  // Operands of products must stay for all cycles of a stage; s0_texture is valid in the last one.
  logic s0_is_texture;

  assign s0_is_texture = rc_pkg::HasTextures && state.next_event == rc_pkg::EventTexture;

  if (rc_pkg::HasTextures) begin : gen_share
    assign share = state.ambient;
  end else begin : gen_no_share
    assign share = '0;
  end

  rc_surf #(.UnitW(UnitW)) u_surf (
    .clk_i, .valid_i(surf_at[Ambient-1:0]), .phase_i(phase[Ambient*Every-1:0]),
    .s0_u_i(u), .s0_v_i(v), .s0_t_i(t), .s0_back_i(back),
    .s0_surface_i(surface), .s0_o_i(o), .s0_d_i(d), .s0_weight_i(state.weight),
    .tone_valid_i(tone_at[Ambient-1:0]), .s0_texture_i(s0_is_texture), .s0_albedo_i(albedo),
    .s0_share_i(share), .s0_texel_i(texel.colour),
    .s5_o_o(s5_o), .s5_n_o(s5_n), .s5_toward_o(s5_toward), .s5_far_o(s5_far),
    .s5_lost_o(s5_lost),
    .s6_albedo_o(s6_albedo), .s7_ambient_o(s7_ambient));

  rc_stage_delay #(.Width(3 * PointWidth + 3 * NormalBits + 2), .Stages(Out - Toward),
                   .Parts(rc_pkg::PassParts))
    u_point (
    .clk_i, .rst_ni, .enter_i(surf_at[Toward]), .leave_i(surf_at[Out]),
    .data_i({s5_o, s5_n, s5_far, s5_lost}),
    .data_o({surf_o, surf_n, surf_far, surf_lost}));

  rc_stage_delay #(.Width(3 * ColourBits), .Stages(Out - Albedo),
                   .Parts(rc_pkg::PassParts))
  u_albedo (
    .clk_i, .rst_ni, .enter_i(tone_at[Albedo]), .leave_i(tone_at[Out]), .data_i(s6_albedo),
    .data_o(surf_albedo));

  rc_stage_delay #(.Width(3 * ValueBits), .Stages(Out - Ambient),
                   .Parts(rc_pkg::PassParts))
  u_ambient (
    .clk_i, .rst_ni, .enter_i(tone_at[Ambient]), .leave_i(tone_at[Out]), .data_i(s7_ambient),
    .data_o(surf_ambient));

  // ---- With textures: the inputs of tex: the length of the path, u and v.
  logic [rc_pkg::PathBits-1:0] surf_path;
  logic [UvBits-1:0] face_u, face_v, round_u, round_v;
  logic              end_hole;   // the texture has a hole: the ray continues
  logic [3*M-1:0]    s15_old_d;  // in its direction

  if (rc_pkg::HasTextures) begin : gen_path
    logic [rc_pkg::PathBits-1:0] s3_path, near_path;

    rc_stage_delay #(.Width(3 * M), .Stages(Cosine)) u_old_d (
      .clk_i, .rst_ni, .enter_i(s0_texture), .leave_i(texture_at[Cosine]), .data_i(d),
      .data_o(s15_old_d));

    rc_stage_delay #(.Width(1), .Stages(Out), .Parts(rc_pkg::PassParts)) u_hole (
      .clk_i, .rst_ni, .enter_i(s0_texture), .leave_i(texture_at[Out]),
      .data_i(texel.hole), .data_o(end_hole));

    rc_path_length u_path_length (
      .clk_i, .valid_i(surf_at[Path-1:0]), .s1_phase_i(phase[Every +: Every]),
      .s0_path_i(state.path), .s0_t_i(t), .s0_d_i(d), .s3_path_o(s3_path));

    rc_stage_delay #(.Width(rc_pkg::PathBits), .Stages(Out - Path), .Parts(rc_pkg::PassParts))
    u_path (
      .clk_i, .rst_ni, .enter_i(surf_at[Path]), .leave_i(surf_at[Out]), .data_i(s3_path),
      .data_o(near_path));

    // A plane's hit may be too far away for t.
    if (rc_pkg::Planes) begin : gen_far_path
      logic                        end_far;
      logic [rc_pkg::PathBits-1:0] s8_path, far_path;

      rc_far_path u_far_path (
        .clk_i, .rst_ni, .valid_i(surf_at[FarPath-1:0]), .s0_path_i(state.path), .s0_o_i(o),
        .s5_o_i(s5_o), .s8_path_o(s8_path));

      rc_stage_delay #(.Width(rc_pkg::PathBits), .Stages(Out - FarPath), .Parts(rc_pkg::PassParts))
      u_far (
        .clk_i, .rst_ni, .enter_i(surf_at[FarPath]), .leave_i(surf_at[Out]), .data_i(s8_path),
        .data_o(far_path));

      rc_stage_delay #(.Width(1), .Stages(Out), .Parts(rc_pkg::PassParts)) u_is_far (
        .clk_i, .rst_ni, .enter_i(surf_at[0]), .leave_i(surf_at[Out]),
        .data_i(surface.kind == rc_pkg::PrimPlane && t == '1), .data_o(end_far));

      assign surf_path = end_far ? far_path : near_path;
    end else begin : gen_no_far_path
      assign surf_path = near_path;
    end

    rc_stage_delay #(.Width(2 * UvBits), .Stages(Out), .Parts(rc_pkg::PassParts)) u_uv (
      .clk_i, .rst_ni, .enter_i(face_at[0] || cutout_at[0]),
      .leave_i(face_at[Out] || cutout_at[Out]), .data_i({u, v}),
      .data_o({face_u, face_v}));
  end else begin : gen_no_path
    assign {surf_path, face_u, face_v, end_hole, s15_old_d} = '0;

    logic unused;
    assign unused = texel.hole;
  end

  // ---- Unit vectors and cosines.
  logic [3*ToLightW-1:0] s5_to;
  logic [3*AxisBits-1:0] s13_unit, s13_new_view, surf_normal, surf_view;
  logic [ValueBits-1:0]  s15_cosine, surf_cosine;
  logic signed [AxisBits:0] s15_mirror;

  for (genvar k = 0; k < 3; k++) begin : gen_target
    assign s5_target[k*UnitW +: UnitW] =
        light_q[Toward]        ? UnitW'($signed(s5_to[k*ToLightW +: ToLightW]))
        : transform_q[Toward] ? s5_turned[k*UnitW +: UnitW] : s5_toward[k*UnitW +: UnitW];
  end

  rc_angles #(.UnitW(UnitW)) u_angles (
    .clk_i, .rst_ni, .surf_i(face_at[Unit+1:0]), .light_i(light_at[Unit+1:0]),
    .phase_i(phase[(Unit+1)*Every-1:0]), .s13_surf_i(surf_q[Unit] || transform_q[Unit]),
    .s0_d_i(d),
    .s5_toward_i(s5_target), .s13_normal_i(s13_normal), .s13_view_i(s13_view),
    .s13_unit_o(s13_unit), .s13_view_o(s13_new_view), .s15_cosine_o(s15_cosine),
    .s15_mirror_o(s15_mirror));

  rc_stage_delay #(.Width(6 * AxisBits), .Stages(Out - Unit), .Parts(rc_pkg::PassParts))
  u_surf_vectors (
    .clk_i, .rst_ni, .enter_i(face_at[Unit]), .leave_i(face_at[Out]),
    .data_i({s13_unit, s13_new_view}),
    .data_o({surf_normal, surf_view}));

  rc_stage_delay #(.Width(ValueBits), .Stages(Out - Cosine), .Parts(rc_pkg::PassParts)) u_cosine (
    .clk_i, .rst_ni, .enter_i(face_at[Cosine]), .leave_i(face_at[Out]), .data_i(s15_cosine),
    .data_o(surf_cosine));

  // ---- With textures on spheres: the place of the normal in the picture.
  localparam int unsigned Steps = rc_pkg::OctahedralSteps;
  // The first stage at whose end the place is in rc_octahedral's output registers.
  localparam int unsigned Ready = Unit + (Steps + 1 + Every) / Every;

  if (Round && Ready >= Out) begin : gen_refuse
    $error("rc_pass: a sphere's place in its picture comes too late");
  end

  if (Round) begin : gen_octahedral
    logic              s13_inside, leaves_13, begins_14;
    logic [UvBits-1:0] ready_u, ready_v;

    assign leaves_13 = rc_pkg::HasHomes ? transform_at[Unit] : surf_at[Unit];
    assign begins_14 = phase[(Unit+1)*Every]
                     && (rc_pkg::HasHomes ? transform_q[Unit+1] : surf_q[Unit+1]);

    rc_stage_delay #(.Width(1), .Stages(Unit)) u_inside (
      .clk_i, .rst_ni, .enter_i(face_at[0]), .leave_i(face_at[Unit]),
      .data_i(s0_begin_state.is_inside), .data_o(s13_inside));

    rc_octahedral u_octahedral (
      .clk_i, .leaves_13_i(leaves_13), .s13_normal_i(rc_pkg::HasHomes ? s13_normal : s13_unit),
      .s13_inside_i(s13_inside), .begins_14_i(begins_14), .done_i(phase[(Unit+1)*Every+Steps]),
      .u_o(ready_u), .v_o(ready_v));

    rc_stage_delay #(.Width(2 * UvBits), .Stages(Out - Ready), .Parts(rc_pkg::PassParts)) u_round (
      .clk_i, .rst_ni, .enter_i(face_at[Ready]), .leave_i(face_at[Out]),
      .data_i({ready_u, ready_v}), .data_o({round_u, round_v}));
  end else begin : gen_no_octahedral
    assign {round_u, round_v} = '0;
  end

  // ---- Light and bounce.
  logic                    light_near, light_clear, s13_total, bounce_total, s15_near;
  logic [3*RayDirBits-1:0] s15_light_d, s15_d, end_d;
  logic [3*N-1:0]          s15_place, light_place;
  logic [3*ValueBits-1:0]  light_share;
  logic [ValueBits-1:0]    s9_weight, bounce_weight;
  logic [3*M-1:0]          s15_bounce_d;

  rc_light u_light (
    .clk_i, .rst_ni, .frame_i, .valid_i(light_at), .phase_i(phase[Stages*Every-1:0]),
    .s0_light_i(state.light),
    .s0_o_i(state.o), .s0_far_i(state.is_far), .s0_weight_i(state.weight),
    .s0_state_i(state), .s5_to_o(s5_to),
    .s13_unit_i(s13_unit), .s15_cosine_i(s15_cosine), .s15_mirror_i(s15_mirror),
    .s15_d_o(s15_light_d), .s15_near_o(s15_near), .s15_place_o(s15_place),
    .s28_place_o(light_place),
    .s28_near_o(light_near), .s28_clear_o(light_clear), .s28_share_o(light_share));

  rc_bounce u_bounce (
    .clk_i, .rst_ni, .valid_i(bounce_at[Unit+1:0]), .phase_i(phase[(Unit+1)*Every-1:0]),
    .s0_refract_i(s0_refract), .s0_state_i(state),
    .s13_normal_i(s13_normal), .s13_view_i(s13_view), .s9_weight_o(s9_weight),
    .s13_total_o(s13_total), .s15_d_o(s15_bounce_d));

  rc_stage_delay #(.Width(ValueBits), .Stages(Out - Weight), .Parts(rc_pkg::PassParts)) u_weight (
    .clk_i, .rst_ni, .enter_i(bounce_at[Weight]), .leave_i(bounce_at[Out]), .data_i(s9_weight),
    .data_o(bounce_weight));

  rc_stage_delay #(.Width(1), .Stages(Out - Unit), .Parts(rc_pkg::PassParts)) u_total (
    .clk_i, .rst_ni, .enter_i(bounce_at[Unit]), .leave_i(bounce_at[Out]), .data_i(s13_total),
    .data_o(bounce_total));

  // ---- Background, for a ray that met nothing or a bounce that is not traced.
  logic [3*ValueBits-1:0] background, end_background;
  logic [ValueBits-1:0]   state_weight;

  assign state_weight = state.weight;
  assign background   = frame_i.background;

  rc_background u_background (
    .clk_i, .rst_ni, .begins_i(ends[0]), .s0_weight_i(state_weight), .s9_ends_i(ends[Weight]),
    .s9_phase_i(phase[Weight*Every +: Every]), .s9_bounce_i(bounce_q[Weight]),
    .s9_weight_i(s9_weight), .colour_i(background), .s10_ends_i(ends[Weight+1]),
    .end_i(ends[Out]), .end_colour_o(end_background));

  // ---- Side of the surface to which a direction leaves: exact.
  logic above, below, end_above, end_below, end_positive;
  logic [3*RayDirBits-1:0] side_d;

  for (genvar k = 0; k < 3; k++) begin : gen_d
    assign s15_d[k*RayDirBits +: RayDirBits] =
        light_q[Cosine]     ? s15_light_d[k*RayDirBits +: RayDirBits]
        : texture_q[Cosine] ? RayDirBits'($signed(s15_old_d[k*M +: M]))
        : RayDirBits'($signed(s15_bounce_d[k*M +: M]));
  end

  rc_normal_side u_normal_side (
    .clk_i, .valid_i((light_at[Side+1:Side] | bounce_at[Side+1:Side])),
    .phase_i(phase[Side*Every+rc_pkg::PassCut +: Every]), .n_i(side_n), .d_i(side_d),
    .above_o(above), .below_o(below));

  rc_stage_delay #(.Width(2), .Stages(Out - Side - 2), .Parts(rc_pkg::PassParts)) u_sides (
    .clk_i, .rst_ni, .enter_i(light_at[Side+2] || bounce_at[Side+2]),
    .leave_i(light_at[Out] || bounce_at[Out]), .data_i({above, below}),
    .data_o({end_above, end_below}));

  rc_stage_delay #(.Width(3 * RayDirBits + 1), .Stages(Out - Cosine),
                   .Parts(rc_pkg::PassParts))
  u_d (
    .clk_i, .rst_ni, .enter_i(sends_at[Cosine]), .leave_i(sends_at[Out]),
    .data_i({s15_d, s15_cosine != '0}),
    .data_o({end_d, end_positive}));

  // ---- With two levels: from a mesh's space, and into it.
  logic [3*OriginWidth-1:0]    turned_o, end_home_o;
  logic [3*RayDirBits-1:0]     end_home_d;
  logic [rc_pkg::AddrBits-1:0] end_home;
  logic [rc_pkg::LevelBits-1:0] end_scale;   // of the instance's texels

  if (rc_pkg::HasHomes) begin : gen_homes
    localparam int unsigned MapBits    = rc_pkg::MapBits;
    localparam int unsigned TranslateW = N + rc_pkg::MapFrac;
    logic [3*OriginWidth-1:0]    s5_turned_o, s19_home_o;
    logic [3*RayDirBits-1:0]     s19_home_d;
    logic [rc_pkg::AddrBits-1:0] here;
    logic [9*MapBits-1:0]        map_a;
    logic [3*TranslateW-1:0]     map_b;

    assign here  = place.here;
    assign map_a = place.a;
    assign map_b = place.b;

    rc_instance_space #(.UnitW(UnitW)) u_instance_space (
      .clk_i, .rst_ni, .transform_valid_i(transform_at[Toward-1:0]), .s0_phase_i(phase[Every-1:0]),
      .s0_o_i(o),
      .s0_d_i(d), .s0_t_i(t), .s0_normal_i(state.normal), .s0_a_i(map_a),
      .s5_toward_o(s5_turned), .s5_o_o(s5_turned_o),
      .leave_0_i(sends_at[0]), .leave_valid_i(sends_at[Home-1:Cosine]),
      .s15_phase_i(phase[Cosine*Every +: Every]), .s0_b_i(map_b), .s0_inner_i(state.inner),
      .s15_near_i(light_q[Cosine] && s15_near), .s15_place_i(s15_place), .s15_d_i(s15_d),
      .s19_o_o(s19_home_o), .s19_d_o(s19_home_d));

    assign side_d = s19_home_d;

    rc_stage_delay #(.Width(3 * OriginWidth), .Stages(Out - Toward), .Parts(rc_pkg::PassParts))
    u_turned (
      .clk_i, .rst_ni, .enter_i(transform_at[Toward]), .leave_i(transform_at[Out]),
      .data_i(s5_turned_o), .data_o(turned_o));

    rc_stage_delay #(.Width(3 * (OriginWidth + RayDirBits)), .Stages(Out - Home),
                     .Parts(rc_pkg::PassParts))
    u_home (
      .clk_i, .rst_ni, .enter_i(sends_at[Home]), .leave_i(sends_at[Out]),
      .data_i({s19_home_o, s19_home_d}),
      .data_o({end_home_o, end_home_d}));

    rc_stage_delay #(.Width(rc_pkg::AddrBits), .Stages(Out), .Parts(rc_pkg::PassParts)) u_here (
      .clk_i, .rst_ni, .enter_i(sends_at[0] || s0_transform),
      .leave_i(sends_at[Out] || transform_at[Out]), .data_i(here),
      .data_o(end_home));
    if (rc_pkg::HasTextures) begin : gen_scale
      rc_stage_delay #(.Width(rc_pkg::LevelBits), .Stages(Out), .Parts(rc_pkg::PassParts))
      u_scale (
        .clk_i, .rst_ni, .enter_i(s0_transform || s0_cutout),
        .leave_i(transform_at[Out] || cutout_at[Out]), .data_i(place.texel_scale),
        .data_o(end_scale));
    end else begin : gen_no_scale
      assign end_scale = '0;
    end
  end else begin : gen_one_space
    assign end_scale = '0;
    assign side_d    = s15_d;
    assign s5_turned = '0;
    assign {turned_o, end_home, end_home_o, end_home_d} = '0;

    logic unused;
    assign unused = ^{place, s15_near, s15_place};
  end

  // ---- From beyond the lattice: the point of entry.
  logic                     enters;
  logic [3*OriginWidth-1:0] entry;

  if (rc_pkg::Planes) begin : gen_approach
    logic [3*PointWidth-1:0] s0_o, s15_o;
    logic [3*M-1:0]          s15_new_d, s15_short_d;

    assign s0_o = state.o;

    rc_stage_delay #(.Width(3 * PointWidth), .Stages(Cosine)) u_o (
      .clk_i, .rst_ni, .enter_i(s0_light || s0_bounce),
      .leave_i(light_at[Cosine] || bounce_at[Cosine]), .data_i(s0_o), .data_o(s15_o));

    for (genvar k = 0; k < 3; k++) begin : gen_short
      assign s15_new_d[k*M +: M] = s15_d[k*RayDirBits +: M];
    end

    rc_path_register #(.Width(3 * M), .Stages(rc_pkg::PassCut)) u_short (
      .clk_i, .data_i(s15_new_d), .data_o(s15_short_d));

    rc_approach u_approach (
      .clk_i, .rst_ni, .valid_i(light_at[Stages-1:Cosine] | bounce_at[Stages-1:Cosine]),
      .s15_p_i(s15_o),
      .s15_d_i(s15_short_d), .s28_enters_o(enters), .s28_entry_o(entry));
  end else begin : gen_within
    assign enters = 1'b0;
    assign entry  = '0;
  end

  // A ray that passes by the lattice begins at the surface's point, at reduced precision. On each
  // axis the point is rounded up or down, to the side to which the ray leaves.
  logic [2:0] end_up;

  if (rc_pkg::Horizon) begin : gen_horizon
    logic [3*NormalBits-1:0] s0_n;
    logic [2:0]              s0_up;

    assign s0_n = state.n;

    for (genvar k = 0; k < 3; k++) begin : gen_up
      assign s0_up[k] = s0_n[k*NormalBits+NormalBits-1] == s0_refract;
    end

    rc_stage_delay #(.Width(3), .Stages(Out), .Parts(rc_pkg::PassParts)) u_up (
      .clk_i, .rst_ni, .enter_i(s0_bounce), .leave_i(bounce_at[Out]), .data_i(s0_up),
      .data_o(end_up));

    logic unused_n;
    assign unused_n = ^s0_n;
  end else begin : gen_no_horizon
    assign end_up = '0;
  end

  // ---- End of the sample.
  logic                   end_more;
  logic [3*SumBits-1:0]   end_sum;
  logic [3*ValueBits-1:0] end_least, end_most, end_mean;

  if (rc_pkg::Supersampling) begin : gen_samples
    logic         s4_more;
    logic [3*SumBits-1:0] s4_sum;
    logic [3*ValueBits-1:0]  s4_least, s4_most, s4_mean;

    rc_finish u_finish (
      .clk_i, .frame_i, .valid_i(end_at[Mean-1:0]), .phase_i(phase[Every +: Every]),
      .s0_state_i(state), .s0_colour_i(colour),
      .s4_more_o(s4_more), .s4_sum_o(s4_sum), .s4_least_o(s4_least), .s4_most_o(s4_most),
      .s4_colour_o(s4_mean));

    rc_stage_delay #(.Width(1 + 3 * SumBits + 9 * ValueBits), .Stages(Out - Mean),
                     .Parts(rc_pkg::PassParts))
      u_end (
      .clk_i, .rst_ni, .enter_i(end_at[Mean]), .leave_i(end_at[Out]),
      .data_i({s4_more, s4_sum, s4_least, s4_most, s4_mean}),
      .data_o({end_more, end_sum, end_least, end_most, end_mean}));
  end else begin : gen_one_sample
    assign end_more = 1'b0;
    assign {end_sum, end_least, end_most, end_mean} = '0;

    logic unused;
    assign unused = ^colour;
  end

  // ---- s28: end of the pass.
  rc_pass_end u_end (
    .clk_i, .take_i(ends[Stages-1]), .frame_i, .path_i(surf_path), .u_i(face_u), .v_i(face_v),
    .round_u_i(round_u), .round_v_i(round_v),
    .hole_i(end_hole), .cutout_i(Cut ? cutout_q[Stages-1] : cutout_at[Stages]),
    .scale_i(end_scale),
    .ray_i(end_ray), .begin_state_i(begin_state),
    .mirrors_i(mirrors),
    .transmits_i(transmits), .top_i(top), .surf_o_i(surf_o), .surf_n_i(surf_n),
    .surf_i(Cut ? surf_q[Stages-1] : surf_at[Stages]),
    .surf_normal_i(surf_normal), .surf_view_i(surf_view), .surf_cosine_i(surf_cosine),
    .surf_far_i(surf_far), .surf_lost_i(surf_lost), .surf_albedo_i(surf_albedo),
    .surf_ambient_i(surf_ambient), .background_i(end_background),
    .transform_i(Cut ? transform_q[Stages-1] : transform_at[Stages]), .transform_o_i(turned_o),
    .home_i(end_home),
    .home_o_i(end_home_o), .home_d_i(end_home_d),
    .light_near_i(light_near), .light_clear_i(light_clear), .light_place_i(light_place),
    .light_share_i(light_share), .above_i(end_above), .below_i(end_below),
    .positive_i(end_positive), .d_i(end_d), .enters_i(enters), .entry_i(entry), .up_i(end_up),
    .weight_i(bounce_weight), .total_i(bounce_total), .more_i(end_more), .sum_i(end_sum),
    .least_i(end_least), .most_i(end_most), .mean_i(end_mean),
    .ray_o(end_ray_o), .state_o(end_state_o), .changes_o, .leave_o, .spawn_o, .pixel_o, .tex_req_o,
    .push_o, .pushed_o);

  logic unused;
  assign unused = ^{hit, phase, ends, surf_at, light_at, bounce_at, end_at, face_at, tone_at,
                    sends_at, cutout_at};
endmodule
`default_nettype wire

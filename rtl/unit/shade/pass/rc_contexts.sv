// The state that shade stores for each context. It consists of the camera ray or bounce, the last
// answer, the state between two passes, and the refracted rays that wait. Part of rc_shade, which
// never has two passes of a context in flight.
//
// read_i reads all state of read_ray_i. It is ready ShadeRead cycles later, with read_valid_o. If
// that is not the same cycle, top_o is ready one cycle later.
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
  localparam int unsigned HitW        = rc_pkg::ShadeHitW,
  localparam int unsigned PlaceW      = rc_pkg::ShadePlaceW
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
  input  logic [HitW-1:0]              closest_hit_i,
  // The instance that was hit: its line, a, b. With textures also the texel scale: of this
  // instance, or of the instance of a cut-out in the way to a light
  input  logic                         place_fires_i,
  input  logic                         scale_fires_i,
  input  logic [RayBits-1:0]           place_ray_i,
  input  logic [PlaceW-1:0]            place_i,
  // With textures: whether a texture has a hole, and its colour
  input  logic                         texel_fires_i,
  input  logic [RayBits-1:0]           texel_ray_i,
  input  logic [3*rc_pkg::ColourBits:0] texel_i,
  // To rc_pass
  input  logic                         read_i,
  input  logic [RayBits-1:0]           read_ray_i,
  output logic                         read_valid_o,
  output logic [HitW-1:0]              hit_o,
  output logic [3*OriginWidth-1:0]     o_o,
  output logic [3*M-1:0]               d_o,
  output rc_pkg::shade_state_t         state_o,
  output logic [rc_pkg::WaitingW-1:0]  top_o,
  output logic [PlaceW-1:0]            place_o,
  output logic [3*rc_pkg::ColourBits:0] texel_o,
  // From rc_pass: a pass has begun with a surface that has this material
  input  logic                         material_valid_i,
  input  logic [RayBits-1:0]           material_ray_i,
  input  logic [rc_pkg::MaterialW-1:0] material_i,
  // From rc_pass: a pass has ended. It has changed these groups, and the group that every pass
  // changes
  input  logic                         write_i,
  input  logic [RayBits-1:0]           write_ray_i,
  input  logic [4:0]                   changes_i,      // point, inner, face, albedo, share
  input  rc_pkg::shade_state_t         write_state_i,
  input  logic                         push_i,
  input  logic [rc_pkg::WaitingW-1:0]  pushed_i
);

  // ---- Reads and writes. A fast chip whose passes are rare has registers in front of the
  // memories' ports. The data of a pass stays stable for that time.
  localparam int unsigned Parts = rc_pkg::PassParts;

  logic               reads;
  logic [RayBits-1:0] reads_ray;

  rc_path_register #(.Width(RayBits), .Stages(rc_pkg::PassCut)) u_reads_ray (
    .clk_i, .data_i(read_ray_i), .data_o(reads_ray));

  rc_pulse_register #(.Stages(rc_pkg::PassCut)) u_reads (
    .clk_i, .rst_ni, .fires_i(read_i), .fires_o(reads));

  rc_pulse_register #(.Stages(rc_pkg::PassReadCycles)) u_there (
    .clk_i, .rst_ni, .fires_i(read_i), .fires_o(read_valid_o));

  logic                         material_valid, writes;
  logic [RayBits-1:0]           material_ray;
  logic [rc_pkg::MaterialW-1:0] material;

  rc_path_register #(.Width(RayBits + rc_pkg::MaterialW), .Stages(rc_pkg::PassCut)) u_material (
    .clk_i, .data_i({material_ray_i, material_i}), .data_o({material_ray, material}));

  rc_pulse_register #(.Stages(rc_pkg::PassCut)) u_material_valid (
    .clk_i, .rst_ni, .fires_i(material_valid_i), .fires_o(material_valid));

  rc_pulse_register #(.Stages(rc_pkg::PassCut)) u_writes (
    .clk_i, .rst_ni, .fires_i(write_i), .fires_o(writes));

  // ---- Rays, except shadow rays and rays away to a light.
  logic [rc_pkg::RayW-1:0] ray;
  logic [3*RayDirBits-1:0] ray_d;
  logic [3*M-1:0]          d;
  logic                    is_kept;

  assign ray     = ray_i;
  assign ray_d   = ray_i.d;
  assign is_kept = kind_o == rc_pkg::RayCamera || kind_o == rc_pkg::RayBounce;

  if (rc_pkg::Shading) begin : gen_kind
    assign kind_o = ray_i.kind;
  end else begin : gen_camera   // never built, but tools read it
    assign kind_o = rc_pkg::RayCamera;
  end

  for (genvar k = 0; k < 3; k++) begin : gen_axis
    assign d[k*M +: M] = ray_d[k*RayDirBits +: M];
  end

  rc_context_ram #(.Width(3 * OriginWidth + 3 * M), .Depth(Contexts)) u_ray (
    .clk_i, .rst_ni, .write_i(ray_fires_i && is_kept), .write_addr_i(ray_i.ray),
    .write_data_i({ray_i.o, d}), .read_i(reads), .read_addr_i(reads_ray),
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
    .write_data_i(answer), .read_i(reads), .read_addr_i(reads_ray), .read_data_o(hit_o));

  // ---- The instance that was hit last.
  localparam int unsigned MapW = PlaceW - (rc_pkg::HasTextures ? rc_pkg::LevelBits : 0);

  rc_pkg::shade_place_t place_came, place_read;
  logic [MapW-1:0]      map_came, map_read;

  assign place_came = place_i;
  assign place_o    = place_read;
  assign map_came   = {place_came.here, place_came.a, place_came.b};

  if (rc_pkg::HasHomes) begin : gen_place
    rc_context_ram #(.Width(MapW), .Depth(Contexts)) u_place (
      .clk_i, .rst_ni, .write_i(place_fires_i), .write_addr_i(place_ray_i), .write_data_i(map_came),
      .read_i(reads), .read_addr_i(reads_ray), .read_data_o(map_read));
  end else begin : gen_no_place
    assign map_read = '0;

    logic unused;
    assign unused = ^{place_fires_i, place_ray_i, map_came};
  end

  assign {place_read.here, place_read.a, place_read.b} = map_read;

  if (rc_pkg::HasHomes && rc_pkg::HasTextures) begin : gen_texel_scale
    logic [rc_pkg::LevelBits-1:0] scale_came, scale_read;

    assign scale_came             = place_came.texel_scale;
    assign place_read.texel_scale = scale_read;

    rc_context_ram #(.Width(rc_pkg::LevelBits), .Depth(Contexts)) u_scale (
      .clk_i, .rst_ni, .write_i(scale_fires_i), .write_addr_i(place_ray_i),
      .write_data_i(scale_came), .read_i(reads), .read_addr_i(reads_ray),
      .read_data_o(scale_read));
  end else if (rc_pkg::HasTextures) begin : gen_one_scale
    assign place_read.texel_scale = '0;

    logic unused;
    assign unused = ^{scale_fires_i, place_came};
  end else begin : gen_no_texel_scale
    logic unused;
    assign unused = scale_fires_i;
  end

  // ---- State, in the groups of model/unit/shade/state.hpp.
  localparam int unsigned PixelW  = rc_pkg::ShadePixelW;
  localparam int unsigned EveryW  = rc_pkg::ShadeEveryW;
  localparam int unsigned PointW  = rc_pkg::ShadePointW;
  localparam int unsigned InnerW  = rc_pkg::HasHomes ? 3 * OriginWidth : 0;
  localparam int unsigned FaceW   = rc_pkg::ShadeFaceW;
  localparam int unsigned ShareW  = rc_pkg::ShadeShareW;
  localparam int unsigned SampleW = rc_pkg::ShadeSamplesW;
  localparam int unsigned WaitsW  = rc_pkg::ShadeWaitsW;
  localparam int unsigned LookW   = rc_pkg::ShadeLookW;   // of all materials
  localparam int unsigned BendW   = rc_pkg::ShadeBendW;
  localparam int unsigned SelfW   = rc_pkg::ShadeSelfW;
  localparam int unsigned PlaceAt = FaceW + ShareW + SampleW + WaitsW + rc_pkg::MaterialW;

  logic [PixelW-1:0]  pixel, new_pixel;
  logic [EveryW-1:0]  every, new_every;
  logic [PointW-1:0]  point, new_point;
  logic [FaceW-1:0]   face, new_face;
  logic [ShareW-1:0]  share, new_share;
  logic [SampleW-1:0] sample, new_sample;
  logic [WaitsW-1:0]  waits, new_waits;
  logic [LookW-1:0]   look, new_look;
  logic [BendW-1:0]   bend, new_bend;
  logic [SelfW-1:0]   self, new_self;
  logic [rc_pkg::ShadeStateW-1:0] new_state, kept_state;
  logic [rc_pkg::MaterialW-1:0]   end_look;   // was written when the pass began
  logic                           writes_point, writes_inner, writes_face, writes_share;
  logic                           writes_albedo;

  assign {writes_point, writes_inner, writes_face, writes_albedo, writes_share} =
      changes_i & {5{writes}};

  assign new_state = write_state_i;
  assign {new_face, new_share, new_sample, new_waits, end_look} = new_state[PlaceAt-1:0];
  assign {new_pixel, new_every, new_point} = new_state[rc_pkg::ShadeStateW-1:PlaceAt+InnerW];
  assign {new_look, new_bend, new_self}    = material;

  // Begin of a pixel. A fast chip writes it one cycle later; the pixel's passes come much later.
  logic               begins;
  logic [RayBits-1:0] begins_ray;
  logic [PixelW-1:0]  begins_pixel;

  rc_path_register #(.Width(RayBits + PixelW)) u_begins (
    .clk_i, .data_i({slot_i.ray, slot_i.x, slot_i.y}), .data_o({begins_ray, begins_pixel}));

  rc_pulse_register u_pixel_begins (.clk_i, .rst_ni, .fires_i(slot_fires_i), .fires_o(begins));

  rc_context_ram #(.Width(PixelW), .Depth(Contexts)) u_pixel (
    .clk_i, .rst_ni, .write_i(begins), .write_addr_i(begins_ray), .write_data_i(begins_pixel),
    .read_i(reads), .read_addr_i(reads_ray), .read_data_o(pixel));

  // Memories of the groups.
  if (rc_pkg::Refraction) begin : gen_bend
    rc_context_ram #(.Width(EveryW + WaitsW), .Depth(Contexts), .Parts(Parts)) u_every (
      .clk_i, .rst_ni, .write_i(writes), .write_addr_i(write_ray_i),
      .write_data_i({new_every, new_waits}), .read_i(reads), .read_addr_i(reads_ray),
      .read_data_o({every, waits}));

    rc_context_ram #(.Width(LookW + BendW), .Depth(Contexts), .Parts(Parts)) u_look (
      .clk_i, .rst_ni, .write_i(material_valid), .write_addr_i(material_ray),
      .write_data_i({new_look, new_bend}), .read_i(reads), .read_addr_i(reads_ray),
      .read_data_o({look, bend}));
  end else begin : gen_no_bend
    rc_context_ram #(.Width(EveryW), .Depth(Contexts), .Parts(Parts)) u_every (
      .clk_i, .rst_ni, .write_i(writes), .write_addr_i(write_ray_i), .write_data_i(new_every),
      .read_i(reads), .read_addr_i(reads_ray), .read_data_o(every));

    rc_context_ram #(.Width(LookW), .Depth(Contexts), .Parts(Parts)) u_look (
      .clk_i, .rst_ni, .write_i(material_valid), .write_addr_i(material_ray),
      .write_data_i(new_look),
      .read_i(reads), .read_addr_i(reads_ray), .read_data_o(look));

    assign waits = '0;
    assign bend  = '0;
  end

  rc_context_ram #(.Width(PointW), .Depth(Contexts), .Parts(Parts)) u_point (
    .clk_i, .rst_ni, .write_i(writes_point), .write_addr_i(write_ray_i), .write_data_i(new_point),
    .read_i(reads), .read_addr_i(reads_ray), .read_data_o(point));

  // A texture changes the albedo, in the lowest bits of the face.
  if (rc_pkg::HasTextures) begin : gen_albedo
    localparam int unsigned AlbedoW = 3 * rc_pkg::ColourBits;

    rc_context_ram #(.Width(FaceW - AlbedoW), .Depth(Contexts), .Parts(Parts)) u_face (
      .clk_i, .rst_ni, .write_i(writes_face), .write_addr_i(write_ray_i),
      .write_data_i(new_face[FaceW-1:AlbedoW]), .read_i(reads), .read_addr_i(reads_ray),
      .read_data_o(face[FaceW-1:AlbedoW]));

    rc_context_ram #(.Width(AlbedoW), .Depth(Contexts), .Parts(Parts)) u_albedo (
      .clk_i, .rst_ni, .write_i(writes_albedo), .write_addr_i(write_ray_i),
      .write_data_i(new_face[AlbedoW-1:0]), .read_i(reads), .read_addr_i(reads_ray),
      .read_data_o(face[AlbedoW-1:0]));

    rc_context_ram #(.Width(AlbedoW + 1), .Depth(Contexts)) u_texel (
      .clk_i, .rst_ni, .write_i(texel_fires_i), .write_addr_i(texel_ray_i),
      .write_data_i(texel_i), .read_i(reads), .read_addr_i(reads_ray), .read_data_o(texel_o));
  end else begin : gen_no_albedo
    rc_context_ram #(.Width(FaceW), .Depth(Contexts), .Parts(Parts)) u_face (
      .clk_i, .rst_ni, .write_i(writes_face), .write_addr_i(write_ray_i), .write_data_i(new_face),
      .read_i(reads), .read_addr_i(reads_ray), .read_data_o(face));

    assign texel_o = '0;

    logic unused;
    assign unused = ^{writes_albedo, texel_fires_i, texel_ray_i, texel_i};
  end

  rc_context_ram #(.Width(ShareW), .Depth(Contexts), .Parts(Parts)) u_share (
    .clk_i, .rst_ni, .write_i(writes_share), .write_addr_i(write_ray_i), .write_data_i(new_share),
    .read_i(reads), .read_addr_i(reads_ray), .read_data_o(share));

  if (rc_pkg::Supersampling) begin : gen_sample
    rc_context_ram #(.Width(SampleW), .Depth(Contexts), .Parts(Parts)) u_sample (
      .clk_i, .rst_ni, .write_i(writes), .write_addr_i(write_ray_i), .write_data_i(new_sample),
      .read_i(reads), .read_addr_i(reads_ray), .read_data_o(sample));
  end else begin : gen_no_sample
    assign sample = '0;
  end

  if (rc_pkg::Spheres) begin : gen_self
    rc_context_ram #(.Width(SelfW), .Depth(Contexts), .Parts(Parts)) u_self (
      .clk_i, .rst_ni, .write_i(material_valid), .write_addr_i(material_ray),
      .write_data_i(new_self),
      .read_i(reads), .read_addr_i(reads_ray), .read_data_o(self));
  end else begin : gen_no_self
    assign self = '0;
  end

  assign kept_state[PlaceAt-1:0] = {face, share, sample, waits, look, bend, self};

  if (rc_pkg::HasHomes) begin : gen_inner
    logic [InnerW-1:0] inner;

    rc_context_ram #(.Width(InnerW), .Depth(Contexts), .Parts(Parts)) u_inner (
      .clk_i, .rst_ni, .write_i(writes_inner), .write_addr_i(write_ray_i),
      .write_data_i(new_state[PlaceAt +: InnerW]), .read_i(reads), .read_addr_i(reads_ray),
      .read_data_o(inner));

    assign kept_state[rc_pkg::ShadeStateW-1:PlaceAt] = {pixel, every, point, inner};
  end else begin : gen_no_inner
    assign kept_state[rc_pkg::ShadeStateW-1:PlaceAt] = {pixel, every, point};

    logic unused;
    assign unused = writes_inner;
  end

  // State of a context that has just begun: a camera ray of full weight.
  logic [Contexts-1:0] all_fresh;
  logic                fresh;

  if (rc_pkg::ShadeInterval == 1) begin : gen_now
    assign fresh = all_fresh[reads_ray];
  end else begin : gen_next
    logic read_fresh_q;
    always_ff @(posedge clk_i) if (reads) read_fresh_q <= all_fresh[reads_ray];
    assign fresh = read_fresh_q;
  end

  rc_pkg::shade_state_t state, begun;

  assign state = kept_state;

  always_comb begin
    begun = state;
    if (fresh) begin
      begun.next_event = rc_pkg::EventArrive;
      begun.pending    = rc_pkg::PendingNone;
      begun.colour     = '0;
      begun.weight     = rc_pkg::ValueOne;
      begun.depth      = '0;
      begun.waiting    = '0;
      begun.sample     = '0;
      begun.sum        = '0;
      begun.least      = {3{rc_pkg::ValueOne}};
      begun.most       = '0;
    end
  end

  rc_pkg::shade_state_t begun_path;

  if (rc_pkg::HasTextures) begin : gen_path
    always_comb begin
      begun_path = begun;
      if (fresh) begun_path.path  = '0;
      if (fresh) begun_path.holes = '0;
    end
  end else begin : gen_no_path
    assign begun_path = begun;
  end

  if (rc_pkg::Panes != 0) begin : gen_panes
    always_comb begin
      state_o = begun_path;
      if (fresh) state_o.in_cell = '0;
    end
  end else begin : gen_no_panes
    assign state_o = begun_path;
  end

  rc_flags #(.Flags(Contexts)) u_fresh (
    .clk_i, .rst_ni, .clear_i(write_i), .clear_at_i(write_ray_i),
    .set_i(begins), .set_at_i(begins_ray), .flags_o(all_fresh));

  // ---- Stack of waiting rays.
  logic [3:0] top_at, new_top_at;

  assign new_top_at = write_state_i.waiting - 4'd1;

  if (rc_pkg::Refraction) begin : gen_stack
    localparam int unsigned Up    = $clog2(rc_pkg::Bounces);
    localparam int unsigned AddrW = RayBits + Up;
    logic [RayBits-1:0] top_ray;   // with ShadeInterval above 1: one cycle after the state

    if (rc_pkg::ShadeInterval == 1) begin : gen_top_now
      assign top_ray = reads_ray;
    end else begin : gen_top_next
      logic [RayBits-1:0] top_ray_q;

      assign top_ray = top_ray_q;
      always_ff @(posedge clk_i) if (reads) top_ray_q <= reads_ray;
    end

    logic [AddrW-1:0] write_at, read_at;

    assign top_at   = state.waiting - 4'd1;
    assign write_at = AddrW'(write_ray_i) << Up | AddrW'(new_top_at);
    assign read_at  = AddrW'(top_ray) << Up | (AddrW'(top_at) & AddrW'((1 << Up) - 1));

    rc_context_ram #(.Width(rc_pkg::WaitingW), .Depth(1 << AddrW)) u_stack (
      .clk_i, .rst_ni, .write_i(write_i && push_i), .write_addr_i(write_at),
      .write_data_i(pushed_i), .read_i(read_valid_o), .read_addr_i(read_at), .read_data_o(top_o));
  end else begin : gen_no_stack
    assign top_o  = '0;
    assign top_at = '0;

    logic unused;
    assign unused = ^{push_i, pushed_i, top_at, new_top_at};
  end

  logic unused;
  assign unused = ^{ray, ray_d, slot_i, new_pixel, new_sample, new_waits, new_bend, new_self,
                    end_look};
endmodule
`default_nettype wire

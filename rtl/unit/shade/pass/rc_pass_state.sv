// Delays a context's state from the start of a pass to its end. Fields that a pass does not change,
// or makes anew, are left out. Of the surface that was hit, the end needs its point, and whether it
// mirrors and transmits. Part of rc_pass; all other fields of begin_state_o are 0.
`default_nettype none
module rc_pass_state #(
  localparam int unsigned RayBits   = rc_pkg::RayBits,
  localparam int unsigned PrimBits  = rc_pkg::PrimBits,
  localparam int unsigned DepthBits = rc_pkg::DepthBits
) (
  input  logic                 clk_i,
  input  logic                 rst_ni,
  input  logic                 enter_i,       // as in rc_stage_delay
  input  logic                 leave_i,
  // Start of the pass
  input  logic [RayBits-1:0]   ray_i,
  input  rc_pkg::shade_state_t s0_state_i,
  // End of the pass
  output logic [RayBits-1:0]   ray_o,
  output rc_pkg::shade_state_t begin_state_o,
  output logic                 mirrors_o,
  output logic                 transmits_o
);
  localparam int unsigned Stages = rc_pkg::ShadeStages;
  localparam int unsigned PixelW = rc_pkg::ShadePixelW;
  localparam int unsigned EveryW = rc_pkg::ShadeEveryW;
  localparam int unsigned PointW = 3 * rc_pkg::PointWidth;

  rc_pkg::shade_groups_t  s0_groups, groups;
  rc_pkg::shade_samples_t s0_samples, samples;
  rc_pkg::shade_state_t   common;   // the state, without the fields for textures
  logic [PixelW-1:0]      pixel;
  logic [EveryW-1:0]      every;
  logic [PointW-1:0]      o;
  logic                   is_far, is_lost, total, is_inside;
  logic [DepthBits-1:0]   waiting;
  logic [PrimBits-1:0]    self;

  assign s0_groups         = s0_state_i;
  assign s0_samples.sample = s0_state_i.sample;
  assign s0_samples.sum    = s0_state_i.sum;
  assign s0_samples.least  = s0_state_i.least;
  assign s0_samples.most   = s0_state_i.most;

  rc_stage_delay #(.Width(RayBits + PixelW + EveryW + PointW + 6 + DepthBits + PrimBits),
                   .Stages(Stages), .Parts(rc_pkg::PassParts))
  u_all (
    .clk_i, .rst_ni, .enter_i, .leave_i,
    .data_i({ray_i, s0_groups.pixel, s0_groups.every, s0_state_i.o, s0_state_i.is_far,
             s0_state_i.is_lost, s0_state_i.mirror != '0, s0_state_i.transmit != '0,
             s0_state_i.total, s0_state_i.is_inside, s0_state_i.waiting, s0_state_i.self}),
    .data_o({ray_o, pixel, every, o, is_far, is_lost, mirrors_o, transmits_o, total, is_inside,
             waiting, self}));

  if (rc_pkg::Supersampling) begin : gen_samples
    rc_stage_delay #(
      .Width(rc_pkg::ShadeSamplesW), .Stages(Stages), .Parts(rc_pkg::PassParts)) u_samples (
      .clk_i, .rst_ni, .enter_i, .leave_i, .data_i(s0_samples), .data_o(samples));
  end else begin : gen_one
    assign samples = '0;
  end

  always_comb begin
    groups       = '0;
    groups.pixel = pixel;
    groups.every = every;
  end

  always_comb begin
    common           = groups;
    common.o         = o;
    common.is_far    = is_far;
    common.is_lost   = is_lost;
    common.total     = total;
    common.is_inside = is_inside;
    common.waiting   = waiting;
    common.self      = self;
    common.sample    = samples.sample;
    common.sum       = samples.sum;
    common.least     = samples.least;
    common.most      = samples.most;
  end

  rc_pkg::shade_state_t with_texture;

  // With textures: the texture's record, and the old cosine for an instance without a map.
  if (rc_pkg::HasTextures) begin : gen_texture
    localparam int unsigned CosineW = rc_pkg::HasHomes ? rc_pkg::ValueBits : 1;
    logic [rc_pkg::AddrBits-1:0] record;
    logic [CosineW-1:0]          cosine;
    logic [rc_pkg::ValueBits-1:0] s0_cosine;

    assign s0_cosine = s0_state_i.cosine;

    rc_stage_delay #(.Width(rc_pkg::AddrBits + CosineW), .Stages(Stages),
                     .Parts(rc_pkg::PassParts)) u_texture (
      .clk_i, .rst_ni, .enter_i, .leave_i, .data_i({s0_state_i.record, s0_cosine[CosineW-1:0]}),
      .data_o({record, cosine}));

    always_comb begin
      with_texture        = common;
      with_texture.record = record;
      with_texture.cosine = rc_pkg::ValueBits'(cosine);
    end

    logic unused;
    assign unused = ^s0_cosine;
  end else begin : gen_no_texture
    assign with_texture = common;
  end

  // With textures and spheres: whether the surface is a sphere.
  if (rc_pkg::HasTextures && rc_pkg::Spheres) begin : gen_round
    logic is_round;

    rc_stage_delay #(.Width(1), .Stages(Stages), .Parts(rc_pkg::PassParts)) u_round (
      .clk_i, .rst_ni, .enter_i, .leave_i, .data_i(s0_state_i.is_round), .data_o(is_round));

    always_comb begin
      begin_state_o          = with_texture;
      begin_state_o.is_round = is_round;
    end
  end else begin : gen_not_round
    assign begin_state_o = with_texture;
  end

  logic unused;
  assign unused = ^{s0_groups, s0_samples};
endmodule
`default_nettype wire

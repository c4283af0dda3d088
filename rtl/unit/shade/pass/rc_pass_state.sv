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
  input  rc_pkg::shade_state_t known_i,
  // End of the pass
  output logic [RayBits-1:0]   ray_o,
  output rc_pkg::shade_state_t begin_state_o,
  output logic                 mirrors_o,
  output logic                 transmits_o
);
  localparam int unsigned Stages = rc_pkg::ShadeStages;
  localparam int unsigned StateW = rc_pkg::ShadeStateW;
  localparam int unsigned FrontW = rc_pkg::ShadePixelW + rc_pkg::ShadeEveryW
                                 + 3 * rc_pkg::PointWidth;   // from x to o

  logic [StateW-1:0] known;
  logic [FrontW-1:0] front;
  rc_pkg::shade_samples_t known_many, many;
  rc_pkg::shade_state_t   kept;
  logic                     is_far, is_lost, total, is_inside;
  logic [DepthBits-1:0]     waiting;
  logic [PrimBits-1:0]      self;

  assign known             = known_i;
  assign known_many.sample = known_i.sample;
  assign known_many.sum    = known_i.sum;
  assign known_many.least  = known_i.least;
  assign known_many.most   = known_i.most;

  rc_stage_delay #(.Width(RayBits + FrontW + 6 + DepthBits + PrimBits), .Stages(Stages),
    .Parts(rc_pkg::PassParts)) u_all (
    .clk_i, .rst_ni, .enter_i, .leave_i,
    .data_i({ray_i, known[StateW-1 -: FrontW], known_i.is_far, known_i.is_lost,
             known_i.mirror != '0, known_i.transmit != '0, known_i.total, known_i.is_inside,
             known_i.waiting, known_i.self}),
    .data_o({ray_o, front, is_far, is_lost, mirrors_o, transmits_o, total, is_inside, waiting,
             self}));

  if (rc_pkg::Supersampling) begin : gen_many
    rc_stage_delay #(
      .Width(rc_pkg::ShadeSamplesW), .Stages(Stages), .Parts(rc_pkg::PassParts)) u_many (
      .clk_i, .rst_ni, .enter_i, .leave_i, .data_i(known_many), .data_o(many));
  end else begin : gen_one
    assign many = '0;
  end

  always_comb begin
    kept   = {front, {(StateW-FrontW){1'b0}}};
    kept.is_far = is_far;
    kept.is_lost = is_lost;
    kept.total = total;
    kept.is_inside = is_inside;
    kept.waiting = waiting;
    kept.self = self;
    kept.sample = many.sample;
    kept.sum = many.sum;
    kept.least = many.least;
    kept.most = many.most;
  end
  rc_pkg::shade_state_t with_texture;

  // With textures: the texture's record, and the old cosine for an instance without a map.
  if (rc_pkg::HasTextures) begin : gen_texture
    localparam int unsigned CosineW = rc_pkg::HasHomes ? rc_pkg::ValueBits : 1;
    logic [rc_pkg::AddrBits-1:0] record;
    logic [CosineW-1:0]          cosine;
    logic [rc_pkg::ValueBits-1:0] known_cosine;

    assign known_cosine = known_i.cosine;

    rc_stage_delay #(.Width(rc_pkg::AddrBits + CosineW), .Stages(Stages),
                     .Parts(rc_pkg::PassParts)) u_texture (
      .clk_i, .rst_ni, .enter_i, .leave_i, .data_i({known_i.record, known_cosine[CosineW-1:0]}),
      .data_o({record, cosine}));

    always_comb begin
      with_texture        = kept;
      with_texture.record = record;
      with_texture.cosine = rc_pkg::ValueBits'(cosine);
    end

    logic unused;
    assign unused = ^known_cosine;
  end else begin : gen_no_texture
    assign with_texture = kept;
  end

  // With textures and spheres: whether the surface is a sphere.
  if (rc_pkg::HasTextures && rc_pkg::Spheres) begin : gen_round
    logic is_round;

    rc_stage_delay #(.Width(1), .Stages(Stages), .Parts(rc_pkg::PassParts)) u_round (
      .clk_i, .rst_ni, .enter_i, .leave_i, .data_i(known_i.is_round), .data_o(is_round));

    always_comb begin
      begin_state_o          = with_texture;
      begin_state_o.is_round = is_round;
    end
  end else begin : gen_not_round
    assign begin_state_o = with_texture;
  end

  logic unused;
  assign unused = ^{known, known_many};
endmodule
`default_nettype wire

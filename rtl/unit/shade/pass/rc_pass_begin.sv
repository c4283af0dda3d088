// The start of a pass: its event, and the context's state after it. Part of rc_pass; combinational.
// Model: pass() in model/unit/shade/pass/pass.cpp.
`default_nettype none
module rc_pass_begin #(
  localparam int unsigned ValueBits = rc_pkg::ValueBits,
  localparam int unsigned PrimBits  = rc_pkg::PrimBits,
  localparam int unsigned TBits     = rc_pkg::TBits,
  localparam int unsigned UvBits    = rc_pkg::UvBits
) (
  // Context, and the last ray's answer
  input  logic                   valid_i,
  input  logic                   cutout_i,   // a shadow ray has met a cut-out: no event
  input  rc_pkg::shade_state_t   state_i,
  input  rc_pkg::shade_hit_t     hit_i,
  input  rc_pkg::surface_t       surface_i,
  // Event
  output logic                   surf_o,     // a camera ray or bounce has hit a surface
  output logic                   light_o,
  output logic                   bounce_o,
  output logic                   refract_o,  // refracted, not reflected
  // a result of a mesh's space is transformed to the scene's
  output logic                   transform_o,
  output logic                   texture_o,  // the colour of the surface's texture has arrived
  output logic                   end_o,      // a waiting ray, or the end of the sample
  // State
  output logic [3*ValueBits-1:0] colour_o,   // including what was pending
  output logic                   has_material_o,   // a surface has been hit, even without valid_i:
  output rc_pkg::material_t      material_o,   // its material
  output rc_pkg::shade_state_t   begin_state_o
);

  // Event.
  logic                arrives, found, back;   // arrives: a camera ray or bounce is done
  logic                first;                  // the ray has passed no hole
  logic                handles;                // the pass handles an event
  logic [PrimBits-1:0] prim;
  logic [TBits-1:0]    t;
  logic [UvBits-1:0]   u, v;

  assign found = hit_i.found;
  assign back  = hit_i.back;
  assign prim  = hit_i.prim;
  assign t     = hit_i.t;
  assign u     = hit_i.u;
  assign v     = hit_i.v;

  if (rc_pkg::HasTextures) begin : gen_first
    assign first = state_i.holes == '0;
  end else begin : gen_always_first
    assign first = 1'b1;
  end

  assign arrives        = state_i.next_event == rc_pkg::EventArrive;
  assign has_material_o = arrives && found;
  assign handles        = valid_i && !cutout_i;
  assign surf_o         = valid_i && has_material_o;
  assign light_o        = handles && state_i.next_event == rc_pkg::EventLight;
  assign refract_o      = rc_pkg::Refraction && state_i.next_event == rc_pkg::EventRefract;
  assign bounce_o       = handles && (refract_o || state_i.next_event == rc_pkg::EventReflect);
  assign transform_o    = valid_i && rc_pkg::HasHomes
      && state_i.next_event == rc_pkg::EventTransform;
  assign texture_o      = valid_i && rc_pkg::HasTextures
      && state_i.next_event == rc_pkg::EventTexture;
  assign end_o          = handles && state_i.next_event == rc_pkg::EventPop;

  // The light's share counts if nothing was in its way.
  logic        adds;
  logic [3*ValueBits-1:0] old_colour, old_share;

  assign adds       = state_i.pending == rc_pkg::PendingSure
                   || (state_i.pending == rc_pkg::PendingAnswer && !found);
  assign old_colour = state_i.colour;
  assign old_share  = state_i.share;

  for (genvar k = 0; k < 3; k++) begin : gen_channel
    rc_add_saturated u_sum (
      .a_i(old_colour[k*ValueBits +: ValueBits]),
      .b_i(adds ? old_share[k*ValueBits +: ValueBits] : '0),
      .sum_o(colour_o[k*ValueBits +: ValueBits]));
  end

  // The state.
  rc_pkg::shade_state_t common, textured, shaped;   // each with more of the optional fields

  always_comb begin
    common         = state_i;
    common.colour  = colour_o;
    common.pending = rc_pkg::PendingNone;
    if (arrives && first && state_i.depth == '0 && state_i.sample == '0) begin
      common.found = found;
      common.prim  = prim;
      common.t     = t;
      common.u     = u;
      common.v     = v;
    end
    if (has_material_o) begin
      common.diffuse   = surface_i.diffuse;
      common.highlight = surface_i.highlight;
      common.mirror    = surface_i.mirror;
      common.shine     = surface_i.shine;
      common.transmit  = surface_i.transmit;
      common.ratio     = back ? surface_i.leave : surface_i.enter;
      common.schlick   = surface_i.schlick;
      common.r0        = surface_i.r0;
      common.self      = prim;
      common.is_inside = back;
    end
  end

  if (rc_pkg::Panes != 0) begin : gen_panes   // the far side of a pane is another cell
    logic [rc_pkg::Panes-1:0] pane;
    logic [9*rc_pkg::CornerBits-1:0] normal;
    assign normal = surface_i.normal;
    assign pane   = surface_i.kind == rc_pkg::PrimPlane
                  ? normal[4*rc_pkg::CornerBits +: rc_pkg::Panes] : '0;

    always_comb begin
      begin_state_o = shaped;
      if (has_material_o) begin_state_o.across = state_i.in_cell ^ pane;
    end

    logic unused_normal;
    assign unused_normal = ^normal;
  end else begin : gen_no_panes
    assign begin_state_o = shaped;
  end

  if (rc_pkg::HasTextures) begin : gen_texture
    always_comb begin
      textured = common;
      if (has_material_o) begin
        textured.ambient = surface_i.ambient;
        textured.record  = surface_i.record;
      end
      if (cutout_i) textured.record = surface_i.record;
    end

    assign material_o.ambient = textured.ambient;
    assign material_o.record  = textured.record;
  end else begin : gen_no_texture
    assign textured = common;
  end

  if (rc_pkg::HasTextures && rc_pkg::Spheres) begin : gen_round
    always_comb begin
      shaped = textured;
      if (has_material_o) shaped.is_round = surface_i.kind == rc_pkg::PrimSphere;
    end

    assign material_o.is_round = shaped.is_round;
  end else begin : gen_not_round
    assign shaped = textured;
  end

  assign material_o.diffuse   = common.diffuse;
  assign material_o.highlight = common.highlight;
  assign material_o.mirror    = common.mirror;
  assign material_o.shine     = common.shine;
  assign material_o.transmit  = common.transmit;
  assign material_o.ratio     = common.ratio;
  assign material_o.schlick   = common.schlick;
  assign material_o.r0        = common.r0;
  assign material_o.self      = common.self;
  assign material_o.is_inside = common.is_inside;

  logic unused;
  assign unused = ^{surface_i, hit_i};
endmodule
`default_nettype wire

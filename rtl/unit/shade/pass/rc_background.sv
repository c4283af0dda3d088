// The background's contribution to a pixel: its colour times the weight of a ray that met nothing,
// or of a bounce that is not traced. Part of rc_pass, which uses it in its last stage. Model:
// see_background() in model/unit/shade/pass/pass.cpp.
`default_nettype none
module rc_background #(
  localparam int unsigned ValueBits = rc_pkg::ValueBits,
  localparam int unsigned UnitBits  = rc_pkg::UnitBits,
  localparam int unsigned Every     = rc_pkg::ShadeInterval
) (
  input  logic                   clk_i,
  input  logic                   rst_ni,
  input  logic                   begins_i,      // a pass leaves s0
  input  logic [ValueBits-1:0]   s0_weight_i,   // of the ray
  input  logic                   s9_ends_i,     // a pass leaves s9
  input  logic [Every-1:0]       s9_phase_i,    // the cycle of s9
  input  logic                   s9_bounce_i,   // the pass is for a bounce,
  input  logic [ValueBits-1:0]   s9_weight_i,   // which has this weight
  input  logic [3*ValueBits-1:0] colour_i,
  input  logic                   s10_ends_i,
  input  logic                   end_i,         // the end of the pass is accepted
  output logic [3*ValueBits-1:0] end_colour_o
);

  logic [3*ValueBits-1:0]   s10_colour;
  logic [ValueBits-1:0]     s9_ray_weight, s9_share;
  logic [3*2*ValueBits-1:0] s9_product;

  rc_stage_delay #(.Width(ValueBits), .Stages(9)) u_ray_weight (
    .clk_i, .rst_ni, .enter_i(begins_i), .leave_i(s9_ends_i), .data_i(s0_weight_i),
    .data_o(s9_ray_weight));

  assign s9_share = s9_bounce_i ? s9_weight_i : s9_ray_weight;

  rc_mul_held #(.AW(ValueBits), .BW(ValueBits), .Signed(1'b0), .Products(3)) u_product (
    .clk_i, .phase_i(s9_phase_i), .a_i({3{s9_share}}), .b_i(colour_i), .p_o(s9_product));

  // Product, rounded to U1.16.
  for (genvar k = 0; k < 3; k++) begin : gen_channel
    logic [2*ValueBits-1:0] s10_product_q, rounded;

    always_ff @(posedge clk_i)
      if (s9_ends_i) s10_product_q <= s9_product[k*2*ValueBits +: 2*ValueBits];

    assign rounded = s10_product_q + rc_pkg::ProductHalf;
    assign s10_colour[k*ValueBits +: ValueBits] = rounded[UnitBits +: ValueBits];

    logic unused;
    assign unused = ^{rounded[2*ValueBits-1], rounded[UnitBits-1:0]};
  end

  rc_stage_delay #(.Width(3 * ValueBits), .Stages(rc_pkg::PassOutStage - 10),
                   .Parts(rc_pkg::PassParts))
    u_colour (
    .clk_i, .rst_ni, .enter_i(s10_ends_i), .leave_i(end_i), .data_i(s10_colour),
    .data_o(end_colour_o));
endmodule
`default_nettype wire

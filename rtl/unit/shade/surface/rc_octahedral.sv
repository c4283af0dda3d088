// The place of a sphere's unit normal in an octahedral picture, with BaryBits fraction bits. Let n
// be the normal that points outwards, h = 2^(BaryBits-1), and L = |n_x| + |n_y| + |n_z| + 1.
//
//   p = floor(h |n_x| / L), q = floor(h |n_z| / L); if n_y < 0, p and q become h - q and h - p
//   u = h + p, or h - p if n_x < 0; v = h + q, or h - q if n_z < 0
//
// The 1 in L keeps both quotients below h. Part of rc_pass, which has the valid bits. From s14 on,
// two dividers run in parallel with the pass. The place is in the output registers Steps + 1 cycles
// after s14 begins. Exists only in a chip with textures and spheres. Model: octahedral() in
// model/unit/shade/surface/surf.hpp.
`default_nettype none
module rc_octahedral #(
  localparam int unsigned AxisBits = rc_pkg::AxisBits,
  localparam int unsigned BaryBits = rc_pkg::BaryBits,
  localparam int unsigned UvBits   = rc_pkg::UvBits,
  localparam int unsigned Every    = rc_pkg::ShadeInterval
) (
  input  logic                  clk_i,
  input  logic                  leaves_13_i,   // a pass of a surface leaves s13
  input  logic [3*AxisBits-1:0] s13_normal_i,
  input  logic                  s13_inside_i,  // the normal points inwards
  input  logic                  begins_14_i,   // a pass begins s14
  input  logic                  done_i,        // its quotients are there: Steps cycles later
  output logic [UvBits-1:0]     u_o,
  output logic [UvBits-1:0]     v_o
);
  localparam int unsigned Width = AxisBits + 1;            // of three absolute values and 1
  localparam int unsigned Steps = rc_pkg::OctahedralSteps;  // two bits of a quotient in each
  localparam int unsigned QuoW  = 2 * Steps;
  localparam int unsigned PartW = BaryBits;                // 0 to h

  if (QuoW < BaryBits - 1) begin : gen_refuse
    $error("rc_octahedral: too few steps");
  end

  // s14: absolute values, signs and the divisor.
  logic [3*Width-1:0] s13_size;
  logic [2:0]         s13_below, s14_below_q, below;   // the component is negative
  logic [Width-1:0]   s14_x_q, s14_z_q, s14_sum_q;

  for (genvar k = 0; k < 3; k++) begin : gen_axis
    logic signed [Width-1:0] given, n;

    assign given = Width'($signed(s13_normal_i[k*AxisBits +: AxisBits]));
    assign n     = s13_inside_i ? -given : given;
    assign s13_below[k]                = n < 0;
    assign s13_size[k*Width +: Width] = n < 0 ? -n : n;
  end

  always_ff @(posedge clk_i)
    if (leaves_13_i) begin
      s14_x_q     <= s13_size[0 +: Width];
      s14_z_q     <= s13_size[2*Width +: Width];
      s14_sum_q   <= s13_size[0 +: Width] + s13_size[Width +: Width] + s13_size[2*Width +: Width]
                   + Width'(1);
      s14_below_q <= s13_below;
    end

  rc_shift_register #(.Width(3), .Stages(Steps)) u_below (
    .clk_i, .enable_i({Steps{1'b1}}), .data_i(s14_below_q), .data_o(below));

  // The quotients.
  logic [2*QuoW-1:0] quotient;   // of x, of z
  logic [1:0]        inexact;

  for (genvar i = 0; i < 2; i++) begin : gen_quotient
    logic [Width-1:0] size;

    assign size = i == 0 ? s14_x_q : s14_z_q;

    rc_divide #(.Width(Width), .Stages(Steps), .Bits(2), .Every(Every), .Lows(0), .Apart(i == 1))
    u_divide (
      .clk_i, .valid_i(begins_14_i), .rem_i(size), .low_i({QuoW{1'b0}}), .den_i(s14_sum_q),
      .quo_o(quotient[i*QuoW +: QuoW]), .inexact_o(inexact[i]));
  end

  // The place, folded.
  localparam logic [PartW-1:0] Half = PartW'(1) << (BaryBits - 1);
  logic [PartW-1:0] p, q, folded_p, folded_q;

  assign p        = PartW'(quotient[0 +: QuoW] >> (QuoW + 1 - BaryBits));
  assign q        = PartW'(quotient[QuoW +: QuoW] >> (QuoW + 1 - BaryBits));
  assign folded_p = below[1] ? Half - q : p;
  assign folded_q = below[1] ? Half - p : q;

  always_ff @(posedge clk_i)
    if (done_i) begin
      u_o <= below[0] ? UvBits'(Half) - UvBits'(folded_p) : UvBits'(Half) + UvBits'(folded_p);
      v_o <= below[2] ? UvBits'(Half) - UvBits'(folded_q) : UvBits'(Half) + UvBits'(folded_q);
    end

  logic unused;
  assign unused = ^{quotient, inexact};
endmodule
`default_nettype wire

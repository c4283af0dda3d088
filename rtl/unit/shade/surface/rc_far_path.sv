// The length of the path from the eye to a hit on a plane that is too far away for t:
// path + |o - r|, rounded down and saturated. o is the hit's point and r the ray's origin. The
// length of a vector is approximated as in rc_path_length: its largest component plus 3/8 of the
// second and 5/16 of the smallest.
//
// Part of rc_pass, which has the valid bits; the result is in the registers of s8. Exists only in a
// chip with textures and planes. Model: path_to() in model/unit/shade/surface/surf.hpp.
`default_nettype none
module rc_far_path #(
  localparam int unsigned OriginWidth = rc_pkg::OriginWidth,
  localparam int unsigned PointWidth  = rc_pkg::PointWidth,
  localparam int unsigned PathBits    = rc_pkg::PathBits
) (
  input  logic                     clk_i,
  input  logic                     rst_ni,
  input  logic [7:0]               valid_i,
  input  logic [PathBits-1:0]      s0_path_i,   // to the ray's origin
  input  logic [3*OriginWidth-1:0] s0_o_i,      // the ray's origin
  input  logic [3*PointWidth-1:0]  s5_o_i,      // the hit's point
  output logic [PathBits-1:0]      s8_path_o
);
  localparam int unsigned SizeW   = PointWidth + 1;
  localparam int unsigned LengthW = SizeW + 1;
  localparam int unsigned ScaledW = LengthW + rc_pkg::TFracBits;   // including the origin's bits
  localparam int unsigned SumW    = (ScaledW > PathBits ? ScaledW : PathBits) + 1;

  logic [3*OriginWidth-1:0] s5_from;
  logic [PathBits-1:0]      s7_path;

  rc_stage_delay #(.Width(3 * OriginWidth), .Stages(5)) u_from (
    .clk_i, .rst_ni, .enter_i(valid_i[0]), .leave_i(valid_i[5]), .data_i(s0_o_i), .data_o(s5_from));

  rc_stage_delay #(.Width(PathBits), .Stages(7)) u_path (
    .clk_i, .rst_ni, .enter_i(valid_i[0]), .leave_i(valid_i[7]), .data_i(s0_path_i),
    .data_o(s7_path));

  // s6: absolute values of the components of o - r.
  logic [3*SizeW-1:0] s6_size_q;

  for (genvar k = 0; k < 3; k++) begin : gen_axis
    logic signed [SizeW-1:0] way;

    assign way = SizeW'($signed(s5_o_i[k*PointWidth +: PointWidth]))
               - SizeW'($signed(s5_from[k*OriginWidth +: OriginWidth]));

    always_ff @(posedge clk_i)
      if (valid_i[5]) s6_size_q[k*SizeW +: SizeW] <= way < 0 ? -way : way;
  end

  // s7: the length, in units of 2^-OriginBits.
  logic [SizeW-1:0]   size_x, size_y, size_z, larger, smaller, longest, second, shortest;
  logic [LengthW-1:0] s7_length_q;

  assign size_x = s6_size_q[0 +: SizeW];
  assign size_y = s6_size_q[SizeW +: SizeW];
  assign size_z = s6_size_q[2*SizeW +: SizeW];

  assign larger   = size_x > size_y ? size_x : size_y;
  assign smaller  = size_x > size_y ? size_y : size_x;
  assign longest  = larger > size_z ? larger : size_z;
  assign second   = larger <= size_z ? larger : smaller > size_z ? smaller : size_z;
  assign shortest = smaller < size_z ? smaller : size_z;

  always_ff @(posedge clk_i)
    if (valid_i[6])
      s7_length_q <= LengthW'(longest) + LengthW'(second[SizeW-1:2]) + LengthW'(second[SizeW-1:3])
                   + LengthW'(shortest[SizeW-1:2]) + LengthW'(shortest[SizeW-1:4]);

  // s8: the sum, in units of 2^-TFracBits.
  logic [ScaledW-1:0] s7_scaled;
  logic [SumW-1:0]    s7_sum;

  assign s7_scaled = ScaledW'(s7_length_q) << rc_pkg::TFracBits;
  assign s7_sum    = SumW'(s7_scaled[ScaledW-1:rc_pkg::OriginBits]) + SumW'(s7_path);

  always_ff @(posedge clk_i)
    if (valid_i[7])
      s8_path_o <= s7_sum[SumW-1:PathBits] != '0 ? '1 : s7_sum[PathBits-1:0];

  logic unused;
  assign unused = ^{valid_i, s7_scaled, second, shortest};
endmodule
`default_nettype wire

// The part of the test of a ray that all globes of a node share. D is the way from the origin,
// rounded down to the lattice, to the node's corner; e is the direction. Its results are:
// - moment, (D x e) / 2^exp, rounded down, at stage 2 + MulStages + 2 Cut;
// - way, D . e in units of 2^(exp + 13), rounded down, at stage 3 + MulStages + 3 Cut;
// - slack, a bound on how much rounding enlarges the distances, in eighths of 2^exp steps, at stage
//   1 + 4 Cut (the part that all nodes share is left out);
// - square, |e|^2 / 2^18, rounded down, plus one, at stage 3 + MulStages + 4 Cut;
// - inverse, K (rc_inverse_square), at stage 5 + 2 MulStages + 9 Cut;
// - right, the right shift that turns 2^TBits K times a way into a time, at stage 6 + 3 MulStages
//   + 9 Cut;
// - toward, the direction itself, at stage 1.
//
// Part of rc_globe; stages count from the node on. Model: sight_of() in
// model/engine/spheres/globe.cpp.
`default_nettype none
module rc_globe_moment #(
  localparam int unsigned N           = rc_pkg::CoordBits,
  localparam int unsigned OriginWidth = rc_pkg::OriginWidth,
  localparam int unsigned ExpBits     = rc_pkg::ExpBits,
  localparam int unsigned TowardBits  = rc_pkg::TowardBits,
  localparam int unsigned TBits       = rc_pkg::TBits,
  localparam int unsigned Stages      = rc_pkg::GlobeStages,
  localparam int unsigned AxisW       = N + 1,                     // a way on an axis, signed
  localparam int unsigned MomentW     = AxisW + TowardBits + 1,   // a component of a moment, signed
  localparam int unsigned WayW        = N + 7                      // a way along the ray, signed
) (
  input  logic            clk_i,
  input  logic [Stages-1:0] enable_i,   // enable_i[i]: the register after stage i accepts its input
  // Ray, and the node's corner and exponent
  input  logic [3*OriginWidth-1:0] s0_o_i,
  input  logic [3*N-1:0]           s0_org_i,
  input  logic [ExpBits-1:0]       s0_exp_i,
  input  logic [3*TowardBits-1:0]  s0_toward_i,
  input  logic [ExpBits-1:0]       s0_len_i,
  // Results
  output logic [3*TowardBits-1:0]  toward_o,
  output logic [3*MomentW-1:0] moment_o,
  output logic [WayW-1:0]       way_o,
  output logic [N+3:0]          slack_o,
  output logic [TowardBits-1:0] square_o,
  output logic [16:0]           inverse_o,
  output logic [5:0]            right_o
);
  localparam int unsigned Cut  = rc_pkg::PathCut;
  localparam int unsigned Mul  = rc_pkg::MulStages;
  localparam int unsigned Sum  = N + 6;     // of three ways and Least, which is below 2^17
  localparam int unsigned Drop = 13;        // bits from the unit of D . e up to an eighth of a step
  localparam bit          Shades = rc_pkg::Shading;   // origins may lie between lattice points

  // D, the way from the origin to the node's corner.
  logic [3*AxisW-1:0] s0_way, way_q;
  logic [ExpBits-1:0] exp_q;

  for (genvar k = 0; k < 3; k++) begin : gen_way
    assign s0_way[k*AxisW +: AxisW] = AxisW'($signed(s0_org_i[k*N +: N]))
                                    - AxisW'($signed(s0_o_i[k*OriginWidth+OriginWidth-1 -: N]));
  end

  always_ff @(posedge clk_i) begin
    if (enable_i[0]) begin
      way_q    <= s0_way;
      toward_o <= s0_toward_i;
      exp_q    <= s0_exp_i;
    end
  end

  // The moment, shifted right by a multiple of eight, then by the remaining three bits.
  logic [ExpBits-1:0] moment_exp;
  logic [2:0]         fine;

  rc_shift_register #(.Width(ExpBits), .Stages(1 + Mul)) u_exp (
    .clk_i, .enable_i(enable_i[Mul+1:1]), .data_i(exp_q), .data_o(moment_exp));
  rc_path_register #(.Width(3)) u_fine (.clk_i, .data_i(moment_exp[2:0]), .data_o(fine));

  for (genvar k = 0; k < 3; k++) begin : gen_moment
    localparam int unsigned Axis1 = (k + 1) % 3;   // the other two axes
    localparam int unsigned Axis2 = (k + 2) % 3;
    logic signed [AxisW+TowardBits-1:0] ab, ba;
    logic signed [MomentW-1:0]          moment_q, coarse, coarse_q, placed;

    rc_mul #(.AW(AxisW), .BW(TowardBits)) u_ab (
      .clk_i, .a_i($signed(way_q[Axis1*AxisW +: AxisW])),
      .b_i($signed(toward_o[Axis2*TowardBits +: TowardBits])), .p_o(ab));
    rc_mul #(.AW(AxisW), .BW(TowardBits)) u_ba (
      .clk_i, .a_i($signed(way_q[Axis2*AxisW +: AxisW])),
      .b_i($signed(toward_o[Axis1*TowardBits +: TowardBits])), .p_o(ba));

    always_ff @(posedge clk_i) if (enable_i[Mul+1]) moment_q <= MomentW'(ab) - MomentW'(ba);

    assign coarse = moment_q >>> {moment_exp[ExpBits-1:3], 3'd0};
    rc_path_register #(.Width(MomentW)) u_coarse (.clk_i, .data_i(coarse), .data_o(coarse_q));

    assign placed = coarse_q >>> fine;
    rc_path_register #(.Width(MomentW)) u_moment (
      .clk_i, .data_i(placed), .data_o(moment_o[k*MomentW +: MomentW]));
  end

  // The way along the ray. An origin between lattice points was moved by up to 49 eighths of a
  // step.
  localparam int unsigned AlongW = AxisW + TowardBits + 2;
  localparam logic signed [AlongW-1:0] Moved = Shades ? AlongW'(49 << Drop) : '0;

  logic [3*(AxisW+TowardBits)-1:0] parts;
  logic signed [AlongW-1:0]        two, two_q, third, third_q, along_q, along_coarse, along_fine;
  logic signed [AlongW-1:0]        along_placed, along;
  logic [ExpBits-1:0]              along_exp;
  logic [2:0]                      along_rest;

  for (genvar k = 0; k < 3; k++) begin : gen_part
    rc_mul #(.AW(AxisW), .BW(TowardBits)) u_part (
      .clk_i, .a_i($signed(way_q[k*AxisW +: AxisW])),
      .b_i($signed(toward_o[k*TowardBits +: TowardBits])),
      .p_o(parts[k*(AxisW+TowardBits) +: AxisW+TowardBits]));
  end

  assign two   = AlongW'($signed(parts[0 +: AxisW+TowardBits]))
               + AlongW'($signed(parts[AxisW+TowardBits +: AxisW+TowardBits]));
  assign third = AlongW'($signed(parts[2*(AxisW+TowardBits) +: AxisW+TowardBits])) - Moved;

  rc_path_register #(.Width(AlongW)) u_along_two (.clk_i, .data_i(two), .data_o(two_q));
  rc_path_register #(.Width(AlongW)) u_along_third (.clk_i, .data_i(third), .data_o(third_q));

  always_ff @(posedge clk_i) if (enable_i[Mul+1+Cut]) along_q <= two_q + third_q;
  rc_path_register #(.Width(ExpBits)) u_along_exp (.clk_i, .data_i(moment_exp), .data_o(along_exp));

  assign along_coarse = along_q >>> {along_exp[ExpBits-1:3], 3'd0};
  rc_path_register #(.Width(AlongW)) u_along_coarse (
    .clk_i, .data_i(along_coarse), .data_o(along_fine));
  rc_path_register #(.Width(3)) u_along_rest (.clk_i, .data_i(along_exp[2:0]), .data_o(along_rest));

  assign along_placed = along_fine >>> along_rest;
  rc_path_register #(.Width(AlongW)) u_along (.clk_i, .data_i(along_placed), .data_o(along));

  always_ff @(posedge clk_i) if (enable_i[Mul+2+3*Cut]) way_o <= WayW'(along >>> Drop);

  // slack. The distance to the node is the sum over the axes. A direction is off by less than 2^-16
  // of that distance. An origin between lattice points was moved by less than 14 eighths of a step.
  localparam int unsigned Least = 2 + ((1 + (Shades ? 14 : 0)) << Drop);

  logic [3*Sum-1:0]   size, size_q;
  logic [Sum-1:0]     first, rest, first_q, rest_q, away;
  logic [N+3:0]       slack_steps, slack;
  logic [ExpBits-1:0] slack_exp;

  for (genvar k = 0; k < 3; k++) begin : gen_size
    logic signed [Sum-1:0] axis;
    assign axis = Sum'($signed(way_q[k*AxisW +: AxisW]));
    assign size[k*Sum +: Sum] = axis[Sum-1] ? -axis : axis;
  end

  rc_path_register #(.Width(3 * Sum)) u_size (.clk_i, .data_i(size), .data_o(size_q));

  assign first = size_q[0 +: Sum] + size_q[Sum +: Sum];
  assign rest  = size_q[2*Sum +: Sum] + Sum'(Least);

  rc_path_register #(.Width(Sum)) u_first (.clk_i, .data_i(first), .data_o(first_q));
  rc_path_register #(.Width(Sum)) u_rest (.clk_i, .data_i(rest), .data_o(rest_q));
  rc_path_register #(.Width(Sum)) u_away (.clk_i, .data_i(first_q + rest_q), .data_o(away));

  rc_path_register #(.Width(ExpBits), .Stages(3 * Cut)) u_slack_exp (
    .clk_i, .data_i(exp_q), .data_o(slack_exp));

  assign slack_steps = (N + 4)'(away >> Drop);
  assign slack       = slack_steps >> slack_exp;
  rc_path_register #(.Width(N + 4)) u_slack (.clk_i, .data_i(slack), .data_o(slack_o));

  // The square of the direction, and its inverse.
  logic [3*2*TowardBits-1:0] squares;
  logic [2*TowardBits-1:0]   square_two, square_two_q, square_third_q, square_q;
  logic [TowardBits-1:0]     up;
  logic [1:0]                n;
  logic [16:0]               inverse;

  for (genvar k = 0; k < 3; k++) begin : gen_square
    rc_mul #(.AW(TowardBits), .BW(TowardBits)) u_square (
      .clk_i, .a_i($signed(s0_toward_i[k*TowardBits +: TowardBits])),
      .b_i($signed(s0_toward_i[k*TowardBits +: TowardBits])),
      .p_o(squares[k*2*TowardBits +: 2*TowardBits]));
  end

  assign square_two = squares[0 +: 2*TowardBits] + squares[2*TowardBits +: 2*TowardBits];

  rc_path_register #(.Width(2 * TowardBits)) u_square_two (
    .clk_i, .data_i(square_two), .data_o(square_two_q));
  rc_path_register #(.Width(2 * TowardBits)) u_square_third (
    .clk_i, .data_i(squares[4*TowardBits +: 2*TowardBits]), .data_o(square_third_q));

  always_ff @(posedge clk_i) if (enable_i[Mul+Cut]) square_q <= square_two_q + square_third_q;

  assign up = square_q[2*TowardBits-1:TowardBits] + TowardBits'(1);
  rc_shift_register #(.Width(TowardBits), .Stages(2 + 3 * Cut)) u_up (
    .clk_i, .enable_i(enable_i[Mul+Cut+1 +: 2+3*Cut]), .data_i(up), .data_o(square_o));

  rc_inverse_square u_inverse_square (
    .clk_i, .last_enable_i(enable_i[1+2*Mul+3*Cut]), .square_i(square_q), .n_o(n),
    .inverse_o(inverse));

  rc_shift_register #(.Width(17), .Stages(3 + 6 * Cut)) u_late_inverse (
    .clk_i, .enable_i(enable_i[2+2*Mul+3*Cut +: 3+6*Cut]), .data_i(inverse), .data_o(inverse_o));

  // right. Left shifts by TBits or more saturate.
  localparam int unsigned ShiftW = 8;   // shift, signed
  localparam logic signed [ShiftW-1:0] ShiftBase =
      ShiftW'(rc_pkg::TFracBits) + ShiftW'(rc_pkg::RayDirBits)
      - ShiftW'(20);

  logic [ExpBits-1:0]       len_q, shift_exp;
  logic signed [ShiftW-1:0] shift_q, move;
  logic [5:0]               right_q;

  rc_shift_register #(.Width(2 * ExpBits), .Stages(1 + Mul + Cut)) u_len (
    .clk_i, .enable_i(enable_i[Mul+Cut:0]), .data_i({s0_len_i, s0_exp_i}),
    .data_o({len_q, shift_exp}));

  always_ff @(posedge clk_i) begin
    if (enable_i[1+Mul+Cut])
      shift_q <= ShiftBase - $signed({{(ShiftW-ExpBits){1'b0}}, len_q})
          + $signed({{(ShiftW-ExpBits){1'b0}}, shift_exp})
          - $signed({{(ShiftW-2){1'b0}}, n});
    if (enable_i[2+Mul+Cut]) right_q <= move[5:0];
  end

  assign move = shift_q > $signed(ShiftW'(TBits)) ? '0 : $signed(ShiftW'(TBits)) - shift_q;

  rc_shift_register #(.Width(6), .Stages(3 + 2 * Mul + 8 * Cut)) u_right (
    .clk_i, .enable_i(enable_i[3+Mul+Cut +: 3+2*Mul+8*Cut]), .data_i(right_q), .data_o(right_o));

  logic unused;
  assign unused = ^{enable_i, square_q[TowardBits-1:0], s0_o_i, move[ShiftW-1:6], along};
endmodule
`default_nettype wire

// A direction in the form that the sheared triangle test uses: {axis, neg, size, slope y, slope x}.
//
// z is the axis of the largest |d|, the lowest if several are equal; x and y are the next two in
// turn. size = |d_z|; neg is set if d_z < 0. A slope is d_x / d_z with M - 2 fraction bits, rounded
// to nearest, halves away from zero. That is half of floor(2^(M-1) |d_x| / |d_z|) + 1. d = 0 gives
// all zeros.
//
// Latency 1 + floor(M / 2), throughput 1 per cycle. Model: shear_of() in
// model/unit/tri/sheared.hpp.
`default_nettype none
module rc_slope #(
  localparam int unsigned M = rc_pkg::DirBits
) (
  input  logic           clk_i,
  input  logic           enable_i,
  input  logic [3*M-1:0] d_i,
  output logic [3*M+2:0] shear_o
);
  localparam int unsigned Stages = M / 2;   // for M - 1 bits

  // s0: magnitudes, at most 2^(M-1), and the axis of the largest.
  logic [M-1:0] s0_x, s0_y, s0_z;
  logic         s0_x_neg, s0_y_neg, s0_z_neg;
  logic [1:0]   s0_axis;
  logic [M-1:0] s0_0, s0_1, s0_2;

  assign s0_0 = d_i[M-1]   ? -d_i[M-1:0]     : d_i[M-1:0];
  assign s0_1 = d_i[2*M-1] ? -d_i[2*M-1:M]   : d_i[2*M-1:M];
  assign s0_2 = d_i[3*M-1] ? -d_i[3*M-1:2*M] : d_i[3*M-1:2*M];

  always_comb begin
    if (s0_0 >= s0_1 && s0_0 >= s0_2) begin
      s0_axis = 2'd0;
      {s0_x, s0_y, s0_z} = {s0_1, s0_2, s0_0};
      {s0_x_neg, s0_y_neg, s0_z_neg} = {d_i[2*M-1], d_i[3*M-1], d_i[M-1]};
    end else if (s0_1 >= s0_2) begin
      s0_axis = 2'd1;
      {s0_x, s0_y, s0_z} = {s0_2, s0_0, s0_1};
      {s0_x_neg, s0_y_neg, s0_z_neg} = {d_i[3*M-1], d_i[M-1], d_i[2*M-1]};
    end else begin
      s0_axis = 2'd2;
      {s0_x, s0_y, s0_z} = {s0_0, s0_1, s0_2};
      {s0_x_neg, s0_y_neg, s0_z_neg} = {d_i[M-1], d_i[2*M-1], d_i[3*M-1]};
    end
  end

  // s1: a slope of 0 or 1 in magnitude needs no division.
  logic         s1_enable_q, s1_x_one_q, s1_y_one_q, s1_x_neg_q, s1_y_neg_q, s1_z_neg_q;
  logic [1:0]   s1_axis_q;
  logic [M-1:0] s1_x_q, s1_y_q, s1_z_q;

  always_ff @(posedge clk_i) begin
    s1_enable_q <= enable_i;
    if (enable_i) begin
      s1_x_q     <= s0_x == s0_z ? '0 : s0_x;
      s1_y_q     <= s0_y == s0_z ? '0 : s0_y;
      s1_z_q     <= s0_z;
      s1_x_one_q <= s0_x == s0_z && s0_z != '0;
      s1_y_one_q <= s0_y == s0_z && s0_z != '0;
      s1_x_neg_q <= s0_x_neg != s0_z_neg;
      s1_y_neg_q <= s0_y_neg != s0_z_neg;
      s1_z_neg_q <= s0_z_neg;
      s1_axis_q  <= s0_axis;
    end
  end

  // Two bits per stage. With an even M there is one bit too many, dropped below.
  logic [2*Stages-1:0] x_quo, y_quo;
  logic                x_inexact, y_inexact;

  rc_divide #(.Width(M), .Stages(Stages)) u_x (
    .clk_i, .valid_i(s1_enable_q), .rem_i(s1_x_q), .low_i((2*Stages)'(0)), .den_i(s1_z_q),
    .quo_o(x_quo), .inexact_o(x_inexact));
  rc_divide #(.Width(M), .Stages(Stages)) u_y (
    .clk_i, .valid_i(s1_enable_q), .rem_i(s1_y_q), .low_i((2*Stages)'(0)), .den_i(s1_z_q),
    .quo_o(y_quo), .inexact_o(y_inexact));

  // The other fields are delayed to match the dividers.
  logic [Stages-1:0] wait_enable_q;
  logic              x_one, y_one, x_neg, y_neg, z_neg;
  logic [1:0]        axis;
  logic [M-1:0]      z;

  always_ff @(posedge clk_i) wait_enable_q <= {wait_enable_q[Stages-2:0], s1_enable_q};

  rc_shift_register #(.Width(M + 7), .Stages(Stages)) u_wait (
    .clk_i, .enable_i({wait_enable_q[Stages-2:0], s1_enable_q}),
    .data_i({s1_x_one_q, s1_y_one_q, s1_x_neg_q, s1_y_neg_q, s1_z_neg_q, s1_axis_q, s1_z_q}),
    .data_o({x_one, y_one, x_neg, y_neg, z_neg, axis, z}));

  // d = 0 divides by zero: the quotient's bits are ones, and are replaced by 0.
  logic [M-1:0] x_size, y_size;

  assign x_size = z == '0 ? '0 : ({x_one, x_quo[2*Stages-1 -: M-1]} + M'(1)) >> 1;
  assign y_size = z == '0 ? '0 : ({y_one, y_quo[2*Stages-1 -: M-1]} + M'(1)) >> 1;
  assign shear_o = {axis, z_neg, z, y_neg ? -y_size : y_size, x_neg ? -x_size : x_size};

  logic unused;
  assign unused = ^{x_inexact, y_inexact, x_quo[0], y_quo[0], wait_enable_q[Stages-1]};
endmodule
`default_nettype wire

// Direction of a camera ray, from the sums of the pixel's steps, one per axis.
//
// The three sums are shifted left together until one fills its width, by at most MostShift bits. So
// a ray in the middle of a wide picture has as many bits as one in its corners. Then they are
// rounded to DirBits, to nearest, halves up. A component that would round to 2^(DirBits-1), which
// does not fit, is one less. With two levels -2^(DirBits-1) is one more. model/core/frame.hpp has
// the rule.
//
// Latency rc_pkg::DirectionStages, throughput 1 per cycle. Model: direction_of() in
// model/unit/raygen/raygen.cpp. The host ensures that the sums fit and that not all of them are too
// short.
`default_nettype none
module rc_direction #(
  // A sum, with GuardSumW - DirBits fraction bits.
  parameter  int unsigned GuardSumW = rc_pkg::GuardDirBits,
  localparam int unsigned M         = rc_pkg::DirBits,
  localparam int unsigned Stages    = rc_pkg::DirectionStages
) (
  input  logic                   clk_i,
  // enable_i[i]: stage i holds a ray, or the chip is fast
  input  logic [Stages-1:0]      enable_i,
  input  logic [3*GuardSumW-1:0] sum_i,
  output logic [3*M-1:0]         dir_o
);
  localparam int unsigned Cut    = rc_pkg::PathCut;
  localparam int unsigned Most   = rc_pkg::MaxShift;
  localparam int unsigned ShiftW = $clog2(Most + 1);

  // s0: the bits that differ from the sign in any component, and the free bits above them.
  logic [3*GuardSumW-1:0] s0_sum;

  rc_path_register #(.Width(3 * GuardSumW)) u_sum (.clk_i, .data_i(sum_i), .data_o(s0_sum));

  logic [GuardSumW-2:0] s0_used;
  logic [ShiftW-1:0]    s0_shift;

  always_comb begin
    s0_used = '0;
    for (int k = 0; k < 3; k++) begin
      s0_used = s0_used | (s0_sum[k*GuardSumW +: GuardSumW-1]
                           ^ {(GuardSumW-1){s0_sum[k*GuardSumW+GuardSumW-1]}});
    end
    s0_shift = ShiftW'(Most);
    for (int i = Most - 1; i >= 0; i--) if (s0_used[GuardSumW-2-i]) s0_shift = ShiftW'(i);
  end

  logic [3*GuardSumW-1:0] s1_sum_q;
  logic [ShiftW-1:0]      s1_shift_q;

  always_ff @(posedge clk_i) begin
    if (enable_i[Cut]) begin
      s1_sum_q   <= s0_sum;
      s1_shift_q <= s0_shift;
    end
  end

  // s1: the shift, then the rounding, Q(M).0.
  for (genvar k = 0; k < 3; k++) begin : gen_axis
    logic [GuardSumW-1:0] s1_moved;
    logic [M-1:0]         s1_whole, whole, rounded;
    logic                 s1_up, up;

    assign s1_moved = s1_sum_q[k*GuardSumW +: GuardSumW] << s1_shift_q;
    assign s1_whole = s1_moved[GuardSumW-1 -: M];

    if (rc_pkg::Levels == 1) begin : gen_nearest
      assign s1_up = s1_moved[GuardSumW-M-1];
    end else begin : gen_with_opposite   // the least number has no opposite, and a mirror needs it
      assign s1_up = s1_moved[GuardSumW-M-1] || s1_whole == {1'b1, {(M-1){1'b0}}};
    end

    rc_path_register #(.Width(M + 1)) u_whole (
      .clk_i, .data_i({s1_whole, s1_up}), .data_o({whole, up}));

    assign rounded = whole + {{(M-1){1'b0}}, up};
    assign dir_o[k*M +: M] = !whole[M-1] && rounded[M-1] ? whole : rounded;

    logic unused;
    assign unused = ^s1_moved[GuardSumW-M-2:0];
  end

  logic unused;
  assign unused = ^enable_i;
endmodule
`default_nettype wire

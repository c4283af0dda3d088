// Direction of a camera ray from the sums of the pixel's steps, one for each axis.
//
// The three sums are moved up together until one fills its width, by MostShift bits at most,
// so that a ray in the middle of a wide picture has as many bits as one in its corners.
// Then they are rounded to DirBits, to nearest, halves up; what would round to 2^(DirBits-1),
// which does not fit, is one less. model/core/frame.hpp has the rule.
//
// Latency 1, throughput 1 per cycle. Model: direction_of() in model/raygen/raygen.cpp. The
// host sees to it that the sums fit and that none of them is too short.
`default_nettype none
module rc_direction #(
  parameter  int unsigned G = rc_pkg::GuardDirBits,   // of a sum, with G - DirBits fraction bits
  localparam int unsigned M = rc_pkg::DirBits
) (
  input  logic           clk_i,
  input  logic           valid_i,
  input  logic [3*G-1:0] sum_i,
  output logic [3*M-1:0] dir_o    // a cycle later
);
  localparam int unsigned Most = rc_pkg::MostShift;
  localparam int unsigned S    = $clog2(Most + 1);

  // s0: bits that differ from the sign in any component, and how many above them are free.
  logic [G-2:0] s0_used;
  logic [S-1:0] s0_shift;
  always_comb begin
    s0_used = '0;
    for (int k = 0; k < 3; k++) begin
      s0_used = s0_used | (sum_i[k*G +: G-1] ^ {(G-1){sum_i[k*G+G-1]}});
    end
    s0_shift = S'(Most);
    for (int i = Most - 1; i >= 0; i--) if (s0_used[G-2-i]) s0_shift = S'(i);
  end

  logic [3*G-1:0] s1_sum_q;
  logic [S-1:0]   s1_shift_q;
  always_ff @(posedge clk_i) begin
    if (valid_i) begin
      s1_sum_q   <= sum_i;
      s1_shift_q <= s0_shift;
    end
  end

  // s1: moved up and rounded (Q(M).0).
  for (genvar k = 0; k < 3; k++) begin : gen_axis
    logic [G-1:0] s1_moved;
    logic [M-1:0] s1_whole;
    logic         s1_up;
    assign s1_moved = s1_sum_q[k*G +: G] << s1_shift_q;
    assign s1_whole = s1_moved[G-1 -: M];
    assign s1_up    = s1_moved[G-M-1] && s1_whole != {1'b0, {(M-1){1'b1}}};
    assign dir_o[k*M +: M] = s1_whole + {{(M-1){1'b0}}, s1_up};
    logic unused;
    assign unused = ^s1_moved[G-M-2:0];
  end
endmodule
`default_nettype wire

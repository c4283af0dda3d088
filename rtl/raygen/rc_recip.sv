// Reciprocal of one direction component, rounded down.
//
// For |d| of bit length len: m = |d| << (M - len), recip = floor(2^(M+R-1) / m), an
// R + 1 bit number between 2^(R-1) and 2^R. d = 0 gives len 0, recip 1. M is the width of
// a ray's direction; len of one that has only DirBits counts as if it were as long.
// Latency 1 + ceil(R / 2), throughput 1 per cycle. Model: model/raygen/raygen.hpp
// (reciprocal).
`default_nettype none
module rc_recip (
  input  logic                                 clk_i,
  input  logic                                 valid_i,
  input  logic                                 short_i,  // of DirBits only
  input  logic signed [rc_pkg::RayDirBits-1:0] d_i,
  output logic [rc_pkg::RecipBits:0]           recip_o,
  output logic [rc_pkg::ExpBits-1:0]           len_o
);
  localparam int unsigned M      = rc_pkg::RayDirBits;
  localparam int unsigned R      = rc_pkg::RecipBits;
  localparam int unsigned E      = rc_pkg::ExpBits;
  localparam int unsigned Stages = (R + 1) / 2;

  // s0: magnitude, bit length, and the magnitude moved up until its top bit is set.
  logic [M-1:0] s0_mag, s0_m;
  logic [E-1:0] s0_len;
  always_comb begin
    s0_mag = '0;
    s0_len = '0;
    s0_m   = '0;
    if (valid_i) begin
      s0_mag = d_i[M-1] ? $unsigned(-d_i) : $unsigned(d_i);
      for (int i = 0; i < M; i++) if (s0_mag[i]) s0_len = E'(i + 1);
      s0_m = s0_mag << (E'(M) - s0_len);
    end
  end

  // s1: the quotient's top bit is one only for a power of two, which divides exactly.
  logic         s1_valid_q, s1_top_q;
  logic [M-1:0] s1_m_q, s1_rem_q;
  logic [E-1:0] s1_len_q;
  logic         s0_top;
  assign s0_top = s0_m[M-2:0] == '0;
  always_ff @(posedge clk_i) begin
    s1_valid_q <= valid_i;
    if (valid_i) begin
      s1_m_q   <= s0_m;
      s1_len_q <= short_i && s0_len != '0 ? s0_len + E'(M - rc_pkg::DirBits) : s0_len;
      s1_top_q <= s0_top;
      s1_rem_q <= s0_top ? '0 : {1'b1, {(M-1){1'b0}}};
    end
  end

  // The other R bits, two a stage; for an odd R one bit too many, dropped below.
  logic [2*Stages-1:0] quo;
  logic                inexact;
  rc_divide #(.Width(M), .Stages(Stages)) u_divide (
    .clk_i, .valid_i(s1_valid_q), .rem_i(s1_rem_q), .low_i('0), .den_i(s1_m_q),
    .quo_o(quo), .inexact_o(inexact));

  // Bit length and top bit wait beside the divider.
  logic [Stages-1:0] wait_valid_q;
  logic              top;
  always_ff @(posedge clk_i) wait_valid_q <= {wait_valid_q[Stages-2:0], s1_valid_q};
  rc_delay #(.Width(E + 1), .Stages(Stages)) u_wait (
    .clk_i, .valid_i({wait_valid_q[Stages-2:0], s1_valid_q}), .data_i({s1_top_q, s1_len_q}),
    .data_o({top, len_o}));

  assign recip_o = len_o == '0 ? {{R{1'b0}}, 1'b1} : {top, quo[2*Stages-1 -: R]};

  logic unused;
  assign unused = ^{inexact, quo[0], wait_valid_q[Stages-1]};
endmodule
`default_nettype wire

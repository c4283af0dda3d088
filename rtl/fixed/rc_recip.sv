// Reciprocal of one direction component, rounded down.
//
// For |d| of bit length len, m = |d| << (RayDirBits - len) and recip = floor(2^(RayDirBits+R-1) /
// m). recip has R + 1 bits and lies in 2^(R-1)..2^R. d = 0 gives len 0, recip 1. RayDirBits is the
// width of a ray's direction. For a direction of DirBits only, len counts as for full width.
//
// Latency rc_pkg::RecipStages. A component may come every Every cycles. If Every is above 1, Every
// steps of the division share a stage, and valid_i must be set for valid components only. Model:
// reciprocal() in model/unit/raygen/raygen.hpp.
`default_nettype none
module rc_recip #(
  parameter int unsigned Every = 1
) (
  input  logic                                 clk_i,
  input  logic                                 rst_ni,
  input  logic                                 valid_i,
  input  logic                                 short_i,  // of DirBits only
  input  logic signed [rc_pkg::RayDirBits-1:0] d_i,
  output logic [rc_pkg::RecipBits:0]           recip_o,
  output logic [rc_pkg::ExpBits-1:0]           len_o
);
  localparam int unsigned RayDirBits = rc_pkg::RayDirBits;
  localparam int unsigned R          = rc_pkg::RecipBits;
  localparam int unsigned ExpBits    = rc_pkg::ExpBits;
  localparam int unsigned Stages     = rc_pkg::RecipStages;
  localparam int unsigned Bits       = rc_pkg::QuotientBits;
  // Moved: the stage in which the division begins.
  localparam int unsigned Moved      = 1 + 3 * rc_pkg::PathCut;
  localparam int unsigned DivStages  = Stages - Moved;        // stages of the division

  // valid[i]: stage i holds a component. A ring (rc_stage_delay) counts the components. So a reset
  // clears every bit: the shortest reset takes fewer cycles than there are stages.
  logic [Stages-1:0] valid_q;
  logic [Stages:0]   valid;

  assign valid = {valid_q, valid_i};
  always_ff @(posedge clk_i) valid_q <= rst_ni ? valid[Stages-1:0] : '0;

  // Magnitude.
  logic [RayDirBits-1:0] s0_mag, mag;
  logic                  mag_short;

  assign s0_mag = d_i[RayDirBits-1] ? $unsigned(-d_i) : $unsigned(d_i);

  rc_path_register #(.Width(RayDirBits + 1)) u_mag (
    .clk_i, .data_i({short_i, s0_mag}), .data_o({mag_short, mag}));

  // Its bit length, and the left shift that sets its top bit. len_full counts a short direction
  // (DirBits) as if it had RayDirBits bits.
  logic [ExpBits-1:0]    mag_len, mag_up, len, len_full, len_up;
  logic [RayDirBits-1:0] len_mag;
  logic                  mag_power, len_power;   // a power of two, or zero
  logic                  len_short;

  always_comb begin
    mag_len = '0;
    mag_up  = ExpBits'(RayDirBits);
    if (valid[rc_pkg::PathCut]) begin
      for (int i = 0; i < RayDirBits; i++) begin
        if (mag[i]) begin
          mag_len = ExpBits'(i + 1);
          mag_up  = ExpBits'(RayDirBits - 1 - i);
        end
      end
    end
  end

  assign mag_power = (mag & (mag - 1'b1)) == '0;

  rc_path_register #(.Width(RayDirBits + 2 * ExpBits + 2)) u_len (
    .clk_i, .data_i({mag, mag_short, mag_len, mag_up, mag_power}),
    .data_o({len_mag, len_short, len, len_up, len_power}));

  assign len_full = len_short && len != '0 ? len + ExpBits'(RayDirBits - rc_pkg::DirBits) : len;

  // The shift, first by multiples of four, then by the remaining two bits.
  logic [RayDirBits-1:0] coarse_mag, coarse, fine_m;
  logic [ExpBits-1:0]    coarse_full;
  logic [1:0]            coarse_up;
  logic                  coarse_power;

  assign coarse_mag = len_mag << {len_up[ExpBits-1:2], 2'b00};

  rc_path_register #(.Width(RayDirBits + ExpBits + 3)) u_coarse (
    .clk_i, .data_i({coarse_mag, len_full, len_up[1:0], len_power}),
    .data_o({coarse, coarse_full, coarse_up, coarse_power}));

  assign fine_m = coarse << coarse_up;

  // Top bit of the quotient: it is set only for a power of two, which divides exactly.
  logic                  top_q;
  logic [RayDirBits-1:0] m_q, rem_q;
  logic [ExpBits-1:0]    len_q;

  always_ff @(posedge clk_i) begin
    if (valid[Moved-1]) begin
      m_q   <= fine_m;
      len_q <= coarse_full;
      top_q <= coarse_power;
      rem_q <= coarse_power ? '0 : {1'b1, {(RayDirBits-1){1'b0}}};
    end
  end

  // The other R bits. With two bits per stage and an odd R there is one bit too many, dropped
  // below.
  logic [Bits*DivStages-1:0] quo;
  logic                      inexact;

  rc_divide #(.Width(RayDirBits), .Stages(DivStages), .Bits(Bits), .Every(Every), .Lows(0))
  u_divide (
    .clk_i, .valid_i(valid[Moved]), .rem_i(rem_q), .low_i((Bits*DivStages)'(0)),
    .den_i(m_q), .quo_o(quo), .inexact_o(inexact));

  // Bit length and top bit are delayed to match the divider.
  logic top;

  rc_interval_delay #(.Width(ExpBits + 1), .Stages(DivStages), .Every(Every)) u_wait (
    .clk_i, .rst_ni, .enable_i(valid[Stages-1:Moved]), .valid_i(valid[Stages-1:Moved]),
    .data_i({top_q, len_q}), .data_o({top, len_o}));

  assign recip_o = len_o == '0 ? {{R{1'b0}}, 1'b1} : {top, quo[Bits*DivStages-1 -: R]};

  logic unused;
  assign unused = ^{inexact, quo[0], valid[Stages]};
endmodule
`default_nettype wire

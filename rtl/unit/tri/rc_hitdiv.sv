// Distance and barycentrics of a hit. t = ceil(2^(M-1+F) num / den), saturated at all ones. u and v
// are floor(2^BaryBits u / det) and floor(2^BaryBits v / det). Part of rc_tri.
//
// The user ensures den, det > 0, num > 0 and 0 <= u, v <= det. With planes u and v are arbitrary,
// as magnitude and sign. The answer is then in two's complement and saturates at both ends.
//
// Latency rc_pkg::HitdivStages, throughput 1 every rc_pkg::TriInterval cycles: that many steps
// share a stage of a divider. A stage works only if enable_i came with its operands.
`default_nettype none
module rc_hitdiv #(
  parameter  int unsigned DenW     = 8,         // bits of den, at least those of det
  localparam int unsigned EdgeBits = rc_pkg::EdgeBits,
  localparam int unsigned NumBits  = rc_pkg::NumBits,
  localparam int unsigned TBits    = rc_pkg::TBits,
  localparam int unsigned BaryBits = rc_pkg::BaryBits,
  localparam int unsigned UvBits   = rc_pkg::UvBits,
  localparam int unsigned WholeW   = UvBits - 1 - BaryBits,  // whole bits of u and v of a plane
  localparam int unsigned Stages   = rc_pkg::HitdivStages
) (
  input  logic                clk_i,
  input  logic                enable_i,
  input  logic                valid_i,   // the valid bit alone; enable_i may be set without a hit
  // Operands
  input  logic [NumBits-1:0]  num_i,
  input  logic [DenW-1:0]     den_i,
  input  logic [EdgeBits-1:0] det_i,
  input  logic [EdgeBits-1:0] u_i,
  input  logic [EdgeBits-1:0] v_i,
  input  logic                u_neg_i,   // if WholeW > 0
  input  logic                v_neg_i,
  // Quotients
  output logic [TBits-1:0]    t_o,
  output logic [UvBits-1:0]   u_o,
  output logic [UvBits-1:0]   v_o
);
  localparam int unsigned Cut       = rc_pkg::PathCut;
  localparam int unsigned Bits      = rc_pkg::HitBits;    // quotient bits per stage
  localparam int unsigned DivStages = Stages - 2 * Cut;   // stages of the division
  localparam int unsigned Every     = rc_pkg::TriInterval;
  // Quotient bits, at least TBits and BaryBits.
  localparam int unsigned QuoW      = Bits * DivStages;

  // num * 2^(M-1+F) * 2^(QuoW-TBits) / den in QuoW bits. The dividend above the quotient's bits is
  // num * 2^(M-1+F-TBits). That is num shifted left by M - N - 3, or right if that is negative.
  localparam int unsigned Left    = rc_pkg::DirBits > rc_pkg::CoordBits + 3
                                 ? rc_pkg::DirBits - rc_pkg::CoordBits - 3 : 0;
  localparam int unsigned Right   = rc_pkg::CoordBits + 3 > rc_pkg::DirBits
                                 ? rc_pkg::CoordBits + 3 - rc_pkg::DirBits : 0;
  localparam int unsigned WideW   = (NumBits + Left > DenW ? NumBits + Left : DenW) + 1;

  // Dividend of t.
  logic [WideW-1:0] num_wide, num_above;
  logic [QuoW-1:0]  num_below;
  logic             beyond;

  assign num_wide  = {{(WideW-NumBits){1'b0}}, num_i} << Left;
  assign num_above = num_wide >> Right;
  assign beyond    = num_above >= {{(WideW-DenW){1'b0}}, den_i};

  if (Right > 0) begin : gen_below
    assign num_below = {num_i[Right-1:0], {(QuoW-Right){1'b0}}};
  end else begin : gen_nothing_below
    assign num_below = '0;
  end

  // enable[i]: the register after stage i accepts its input.
  logic [Stages-1:0] enable_q;
  logic [Stages:0]   enable;

  assign enable = {enable_q, enable_i};

  always_ff @(posedge clk_i) enable_q <= enable[Stages-1:0];

  // Begin of the dividers. If they make several steps per stage, the valid bit alone is needed.
  logic valid, begins;

  rc_path_register #(.Width(1)) u_valid (.clk_i, .data_i(valid_i), .data_o(valid));

  assign begins = Every > 1 ? valid : enable[Cut];

  // t.
  logic [DenW-1:0] t_rem, t_den;
  logic [QuoW-1:0] t_below, t_quo;
  logic            t_inexact;

  // A quotient that overflows becomes all ones at the end. A fast chip does not clear the dividend
  // before, because each bit of num would depend on the comparison.
  rc_path_register #(.Width(2 * DenW + QuoW)) u_t_first (
    .clk_i, .data_i({beyond && Cut == 0 ? '0 : num_above[DenW-1:0], den_i, num_below}),
    .data_o({t_rem, t_den, t_below}));

  rc_divide #(.Width(DenW), .Stages(DivStages), .Bits(Bits), .Every(Every), .Lows(Right)) u_t (
    .clk_i, .valid_i(begins), .rem_i(t_rem), .low_i(t_below), .den_i(t_den),
    .quo_o(t_quo), .inexact_o(t_inexact));

  // u and v have fewer bits: they are ready earlier, and wait for t. Their quotients have WholeW +
  // BaryBits bits and one more: without planes for u = det, with planes for saturation.
  localparam int unsigned Short  = (WholeW + BaryBits + Bits - 1) / Bits;
  localparam int unsigned Rest   = DivStages - Short;
  localparam int unsigned ShortW = Bits * Short;

  logic [EdgeBits-1:0] u_above, v_above;
  logic [ShortW-1:0]   u_below, v_below, u_quo, v_quo;
  logic                u_top, v_top, u_inexact, v_inexact;

  if (WholeW > 0) begin : gen_whole
    assign u_above = u_i >> WholeW;
    assign v_above = v_i >> WholeW;
    logic [EdgeBits+WholeW-1:0] u_wide, v_wide;   // small formats have fewer than WholeW bits
    assign u_wide  = {{WholeW{1'b0}}, u_i};
    assign v_wide  = {{WholeW{1'b0}}, v_i};
    assign u_below = {u_wide[WholeW-1:0], {(ShortW-WholeW){1'b0}}};
    assign v_below = {v_wide[WholeW-1:0], {(ShortW-WholeW){1'b0}}};

    logic unused;
    assign unused  = ^{u_wide, v_wide};

    assign u_top   = u_above >= det_i;
    assign v_top   = v_above >= det_i;
  end else begin : gen_no_whole
    assign u_above = u_i;
    assign v_above = v_i;
    assign u_below = '0;
    assign v_below = '0;
    assign u_top   = u_i == det_i;
    assign v_top   = v_i == det_i;
  end

  logic [EdgeBits-1:0] u_rem, v_rem, uv_den;
  logic [ShortW-1:0]   u_low, v_low;

  rc_path_register #(.Width(3 * EdgeBits + 2 * ShortW)) u_uv_first (
    .clk_i, .data_i({u_top ? '0 : u_above, v_top ? '0 : v_above, det_i, u_below, v_below}),
    .data_o({u_rem, v_rem, uv_den, u_low, v_low}));

  rc_divide #(
    .Width(EdgeBits), .Stages(Short), .Bits(Bits), .Every(Every), .Lows(WholeW), .Apart(Cut == 1)
  ) u_u (
    .clk_i, .valid_i(begins), .rem_i(u_rem), .low_i(u_low), .den_i(uv_den),
    .quo_o(u_quo), .inexact_o(u_inexact));

  rc_divide #(
    .Width(EdgeBits), .Stages(Short), .Bits(Bits), .Every(Every), .Lows(WholeW), .Apart(Cut == 1)
  ) u_v (
    .clk_i, .valid_i(begins), .rem_i(v_rem), .low_i(v_low), .den_i(uv_den),
    .quo_o(v_quo), .inexact_o(v_inexact));

  // A negative quotient is rounded down as well: -q, or -q - 1 if a remainder is left.
  localparam int unsigned UvW = WholeW + BaryBits + (WholeW > 0 ? 1 : 0);

  logic [2:0]       end_flags;
  logic [2*UvW-1:0] short_uv, end_uv;

  rc_shift_register #(.Width(3), .Stages(Stages)) u_flags (
    .clk_i, .enable_i(enable[Stages-1:0]), .data_i({beyond, u_top, v_top}), .data_o(end_flags));

  if (WholeW > 0) begin : gen_signed
    logic              u_many, u_neg, v_many, v_neg, u_rest, v_rest, u_left, v_left;
    logic [UvBits-2:0] u_whole, v_whole;
    logic [UvBits-1:0] u_size, v_size, u_end, v_end;

    rc_shift_register #(.Width(4), .Stages(2 * Cut + Short)) u_how (
      .clk_i, .enable_i(enable[2*Cut+Short-1:0]), .data_i({u_top, u_neg_i, v_top, v_neg_i}),
      .data_o({u_many, u_neg, v_many, v_neg}));

    assign u_rest = u_inexact || (ShortW > WholeW + BaryBits && u_quo[0]);
    assign v_rest = v_inexact || (ShortW > WholeW + BaryBits && v_quo[0]);

    rc_path_register #(.Width(2 * UvBits)) u_left_over (
      .clk_i,
      .data_i({u_rest, v_rest, u_quo[ShortW-1 -: WholeW+BaryBits],
               v_quo[ShortW-1 -: WholeW+BaryBits]}),
      .data_o({u_left, v_left, u_whole, v_whole}));

    assign u_size   = {1'b0, u_whole};
    assign v_size   = {1'b0, v_whole};

    assign u_end    = u_neg ? ~u_size + {{(UvBits-1){1'b0}}, !u_left} : u_size;
    assign v_end    = v_neg ? ~v_size + {{(UvBits-1){1'b0}}, !v_left} : v_size;

    assign short_uv = {u_many ? {u_neg, {(UvBits-1){!u_neg}}} : u_end,
                       v_many ? {v_neg, {(UvBits-1){!v_neg}}} : v_end};
  end else begin : gen_positive
    rc_path_register #(.Width(2 * BaryBits)) u_whole (
      .clk_i, .data_i({u_quo[ShortW-1 -: BaryBits], v_quo[ShortW-1 -: BaryBits]}),
      .data_o(short_uv));

    logic unused;
    assign unused = ^{u_neg_i, v_neg_i, u_inexact, v_inexact};
  end

  if (Rest == 0) begin : gen_no_wait
    assign end_uv = short_uv;
  end else begin : gen_wait
    rc_shift_register #(.Width(2 * UvW), .Stages(Rest)) u_uv (
      .clk_i, .enable_i(enable[Stages-1:Stages-Rest]), .data_i(short_uv), .data_o(end_uv));
  end

  // t, rounded up.
  logic             end_beyond, end_u_top, end_v_top, t_rest, t_up;
  logic [TBits-1:0] t_down;

  assign {end_beyond, end_u_top, end_v_top} = end_flags;

  if (QuoW > TBits) begin : gen_spare_bits
    assign t_rest = t_inexact || t_quo[QuoW-TBits-1:0] != '0;
  end else begin : gen_exact_bits
    assign t_rest = t_inexact;
  end

  rc_path_register #(.Width(TBits + 1)) u_t_last (
    .clk_i, .data_i({t_rest, t_quo[QuoW-1 -: TBits]}), .data_o({t_up, t_down}));

  assign t_o = end_beyond || (&t_down) ? '1 : t_down + {{(TBits-1){1'b0}}, t_up};

  if (WholeW > 0) begin : gen_end
    assign {u_o, v_o} = end_uv;
    logic unused;
    assign unused = ^{end_u_top, end_v_top};
  end else begin : gen_end_one
    assign u_o = {end_u_top, end_uv[2*BaryBits-1 -: BaryBits]};
    assign v_o = {end_v_top, end_uv[BaryBits-1:0]};
  end

  logic unused;
  assign unused = ^{u_quo, v_quo, num_above[WideW-1:DenW], enable[Stages]};
endmodule
`default_nettype wire

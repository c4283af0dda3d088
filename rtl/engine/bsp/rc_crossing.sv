// One plane of a slant, in any direction. It decides whether the ray may be on the side that it
// meets first (near), and on the other side (far). It also gives the end of the near side, rounded
// up, and the start of the far side, rounded down.
//
// Part of rc_slant, which has the valid bits. Operands come with valid_i[0]; the answer comes
// rc_pkg::CrossingStages later.
//
// at - n . o and n . d are exact. So the origin's side and the ray's direction relative to the
// plane are exact decisions. Only for the time both are truncated to CrossingBits; the error of
// their quotient is then below 2. Model: crossing() in model/engine/bsp/slant.hpp, which has the
// formulas.
`default_nettype none
module rc_crossing #(
  localparam int unsigned OriginWidth     = rc_pkg::OriginWidth,
  localparam int unsigned RayDirBits      = rc_pkg::RayDirBits,
  localparam int unsigned NormalStepBits  = rc_pkg::NormalStepBits,
  localparam int unsigned PlaneOffsetBits = rc_pkg::PlaneOffsetBits,
  localparam int unsigned TBits           = rc_pkg::TBits,
  localparam int unsigned Stages          = rc_pkg::CrossingStages
) (
  input  logic                              clk_i,
  input  logic [Stages-1:0]                 valid_i,      // valid_i[i]: stage i holds a slant
  // Ray: origin and direction
  input  logic [3*OriginWidth-1:0]          s0_o_i,
  input  logic [3*RayDirBits-1:0]           s0_along_i,
  // Plane: normal n and offset
  input  logic [3*NormalStepBits-1:0]       s0_normal_i,
  input  logic signed [PlaneOffsetBits-1:0] s0_at_i,
  // Result
  output logic                              turned_o,     // the ray meets the upper side first
  output logic                              near_o,
  output logic                              far_o,
  output logic [TBits-1:0]                  near_to_o,
  output logic [TBits-1:0]                  far_from_o
);
  localparam int unsigned Frac      = OriginWidth - rc_pkg::CoordBits;   // of the origin
  localparam int unsigned NumW      = PlaneOffsetBits + Frac + 1;        // at - n . o, signed
  localparam int unsigned DenW      = RayDirBits + NormalStepBits + 1;   // n . d, signed
  localparam int unsigned QuotientW = rc_pkg::CrossingBits;
  localparam int unsigned LengthW   = 6;                        // a length; a right shift
  localparam int unsigned ShiftW    = 8;                        // bits of a shift, signed
  localparam int unsigned Mul       = rc_pkg::MulStages;
  localparam int unsigned Cut       = rc_pkg::PathCut;
  localparam int unsigned Div       = QuotientW / rc_pkg::QuotientBits;

  // The answer, except for the times.
  typedef struct packed {
    logic turned;    // the ray meets the upper side first
    logic on_near;   // the ray may be on the side that it meets first
    logic on_far;    // the ray may be on the other side
    logic timed;     // the ray crosses the plane ahead of its origin
  } flags_t;
  localparam int unsigned FlagsW = 4;

  // Stages: products, their sums, truncated magnitudes, the quotient; then its shift.
  localparam int unsigned Product = Mul + 1;
  localparam int unsigned Sum     = Product + 1 + Cut;
  localparam int unsigned Size    = Sum + 1 + 3 * Cut;

  // 2^TBits times the quotient is shifted right by TBits - x, where x = F + RayDirBits - Frac -
  // QuotientW plus the difference of the lengths.
  localparam logic signed [ShiftW-1:0] RightBase =
      ShiftW'(TBits) + ShiftW'(Frac) + ShiftW'(QuotientW) - ShiftW'(rc_pkg::TFracBits)
      - ShiftW'(RayDirBits);

  // The products of n . o and n . d.
  logic [3*NumW-1:0] origin_q;
  logic [3*DenW-1:0] along_q;

  for (genvar k = 0; k < 3; k++) begin : gen_axis
    logic signed [NormalStepBits-1:0]             normal;
    logic signed [OriginWidth-1:0]                o;
    logic signed [RayDirBits-1:0]                 along;
    logic signed [OriginWidth+NormalStepBits-1:0] origin_product;
    logic signed [RayDirBits+NormalStepBits-1:0]  along_product;

    assign normal = s0_normal_i[k*NormalStepBits +: NormalStepBits];
    assign o      = s0_o_i[k*OriginWidth +: OriginWidth];
    assign along  = s0_along_i[k*RayDirBits +: RayDirBits];

    rc_mul #(.AW(OriginWidth), .BW(NormalStepBits)) u_origin (
      .clk_i, .a_i(o), .b_i(normal), .p_o(origin_product));
    rc_mul #(.AW(RayDirBits), .BW(NormalStepBits)) u_along (
      .clk_i, .a_i(along), .b_i(normal), .p_o(along_product));

    always_ff @(posedge clk_i) begin
      if (valid_i[Product-1]) begin
        origin_q[k*NumW +: NumW] <= NumW'(origin_product);
        along_q[k*DenW +: DenW]  <= DenW'(along_product);
      end
    end
  end

  logic signed [PlaneOffsetBits-1:0] at, at_q;

  rc_path_register #(.Width(PlaneOffsetBits), .Stages(Mul)) u_at (
    .clk_i, .data_i(s0_at_i), .data_o(at));
  always_ff @(posedge clk_i) if (valid_i[Product-1]) at_q <= at;

  // Their sums: num = at - n . o, den = n . d.
  logic [NumW-1:0] num_less, num_more, num_two, num_rest, num_q;
  logic [DenW-1:0] den_one, den_two, den_rest, den_q;

  assign num_less = origin_q[0 +: NumW] + origin_q[NumW +: NumW];
  assign num_more = $unsigned(NumW'(at_q) <<< Frac) - origin_q[2*NumW +: NumW];
  assign den_one  = along_q[0 +: DenW] + along_q[DenW +: DenW];

  rc_path_register #(.Width(2 * NumW + 2 * DenW)) u_two (
    .clk_i, .data_i({num_less, num_more, den_one, along_q[2*DenW +: DenW]}),
    .data_o({num_two, num_rest, den_two, den_rest}));

  always_ff @(posedge clk_i) begin
    if (valid_i[Sum-1]) begin
      num_q <= num_rest - num_two;
      den_q <= den_two + den_rest;
    end
  end

  // Both along the ray. If the ray does not approach the plane, only the origin's side matters.
  logic            neg, zero, ahead, on, near, far, timed;
  logic [NumW-1:0] num;
  logic [NumW-2:0] num_abs, num_size;
  logic [DenW-1:0] den;
  logic [DenW-2:0] den_abs, den_size;
  flags_t          new_flags, flags;

  assign neg   = den_q[DenW-1];
  assign zero  = den_q == '0;
  assign num   = neg ? -num_q : num_q;
  assign den   = neg ? -den_q : den_q;
  assign on    = num_q == '0;
  assign ahead = !on && num_q[NumW-1] == neg;
  assign near  = zero ? ahead || on : ahead;
  assign far   = !zero || !ahead;
  assign timed = !zero && ahead;

  assign new_flags = {neg, near, far, timed};

  rc_path_register #(.Width(NumW + DenW - 2 + FlagsW)) u_abs (
    .clk_i, .data_i({num[NumW-2:0], den[DenW-2:0], new_flags}),
    .data_o({num_abs, den_abs, flags}));

  // Their bit lengths, then their highest QuotientW bits: the shift is first by a multiple of
  // eight, then by the remaining three bits.
  logic [LengthW-1:0] num_len, den_len, num_long, den_long, num_short, den_short, num_up, den_up;
  logic [2:0]      num_fine, den_fine;
  logic [NumW-2:0] num_coarse, num_rough, num_top;
  logic [DenW-2:0] den_coarse, den_rough, den_top;
  logic signed [ShiftW-1:0] right;
  logic [LengthW-1:0]    size_right, rough_right, right_q;
  flags_t                len_flags, rough_flags, flags_q;
  logic [QuotientW-1:0]  dividend_q, divisor_q;

  always_comb begin
    num_len = '0;
    den_len = '0;
    for (int i = 0; i < NumW - 1; i++) if (num_abs[i]) num_len = LengthW'(i + 1);
    for (int i = 0; i < DenW - 1; i++) if (den_abs[i]) den_len = LengthW'(i + 1);
  end

  rc_path_register #(.Width(NumW + DenW - 2 + 2 * LengthW + FlagsW)) u_len (
    .clk_i, .data_i({num_abs, den_abs, num_len, den_len, flags}),
    .data_o({num_size, den_size, num_long, den_long, len_flags}));

  assign num_short = LengthW'(NumW - 1) - num_long;
  assign den_short = LengthW'(DenW - 1) - den_long;

  assign right = RightBase + $signed({{(ShiftW-LengthW){1'b0}}, den_long})
                               - $signed({{(ShiftW-LengthW){1'b0}}, num_long});
  assign size_right = right[ShiftW-1] ? '0
                    : right > $signed(ShiftW'(63)) ? LengthW'(63) : right[LengthW-1:0];

  assign num_up     = {num_short[LengthW-1:3], 3'd0};
  assign den_up     = {den_short[LengthW-1:3], 3'd0};
  assign num_coarse = num_size << num_up;
  assign den_coarse = den_size << den_up;

  rc_path_register #(.Width(NumW + DenW - 2 + 6 + LengthW + FlagsW)) u_coarse (
    .clk_i,
    .data_i({num_coarse, den_coarse, num_short[2:0], den_short[2:0], size_right, len_flags}),
    .data_o({num_rough, den_rough, num_fine, den_fine, rough_right, rough_flags}));

  assign num_top = num_rough << num_fine;
  assign den_top = den_rough << den_fine;

  always_ff @(posedge clk_i) begin
    if (valid_i[Size-1]) begin
      dividend_q <= num_top[NumW-2 -: QuotientW];
      divisor_q  <= den_top[DenW-2 -: QuotientW];
      right_q    <= rough_right;
      flags_q    <= rough_flags;
    end
  end

  // quo = 2^(QuotientW-1) num / den.
  logic [QuotientW-1:0] quo;
  logic [LengthW-1:0]   quo_right;
  flags_t               quo_flags;
  logic                 inexact;

  rc_divide #(.Width(QuotientW), .Stages(Div), .Bits(rc_pkg::QuotientBits)) u_divide (
    .clk_i, .valid_i(valid_i[Size]), .rem_i({1'b0, dividend_q[QuotientW-1:1]}),
    .low_i({dividend_q[0], {(QuotientW-1){1'b0}}}), .den_i(divisor_q), .quo_o(quo),
    .inexact_o(inexact));

  rc_path_register #(.Width(LengthW + FlagsW), .Stages(Div)) u_beside (
    .clk_i, .data_i({right_q, flags_q}), .data_o({quo_right, quo_flags}));

  // The times: quo - 2 and quo + 2, shifted to t's unit. An overflow at the top saturates.
  logic [QuotientW:0]         from_end, to_end, from_d, to_d, over;
  logic [LengthW-1:0]         end_right;
  flags_t                     end_flags, place_flags, out_flags;
  logic [QuotientW+TBits:0]   from_moved, to_moved;
  logic [TBits+6:0]           from_rest, to_rest, from_fine, to_fine;
  logic                       from_over, to_over, from_many, to_many, from_most, to_most;
  logic [2:0]                 fine;
  logic [TBits-1:0]           from_t, to_t;

  assign from_d = {1'b0, quo} - (QuotientW+1)'(2);
  assign to_d   = {1'b0, quo} + (QuotientW+1)'(2);

  rc_path_register #(.Width(2 * (QuotientW + 1) + LengthW + FlagsW)) u_ends (
    .clk_i, .data_i({from_d, to_d, quo_right, quo_flags}),
    .data_o({from_end, to_end, end_right, end_flags}));

  assign over       = {(QuotientW+1){1'b1}} << end_right;
  assign from_moved = {from_end, {TBits{1'b0}}} >> {end_right[LengthW-1:3], 3'd0};
  assign to_moved   = {to_end, {TBits{1'b0}}} >> {end_right[LengthW-1:3], 3'd0};
  assign from_over  = |(from_end & over);
  assign to_over    = |(to_end & over);

  rc_path_register #(.Width(2 * (TBits + 7) + 5 + FlagsW)) u_place (
    .clk_i,
    .data_i({from_moved[TBits+6:0], to_moved[TBits+6:0], from_over, to_over, end_right[2:0],
             end_flags}),
    .data_o({from_rest, to_rest, from_many, to_many, fine, place_flags}));

  assign from_fine = from_rest >> fine;
  assign to_fine   = to_rest >> fine;

  rc_path_register #(.Width(2 * TBits + 2 + FlagsW)) u_fine (
    .clk_i, .data_i({from_fine[TBits-1:0], to_fine[TBits-1:0], from_many, to_many, place_flags}),
    .data_o({from_t, to_t, from_most, to_most, out_flags}));

  always_ff @(posedge clk_i) begin
    if (valid_i[Stages-1]) begin
      turned_o   <= out_flags.turned;
      near_o     <= out_flags.on_near;
      far_o      <= out_flags.on_far;
      far_from_o <= out_flags.timed ? from_t | {TBits{from_most}} : '0;
      near_to_o  <= !out_flags.timed || to_most || &to_t ? '1 : to_t + TBits'(1);
    end
  end

  logic unused;
  assign unused = ^{valid_i, num[NumW-1], den[DenW-1], num_top[NumW-2-QuotientW:0],
                    den_top[DenW-2-QuotientW:0], inexact, from_moved[QuotientW+TBits:TBits+7],
                    to_moved[QuotientW+TBits:TBits+7], from_fine[TBits+6:TBits],
                    to_fine[TBits+6:TBits]};
endmodule
`default_nettype wire

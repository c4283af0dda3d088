// One plane of a treelet: whether the ray may be on the side that it meets first (near), and on the
// other side (far). It also gives the end of the near side, rounded up, and the start of the far
// side, rounded down.
//
// Part of rc_treelet, rc_bih and rc_bounds, which have the valid bits. Operands come with
// valid_i[0]; the answer comes rc_pkg::PlaneStages later.
//
// way is the distance to the plane in lattice steps, rounded down. far_from is floor(2^shift r
// way). One shift serves both times: near_to is far_from plus these bounds:
// - far_from / 2^(R-1);
// - the rounding errors;
// - if the origin lies between lattice points, at least the time of one lattice step, 2^(shift +
//   R).
//
// Model: plane_sides() in model/engine/space_cells/decide.hpp, which has the formulas.
`default_nettype none
module rc_plane #(
  parameter  bit          HasTo = 1'b1,   // 0: near_to_o is always the latest time
  localparam int unsigned N           = rc_pkg::CoordBits,
  localparam int unsigned OriginWidth = rc_pkg::OriginWidth,
  localparam int unsigned R1          = rc_pkg::RecipBits + 1,
  localparam int unsigned ExpBits     = rc_pkg::ExpBits,
  localparam int unsigned TBits       = rc_pkg::TBits,
  localparam int unsigned Stages      = rc_pkg::PlaneStages
) (
  input  logic                     clk_i,
  input  logic [Stages-1:0]        valid_i,   // valid_i[i]: stage i holds a node
  // Ray: origin, signs, reciprocals and lengths of its direction
  input  logic [3*OriginWidth-1:0] s0_o_i,
  input  logic [2:0]               s0_neg_i,
  input  logic [3*R1-1:0]          s0_recip_i,
  input  logic [3*ExpBits-1:0]     s0_len_i,
  // Plane
  input  logic [1:0]               s0_axis_i,
  input  logic signed [N-1:0]      s0_at_i,
  // Result
  output logic                     turned_o,  // the ray meets the upper side first
  output logic                     near_o,
  output logic                     far_o,
  output logic [TBits-1:0]         near_to_o,
  output logic [TBits-1:0]         far_from_o
);

  localparam int unsigned DistanceW = N + 1;        // distance to the plane, signed
  localparam int unsigned ProductW  = N + R1 - 1;   // times r <= 2^R, if not negative
  localparam int unsigned Mul       = rc_pkg::MulStages;
  localparam int unsigned Cut       = rc_pkg::PathCut;

  // Stages: the distance; then its product, shifted; then both times.
  localparam int unsigned Way = 1 + Cut;
  localparam int unsigned End = Way + Mul + 1 + Cut;

  // shift = F + M - R - len, where M is the width of a ray's direction. 2^(F+M-R) times the
  // product, rounded down if necessary, is shifted right by len.
  localparam int unsigned Time  = rc_pkg::TFracBits + rc_pkg::RayDirBits;
  localparam int unsigned Up    = Time > R1 - 1 ? Time - (R1 - 1) : 0;
  localparam int unsigned Down  = Time > R1 - 1 ? 0 : R1 - 1 - Time;
  localparam int unsigned BaseW = ProductW + Up;
  localparam int unsigned Parts = 1 << (ExpBits - 3);

  // s0: the ray's components on the plane's axis.
  logic [OriginWidth-1:0] s0_o;
  logic                   s0_neg;
  logic [R1-1:0]          s0_r;
  logic [ExpBits-1:0]     s0_len;

  always_comb begin
    s0_o   = '0;
    s0_neg = 1'b0;
    s0_r   = '0;
    s0_len = '0;
    for (int k = 0; k < 3; k++) begin
      if (s0_axis_i == 2'(k)) begin
        s0_o   = s0_o_i[k*OriginWidth +: OriginWidth];
        s0_neg = s0_neg_i[k];
        s0_r   = s0_recip_i[k*R1 +: R1];
        s0_len = s0_len_i[k*ExpBits +: ExpBits];
      end
    end
  end

  // The lattice point below the origin, and whether the origin lies above that point.
  logic signed [N-1:0] s0_point;
  logic                s0_between;

  assign s0_point = s0_o[OriginWidth-1 -: N];

  if (rc_pkg::OriginBits == 0) begin : gen_on_lattice
    assign s0_between = 1'b0;
  end else begin : gen_between
    assign s0_between = |s0_o[OriginWidth-N-1:0];
  end
  logic          way_neg, way_zero, way_whole, way_between;   // whole: no plane
  logic signed [N-1:0] way_point, way_at;
  logic [R1-1:0]      way_r;
  logic [ExpBits-1:0] way_len;

  rc_path_register #(.Width(4 + 2 * N + R1 + ExpBits)) u_axis (
    .clk_i,
    .data_i({s0_neg, s0_len == '0, s0_axis_i == 2'd3, s0_between, s0_point, s0_at_i, s0_r,
             s0_len}),
    .data_o({way_neg, way_zero, way_whole, way_between, way_point, way_at, way_r, way_len}));

  // The distance to the plane, rounded down along the ray.
  logic signed [DistanceW-1:0] way, way_q;
  logic                     neg_q, zero_q, whole_q, between_q;
  logic [R1-1:0]            r_q;
  logic [ExpBits-1:0]       len_q;

  assign way = way_neg ? DistanceW'(way_point) - DistanceW'(way_at)
                       : DistanceW'(way_at) - DistanceW'(way_point)
                           - $signed({{(DistanceW-1){1'b0}}, way_between});

  always_ff @(posedge clk_i) begin
    if (valid_i[Way-1]) begin
      way_q     <= way;
      neg_q     <= way_neg;
      zero_q    <= way_zero;
      whole_q   <= way_whole;
      between_q <= way_between;
      r_q       <= way_r;
      len_q     <= way_len;
    end
  end

  // The sides that exist. A ray that does not move on this axis has the origin's side, or both.
  logic ahead, at_or_ahead, s_near, s_far, s_timed;

  assign at_or_ahead = !way_q[DistanceW-1];
  assign ahead       = at_or_ahead && (between_q || way_q != '0);   // the way rounded up is
  assign s_near      = whole_q || (zero_q ? at_or_ahead : ahead);
  assign s_far       = whole_q || !zero_q || !ahead;
  assign s_timed     = !whole_q && !zero_q && ahead;

  // Product of the distance and the reciprocal.
  logic signed [DistanceW+R1:0] product;
  rc_mul #(.AW(DistanceW), .BW(R1 + 1)) u_product (
    .clk_i, .a_i(way_q), .b_i($signed({1'b0, r_q})), .p_o(product));

  logic [ExpBits-1:0] product_len;
  logic               product_between, product_neg, product_near, product_far, product_timed;

  rc_path_register #(.Width(ExpBits + 5), .Stages(Mul)) u_beside (
    .clk_i,
    .data_i({len_q, between_q, neg_q && !zero_q && !whole_q, s_near, s_far, s_timed}),
    .data_o({product_len, product_between, product_neg, product_near, product_far, product_timed}));

  // The shift, first by a multiple of eight, then by the remaining three bits. An overflow at the
  // top saturates: part[i] is set if a shift by 8 i leaves bits above `rest`.
  logic [ProductW-1:0] low;
  logic [BaseW-1:0]   base, moved;
  logic [Parts-1:0]   part;
  logic [TBits+6:0]   rest, fine;
  logic [ExpBits-1:0] rest_len, end_len_q;
  logic [TBits-1:0]   from_q;
  logic               rest_many, rest_between, rest_neg, rest_near, rest_far, rest_timed;
  logic               between_end_q, neg_end_q, near_end_q, far_end_q, timed_end_q;

  assign low   = product[ProductW-1:0] >> Down;
  assign base  = BaseW'(low) << Up;
  assign moved = base >> {product_len[ExpBits-1:3], 3'd0};

  for (genvar i = 0; i < Parts; i++) begin : gen_part
    if (TBits + 7 + 8 * i < BaseW) begin : gen_above
      assign part[i] = |base[BaseW-1:TBits+7+8*i];
    end else begin : gen_nothing
      assign part[i] = 1'b0;
    end
  end

  rc_path_register #(.Width(TBits + 7 + ExpBits + 6)) u_coarse (
    .clk_i,
    .data_i({moved[TBits+6:0], product_len, part[product_len[ExpBits-1:3]], product_between,
             product_neg, product_near, product_far, product_timed}),
    .data_o({rest, rest_len, rest_many, rest_between, rest_neg, rest_near, rest_far, rest_timed}));

  assign fine = rest >> rest_len[2:0];
  always_ff @(posedge clk_i) begin
    if (valid_i[End-1]) begin
      from_q        <= fine[TBits-1:0] | {TBits{rest_many || fine[TBits+6:TBits] != '0}};
      end_len_q     <= rest_len;
      between_end_q <= rest_between;
      neg_end_q     <= rest_neg;
      near_end_q    <= rest_near;
      far_end_q     <= rest_far;
      timed_end_q   <= rest_timed;
    end
  end

  // Both times. more is the part of near_to beyond far_from. A lattice step is bit F + M - len;
  // beyond TBits it saturates.
  logic [TBits-1:0] step, more, from_late, more_late;
  logic [TBits:0]   to;
  logic             step_many, many_late, out_timed, out_neg, out_near, out_far;

  for (genvar i = 0; i < TBits; i++) begin : gen_step
    if (i >= rc_pkg::TFracBits && i < Time) begin : gen_reached
      assign step[i] = HasTo && between_end_q && end_len_q == ExpBits'(Time - i);
    end else begin : gen_beyond
      assign step[i] = 1'b0;
    end
  end

  if (Time < TBits) begin : gen_few
    assign step_many = 1'b0;
  end else begin : gen_many
    assign step_many = HasTo && between_end_q && end_len_q <= ExpBits'(Time - TBits);
  end

  assign more      = HasTo ? (from_q >> (R1 - 2)) + TBits'(2) + step : '0;

  rc_path_register #(.Width(2 * TBits + 5)) u_more (
    .clk_i,
    .data_i({from_q, more, step_many, neg_end_q, near_end_q, far_end_q, timed_end_q}),
    .data_o({from_late, more_late, many_late, out_neg, out_near, out_far, out_timed}));

  assign to = HasTo ? {1'b0, from_late} + {1'b0, more_late} : '1;
  always_ff @(posedge clk_i) begin
    if (valid_i[Stages-1]) begin
      turned_o   <= out_neg;
      near_o     <= out_near;
      far_o      <= out_far;
      far_from_o <= out_timed ? from_late : '0;
      near_to_o  <= out_timed ? to[TBits-1:0] | {TBits{to[TBits] || many_late}} : '1;
    end
  end

  logic unused;
  assign unused = ^{valid_i, product[DistanceW+R1:ProductW], moved};
endmodule
`default_nettype wire

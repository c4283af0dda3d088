// One plane of a treelet: whether the ray may be on the side that it meets first (near) and on the
// other one (far), until when on the near side, rounded up, and from when on the far side, rounded
// down. Part of rc_treelet, which has the valid bits: operands come with valid_i[0], the answer
// rc_pkg::PlaneStages later.
//
// The way to the plane is counted in lattice steps. If the origin lies between lattice points it is
// w_hi, rounded up, or w_lo = w_hi - 1. near_to is 2^shift (r + 1) w_hi, far_from 2^shift r w_lo,
// which is 2^shift (r w_hi - r): one product serves both.
// Model: plane_sides() in model/kd/treelet.hpp, which has the formulas.
`default_nettype none
module rc_plane #(
  localparam int unsigned N  = rc_pkg::CoordBits,
  localparam int unsigned OW = rc_pkg::OriginWidth,
  localparam int unsigned R1 = rc_pkg::RecipBits + 1,
  localparam int unsigned E  = rc_pkg::ExpBits,
  localparam int unsigned T  = rc_pkg::TBits,
  localparam int unsigned L  = rc_pkg::PlaneStages
) (
  input  logic                clk_i,
  input  logic [L-1:0]        valid_i,   // valid_i[i]: stage i holds a treelet
  input  logic [3*OW-1:0]     s0_o_i,
  input  logic [2:0]          s0_neg_i,
  input  logic [3*R1-1:0]     s0_recip_i,
  input  logic [3*E-1:0]      s0_len_i,
  input  logic [1:0]          s0_axis_i,
  input  logic signed [N-1:0] s0_at_i,
  output logic                turned_o,  // the ray meets the upper side first
  output logic                near_o,
  output logic                far_o,
  output logic [T-1:0]        near_to_o,
  output logic [T-1:0]        far_from_o
);
  localparam int unsigned D   = N + 2;        // the way to the plane, signed
  localparam int unsigned P   = D + R1 + 1;   // its product with r, signed
  localparam int unsigned V   = P + 1;        // and rounded up, signed
  localparam int unsigned S   = 8;            // shift, signed: -24..62
  localparam int unsigned A   = 6;            // shift to the right of 2^T times as much
  localparam int unsigned M   = rc_pkg::MulStages;
  localparam int unsigned Cut = rc_pkg::Cut;
  // Stages: the way is there, then its product, then both ends, moved to their places.
  localparam int unsigned Way = 1 + Cut;
  localparam int unsigned End = Way + M + 1 + Cut;
  // shift = F + M - len - R, M as wide as a ray's direction; the constant part:
  localparam logic signed [S-1:0] ShiftBase = S'(rc_pkg::TFracBits) + S'(rc_pkg::RayDirBits)
      - S'(rc_pkg::RecipBits);

  // s0: the plane's axis of the ray.
  logic [OW-1:0] s0_o;
  logic          s0_neg;
  logic [R1-1:0] s0_r;
  logic [E-1:0]  s0_len;
  always_comb begin
    s0_o   = '0;
    s0_neg = 1'b0;
    s0_r   = '0;
    s0_len = '0;
    for (int k = 0; k < 3; k++) begin
      if (s0_axis_i == 2'(k)) begin
        s0_o   = s0_o_i[k*OW +: OW];
        s0_neg = s0_neg_i[k];
        s0_r   = s0_recip_i[k*R1 +: R1];
        s0_len = s0_len_i[k*E +: E];
      end
    end
  end
  // The lattice point before the origin, and whether that is not the one beyond as well.
  logic signed [N-1:0] s0_point;
  logic                s0_between;
  assign s0_point = s0_o[OW-1 -: N];
  if (rc_pkg::OriginBits == 0) begin : gen_on_lattice
    assign s0_between = 1'b0;
  end else begin : gen_between
    assign s0_between = |s0_o[OW-N-1:0];
  end
  logic          way_neg, way_zero, way_whole, way_between;   // whole: no plane
  logic signed [N-1:0] way_point, way_at;
  logic [R1-1:0] way_r;
  logic [E-1:0]  way_len;
  rc_cut #(.Width(4 + 2 * N + R1 + E)) u_axis (
    .clk_i,
    .data_i({s0_neg, s0_len == '0, s0_axis_i == 2'd3, s0_between, s0_point, s0_at_i, s0_r,
             s0_len}),
    .data_o({way_neg, way_zero, way_whole, way_between, way_point, way_at, way_r, way_len}));

  // The way to the plane, rounded up, and what moves it to t's unit.
  logic signed [D-1:0] way, way_q;
  logic                neg_q, zero_q, whole_q, between_q;
  logic [R1-1:0]       r_q;
  logic signed [S-1:0] way_shift, way_right;
  logic [A-1:0]        move_q;
  assign way = way_neg ? D'(way_point) - D'(way_at)
                         + $signed({{(D-1){1'b0}}, way_between})
                       : D'(way_at) - D'(way_point);
  // 2^T times as much is moved to the right; a move to the left by T, and all beyond it, saturates.
  assign way_shift = ShiftBase - $signed({{(S-E){1'b0}}, way_len});
  assign way_right = way_shift > $signed(S'(T)) ? '0 : $signed(S'(T)) - way_shift;
  always_ff @(posedge clk_i) begin
    if (valid_i[Way-1]) begin
      way_q     <= way;
      neg_q     <= way_neg;
      zero_q    <= way_zero;
      whole_q   <= way_whole;
      between_q <= way_between;
      r_q       <= way_r;
      move_q    <= way_right[A-1:0];
    end
  end

  // Which sides there are. Of a ray that does not move on this axis the origin's side, or both.
  logic ahead, at_or_ahead, sure_behind, s_near, s_far, s_timed;
  assign ahead       = way_q > $signed(D'(0));
  assign sure_behind = way_q < $signed({{(D-1){1'b0}}, between_q});   // w_lo < 0
  assign at_or_ahead = !sure_behind;
  assign s_near      = whole_q || (zero_q ? at_or_ahead : ahead);
  assign s_far       = whole_q || !zero_q || !ahead;
  assign s_timed     = !whole_q && !zero_q && ahead;

  // r w_hi; then both ends.
  logic signed [D+R1:0] product;
  rc_mul #(.AW(D), .BW(R1 + 1)) u_product (
    .clk_i, .a_i(way_q), .b_i($signed({1'b0, r_q})), .p_o(product));
  logic signed [D-1:0] product_way;
  logic [R1-1:0]       product_r;
  logic [A-1:0]        product_move;
  logic                product_between, product_neg, product_near, product_far, product_timed;
  rc_cut #(.Width(D + R1 + A + 5), .Stages(M)) u_beside (
    .clk_i,
    .data_i({way_q, r_q, move_q, between_q, neg_q && !zero_q && !whole_q, s_near, s_far, s_timed}),
    .data_o({product_way, product_r, product_move, product_between, product_neg, product_near,
             product_far, product_timed}));
  logic [A-1:0]        product_right;
  logic [R1-1:0]       product_up;   // 2^right - 1, if it goes to the right by itself
  logic signed [V-1:0] from_d, to_d, to_cut;
  logic [V-1:0]        from_q, to_q;
  logic [A-1:0]        move_late, move_end_q;
  logic [R1-1:0]       up_late;
  logic                neg_end_q, near_end_q, far_end_q, timed_end_q;
  logic signed [V-1:0] from_late;
  logic                neg_late, near_late, far_late, timed_late;
  assign product_right = product_move > A'(T) ? product_move - A'(T) : '0;
  assign product_up    = ~({R1{1'b1}} << product_right);
  assign from_d = V'(product) - (product_between ? $signed({{(V-R1){1'b0}}, product_r}) : '0);
  assign to_d   = V'(product) + V'(product_way);
  rc_cut #(.Width(2 * V + A + R1 + 4)) u_ends (
    .clk_i,
    .data_i({from_d, to_d, product_move, product_up, product_neg, product_near, product_far,
             product_timed}),
    .data_o({from_late, to_cut, move_late, up_late, neg_late, near_late, far_late, timed_late}));
  always_ff @(posedge clk_i) begin
    if (valid_i[End-1]) begin
      from_q      <= $unsigned(from_late);
      to_q        <= $unsigned(to_cut + $signed({{(V-R1){1'b0}}, up_late}));
      move_end_q  <= move_late;
      neg_end_q   <= neg_late;
      near_end_q  <= near_late;
      far_end_q   <= far_late;
      timed_end_q <= timed_late;
    end
  end

  // What is moved off at the top saturates. By a multiple of eight first, then by what is left.
  logic [V-1:0]   over;
  logic [V+T-1:0] from_moved, to_moved;
  logic [T+6:0]   from_rest, to_rest, from_fine, to_fine;
  logic           from_over, to_over, from_many, to_many, out_timed, out_neg, out_near, out_far;
  logic [2:0]     fine;
  assign over       = {V{1'b1}} << move_end_q;
  assign from_moved = {from_q, {T{1'b0}}} >> {move_end_q[A-1:3], 3'd0};
  assign to_moved   = {to_q, {T{1'b0}}} >> {move_end_q[A-1:3], 3'd0};
  assign from_over  = |(from_q & over);
  assign to_over    = |(to_q & over);
  rc_cut #(.Width(2 * (T + 7) + 9)) u_coarse (
    .clk_i,
    .data_i({from_moved[T+6:0], to_moved[T+6:0], from_over, to_over, move_end_q[2:0], neg_end_q,
             near_end_q, far_end_q, timed_end_q}),
    .data_o({from_rest, to_rest, from_many, to_many, fine, out_neg, out_near, out_far, out_timed}));
  assign from_fine = from_rest >> fine;
  assign to_fine   = to_rest >> fine;
  always_ff @(posedge clk_i) begin
    if (valid_i[L-1]) begin
      turned_o   <= out_neg;
      near_o     <= out_near;
      far_o      <= out_far;
      far_from_o <= out_timed ? from_fine[T-1:0] | {T{from_many}} : '0;
      near_to_o  <= out_timed ? to_fine[T-1:0] | {T{to_many}} : '1;
    end
  end

  logic unused;
  assign unused = ^{valid_i, way_right[S-1:A], from_moved[V+T-1:T+7], to_moved[V+T-1:T+7],
                    from_fine[T+6:T], to_fine[T+6:T]};
endmodule
`default_nettype wire

// Ray and sphere: whether they meet is decided exactly, the distance holds a square root
// that is rounded so that t is never too small; and the comparison with the best hit. Part
// of rc_tri, which has the best hit wait. Formulas, rules, the error's bound and the proof
// of the widths: model/isect/any.hpp; model: sphere_test() in model/isect/any.cpp.
//
// Latency rc_pkg::TriLatency, throughput 1 per cycle. Best is wanted BestStage cycles after
// the sphere.
`default_nettype none
module rc_sphere #(
  localparam int unsigned N = rc_pkg::CoordBits,
  localparam int unsigned B = rc_pkg::OriginBits,
  localparam int unsigned W = rc_pkg::OriginWidth,
  localparam int unsigned H = rc_pkg::RayDirBits,
  localparam int unsigned M = rc_pkg::DirBits,
  localparam int unsigned F = rc_pkg::TFracBits,
  localparam int unsigned T = rc_pkg::TBits,
  localparam int unsigned U = rc_pkg::NumBits,
  localparam int unsigned E = rc_pkg::EdgeBits,
  localparam int unsigned RootStages = rc_pkg::RootBits / 2,
  localparam int unsigned DivStages  = (T + 1) / 2,
  localparam int unsigned Root       = 5 + RootStages,       // stage that holds the root
  localparam int unsigned BestStage  = Root + 1 + DivStages  // and the distance
) (
  input  logic           clk_i,
  input  logic           rst_ni,
  input  logic           s0_valid_i,
  input  logic           s0_any_i,      // any hit will do: a ray from or to a light
  input  logic           s0_leaves_i,   // from a surface; any that does not comes from a light
  input  logic           s0_own_i,      // the sphere on which the ray begins or ends
  input  logic           s0_inside_i,   // the ray is inside its own sphere
  input  logic [3*W-1:0] s0_o_i,
  input  logic [3*H-1:0] s0_d_i,
  input  logic [3*N-1:0] s0_c_i,        // centre
  input  logic [2*N-1:0] s0_rr_i,       // square of the radius
  input  logic           best_found_i,
  input  logic           best_first_i,  // this sphere's number is not the higher one
  input  logic [U-1:0]   best_num_i,
  input  logic [E-1:0]   best_det_i,
  output logic           closer_o,
  output logic           blocked_o,     // instead of closer, if any hit will do
  output logic           far_o,
  output logic [T-1:0]   t_o            // if closer
);
  localparam int unsigned S = W + 1;            // s
  localparam int unsigned G = 2 * M;            // d.d of all but shadow rays
  localparam int unsigned A = 2 * W + 3 > G + 1 ? 2 * W + 3 : G + 1;   // d.d, and a sign
  localparam int unsigned V = M + W + 2 > G + 1 ? M + W + 2 : G + 1;   // numerator of t; d.s of
                                                                       // all but shadow rays
  localparam int unsigned L = V > N + W + 3 ? V : N + W + 3;           // d.s
  localparam int unsigned C = 2 * W + 3;        // s.s - R2
  localparam int unsigned D = 2 * (M + W) + 2 > 2 * (N + W) + 4
                            ? 2 * (M + W) + 2 : 2 * (N + W) + 4;  // discriminant

  // ---- s1: from the centre to the origin, 2^B (o - c); in lattice steps for a shadow ray.
  logic                s1_valid_q, s1_any_q, s1_shadow_q, s1_own_q, s1_inside_q;
  logic signed [H-1:0] s1_dx_q, s1_dy_q, s1_dz_q;
  logic signed [S-1:0] s1_sx_q, s1_sy_q, s1_sz_q;
  logic [2*W-1:0]      s1_rr_q;
  logic signed [W-1:0] s0_ox, s0_oy, s0_oz;
  logic signed [N-1:0] s0_cx, s0_cy, s0_cz;
  logic signed [S-1:0] s0_sx, s0_sy, s0_sz;
  assign {s0_oz, s0_oy, s0_ox} = s0_o_i;
  assign {s0_cz, s0_cy, s0_cx} = s0_c_i;
  logic                s0_shadow;
  assign s0_shadow = s0_any_i && !s0_leaves_i;
  assign s0_sx = S'(s0_ox) - (S'(s0_cx) <<< B);
  assign s0_sy = S'(s0_oy) - (S'(s0_cy) <<< B);
  assign s0_sz = S'(s0_oz) - (S'(s0_cz) <<< B);
  always_ff @(posedge clk_i) begin
    if (s0_valid_i) begin
      {s1_dz_q, s1_dy_q, s1_dx_q} <= s0_d_i;
      s1_sx_q <= s0_shadow ? s0_sx >>> B : s0_sx;
      s1_sy_q <= s0_shadow ? s0_sy >>> B : s0_sy;
      s1_sz_q <= s0_shadow ? s0_sz >>> B : s0_sz;
      s1_rr_q <= s0_shadow ? {{(2*B){1'b0}}, s0_rr_i} : {s0_rr_i, {(2*B){1'b0}}};
      {s1_any_q, s1_shadow_q}  <= {s0_any_i, s0_shadow};
      {s1_own_q, s1_inside_q}  <= {s0_own_i, s0_inside_i};
    end
  end

  // ---- s2: b = d.s, A = d.d, C = s.s - R2.
  logic                s2_valid_q, s2_any_q, s2_shadow_q, s2_own_q, s2_inside_q;
  logic signed [L-1:0] s2_along_q;
  logic signed [A-1:0] s2_square_q;
  logic signed [C-1:0] s2_power_q;
  always_ff @(posedge clk_i) begin
    if (s1_valid_q) begin
      s2_along_q  <= L'(s1_dx_q) * L'(s1_sx_q) + L'(s1_dy_q) * L'(s1_sy_q)
          + L'(s1_dz_q) * L'(s1_sz_q);
      s2_square_q <= A'(s1_dx_q) * A'(s1_dx_q) + A'(s1_dy_q) * A'(s1_dy_q)
          + A'(s1_dz_q) * A'(s1_dz_q);
      s2_power_q  <= C'(s1_sx_q) * C'(s1_sx_q) + C'(s1_sy_q) * C'(s1_sy_q)
          + C'(s1_sz_q) * C'(s1_sz_q) - $signed({{(C-2*W){1'b0}}, s1_rr_q});
      {s2_any_q, s2_shadow_q} <= {s1_any_q, s1_shadow_q};
      {s2_own_q, s2_inside_q} <= {s1_own_q, s1_inside_q};
    end
  end

  // ---- s3: b b and A C, modulo 2^D since their difference fits; of A and C one is long for a
  // shadow ray, the other for all others. |O - c|^2 - R2, where a shadow ray ends; is its point
  // nearest to the centre before that?
  localparam int unsigned Short = G + 1 > 2 * N + 3 ? G + 1 : 2 * N + 3;
  localparam int unsigned Long  = A > C ? A : C;
  localparam int unsigned Foot  = (L + B > A ? L + B : A) + 1;
  logic                    s3_valid_q, s3_any_q, s3_shadow_q, s3_own_q, s3_inside_q;
  logic signed [Long-1:0]  s2_long;
  logic signed [Short-1:0] s2_short;
  logic signed [C-1:0]     s2_end;
  logic signed [Foot-1:0]  s2_foot;
  logic signed [D-1:0]     s3_bb_q, s3_ac_q;
  logic signed [V-1:0]     s3_along_q;
  logic [G-1:0]            s3_square_q;
  logic                    s3_still_q, s3_nearing_q, s3_outside_q, s3_on_q, s3_before_q,
      s3_end_in_q, s3_end_out_q;
  assign s2_long  = s2_shadow_q ? Long'(s2_square_q) : Long'(s2_power_q);
  assign s2_short = s2_shadow_q ? Short'(s2_power_q) : Short'(s2_square_q);
  assign s2_end   = C'(s2_square_q) + (C'(s2_along_q) <<< (B + 1)) + (s2_power_q <<< (2 * B));
  assign s2_foot  = (Foot'(s2_along_q) <<< B) + Foot'(s2_square_q);
  always_ff @(posedge clk_i) begin
    if (s2_valid_q) begin
      s3_bb_q      <= D'(s2_along_q) * D'(s2_along_q);
      s3_ac_q      <= D'(s2_long) * D'(s2_short);
      s3_along_q   <= V'(s2_along_q);
      s3_square_q  <= G'(s2_square_q);
      s3_still_q   <= s2_square_q == '0;
      s3_nearing_q <= s2_along_q[L-1];
      s3_outside_q <= !s2_power_q[C-1] && s2_power_q != '0;
      s3_on_q      <= s2_power_q == '0;
      s3_before_q  <= !s2_foot[Foot-1] && s2_foot != '0;
      s3_end_in_q  <= s2_end[C-1];
      s3_end_out_q <= !s2_end[C-1] && s2_end != '0;
      {s3_any_q, s3_shadow_q} <= {s2_any_q, s2_shadow_q};
      {s3_own_q, s3_inside_q} <= {s2_own_q, s2_inside_q};
    end
  end

  // ---- s4: the discriminant, and all decisions.
  localparam int unsigned Plain = 2 * (M + W) > 2 * rc_pkg::RootBits
                                ? 2 * (M + W) : 2 * rc_pkg::RootBits;   // of one that is met
  logic signed [D-1:0] s3_disc;
  logic                s3_meets, s3_goes, s3_met, s3_blocked, s4_met_q, s4_blocked_q, s4_far_q;
  logic [Plain-1:0]    s4_disc_q;
  logic signed [V-1:0] s4_along_q;
  logic [G-1:0]        s4_square_q;
  assign s3_disc  = s3_bb_q - s3_ac_q;
  assign s3_meets = s3_nearing_q && !s3_disc[D-1];
  assign s3_goes  = (!s3_own_q || s3_inside_q)
                 && (s3_outside_q ? s3_meets : s3_on_q ? s3_nearing_q : !s3_still_q);
  assign s3_met   = s3_valid_q && s3_goes && !s3_any_q;
  always_comb begin
    if (!s3_shadow_q)      s3_blocked = s3_goes;
    else if (s3_own_q)     s3_blocked = s3_inside_q && s3_outside_q;
    else if (s3_outside_q) s3_blocked = s3_meets && (s3_end_in_q || s3_before_q);
    else                   s3_blocked = s3_end_out_q && (!s3_on_q || s3_nearing_q);
  end
  if (Plain > D) begin : gen_short_disc
    always_ff @(posedge clk_i) if (s3_met) s4_disc_q <= {{(Plain-D){1'b0}}, s3_disc};
  end else begin : gen_disc
    always_ff @(posedge clk_i) if (s3_met) s4_disc_q <= s3_disc[Plain-1:0];
  end
  always_ff @(posedge clk_i) begin
    s4_blocked_q <= s3_valid_q && s3_any_q && s3_blocked;
    if (s3_met) begin
      s4_far_q    <= s3_own_q || !s3_outside_q;
      s4_along_q  <= s3_along_q;
      s4_square_q <= s3_square_q;
    end
  end

  // ---- s5: the discriminant cut to 2 RootBits bits by an even number of places, 2 s5_right.
  localparam int unsigned Places = Plain / 2 - rc_pkg::RootBits;   // most pairs of bits cut
  localparam int Levels          = $clog2(Places + 1);
  localparam int unsigned RightW = Levels > 0 ? Levels : 1;
  logic [Plain-1:0]              s4_cut;
  logic [RightW-1:0]             s4_right;
  logic                          s4_lost, s5_met_q;
  logic [2*rc_pkg::RootBits-1:0] s5_cut_q;
  logic [RightW:0]               s5_right_lost_q;
  always_comb begin
    s4_cut   = s4_disc_q;
    s4_right = '0;
    s4_lost  = 1'b0;
    for (int k = 0; k < Levels; k++) begin
      // Highest power of two first. As many pairs must go if with one less there are too many bits.
      if (s4_cut >> (2 * rc_pkg::RootBits + 2 * ((1 << (Levels - 1 - k)) - 1)) != '0) begin
        s4_right[Levels-1-k] = 1'b1;
        s4_lost = s4_lost || (s4_cut & ~({Plain{1'b1}} << (2 << (Levels - 1 - k)))) != '0;
        s4_cut  = s4_cut >> (2 << (Levels - 1 - k));
      end
    end
  end
  always_ff @(posedge clk_i) begin
    if (s4_met_q) begin
      s5_cut_q        <= s4_cut[2*rc_pkg::RootBits-1:0];
      s5_right_lost_q <= {s4_right, s4_lost};
    end
  end

  // ---- Root: what goes with it waits.
  logic [rc_pkg::RootBits-1:0] r_root;
  logic                        r_inexact, r_met, r_lost, r_far;
  logic [RightW-1:0]           r_right;
  logic signed [V-1:0]         r_along;
  logic [G-1:0]                r_square;
  logic [RightW:0]             r_right_lost;
  logic [V+G:0]                r_far_along_square;
  rc_sqrt #(.Stages(RootStages)) u_sqrt (
    .clk_i, .valid_i(s5_met_q), .square_i(s5_cut_q), .root_o(r_root), .inexact_o(r_inexact));
  rc_wait #(.Width(RightW + 1), .Stages(RootStages)) u_right (
    .clk_i, .rst_ni, .valid_i(s5_met_q), .data_i(s5_right_lost_q), .data_o(r_right_lost));
  rc_wait #(.Width(1 + V + G), .Stages(RootStages + 1)) u_ray (
    .clk_i, .rst_ni, .valid_i(s4_met_q), .data_i({s4_far_q, s4_along_q, s4_square_q}),
    .data_o(r_far_along_square));
  assign {r_right, r_lost}          = r_right_lost;
  assign {r_far, r_along, r_square} = r_far_along_square;

  // ---- The way to the near root, -b - r, with r rounded down, or to the far one, -b + r, with
  // r rounded up.
  logic [V-1:0] r_size, w_way_q;
  logic [G-1:0] w_square_q;
  logic         w_met_q;
  assign r_size = (V'(r_root)
                   + {{(V-1){1'b0}}, r_far && (r_inexact || r_lost)}) << r_right;
  always_ff @(posedge clk_i) begin
    if (r_met) begin
      w_way_q    <= r_far ? r_size - r_along : -r_along - r_size;
      w_square_q <= r_square;
    end
  end

  // ---- Distance: ceil(2^(M-1+F-B) way / d.d), saturated, as in rc_hitdiv.
  localparam int unsigned Q     = 2 * DivStages;
  localparam int unsigned Right = N + 3 + B > M ? N + 3 + B - M : 1;   // at least 2: M <= N + B + 1
  logic [V-1:0]   w_above;
  logic [Q+V-1:0] w_below;
  logic           w_beyond, t_met, t_beyond, t_inexact, t_up;
  logic [Q-1:0]   t_quo;
  logic [T-1:0]   t_down, t;
  assign w_above  = w_way_q >> Right;
  assign w_below  = {w_way_q, {Q{1'b0}}} >> Right;
  assign w_beyond = w_above >= {{(V-G){1'b0}}, w_square_q};
  rc_divide #(.Width(G), .Stages(DivStages)) u_t (
    .clk_i, .valid_i(w_met_q), .rem_i(w_beyond ? '0 : w_above[G-1:0]), .low_i(w_below[Q-1:0]),
    .den_i(w_square_q), .quo_o(t_quo), .inexact_o(t_inexact));
  rc_wait #(.Width(1), .Stages(DivStages)) u_beyond (
    .clk_i, .rst_ni, .valid_i(w_met_q), .data_i(w_beyond), .data_o(t_beyond));
  assign t_down = t_quo[Q-1 -: T];
  if (Q > T) begin : gen_spare_bit
    assign t_up = t_inexact || t_quo[0];
  end else begin : gen_exact_bits
    assign t_up = t_inexact;
  end
  assign t = t_beyond || (&t_down) ? '1 : t_down + {{(T-1){1'b0}}, t_up};

  // ---- t / 2^(M-1+F) against best_num / best_det; then closer, or as close with a lower number.
  localparam int unsigned P = T + E > U + M - 1 + F ? T + E : U + M - 1 + F;
  logic         p_met_q, p_found_q, p_first_q, p_closer, q_closer_q;
  logic [P-1:0] p_mine_q, p_theirs_q;
  logic [T-1:0] p_t_q, q_t_q;
  assign p_closer = p_met_q && (!p_found_q || p_mine_q < p_theirs_q
                                || (p_mine_q == p_theirs_q && p_first_q));
  always_ff @(posedge clk_i) begin
    if (t_met) begin
      p_found_q  <= best_found_i;
      p_first_q  <= best_first_i;
      p_mine_q   <= {{(P-T){1'b0}}, t} * {{(P-E){1'b0}}, best_det_i};
      p_theirs_q <= {{(P-U){1'b0}}, best_num_i} << (M - 1 + F);
      p_t_q      <= t;
    end
    if (p_closer) q_t_q <= p_t_q;
  end

  // ---- What is under way: met_q[k] and far_q[k] belong to stage 5 + k.
  localparam int unsigned Tail = BestStage + 2 - 4;   // stages after s4
  logic [Tail-1:0] met_q, far_q, blocked_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      {s1_valid_q, s2_valid_q, s3_valid_q, s4_met_q} <= '0;
      met_q     <= '0;
      blocked_q <= '0;
    end else begin
      {s1_valid_q, s2_valid_q} <= {s0_valid_i, s1_valid_q};
      {s3_valid_q, s4_met_q}   <= {s2_valid_q, s3_met};
      met_q     <= {met_q[Tail-2:0], s4_met_q};
      blocked_q <= {blocked_q[Tail-2:0], s4_blocked_q};
    end
    far_q      <= {far_q[Tail-2:0], s4_far_q};
    q_closer_q <= p_closer;
  end
  assign s5_met_q  = met_q[0];
  assign r_met     = met_q[RootStages];
  assign w_met_q   = met_q[RootStages+1];
  assign t_met     = met_q[RootStages+1+DivStages];
  assign p_met_q   = met_q[RootStages+2+DivStages];
  assign closer_o  = q_closer_q;
  assign blocked_o = blocked_q[Tail-1];
  assign far_o     = far_q[Tail-1];
  assign t_o       = q_t_q;

`ifndef SYNTHESIS
  a_way_is_ahead: assert property (@(posedge clk_i) disable iff (!rst_ni)
      r_met |-> (r_far ? r_size > V'(r_along) || r_along[V-1]
                       : r_along[V-1] && V'(-r_along) > r_size))
    else $error("a sphere is met behind the ray's origin");
`endif

  logic unused;
  assign unused = ^{w_below[Q+V-1:Q], met_q[Tail-1], s2_foot, s3_disc, r_root};
endmodule
`default_nettype wire

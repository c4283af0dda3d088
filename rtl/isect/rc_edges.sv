// Edge functions of a ray and a triangle, turned so that det > 0, and whether the
// ray's line crosses the triangle at t > 0. Part of rc_tri, which has the valid bits:
// operands in s0, answers from the registers of s4; det, num, u and v are sure to
// be non-negative only if hit. Model: tri_test() in model/isect/tri.cpp.
//
// If the chip shades, origins have B fraction bits, and of rays that leave a surface u, v,
// num and det are in units of 2^-B. A plane is a triangle whose edges do not count: u and v
// may then be negative, and are given as magnitude and sign. Model: flat_test() in
// model/isect/any.cpp.
`default_nettype none
module rc_edges #(
  localparam int unsigned N = rc_pkg::CoordBits,
  localparam int unsigned W = rc_pkg::OriginWidth,
  localparam int unsigned M = rc_pkg::RayDirBits,
  localparam int unsigned E = rc_pkg::EdgeBits,
  localparam int unsigned U = rc_pkg::NumBits
) (
  input  logic                clk_i,
  input  logic                s0_valid_i,
  input  logic                s1_valid_i,
  input  logic                s2_valid_i,
  input  logic                s3_valid_i,
  input  logic                s0_leaves_i,   // from a surface: o has a fraction
  input  logic                s0_plane_i,
  input  logic [3*W-1:0]      s0_o_i,
  input  logic [3*M-1:0]      s0_d_i,
  input  logic [3*N-1:0]      s0_a_i,
  input  logic [3*N-1:0]      s0_b_i,
  input  logic [3*N-1:0]      s0_c_i,
  output logic                s4_hit_o,
  output logic signed [E-1:0] s4_det_o,
  output logic signed [U-1:0] s4_num_o,
  output logic signed [E-1:0] s4_u_o,
  output logic signed [E-1:0] s4_v_o,
  output logic                s4_back_o,     // n.d > 0
  output logic                s4_u_neg_o,
  output logic                s4_v_neg_o
);
  localparam int unsigned B = rc_pkg::OriginBits;
  localparam int unsigned D = N + 1;      // difference of two points
  localparam int unsigned S = W + 1;      // the same with fraction
  localparam int unsigned C = M + D + 1;  // component of d x e
  localparam int unsigned X = 2 * D + 1;  // component of e1 x e2

  // s1: edges from a, and a to the origin.
  logic signed [D-1:0] s1_e1x_q, s1_e1y_q, s1_e1z_q, s1_e2x_q, s1_e2y_q, s1_e2z_q;
  logic signed [S-1:0] s1_sx_q, s1_sy_q, s1_sz_q;
  logic signed [M-1:0] s1_dx_q, s1_dy_q, s1_dz_q;
  logic                s1_leaves_q, s1_plane_q;
  logic signed [W-1:0] s0_ox, s0_oy, s0_oz;
  logic signed [N-1:0] s0_ax, s0_ay, s0_az, s0_bx, s0_by, s0_bz, s0_cx, s0_cy, s0_cz;
  logic signed [S-1:0] s0_sx, s0_sy, s0_sz;   // 2^B (o - a)
  assign {s0_oz, s0_oy, s0_ox} = s0_o_i;
  assign {s0_az, s0_ay, s0_ax} = s0_a_i;
  assign {s0_bz, s0_by, s0_bx} = s0_b_i;
  assign {s0_cz, s0_cy, s0_cx} = s0_c_i;
  assign s0_sx = S'(s0_ox) - (S'(s0_ax) <<< B);
  assign s0_sy = S'(s0_oy) - (S'(s0_ay) <<< B);
  assign s0_sz = S'(s0_oz) - (S'(s0_az) <<< B);
  always_ff @(posedge clk_i) begin
    if (s0_valid_i) begin
      {s1_dz_q, s1_dy_q, s1_dx_q} <= s0_d_i;
      s1_e1x_q <= D'(s0_bx) - D'(s0_ax);
      s1_e1y_q <= D'(s0_by) - D'(s0_ay);
      s1_e1z_q <= D'(s0_bz) - D'(s0_az);
      s1_e2x_q <= D'(s0_cx) - D'(s0_ax);
      s1_e2y_q <= D'(s0_cy) - D'(s0_ay);
      s1_e2z_q <= D'(s0_cz) - D'(s0_az);
      s1_sx_q  <= s0_leaves_i ? s0_sx : s0_sx >>> B;
      s1_sy_q  <= s0_leaves_i ? s0_sy : s0_sy >>> B;
      s1_sz_q  <= s0_leaves_i ? s0_sz : s0_sz >>> B;
      s1_leaves_q <= s0_leaves_i;
      s1_plane_q  <= s0_plane_i;
    end
  end

  // s2: P1 = d x e1, P2 = d x e2, n = e1 x e2.
  logic signed [C-1:0] s2_p1x_q, s2_p1y_q, s2_p1z_q, s2_p2x_q, s2_p2y_q, s2_p2z_q;
  logic signed [X-1:0] s2_nx_q, s2_ny_q, s2_nz_q;
  logic signed [D-1:0] s2_e1x_q, s2_e1y_q, s2_e1z_q;
  logic signed [S-1:0] s2_sx_q, s2_sy_q, s2_sz_q;
  logic                s2_leaves_q, s2_plane_q;
  always_ff @(posedge clk_i) begin
    if (s1_valid_i) begin
      s2_p1x_q <= C'(s1_dy_q) * C'(s1_e1z_q) - C'(s1_dz_q) * C'(s1_e1y_q);
      s2_p1y_q <= C'(s1_dz_q) * C'(s1_e1x_q) - C'(s1_dx_q) * C'(s1_e1z_q);
      s2_p1z_q <= C'(s1_dx_q) * C'(s1_e1y_q) - C'(s1_dy_q) * C'(s1_e1x_q);
      s2_p2x_q <= C'(s1_dy_q) * C'(s1_e2z_q) - C'(s1_dz_q) * C'(s1_e2y_q);
      s2_p2y_q <= C'(s1_dz_q) * C'(s1_e2x_q) - C'(s1_dx_q) * C'(s1_e2z_q);
      s2_p2z_q <= C'(s1_dx_q) * C'(s1_e2y_q) - C'(s1_dy_q) * C'(s1_e2x_q);
      s2_nx_q  <= X'(s1_e1y_q) * X'(s1_e2z_q) - X'(s1_e1z_q) * X'(s1_e2y_q);
      s2_ny_q  <= X'(s1_e1z_q) * X'(s1_e2x_q) - X'(s1_e1x_q) * X'(s1_e2z_q);
      s2_nz_q  <= X'(s1_e1x_q) * X'(s1_e2y_q) - X'(s1_e1y_q) * X'(s1_e2x_q);
      {s2_e1x_q, s2_e1y_q, s2_e1z_q} <= {s1_e1x_q, s1_e1y_q, s1_e1z_q};
      {s2_sx_q, s2_sy_q, s2_sz_q}    <= {s1_sx_q, s1_sy_q, s1_sz_q};
      {s2_leaves_q, s2_plane_q}      <= {s1_leaves_q, s1_plane_q};
    end
  end

  // s3: det = P2.e1, u = P2.s, v = -P1.s, num = n.s. Each term may exceed the sum's
  // proven width; the sum modulo 2^E does not care.
  logic signed [E-1:0] s2_det, s3_det_q, s3_u_q, s3_v_q;
  logic                s3_plane_q;
  logic signed [U-1:0] s3_num_q;
  logic signed [C-1:0] s3_p1x_q, s3_p1y_q, s3_p1z_q, s3_p2x_q, s3_p2y_q, s3_p2z_q;
  always_comb begin
    s2_det = '0;
    if (s2_valid_i)
      s2_det = E'(s2_p2x_q) * E'(s2_e1x_q) + E'(s2_p2y_q) * E'(s2_e1y_q)
          + E'(s2_p2z_q) * E'(s2_e1z_q);
  end
  always_ff @(posedge clk_i) begin
    if (s2_valid_i) begin
      s3_det_q <= s2_leaves_q ? s2_det <<< B : s2_det;
      s3_plane_q <= s2_plane_q;
      s3_u_q   <= E'(s2_p2x_q) * E'(s2_sx_q) + E'(s2_p2y_q) * E'(s2_sy_q)
          + E'(s2_p2z_q) * E'(s2_sz_q);
      s3_v_q   <= -(E'(s2_p1x_q) * E'(s2_sx_q) + E'(s2_p1y_q) * E'(s2_sy_q)
          + E'(s2_p1z_q) * E'(s2_sz_q));
      s3_num_q <= U'(s2_nx_q) * U'(s2_sx_q) + U'(s2_ny_q) * U'(s2_sy_q) + U'(s2_nz_q) * U'(s2_sz_q);
      {s3_p1x_q, s3_p1y_q, s3_p1z_q} <= {s2_p1x_q, s2_p1y_q, s2_p1z_q};
      {s3_p2x_q, s3_p2y_q, s3_p2z_q} <= {s2_p2x_q, s2_p2y_q, s2_p2z_q};
    end
  end

  // s4: signs. An edge function of zero takes the sign of the first non-zero component
  // of its gradient: P2 for u, -P1 for v, P1 - P2 for w.
  logic signed [E-1:0] s3_w;
  logic                s3_flip, s3_u_neg, s3_v_neg, s3_w_neg;
  assign s3_w     = s3_det_q - s3_u_q - s3_v_q;
  assign s3_flip  = s3_det_q[E-1];
  always_comb begin
    s3_u_neg = s3_u_q != '0 ? s3_u_q[E-1] :
               s3_p2x_q != '0 ? s3_p2x_q[C-1] : s3_p2y_q != '0 ? s3_p2y_q[C-1] : s3_p2z_q[C-1];
    s3_v_neg = s3_v_q != '0 ? s3_v_q[E-1] :
               s3_p1x_q != '0 ? !s3_p1x_q[C-1] : s3_p1y_q != '0 ? !s3_p1y_q[C-1] : !s3_p1z_q[C-1];
    s3_w_neg = s3_w != '0 ? s3_w[E-1] :
               s3_p1x_q != s3_p2x_q ? s3_p1x_q < s3_p2x_q :
               s3_p1y_q != s3_p2y_q ? s3_p1y_q < s3_p2y_q : s3_p1z_q < s3_p2z_q;
  end
  // Of a triangle that is hit the turned u and v are their magnitudes.
  logic s3_u_turn, s3_v_turn;
  assign s3_u_turn = rc_pkg::Planes == 1 ? s3_u_q[E-1] : s3_flip;
  assign s3_v_turn = rc_pkg::Planes == 1 ? s3_v_q[E-1] : s3_flip;

  always_ff @(posedge clk_i) begin
    if (s3_valid_i) begin
      s4_hit_o <= s3_det_q != '0
               && (s3_plane_q || (s3_u_neg == s3_flip && s3_v_neg == s3_flip
                                  && s3_w_neg == s3_flip))
               && s3_num_q != '0 && s3_num_q[U-1] == s3_flip;
      s4_det_o <= s3_flip ? -s3_det_q : s3_det_q;
      s4_u_o   <= s3_u_turn ? -s3_u_q : s3_u_q;
      s4_v_o   <= s3_v_turn ? -s3_v_q : s3_v_q;
      s4_num_o <= s3_flip ? -s3_num_q : s3_num_q;
      s4_back_o  <= s3_flip;
      s4_u_neg_o <= s3_u_turn != s3_flip;
      s4_v_neg_o <= s3_v_turn != s3_flip;
    end
  end
endmodule
`default_nettype wire

// Edge functions of a ray and a triangle, with signs such that det > 0, and whether the ray's line
// crosses the triangle at t > 0.
//
// Part of rc_tri, which has the valid bits. Operands come with enable_i[0], answers
// rc_pkg::EdgesStages later. det, num, u and v are sure to be non-negative only if hit is set. If
// operands come only every few cycles, products share multipliers (rc_mul_shared). Model:
// tri_test() in model/unit/tri/tri.cpp.
//
// If the chip shades, origins have OriginBits fraction bits. For rays that leave a surface u, v,
// num and det are in units of 2^-OriginBits. For rays that begin beyond the lattice the unit is
// 2^(FarDrop - OriginBits). A plane is a triangle whose edges do not count: u and v may then be
// negative, and are returned as magnitude and sign. Model: flat_test() in
// model/unit/tri/any_primitive.cpp.
`default_nettype none
module rc_edges #(
  localparam int unsigned N           = rc_pkg::CoordBits,
  localparam int unsigned OriginWidth = rc_pkg::OriginWidth,
  localparam int unsigned RayDirBits  = rc_pkg::RayDirBits,
  localparam int unsigned EdgeBits    = rc_pkg::EdgeBits,
  localparam int unsigned NumBits     = rc_pkg::NumBits,
  localparam int unsigned Stages      = rc_pkg::EdgesStages
) (
  input  logic                       clk_i,
  input  logic [Stages-1:0]          enable_i,      // stage i holds a triangle, or the chip is fast
  input  logic [Stages-1:0]          valid_i,       // stage i holds a triangle
  // Ray and triangle
  input  logic                       s0_leaves_i,   // from a surface: o has a fraction
  input  logic                       s0_far_i,      // from beyond the lattice: o in units of 2^-Far
  input  logic                       s0_plane_i,
  input  logic [3*OriginWidth-1:0]   s0_o_i,
  input  logic [3*RayDirBits-1:0]    s0_d_i,
  input  logic [3*N-1:0]             s0_a_i,
  input  logic [3*N-1:0]             s0_b_i,
  input  logic [3*N-1:0]             s0_c_i,
  // Result
  output logic                       hit_o,
  output logic signed [EdgeBits-1:0] det_o,
  output logic signed [NumBits-1:0]  num_o,
  output logic signed [EdgeBits-1:0] u_o,
  output logic signed [EdgeBits-1:0] v_o,
  output logic                       back_o,        // n.d > 0
  output logic                       u_neg_o,
  output logic                       v_neg_o
);
  localparam int unsigned OriginBits = rc_pkg::OriginBits;
  localparam int unsigned Far = rc_pkg::Horizon ? OriginBits - rc_pkg::FarDrop : OriginBits;
  localparam int unsigned DiffW       = N + 1;                   // difference of two points
  localparam int unsigned OriginDiffW = OriginWidth + 1;         // the same with fraction
  localparam int unsigned RayCrossW   = RayDirBits + DiffW + 1;  // component of d x e
  localparam int unsigned EdgeCrossW  = 2 * DiffW + 1;           // component of e1 x e2
  localparam int unsigned Cut = rc_pkg::PathCut;
  localparam int unsigned Mul = rc_pkg::MulStages;
  localparam int unsigned CrossShare = rc_pkg::CrossShare;
  localparam int unsigned DotShare   = rc_pkg::DotShare;

  // Stages that hold the edges, their cross products, the edge functions.
  localparam int unsigned Edge  = 1;
  localparam int unsigned Cross = Edge + Mul + CrossShare;
  localparam int unsigned Dot   = Cross + Mul + DotShare;

  // s1: the edges from a, and the vector from a to the origin, 2^OriginBits (o - a).
  for (genvar k = 0; k < 3; k++) begin : gen_edge
    logic signed [N-1:0]           s0_a, s0_b, s0_c;
    logic signed [OriginWidth-1:0] s0_o;
    logic signed [OriginDiffW-1:0] s0_s, s_q, dot_s;
    logic signed [DiffW-1:0]       e1_q, e2_q, dot_e1;
    logic signed [RayDirBits-1:0]  d_q;

    assign s0_a = s0_a_i[k*N +: N];
    assign s0_b = s0_b_i[k*N +: N];
    assign s0_c = s0_c_i[k*N +: N];
    assign s0_o = s0_o_i[k*OriginWidth +: OriginWidth];
    assign s0_s = OriginDiffW'(s0_o) - (OriginDiffW'(s0_a) <<< (s0_far_i ? Far : OriginBits));

    always_ff @(posedge clk_i) begin
      if (enable_i[0]) begin
        d_q  <= s0_d_i[k*RayDirBits +: RayDirBits];
        e1_q <= DiffW'(s0_b) - DiffW'(s0_a);
        e2_q <= DiffW'(s0_c) - DiffW'(s0_a);
        s_q  <= s0_leaves_i ? s0_s : s0_s >>> OriginBits;
      end
    end

    rc_shift_register #(.Width(DiffW), .Stages(Cross - Edge)) u_e1 (
      .clk_i, .enable_i(enable_i[Cross-1:Edge]), .data_i(e1_q), .data_o(dot_e1));
    rc_shift_register #(.Width(OriginDiffW), .Stages(Cross - Edge)) u_s (
      .clk_i, .enable_i(enable_i[Cross-1:Edge]), .data_i(s_q), .data_o(dot_s));
  end

  // Flags that wait.
  logic dot_leaves, dot_far, end_plane;

  rc_shift_register #(.Width(1), .Stages(Dot - 1)) u_leaves (
    .clk_i, .enable_i(enable_i[Dot-2:0]), .data_i(s0_leaves_i), .data_o(dot_leaves));

  if (rc_pkg::Horizon) begin : gen_far
    rc_shift_register #(.Width(1), .Stages(Dot - 1)) u_far (
      .clk_i, .enable_i(enable_i[Dot-2:0]), .data_i(s0_far_i), .data_o(dot_far));
  end else begin : gen_near
    assign dot_far = 1'b0;
  end

  rc_shift_register #(.Width(1), .Stages(Stages - 1)) u_plane (
    .clk_i, .enable_i(enable_i[Stages-2:0]), .data_i(s0_plane_i), .data_o(end_plane));

  // Cross products: P1 = d x e1, P2 = d x e2, n = e1 x e2.
  for (genvar k = 0; k < 3; k++) begin : gen_cross
    localparam int unsigned Axis1 = (k + 1) % 3;   // the other two axes
    localparam int unsigned Axis2 = (k + 2) % 3;
    logic signed [RayDirBits+DiffW-1:0] p1_yz, p1_zy, p2_yz, p2_zy;
    logic signed [2*DiffW-1:0]          n_yz, n_zy;
    logic signed [RayCrossW-1:0]        p1_q, p2_q;
    logic signed [EdgeCrossW-1:0]       n_q;

    if (CrossShare == 1) begin : gen_at_once
      rc_mul #(.AW(RayDirBits), .BW(DiffW)) u_p1_yz (
        .clk_i, .a_i(gen_edge[Axis1].d_q), .b_i(gen_edge[Axis2].e1_q), .p_o(p1_yz));
      rc_mul #(.AW(RayDirBits), .BW(DiffW)) u_p1_zy (
        .clk_i, .a_i(gen_edge[Axis2].d_q), .b_i(gen_edge[Axis1].e1_q), .p_o(p1_zy));
      rc_mul #(.AW(RayDirBits), .BW(DiffW)) u_p2_yz (
        .clk_i, .a_i(gen_edge[Axis1].d_q), .b_i(gen_edge[Axis2].e2_q), .p_o(p2_yz));
      rc_mul #(.AW(RayDirBits), .BW(DiffW)) u_p2_zy (
        .clk_i, .a_i(gen_edge[Axis2].d_q), .b_i(gen_edge[Axis1].e2_q), .p_o(p2_zy));
      rc_mul #(.AW(DiffW), .BW(DiffW)) u_n_yz (
        .clk_i, .a_i(gen_edge[Axis1].e1_q), .b_i(gen_edge[Axis2].e2_q), .p_o(n_yz));
      rc_mul #(.AW(DiffW), .BW(DiffW)) u_n_zy (
        .clk_i, .a_i(gen_edge[Axis2].e1_q), .b_i(gen_edge[Axis1].e2_q), .p_o(n_zy));

    end else begin : gen_shared
      localparam int unsigned WiderW = RayDirBits > DiffW ? RayDirBits : DiffW;
      logic [3*(WiderW+DiffW)-1:0] yz, zy;
      rc_mul_shared #(.AW(WiderW), .BW(DiffW), .Products(3), .Share(CrossShare)) u_yz (
        .clk_i, .valid_i(valid_i[Edge]),
        .a_i({WiderW'(gen_edge[Axis1].e1_q), WiderW'(gen_edge[Axis1].d_q),
              WiderW'(gen_edge[Axis1].d_q)}),
        .b_i({gen_edge[Axis2].e2_q, gen_edge[Axis2].e2_q, gen_edge[Axis2].e1_q}), .p_o(yz));
      rc_mul_shared #(.AW(WiderW), .BW(DiffW), .Products(3), .Share(CrossShare)) u_zy (
        .clk_i, .valid_i(valid_i[Edge]),
        .a_i({WiderW'(gen_edge[Axis2].e1_q), WiderW'(gen_edge[Axis2].d_q),
              WiderW'(gen_edge[Axis2].d_q)}),
        .b_i({gen_edge[Axis1].e2_q, gen_edge[Axis1].e2_q, gen_edge[Axis1].e1_q}), .p_o(zy));

      assign p1_yz = yz[0 +: RayDirBits+DiffW];
      assign p2_yz = yz[WiderW+DiffW +: RayDirBits+DiffW];
      assign n_yz  = yz[2*(WiderW+DiffW) +: 2*DiffW];
      assign p1_zy = zy[0 +: RayDirBits+DiffW];
      assign p2_zy = zy[WiderW+DiffW +: RayDirBits+DiffW];
      assign n_zy  = zy[2*(WiderW+DiffW) +: 2*DiffW];

      logic unused;
      assign unused = ^{yz, zy};
    end

    always_ff @(posedge clk_i) begin
      if (enable_i[Cross-1]) begin
        p1_q <= RayCrossW'(p1_yz) - RayCrossW'(p1_zy);
        p2_q <= RayCrossW'(p2_yz) - RayCrossW'(p2_zy);
        n_q  <= EdgeCrossW'(n_yz) - EdgeCrossW'(n_zy);
      end
    end
  end

  // Ties: an edge function of zero takes the sign of the first non-zero component of its gradient:
  // P2 for u, -P1 for v, P1 - P2 for w.
  logic [1:0] u_there, v_there, w_there, tie_u_there, tie_v_there, tie_w_there;   // is not zero
  logic [2:0] u_sign, v_sign, w_sign, tie_u_sign, tie_v_sign, tie_w_sign;
  logic       tie_u, tie_v, tie_w, end_tie_u, end_tie_v, end_tie_w;
  logic holds;   // relaxed: invalid operands cost a simulation no work

  assign holds = Cut != 0 || enable_i[Cross];

  for (genvar k = 0; k < 3; k++) begin : gen_tie
    if (k < 2) begin : gen_there
      assign u_there[k] = holds && gen_cross[k].p2_q != '0;
      assign v_there[k] = holds && gen_cross[k].p1_q != '0;
      assign w_there[k] = holds && gen_cross[k].p1_q != gen_cross[k].p2_q;
    end

    assign u_sign[k]  = gen_cross[k].p2_q[RayCrossW-1];
    assign v_sign[k]  = !gen_cross[k].p1_q[RayCrossW-1];
    assign w_sign[k]  = holds && gen_cross[k].p1_q < gen_cross[k].p2_q;
  end

  rc_path_register #(.Width(15)) u_tie (
    .clk_i, .data_i({u_there, v_there, w_there, u_sign, v_sign, w_sign}),
    .data_o({tie_u_there, tie_v_there, tie_w_there, tie_u_sign, tie_v_sign, tie_w_sign}));

  function automatic logic first_sign(input logic [1:0] there, input logic [2:0] sign);
    first_sign = there[0] ? sign[0] : there[1] ? sign[1] : sign[2];
  endfunction

  assign tie_u = first_sign(tie_u_there, tie_u_sign);
  assign tie_v = first_sign(tie_v_there, tie_v_sign);
  assign tie_w = first_sign(tie_w_there, tie_w_sign);

  rc_shift_register #(.Width(3), .Stages(Dot - Cross - Cut)) u_ties (
    .clk_i, .enable_i(enable_i[Dot-1:Cross+Cut]), .data_i({tie_u, tie_v, tie_w}),
    .data_o({end_tie_u, end_tie_v, end_tie_w}));

  // Edge functions: det = P2.e1, u = P2.s, v = -P1.s, num = n.s. A term may exceed the sum's proven
  // width; the sum modulo 2^EdgeBits is exact.
  for (genvar k = 0; k < 3; k++) begin : gen_dot
    logic signed [RayCrossW+DiffW-1:0]        det_wide;
    logic signed [RayCrossW+OriginDiffW-1:0]  u_wide, v_wide;
    logic signed [EdgeCrossW+OriginDiffW-1:0] num_wide;
    logic signed [EdgeBits-1:0]               det, u, v;
    logic signed [NumBits-1:0]                num;

    if (DotShare == 1) begin : gen_at_once
      rc_mul #(.AW(RayCrossW), .BW(DiffW)) u_det (
        .clk_i, .a_i(gen_cross[k].p2_q), .b_i(gen_edge[k].dot_e1), .p_o(det_wide));
      rc_mul #(.AW(RayCrossW), .BW(OriginDiffW)) u_u (
        .clk_i, .a_i(gen_cross[k].p2_q), .b_i(gen_edge[k].dot_s), .p_o(u_wide));
      rc_mul #(.AW(RayCrossW), .BW(OriginDiffW)) u_v (
        .clk_i, .a_i(gen_cross[k].p1_q), .b_i(gen_edge[k].dot_s), .p_o(v_wide));
      rc_mul #(.AW(EdgeCrossW), .BW(OriginDiffW)) u_num (
        .clk_i, .a_i(gen_cross[k].n_q), .b_i(gen_edge[k].dot_s), .p_o(num_wide));
    end else begin : gen_shared
      localparam int unsigned WiderW = RayCrossW > EdgeCrossW ? RayCrossW : EdgeCrossW;
      logic [4*(WiderW+OriginDiffW)-1:0] wide;

      rc_mul_shared #(.AW(WiderW), .BW(OriginDiffW), .Products(4), .Share(DotShare)) u_products (
        .clk_i, .valid_i(valid_i[Cross]),
        .a_i({WiderW'(gen_cross[k].n_q), WiderW'(gen_cross[k].p2_q), WiderW'(gen_cross[k].p1_q),
              WiderW'(gen_cross[k].p2_q)}),
        .b_i({gen_edge[k].dot_s, OriginDiffW'(gen_edge[k].dot_e1), gen_edge[k].dot_s,
              gen_edge[k].dot_s}),
        .p_o(wide));

      assign u_wide   = wide[0 +: RayCrossW+OriginDiffW];
      assign v_wide   = wide[WiderW+OriginDiffW +: RayCrossW+OriginDiffW];
      assign det_wide = wide[2*(WiderW+OriginDiffW) +: RayCrossW+DiffW];
      assign num_wide = wide[3*(WiderW+OriginDiffW) +: EdgeCrossW+OriginDiffW];

      logic unused;
      assign unused = ^wide;
    end

    assign det = EdgeBits'(det_wide);
    assign u   = EdgeBits'(u_wide);
    assign v   = EdgeBits'(v_wide);
    assign num = NumBits'(num_wide);

    logic unused;
    assign unused = ^{det_wide, u_wide, v_wide, num_wide};
  end

  logic signed [EdgeBits-1:0] det_sum, det_q, u_q, v_q;
  logic signed [NumBits-1:0]  num_q;

  assign det_sum = gen_dot[0].det + gen_dot[1].det + gen_dot[2].det;

  always_ff @(posedge clk_i) begin
    if (enable_i[Dot-1]) begin
      det_q <= dot_far ? det_sum <<< Far : dot_leaves ? det_sum <<< OriginBits : det_sum;
      u_q   <= gen_dot[0].u + gen_dot[1].u + gen_dot[2].u;
      v_q   <= -(gen_dot[0].v + gen_dot[1].v + gen_dot[2].v);
      num_q <= gen_dot[0].num + gen_dot[1].num + gen_dot[2].num;
    end
  end

  // Decision. w = det - u - v; minus one if a zero counts as negative.
  logic signed [EdgeBits-1:0] w, end_det, end_u, end_v;
  logic signed [NumBits-1:0]  end_num;
  logic                       u_neg, v_neg, end_u_neg, end_v_neg, end_w_neg, end_edge_on, end_here;
  logic                       end_flip, end_u_goes, end_v_turn;

  assign w     = det_q - u_q - v_q - $signed({{(EdgeBits-1){1'b0}}, end_tie_w});
  assign u_neg = u_q != '0 ? u_q[EdgeBits-1] : end_tie_u;
  assign v_neg = v_q != '0 ? v_q[EdgeBits-1] : end_tie_v;

  rc_path_register #(.Width(3 * EdgeBits + NumBits + 5)) u_end (
    .clk_i,
    .data_i({det_q, u_q, v_q, num_q, u_neg, v_neg, w[EdgeBits-1], det_q == '0, num_q == '0}),
    .data_o({end_det, end_u, end_v, end_num, end_u_neg, end_v_neg, end_w_neg, end_edge_on,
             end_here}));

  assign end_flip = end_det[EdgeBits-1];
  // For a triangle that is hit, u and v with these signs are their magnitudes.
  assign end_u_goes = rc_pkg::Planes ? end_u[EdgeBits-1] : end_flip;
  assign end_v_turn = rc_pkg::Planes ? end_v[EdgeBits-1] : end_flip;

  always_ff @(posedge clk_i) begin
    if (enable_i[Stages-1]) begin
      hit_o <= !end_edge_on
            && (end_plane || (end_u_neg == end_flip && end_v_neg == end_flip
                              && end_w_neg == end_flip))
            && !end_here && end_num[NumBits-1] == end_flip;
      det_o <= end_flip ? -end_det : end_det;
      u_o   <= end_u_goes ? -end_u : end_u;
      v_o   <= end_v_turn ? -end_v : end_v;
      num_o <= end_flip ? -end_num : end_num;
      back_o  <= end_flip;
      u_neg_o <= end_u_goes != end_flip;
      v_neg_o <= end_v_turn != end_flip;
    end
  end

  logic unused;
  assign unused = ^{w[EdgeBits-2:0], valid_i};
endmodule
`default_nettype wire

// Ray-triangle test, and the comparison with the best hit. Which test is a constant of the
// configuration: rc_edges decides exactly (model/isect/tri.hpp), rc_shear with rounded
// corners (model/isect/sheared.hpp); there are the formulas, tie rules and proven widths.
//
// If the chip shades: rays of every kind, planes and spheres as well (model/isect/any.hpp); of
// a ray from or to a light the answer is only whether the primitive is in its way. Spheres have a
// pipeline of their own, rc_sphere, which is longer; the others' answers wait for it.
//
// Latency rc_pkg::TriLatency + 1 (result queue), throughput 1 per cycle, answers in
// order. Cycles that TriLatency has beyond what the work needs (Core) follow at its end.
// A triangle seen edge-on never hits.
`default_nettype none
module rc_tri (
  input  logic             clk_i,
  input  logic             rst_ni,
  // From prim_cache, with the ray from list
  input  logic             req_valid_i,
  output logic             req_ready_o,
  input  rc_pkg::tri_req_t req_i,
  // To list
  output logic             rsp_valid_o,
  input  logic             rsp_ready_i,
  output rc_pkg::tri_rsp_t rsp_o
);
  localparam bit          IsSheared = rc_pkg::PrimitiveTest == rc_pkg::TestSheared;
  localparam int unsigned N    = rc_pkg::CoordBits;
  localparam int unsigned M    = rc_pkg::DirBits;
  localparam int unsigned T    = rc_pkg::TBits;
  localparam int unsigned V    = rc_pkg::UvBits;
  localparam int unsigned D    = rc_pkg::EdgeBits;   // of det, u, v
  localparam int unsigned U    = rc_pkg::NumBits;
  localparam int unsigned E    = IsSheared ? 2 * N + M + 2 : D;   // of den
  localparam int unsigned I    = rc_pkg::RayBits;
  localparam int unsigned P    = rc_pkg::PrimBits;
  localparam int unsigned L    = rc_pkg::TriLatency;
  localparam int unsigned Front = IsSheared ? 6 : 4; // stages before the comparison
  localparam int unsigned Pre   = Front + 2;         // and before the divisions
  localparam int unsigned Divide = ((T > V - 1 ? T : V - 1) + 1) / 2;   // stages of these
  localparam int unsigned Flat   = Pre + Divide;     // what is no sphere is done
  localparam int unsigned Ball   = 8 + rc_pkg::RootBits / 2 + (T + 1) / 2;   // of rc_sphere
  localparam int unsigned Core   = rc_pkg::Spheres == 1 && Ball > Flat ? Ball : Flat;
  localparam int unsigned Late   = Core - Flat;      // stages of the others meanwhile
  localparam int unsigned Extra  = L - Core;
  localparam int unsigned BackW  = rc_pkg::Shading;
  localparam int unsigned TailW  = 1 + BackW + U + D + P;   // closer, back, num, det, prim
  localparam int unsigned HitW   = TailW + T + 2 * V;

  logic admit;
  assign admit = req_valid_i && req_ready_o;
  rc_door #(.Credits(rc_pkg::TriQueue)) u_door (
    .clk_i, .rst_ni, .admit_i(admit), .leave_i(rsp_valid_o && rsp_ready_i), .open_o(req_ready_o));

  logic [L-1:0] valid_q;
  logic [I-1:0] end_ray;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) valid_q <= '0;
    else         valid_q <= {valid_q[L-2:0], admit};
  end
  rc_delay #(.Width(I), .Stages(L)) u_ray (
    .clk_i, .valid_i({valid_q[L-2:0], admit}), .data_i(req_i.ray), .data_o(end_ray));

  // Stages up to Front: the ray and the triangle, and whether they meet. num / den is t,
  // num / det what is compared with other hits of the ray.
  logic [rc_pkg::TriReqW-1:0] req;
  logic [3*N-1:0]             s0_a, s0_b, s0_c;
  logic                       f0_hit;
  logic [D-1:0]               f0_det, f0_u, f0_v;
  logic [U-1:0]               f0_num;
  logic [E-1:0]               f0_den;
  logic                       f0_back, f0_u_neg, f0_v_neg;
  logic                       s0_any;      // any hit will do: a ray from or to a light
  logic                       s0_leaves;   // from a surface: a bounce, or away to a light
  logic                       s0_plane, s0_sphere;
  logic                       s0_skips;    // the ray asks no planes, and this is one
  assign req     = req_i;
  assign s0_a    = req_i.a;
  assign s0_b    = req_i.b;
  assign s0_c    = req_i.c;
  if (rc_pkg::Shading == 1) begin : gen_kind
    assign s0_any    = req_i.kind == rc_pkg::RayShadow || req_i.kind == rc_pkg::RayAway;
    assign s0_leaves = req_i.kind == rc_pkg::RayBounce || req_i.kind == rc_pkg::RayAway;
  end else begin : gen_camera
    assign s0_any    = 1'b0;
    assign s0_leaves = 1'b0;
  end
  if (rc_pkg::Planes == 1 || rc_pkg::Spheres == 1) begin : gen_prim_kind
    assign s0_plane  = rc_pkg::Planes == 1 && req_i.prim_kind == rc_pkg::PrimPlane;
    assign s0_sphere = rc_pkg::Spheres == 1 && req_i.prim_kind == rc_pkg::PrimSphere;
  end else begin : gen_triangle
    assign s0_plane  = 1'b0;
    assign s0_sphere = 1'b0;
  end
  if (rc_pkg::Planes == 1) begin : gen_finite
    assign s0_skips = s0_plane && req_i.is_finite;
  end else begin : gen_no_planes
    assign s0_skips = 1'b0;
  end
  // What is no sphere, up to the divisions.
  logic           flat;
  logic [Pre-1:0] flat_q;
  if (rc_pkg::Spheres == 1) begin : gen_flat
    assign flat = admit && !s0_sphere;
    always_ff @(posedge clk_i) begin
      if (!rst_ni) flat_q <= '0;
      else         flat_q <= {flat_q[Pre-2:0], flat};
    end
  end else begin : gen_all_flat
    assign flat   = admit;
    assign flat_q = valid_q[Pre-1:0];
  end

  if (IsSheared) begin : gen_sheared
    logic [M-1:0] f0_size;
    rc_shear u_shear (
      .clk_i, .valid_i({valid_q[4:0], admit}),
      .s0_shear_i({req_i.axis, req_i.neg, req_i.size, req_i.slope}),
      .s0_o_i(req_i.o), .s0_a_i(s0_a), .s0_b_i(s0_b), .s0_c_i(s0_c),
      .s6_hit_o(f0_hit), .s6_size_o(f0_size), .s6_det_o(f0_det), .s6_num_o(f0_num),
      .s6_u_o(f0_u), .s6_v_o(f0_v));
    assign f0_den = {{(E-D){1'b0}}, f0_det} * {{(E-M){1'b0}}, f0_size};
    assign {f0_back, f0_u_neg, f0_v_neg} = '0;
  end else begin : gen_exact
    rc_edges u_edges (
      .clk_i, .s0_valid_i(flat), .s1_valid_i(flat_q[0]), .s2_valid_i(flat_q[1]),
      .s3_valid_i(flat_q[2]), .s0_leaves_i(s0_leaves), .s0_plane_i(s0_plane),
      .s0_o_i(req_i.o), .s0_d_i(req_i.d), .s0_a_i(s0_a), .s0_b_i(s0_b),
      .s0_c_i(s0_c),
      .s4_hit_o(f0_hit), .s4_det_o(f0_det), .s4_num_o(f0_num), .s4_u_o(f0_u), .s4_v_o(f0_v),
      .s4_back_o(f0_back), .s4_u_neg_o(f0_u_neg), .s4_v_neg_o(f0_v_neg));
    assign f0_den = f0_det;
  end

  // Meanwhile number and hit to beat wait. A ray from a light must be blocked before its end,
  // t = 2^-B, and equality does not count; one away to a light has no end.
  localparam int unsigned BestW = P + 1 + U + D + P;
  logic [BestW-1:0] s0_best, f0_best;
  logic             f0_any;
  localparam logic [D-1:0] ShadowDet = D'(1) << rc_pkg::OriginBits;
  // One that asks no planes ends before it meets any.
  assign s0_best = s0_any ? {req_i.prim, !s0_leaves || s0_skips, U'(!s0_skips), ShadowDet,
                             req_i.best_prim}
      : {req_i.prim, req_i.found, req_i.best_num, req_i.best_det, req_i.best_prim};
  rc_delay #(.Width(BestW), .Stages(Front)) u_best (
    .clk_i, .valid_i({flat_q[Front-2:0], flat}), .data_i(s0_best), .data_o(f0_best));
  rc_delay #(.Width(1), .Stages(Front)) u_any (
    .clk_i, .valid_i({flat_q[Front-2:0], flat}), .data_i(s0_any), .data_o(f0_any));

  logic [P-1:0] f0_prim, f0_best_prim;
  logic         f0_found;
  logic [U-1:0] f0_best_num;
  logic [D-1:0] f0_best_det;
  assign {f0_prim, f0_found, f0_best_num, f0_best_det, f0_best_prim} = f0_best;

  // f1: num / det against best_num / best_det, cross-multiplied; all four are positive.
  logic           f1_hit_q, f1_found_q, f1_first_q;
  logic [U+D-1:0] f1_mine_q, f1_theirs_q;
  logic [U-1:0]   f1_num_q;
  logic [E-1:0]   f1_den_q;
  logic [D-1:0]   f1_det_q, f1_u_q, f1_v_q;
  logic [P-1:0]   f1_prim_q;
  logic           f1_any_q, f1_back_q, f1_u_neg_q, f1_v_neg_q;
  always_ff @(posedge clk_i) begin
    if (flat_q[Front-1]) f1_hit_q <= f0_hit;
    if (flat_q[Front-1] && f0_hit) begin
      f1_found_q <= f0_found;
      f1_first_q <= f0_prim <= f0_best_prim && !f0_any;
      if (f0_found) begin
        f1_mine_q   <= {{D{1'b0}}, f0_num} * {{U{1'b0}}, f0_best_det};
        f1_theirs_q <= {{D{1'b0}}, f0_best_num} * {{U{1'b0}}, f0_det};
      end
      f1_num_q  <= f0_num;
      f1_den_q  <= f0_den;
      f1_det_q  <= f0_det;
      f1_u_q    <= f0_u;
      f1_v_q    <= f0_v;
      f1_prim_q <= f0_prim;
      f1_any_q   <= f0_any;
      f1_back_q  <= f0_back;
      f1_u_neg_q <= f0_u_neg;
      f1_v_neg_q <= f0_v_neg;
    end
  end

  // f2: closer, or as close with a lower number.
  logic         f1_closer, f2_closer_q;
  logic [U-1:0] f2_num_q;
  logic [E-1:0] f2_den_q;
  logic [D-1:0] f2_det_q, f2_u_q, f2_v_q;
  logic [P-1:0] f2_prim_q;
  logic         f2_any_q, f2_back_q, f2_u_neg_q, f2_v_neg_q;
  assign f1_closer = f1_hit_q && (!f1_found_q || f1_mine_q < f1_theirs_q
                                  || (f1_mine_q == f1_theirs_q && f1_first_q));
  always_ff @(posedge clk_i) begin
    if (flat_q[Front]) f2_closer_q <= f1_closer;
    if (flat_q[Front] && f1_closer) begin
      f2_num_q  <= f1_num_q;
      f2_den_q  <= f1_den_q;
      f2_det_q  <= f1_det_q;
      f2_u_q    <= f1_u_q;
      f2_v_q    <= f1_v_q;
      f2_prim_q <= f1_prim_q;
      f2_any_q   <= f1_any_q;
      f2_back_q  <= f1_back_q;
      f2_u_neg_q <= f1_u_neg_q;
      f2_v_neg_q <= f1_v_neg_q;
    end
  end

  // Divisions; numerator, determinant and number wait.
  logic         f2_divide, f2_block;
  logic [T-1:0] t;
  logic [V-1:0] u, v;
  assign f2_divide = flat_q[Pre-1] && f2_closer_q && !f2_any_q;
  assign f2_block  = flat_q[Pre-1] && f2_closer_q && f2_any_q;
  rc_hitdiv #(.Stages(Divide), .E(E)) u_hitdiv (
    .clk_i, .valid_i(f2_divide), .num_i(f2_num_q), .den_i(f2_den_q), .det_i(f2_det_q),
    .u_i(f2_u_q), .v_i(f2_v_q), .u_neg_i(f2_u_neg_q), .v_neg_i(f2_v_neg_q),
    .t_o(t), .u_o(u), .v_o(v));

  logic [Divide-1:0] closer_q, block_q;
  logic [TailW-2:0]  f2_tail, tail;
  if (rc_pkg::Shading == 1) begin : gen_back
    assign f2_tail = {f2_back_q, f2_num_q, f2_det_q, f2_prim_q};
  end else begin : gen_no_back
    assign f2_tail = {f2_num_q, f2_det_q, f2_prim_q};
  end
  always_ff @(posedge clk_i) begin
    closer_q <= {closer_q[Divide-2:0], f2_divide};
    block_q  <= {block_q[Divide-2:0], f2_block};
  end
  rc_delay #(.Width(TailW - 1), .Stages(Divide)) u_tail (
    .clk_i, .valid_i({closer_q[Divide-2:0], f2_divide}), .data_i(f2_tail), .data_o(tail));

  // hit: closer with all that is told, or blocked with nothing.
  logic            closer, blocked;
  logic [HitW-2:0] hit;
  if (rc_pkg::Spheres == 1) begin : gen_sphere
    localparam int unsigned BallBestW = 2 + U + D;
    localparam int unsigned BestStage = Core - 2;
    localparam logic [D-1:0] Unit = D'(1) << (M - 1 + rc_pkg::TFracBits);   // det of a sphere
    logic [Late-1:0]      late_closer_q, late_block_q;
    logic [HitW-2:0]      flat_hit;
    logic [BallBestW-1:0] ball_best;
    logic [P-1:0]         ball_prim;
    logic                 ball_closer, ball_blocked, ball_far, ball_found, ball_first;
    logic [U-1:0]         ball_best_num;
    logic [D-1:0]         ball_best_det;
    logic [T-1:0]         ball_t;
    logic                 s0_ball, s0_first, s0_own;
    logic [P-1:0]         s0_self, s0_prim, s0_best_prim;
    logic [U+D:0]         s0_found_num_det;
    always_ff @(posedge clk_i) begin
      late_closer_q <= {late_closer_q[Late-2:0], closer_q[Divide-1]};
      late_block_q  <= {late_block_q[Late-2:0], block_q[Divide-1]};
    end
    rc_wait #(.Width(HitW - 1), .Stages(Late)) u_late (
      .clk_i, .rst_ni, .valid_i(closer_q[Divide-1]), .data_i({tail, t, u, v}), .data_o(flat_hit));

    assign s0_ball          = admit && s0_sphere;
    assign s0_self          = req_i.self;
    assign s0_best_prim     = req_i.best_prim;
    assign s0_found_num_det = {req_i.found, req_i.best_num, req_i.best_det};
    assign s0_prim          = req_i.prim;
    assign s0_own           = (s0_any || s0_leaves) && s0_self == s0_prim;
    assign s0_first         = s0_prim <= s0_best_prim;
    rc_wait #(.Width(BallBestW), .Stages(BestStage)) u_ball_best (
      .clk_i, .rst_ni, .valid_i(s0_ball), .data_i({s0_first, s0_found_num_det}),
      .data_o(ball_best));
    rc_wait #(.Width(P), .Stages(Core)) u_ball_prim (
      .clk_i, .rst_ni, .valid_i(s0_ball), .data_i(s0_prim), .data_o(ball_prim));
    assign {ball_first, ball_found, ball_best_num, ball_best_det} = ball_best;
    rc_sphere u_sphere (
      .clk_i, .rst_ni, .s0_valid_i(s0_ball), .s0_any_i(s0_any), .s0_leaves_i(s0_leaves),
      .s0_own_i(s0_own),
      .s0_inside_i(req_i.is_inside), .s0_o_i(req_i.o), .s0_d_i(req_i.d),
      .s0_c_i(s0_a), .s0_rr_i(s0_b[2*N-1:0]), .best_found_i(ball_found),
      .best_first_i(ball_first), .best_num_i(ball_best_num), .best_det_i(ball_best_det),
      .closer_o(ball_closer), .blocked_o(ball_blocked), .far_o(ball_far), .t_o(ball_t));

    assign closer  = late_closer_q[Late-1] || ball_closer;
    assign blocked = late_block_q[Late-1] || ball_blocked;
    assign hit     = late_closer_q[Late-1] ? flat_hit
                   : {ball_far, {(U-T){1'b0}}, ball_t, Unit, ball_prim, ball_t, {(2*V){1'b0}}};
  end else begin : gen_no_sphere
    assign closer  = closer_q[Divide-1];
    assign blocked = block_q[Divide-1];
    assign hit     = {tail, t, u, v};
  end

  logic            end_closer, end_blocked;
  logic [HitW-2:0] end_hit;
  if (Extra == 0) begin : gen_now
    assign {end_closer, end_blocked, end_hit} = {closer, blocked, hit};
  end else begin : gen_later
    rc_delay #(.Width(HitW + 1), .Stages(Extra)) u_end (
      .clk_i, .valid_i(valid_q[L-2:Core-1]), .data_i({closer, blocked, hit}),
      .data_o({end_closer, end_blocked, end_hit}));
  end

  logic                       queue_ready;
  logic [rc_pkg::TriRspW-1:0] queue_data, rsp_data;
  assign queue_data = end_closer ? {end_ray, 1'b1, end_hit}
                                 : {end_ray, end_blocked, {(HitW-1){1'b0}}};
  rc_fifo #(.Width(rc_pkg::TriRspW), .Depth(rc_pkg::TriQueue)) u_queue (
    .clk_i, .rst_ni, .valid_i(valid_q[L-1]), .ready_o(queue_ready), .data_i(queue_data),
    .valid_o(rsp_valid_o), .ready_i(rsp_ready_i), .data_o(rsp_data));
  assign rsp_o = rsp_data;

`ifndef SYNTHESIS
  a_never_dropped: assert property (@(posedge clk_i) disable iff (!rst_ni)
      valid_q[L-1] |-> queue_ready)
    else $error("an answer met a full queue");
`endif

  logic unused;
  assign unused = ^{queue_ready, req, s0_leaves, s0_plane, s0_sphere, f2_back_q};
endmodule
`default_nettype wire

// Ray-triangle test, and the comparison with the best hit.
//
// A constant of the configuration selects the test. rc_edges decides exactly
// (model/unit/tri/tri.hpp); rc_shear rounds the corners (model/unit/tri/sheared.hpp). These
// model files have the formulas, tie rules and proven widths. A triangle seen edge-on never hits.
//
// If the chip shades, rays have several kinds, and primitives include planes and spheres
// (model/unit/tri/any_primitive.hpp). For a ray from or to a light the answer is only whether
// the primitive is in its way. Spheres have their own pipeline, rc_sphere, which is longer; the
// others' answers wait for it.
//
// Latency rc_pkg::TriLatency + 1 (result queue), throughput 1 every rc_pkg::TriInterval cycles,
// answers in order. With an interval above 1, products share multipliers, and steps of a division
// share a stage. Cycles of TriLatency beyond those of the work (Core) follow at its end.
`default_nettype none
module rc_tri (
  input  logic             clk_i,
  input  logic             rst_ni,
  // From prim_cache, with the ray from list
  input  logic             req_valid_i,
  output logic             req_ready_o,
  input  rc_pkg::tri_req_t req_i,
  output logic             occupied_o,    // accepts nothing: the last products are being made
  // To list
  output logic             rsp_valid_o,
  input  logic             rsp_ready_i,
  output rc_pkg::tri_rsp_t rsp_o
);
  localparam bit          IsSheared = rc_pkg::PrimitiveTest == rc_pkg::TestSheared;
  localparam int unsigned N        = rc_pkg::CoordBits;
  localparam int unsigned M        = rc_pkg::DirBits;
  localparam int unsigned TBits    = rc_pkg::TBits;
  localparam int unsigned UvBits   = rc_pkg::UvBits;
  localparam int unsigned EdgeBits = rc_pkg::EdgeBits;   // width of det, u, v
  localparam int unsigned NumBits  = rc_pkg::NumBits;
  localparam int unsigned DenW     = IsSheared ? 2 * N + M + 2 : EdgeBits;   // width of den
  localparam int unsigned RayBits  = rc_pkg::RayBits;
  localparam int unsigned PrimBits = rc_pkg::PrimBits;
  localparam int unsigned Latency  = rc_pkg::TriLatency;
  localparam int unsigned Cut      = rc_pkg::PathCut;
  localparam int unsigned Mul      = rc_pkg::MulStages;
  localparam int unsigned Share    = rc_pkg::PairShare;    // products or parts, per multiplier
  localparam int unsigned Pair     = rc_pkg::PairStages;   // of a pair of products, without Mul
  localparam int unsigned Interval = rc_pkg::TriInterval;

  // Stages in which a triangle has arrived, is tested, and is compared. In Flat all primitives
  // except spheres are done, in Ball the spheres, in Core both.
  localparam int unsigned In    = Cut + rc_pkg::FarPathCut;
  localparam int unsigned Front = In + (IsSheared ? rc_pkg::ShearStages : rc_pkg::EdgesStages);
  localparam int unsigned Wide  = Front + Mul + Pair;   // the products for the comparison are ready
  localparam int unsigned Pre   = Wide + Cut + 1;
  localparam int unsigned Flat  = Pre + rc_pkg::HitdivStages;
  localparam int unsigned Ball  = In + rc_pkg::SphereStages;
  localparam int unsigned Core  = rc_pkg::Spheres && Ball > Flat ? Ball : Flat;
  localparam int unsigned Extra = Latency - Core;
  localparam int unsigned TailW = rc_pkg::TriTailW;
  localparam int unsigned HitW  = rc_pkg::TriHitW;

  // What waits for the comparison: a hit's numbers.
  typedef struct packed {
    logic [NumBits-1:0]  num;
    logic [EdgeBits-1:0] det, u, v;
    logic                back, u_neg, v_neg;
  } compared_t;
  localparam int unsigned ComparedW = NumBits + 3 * EdgeBits + 3;

  // The hit to beat of a sphere's ray.
  typedef struct packed {
    logic                first, found;
    logic [NumBits-1:0]  num;
    logic [EdgeBits-1:0] det;
  } ball_best_t;
  localparam int unsigned BallBestW = 2 + NumBits + EdgeBits;

  if (Latency < Core) begin : gen_refuse
    $error("rc_tri: TriLatency must be at least Core");
  end

  // ---- Admission: an answer has a place in the result queue. valid[i]: stage i holds a primitive.
  logic               admit;
  logic [Latency-1:0] valid_q;
  logic [Latency:0]   valid;

  assign valid = {valid_q, admit};

  rc_credited_pipeline #(.Credits(rc_pkg::TriQueue), .Stages(Latency)) u_stages (
    .clk_i, .rst_ni, .req_valid_i, .req_ready_o, .occupied_i(occupied_o),
    .leave_i(rsp_valid_o && rsp_ready_i), .admit_o(admit), .valid_q_o(valid_q));

  if (Interval > 1) begin : gen_occupied
    assign occupied_o = |valid_q[Interval-2:0];
  end else begin : gen_never_occupied
    assign occupied_o = 1'b0;
  end

  // enable[i]: the register after stage i accepts its input (rtl/README.md, Relaxed and fast).
  logic [Latency:0] enable;

  assign enable = valid | {(Latency+1){Cut != 0}};

  // The request.
  rc_pkg::tri_req_t           in;
  logic [rc_pkg::TriReqW-1:0] in_flat;

  rc_path_register #(.Width(rc_pkg::TriReqW), .Stages(In)) u_in (
    .clk_i, .data_i(req_i), .data_o(in_flat));

  assign in = in_flat;

  logic [RayBits-1:0] end_ray;

  rc_interval_delay #(.Width(RayBits), .Stages(Latency - In), .Every(Interval)) u_ray (
    .clk_i, .rst_ni, .enable_i(enable[Latency-1:In]), .valid_i(valid[Latency-1:In]),
    .data_i(in.ray), .data_o(end_ray));

  // ---- Stages up to Front: the ray and the primitive, and whether they meet. num / den is t; num
  // / det is compared with other hits of the ray.
  logic [3*N-1:0]                  in_a, in_b, in_c;
  logic                            f0_hit;
  logic [EdgeBits-1:0]             f0_det, f0_u, f0_v;
  logic [NumBits-1:0]              f0_num;
  logic                            f0_back, f0_u_neg, f0_v_neg;
  logic                            in_any;      // any hit will do: a ray from or to a light
  logic                            in_leaves;   // from a surface: a bounce, or away to a light
  logic                            in_plane, in_sphere;
  logic                            in_cutout;   // a cut-out, which a ray to a light has met
  // The ray begins beyond the lattice, and tests planes only.
  logic                            in_far;
  logic                            in_skips;    // the ray does not test such a primitive

  assign in_a    = in.a;
  assign in_b    = in.b;
  assign in_c    = in.c;

  if (rc_pkg::Shading) begin : gen_kind
    assign in_any    = in.kind == rc_pkg::RayShadow || in.kind == rc_pkg::RayAway;
    // In an instance a camera ray's origin has a fraction as well.
    assign in_leaves = in.kind == rc_pkg::RayBounce || in.kind == rc_pkg::RayAway
                    || (rc_pkg::Levels == 2 && in.kind == rc_pkg::RayCamera);
  end else begin : gen_camera
    assign in_any    = 1'b0;
    assign in_leaves = 1'b0;
  end

  if (rc_pkg::HasPrimKinds) begin : gen_prim_kind
    assign in_plane  = rc_pkg::Planes && in.prim_kind == rc_pkg::PrimPlane;
    assign in_sphere = rc_pkg::Spheres && in.prim_kind == rc_pkg::PrimSphere;
    assign in_cutout = rc_pkg::HasTextures && in_any && in.prim_kind == rc_pkg::PrimCutout;
  end else begin : gen_triangle
    assign in_plane  = 1'b0;
    assign in_sphere = 1'b0;
    assign in_cutout = 1'b0;
  end

  if (rc_pkg::HasPartial) begin : gen_partial
    assign in_far   = rc_pkg::Horizon && in.is_partial && in.kind == rc_pkg::RayBounce;
    assign in_skips = in.is_partial && (in_plane ? in_any : in_far);
  end else begin : gen_meets_all
    assign in_far   = 1'b0;
    assign in_skips = 1'b0;
  end

  // flat[i]: stage i, of those up to the divisions, holds a primitive that is not a sphere.
  logic [Pre:In] flat;
  if (rc_pkg::Spheres) begin : gen_flat
    logic [Pre-In-1:0] flat_q;

    assign flat = {flat_q, valid[In] && !in_sphere};

    always_ff @(posedge clk_i) begin
      if (!rst_ni) flat_q <= '0;
      else         flat_q <= flat[Pre-1:In];
    end
  end else begin : gen_all_flat
    assign flat = valid[Pre:In];
  end

  logic [Pre:In] flat_enable;   // enable, for primitives that are not spheres

  assign flat_enable = flat | {(Pre-In+1){Cut != 0}};

  // t's divisor. In the sheared test it includes the direction's size as a factor; that product is
  // ready with those of the comparison.
  logic [DenW-1:0]     pre_den;
  compared_t           pre;   // the hit, at the end of the comparison

  if (IsSheared) begin : gen_sheared
    logic [M-1:0]          f0_size;
    logic [EdgeBits+M-1:0] f0_den;
    logic [DenW-1:0]       f1_den, wide_den_q;

    rc_shear u_shear (
      .clk_i, .enable_i(flat_enable[Front-1:In]),
      .s0_axis_i(in.axis), .s0_neg_i(in.neg), .s0_size_i(in.size), .s0_slope_i(in.slope),
      .s0_o_i(in.o), .s0_a_i(in_a), .s0_b_i(in_b), .s0_c_i(in_c),
      .s6_hit_o(f0_hit), .s6_size_o(f0_size), .s6_det_o(f0_det), .s6_num_o(f0_num),
      .s6_u_o(f0_u), .s6_v_o(f0_v));

    rc_mul #(.AW(EdgeBits), .BW(M), .Signed(1'b0)) u_den (
      .clk_i, .a_i(f0_det), .b_i(f0_size), .p_o(f0_den));

    rc_path_register #(.Width(DenW), .Stages(Pair - 1)) u_den_late (
      .clk_i, .data_i(f0_den[DenW-1:0]), .data_o(f1_den));

    always_ff @(posedge clk_i) if (flat_enable[Wide-1]) wide_den_q <= f1_den;
    rc_shift_register #(.Width(DenW), .Stages(Pre - Wide)) u_pre_den (
      .clk_i, .enable_i(flat_enable[Pre-1:Wide]), .data_i(wide_den_q), .data_o(pre_den));

    assign {f0_back, f0_u_neg, f0_v_neg} = '0;

    logic unused;
    assign unused = ^f0_den;
  end else begin : gen_exact
    rc_edges u_edges (
      .clk_i, .enable_i(flat_enable[Front-1:In]), .valid_i(flat[Front-1:In]),
      .s0_leaves_i(in_leaves), .s0_far_i(in_far), .s0_plane_i(in_plane),
      .s0_o_i(in.o), .s0_d_i(in.d), .s0_a_i(in_a), .s0_b_i(in_b), .s0_c_i(in_c),
      .hit_o(f0_hit), .det_o(f0_det), .num_o(f0_num), .u_o(f0_u), .v_o(f0_v),
      .back_o(f0_back), .u_neg_o(f0_u_neg), .v_neg_o(f0_v_neg));

    assign pre_den = pre.det;
  end

  // In parallel, the number and the hit to beat wait. A ray from a light must be blocked before its
  // end, t = 2^-B, and equality does not count. A ray away to a light has no end. A primitive that
  // the ray does not test always comes too late: the hit to beat is then at the ray's origin.
  localparam logic [EdgeBits-1:0] ShadowDet = EdgeBits'(1) << rc_pkg::OriginBits;

  logic                in_found, in_first, wide_found, wide_first;
  logic [NumBits-1:0]  in_best_num, f0_best_num;
  logic [EdgeBits-1:0] in_best_det, f0_best_det;

  assign in_found    = in_skips || (in_any ? !in_leaves : in.found);
  assign in_best_num = in_skips ? '0 : in_any ? NumBits'(1) : in.best_num;
  assign in_best_det = in_any ? ShadowDet : in.best_det;
  assign in_first    = in.prim <= in.best_prim && !in_any && !in_skips;

  rc_shift_register #(.Width(2), .Stages(Wide - In)) u_best (
    .clk_i, .enable_i(flat_enable[Wide-1:In]), .data_i({in_found, in_first}),
    .data_o({wide_found, wide_first}));

  rc_interval_delay #(.Width(NumBits + EdgeBits), .Stages(Front - In), .Every(Interval))
  u_best_hit (
    .clk_i, .rst_ni, .enable_i(flat_enable[Front-1:In]), .valid_i(flat[Front-1:In]),
    .data_i({in_best_num, in_best_det}), .data_o({f0_best_num, f0_best_det}));

  // ---- The comparison: num / det against best_num / best_det, cross-multiplied; all four are
  // positive. A hit is closer, or equally close with a lower number.
  logic [NumBits+EdgeBits-1:0] f0_mine, f0_theirs, f1_mine_q, f1_theirs_q;
  logic                        f1_hit, wide_before, last_before, last_hit, pre_closer_q;

  if (Share == 1) begin : gen_at_once
    rc_mul #(.AW(NumBits), .BW(EdgeBits), .Signed(1'b0), .Sums(2)) u_mine (
      .clk_i, .a_i(f0_num), .b_i(f0_best_det), .p_o(f0_mine));
    rc_mul #(.AW(NumBits), .BW(EdgeBits), .Signed(1'b0), .Sums(2)) u_theirs (
      .clk_i, .a_i(f0_best_num), .b_i(f0_det), .p_o(f0_theirs));
  end else if (rc_pkg::PairParts == 1) begin : gen_parts
    rc_mul_parts #(.AW(NumBits), .BW(EdgeBits), .Signed(1'b0), .Sums(2), .Products(2),
                   .Share(Share))
    u_products (
      .clk_i, .valid_i(flat[Front]), .a_i({f0_best_num, f0_num}), .b_i({f0_det, f0_best_det}),
      .p_o({f0_theirs, f0_mine}));
  end else begin : gen_shared
    rc_mul_shared #(.AW(NumBits), .BW(EdgeBits), .Signed(1'b0), .Sums(2), .Share(Share))
    u_products (
      .clk_i, .valid_i(flat[Front]), .a_i({f0_best_num, f0_num}), .b_i({f0_det, f0_best_det}),
      .p_o({f0_theirs, f0_mine}));
  end

  rc_path_register #(.Width(1), .Stages(Mul + Pair - 1)) u_f1_hit (
    .clk_i, .data_i(f0_hit), .data_o(f1_hit));

  // In a simulation of a relaxed chip, unused products cost no work. Silicon has no such condition.
  logic f1_computes;
`ifdef SYNTHESIS
  assign f1_computes = 1'b1;
`else
  logic f1_found;
  rc_shift_register #(.Width(1), .Stages(Wide - 1 - In)) u_f1_found (
    .clk_i, .enable_i(flat_enable[Wide-2:In]), .data_i(in_found), .data_o(f1_found));
  assign f1_computes = Cut != 0 || f1_found;
`endif

  always_ff @(posedge clk_i) begin
    if (flat_enable[Wide-1] && (Cut != 0 || f1_hit) && f1_computes) begin
      f1_mine_q   <= f0_mine;
      f1_theirs_q <= f0_theirs;
    end
  end

  assign wide_before = !wide_found || {f1_mine_q, 1'b0} < {f1_theirs_q, wide_first};
  rc_path_register #(.Width(1)) u_before (.clk_i, .data_i(wide_before), .data_o(last_before));

  rc_shift_register #(.Width(1), .Stages(Pre - Wide)) u_hit (
    .clk_i, .enable_i(flat_enable[Pre-2:Wide-1]), .data_i(f1_hit), .data_o(last_hit));

  always_ff @(posedge clk_i) if (flat_enable[Pre-1]) pre_closer_q <= last_hit && last_before;

  // The hit waits for the comparison.
  localparam int unsigned Compare = Pre - Front;
  compared_t                     f0;
  logic [ComparedW-1:0]          pre_flat;
  rc_pkg::tri_number_t           in_number, pre_number;
  logic [rc_pkg::TriNumberW-1:0] pre_number_flat;
  logic                          pre_cutout;

  assign f0.num   = f0_num;
  assign f0.det   = f0_det;
  assign f0.u     = f0_u;
  assign f0.v     = f0_v;
  assign f0.back  = f0_back;
  assign f0.u_neg = f0_u_neg;
  assign f0.v_neg = f0_v_neg;

  rc_interval_delay #(.Width(ComparedW), .Stages(Compare), .Every(Interval)) u_hit_aside (
    .clk_i, .rst_ni, .enable_i(flat_enable[Pre-1:Front]), .valid_i(flat[Pre-1:Front]),
    .data_i(f0), .data_o(pre_flat));

  assign pre = pre_flat;

  assign in_number.prim = in.prim;
  assign in_number.any  = in_any;

  rc_interval_delay #(.Width(rc_pkg::TriNumberW), .Stages(Pre - In), .Every(Interval)) u_prim (
    .clk_i, .rst_ni, .enable_i(flat_enable[Pre-1:In]), .valid_i(flat[Pre-1:In]),
    .data_i(in_number), .data_o(pre_number_flat));

  assign pre_number = pre_number_flat;

  if (rc_pkg::HasTextures) begin : gen_cutout
    assign in_number.cutout = in_cutout;
    assign pre_cutout       = pre_number.cutout;
  end else begin : gen_no_cutout
    assign pre_cutout = 1'b0;

    logic unused;
    assign unused = in_cutout;
  end

  // ---- Divisions. Numerator, determinant and number wait.
  localparam int unsigned Divide = rc_pkg::HitdivStages;
  logic              pre_divide, pre_block;
  logic [TBits-1:0]  t;
  logic [UvBits-1:0] u, v;

  assign pre_divide = flat[Pre] && pre_closer_q && (!pre_number.any || pre_cutout);
  assign pre_block  = flat[Pre] && pre_closer_q && pre_number.any && !pre_cutout;

  rc_hitdiv #(.DenW(DenW)) u_hitdiv (
    .clk_i, .enable_i(Cut != 0 || pre_divide), .valid_i(pre_divide),
    .num_i(pre.num), .den_i(pre_den), .det_i(pre.det),
    .u_i(pre.u), .v_i(pre.v), .u_neg_i(pre.u_neg), .v_neg_i(pre.v_neg),
    .t_o(t), .u_o(u), .v_o(v));

  // Valid bits of the division, and the fields that wait.
  logic [Divide-1:0] closer_q, block_q, divides, tail_enable;

  assign divides     = {closer_q[Divide-2:0], pre_divide};
  assign tail_enable = divides | {Divide{Cut != 0}};

  rc_pkg::tri_tail_t pre_tail;
  logic [TailW-1:0]  tail;

  assign pre_tail.num  = pre.num;
  assign pre_tail.det  = pre.det;
  assign pre_tail.prim = pre_number.prim;
  if (rc_pkg::Shading) begin : gen_back
    assign pre_tail.back = pre.back;
  end
  if (rc_pkg::HasTextures) begin : gen_tail_cutout
    assign pre_tail.cutout = pre_cutout;
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) closer_q <= '0;
    else         closer_q <= divides;
    block_q <= {block_q[Divide-2:0], pre_block};
  end

  rc_interval_delay #(.Width(TailW), .Stages(Divide), .Every(Interval)) u_tail (
    .clk_i, .rst_ni, .enable_i(tail_enable), .valid_i(divides), .data_i(pre_tail), .data_o(tail));

  // ---- The hit: closer with all fields, or blocked without fields.
  logic              closer, blocked;
  logic [HitW-1:0]   hit;
  rc_pkg::tri_hit_t  flat_now, ball_hit;   // not a sphere; a sphere
  rc_pkg::tri_tail_t ball_tail;
  ball_best_t        in_best, ball_best;

  assign flat_now.tail = tail;
  assign flat_now.t    = t;
  assign flat_now.u    = u;
  assign flat_now.v    = v;

  if (rc_pkg::Spheres) begin : gen_sphere
    localparam int unsigned BestStage = rc_pkg::SphereStages - Mul - 2 - Cut
                                      - (rc_pkg::PairParts == 1 ? 1 + Cut : 0);

    localparam int unsigned FlatLate  = Core - Flat;   // stages of waiting for the other
    localparam int unsigned BallLate  = Core - Ball;
    // Det of a sphere.
    localparam logic [EdgeBits-1:0] Unit = EdgeBits'(1) << (M - 1 + rc_pkg::TFracBits);

    logic                 flat_closer, flat_block;
    logic [HitW-1:0]      flat_hit;
    logic [BallBestW-1:0] next_best, ball_best_flat;
    logic [PrimBits-1:0]  ball_prim;
    logic                 ball_closer, ball_blocked, ball_far;
    logic                 late_closer, late_blocked, late_far;
    logic [TBits-1:0]     ball_t, late_t;
    logic                 in_ball, in_own, in_inside, best_next;
    logic [2*N-1:0]       in_square;   // of the radius: the low bits of b
    logic                 in_glass;    // its inside can be seen: the bit above them

    if (FlatLate == 0) begin : gen_flat_last
      assign {flat_closer, flat_block} = {closer_q[Divide-1], block_q[Divide-1]};
      assign flat_hit                  = flat_now;
    end else begin : gen_flat_waits
      localparam int unsigned Late = (FlatLate + Interval - 1) / Interval;
      logic [FlatLate-1:0] late_closer_q;
      logic [FlatLate:0]   late;

      assign late        = {late_closer_q, closer_q[Divide-1]};
      assign flat_closer = late[FlatLate];

      always_ff @(posedge clk_i) begin
        if (!rst_ni) late_closer_q <= '0;
        else         late_closer_q <= late[FlatLate-1:0];
      end

      rc_path_register #(.Width(1), .Stages(FlatLate)) u_block (
        .clk_i, .data_i(block_q[Divide-1]), .data_o(flat_block));

      rc_stage_delay #(.Width(HitW), .Stages(Late), .Every(Interval)) u_late (
        .clk_i, .rst_ni, .enter_i(closer_q[Divide-1]), .leave_i(flat_closer),
        .data_i(flat_now), .data_o(flat_hit));
    end

    // Spheres.
    assign in_ball               = valid[In] && in_sphere;
    assign {in_glass, in_square} = in_b[2*N:0];
    // A primitive that the ray does not test counts as the ray's own sphere, seen from outside:
    // never met.
    if (rc_pkg::HasSelf) begin : gen_own
      assign in_own    = in_far
                      || ((in_any || in.kind == rc_pkg::RayBounce) && in.self == in.prim);
      assign in_inside = in.is_inside && !in_far;
    end else begin : gen_no_own
      assign in_own    = 1'b0;
      assign in_inside = 1'b0;
    end

    assign in_best.first = in.prim <= in.best_prim;
    assign in_best.found = in.found;
    assign in_best.num   = in.best_num;
    assign in_best.det   = in.best_det;

    rc_stage_delay #(
      .Width(BallBestW), .Stages((BestStage + Interval - 2) / Interval), .Every(Interval))
    u_ball_best (
      .clk_i, .rst_ni, .enter_i(in_ball), .leave_i(best_next),
      .data_i(in_best), .data_o(next_best));

    rc_path_register #(.Width(BallBestW), .Stages(1)) u_best_last (
      .clk_i, .data_i(next_best), .data_o(ball_best_flat));

    rc_delay_ram #(.Width(PrimBits), .Stages(Core - In)) u_ball_prim (
      .clk_i, .rst_ni, .valid_i(in_ball), .data_i(in.prim), .data_o(ball_prim));

    assign ball_best = ball_best_flat;

    rc_sphere u_sphere (
      .clk_i, .rst_ni, .s0_valid_i(in_ball), .s0_any_i(in_any), .s0_leaves_i(in_leaves),
      .s0_own_i(in_own),
      .s0_inside_i(in_inside), .s0_o_i(in.o), .s0_d_i(in.d),
      .s0_c_i(in_a), .s0_rr_i(in_square), .s0_glass_i(in_glass), .best_next_o(best_next),
      .best_found_i(ball_best.found), .best_first_i(ball_best.first),
      .best_num_i(ball_best.num), .best_det_i(ball_best.det),
      .closer_o(ball_closer), .blocked_o(ball_blocked), .far_o(ball_far), .t_o(ball_t));

    rc_path_register #(.Width(TBits + 3), .Stages(BallLate)) u_ball_late (
      .clk_i, .data_i({ball_closer, ball_blocked, ball_far, ball_t}),
      .data_o({late_closer, late_blocked, late_far, late_t}));

    assign closer  = flat_closer || late_closer;
    assign blocked = flat_block || late_blocked;
    assign hit     = flat_closer ? flat_hit : ball_hit;

    assign ball_tail.num  = {{(NumBits-TBits){1'b0}}, late_t};
    assign ball_tail.det  = Unit;
    assign ball_tail.prim = ball_prim;
    if (rc_pkg::Shading) begin : gen_far
      assign ball_tail.back = late_far;
    end else begin : gen_no_far
      logic unused;
      assign unused = late_far;
    end
    if (rc_pkg::HasTextures) begin : gen_no_cutout
      assign ball_tail.cutout = 1'b0;
    end

    assign ball_hit.tail = ball_tail;
    assign ball_hit.t    = late_t;
    assign ball_hit.u    = '0;
    assign ball_hit.v    = '0;
  end else begin : gen_no_sphere
    assign closer  = closer_q[Divide-1];
    assign blocked = block_q[Divide-1];
    assign hit     = flat_now;

    assign {ball_tail, ball_hit, in_best, ball_best} = '0;
    logic unused;
    assign unused = ^{ball_tail, ball_hit, in_best, ball_best};
  end

  // Spare cycles.
  logic            end_closer, end_blocked;
  logic [HitW-1:0] end_hit;

  if (Extra == 0) begin : gen_now
    assign {end_closer, end_blocked, end_hit} = {closer, blocked, hit};
  end else begin : gen_later
    rc_shift_register #(.Width(HitW + 2), .Stages(Extra)) u_end (
      .clk_i, .enable_i(enable[Latency-1:Core]), .data_i({closer, blocked, hit}),
      .data_o({end_closer, end_blocked, end_hit}));
  end

  // ---- Result queue.
  logic                       queue_ready;
  rc_pkg::tri_rsp_parts_t     end_rsp;
  logic [rc_pkg::TriRspW-1:0] rsp_data;

  assign end_rsp.ray    = end_ray;
  assign end_rsp.closer = end_closer || end_blocked;
  assign end_rsp.hit    = end_closer ? end_hit : '0;

  rc_fifo #(.Width(rc_pkg::TriRspW), .Depth(rc_pkg::TriQueue)) u_queue (
    .clk_i, .rst_ni, .valid_i(valid_q[Latency-1]), .ready_o(queue_ready), .data_i(end_rsp),
    .valid_o(rsp_valid_o), .ready_i(rsp_ready_i), .data_o(rsp_data));

  assign rsp_o = rsp_data;

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) if (rst_ni && valid_q[Latency-1])
    a_never_dropped: assert (queue_ready)
    else $error("an answer met a full queue");

  always_ff @(posedge clk_i) if (rst_ni && admit) a_in_turn: assert (!occupied_o)
    else $error("a primitive came before the products of the last were made");
`endif

  logic unused;
  assign unused = ^{queue_ready, valid[Latency], enable, flat_enable, in_flat, in_leaves, in_far,
                    in_plane, in_sphere, pre};
endmodule
`default_nettype wire

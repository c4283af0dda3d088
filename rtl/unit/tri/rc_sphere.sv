// Ray-sphere test. It decides exactly whether the ray meets the sphere. The distance includes a
// square root, rounded so that t is never too small. Then the hit is compared with the best hit.
//
// Part of rc_tri, which delays the best hit. Formulas, rules, the error bound and the proof of the
// widths: model/unit/tri/any_primitive.hpp. Model: sphere_test() in
// model/unit/tri/any_primitive.cpp.
//
// Latency rc_pkg::SphereStages, throughput 1 every rc_pkg::TriInterval cycles. With an interval
// above 1, products share multipliers, and steps of the root and of the division share a stage.
// model/core/stages.cpp counts its stages in the same way. A signal's prefix names its stage:
// - s1: the vector from the centre; s2: the products; s3: products of these; s4: the decision;
// - s5: the shortened discriminant; r: its root; w: the way along the ray (WayW bits);
// - t: the distance; p: the products with the best hit.
`default_nettype none
module rc_sphere #(
  localparam int unsigned N           = rc_pkg::CoordBits,
  localparam int unsigned OriginBits  = rc_pkg::OriginBits,
  localparam int unsigned OriginWidth = rc_pkg::OriginWidth,
  localparam int unsigned RayDirBits  = rc_pkg::RayDirBits,
  localparam int unsigned M           = rc_pkg::DirBits,
  localparam int unsigned F           = rc_pkg::TFracBits,
  localparam int unsigned TBits       = rc_pkg::TBits,
  localparam int unsigned NumBits     = rc_pkg::NumBits,
  localparam int unsigned EdgeBits    = rc_pkg::EdgeBits
) (
  input  logic                     clk_i,
  input  logic                     rst_ni,
  input  logic                     s0_valid_i,
  // Ray
  input  logic                     s0_any_i,      // any hit will do: a ray from or to a light
  // s0_leaves_i: the ray starts from a surface. Other rays with s0_any_i start from a light.
  input  logic                     s0_leaves_i,
  input  logic                     s0_own_i,      // the sphere on which the ray begins or ends
  input  logic                     s0_inside_i,   // the ray is inside its own sphere
  input  logic [3*OriginWidth-1:0] s0_o_i,
  input  logic [3*RayDirBits-1:0]  s0_d_i,
  // Sphere
  input  logic [3*N-1:0]           s0_c_i,        // centre
  input  logic [2*N-1:0]           s0_rr_i,       // square of the radius
  // s0_glass_i: the sphere is visible from inside as well, because its material transmits light.
  input  logic                     s0_glass_i,
  // Best hit
  output logic                     best_next_o,   // requests the best hit for the next cycle
  input  logic                     best_found_i,
  input  logic                     best_first_i,  // this sphere's number is not the higher one
  input  logic [NumBits-1:0]       best_num_i,
  input  logic [EdgeBits-1:0]      best_det_i,
  // Result
  output logic                     closer_o,
  output logic                     blocked_o,     // instead of closer, if any hit will do
  output logic                     far_o,
  output logic [TBits-1:0]         t_o            // if closer
);
  localparam int unsigned VectorW     = OriginWidth + 1;       // s
  localparam int unsigned NearSquareW = 2 * M;                 // d.d of all rays except shadow rays
  localparam int unsigned PowerW      = 2 * OriginWidth + 3;   // s.s - R2
  // SquareW: d.d and a sign. WayW: d.s of all rays except shadow rays. AlongW: d.s of all rays.
  localparam int unsigned SquareW = PowerW > NearSquareW + 1 ? PowerW : NearSquareW + 1;
  localparam int unsigned WayW    = M + OriginWidth + 2 > NearSquareW + 1
                                  ? M + OriginWidth + 2 : NearSquareW + 1;
  localparam int unsigned AlongW  = WayW > N + OriginWidth + 3 ? WayW : N + OriginWidth + 3;
  // DiscW: the discriminant. Plain: the same, if the sphere is met.
  localparam int unsigned DiscW   = 2 * (M + OriginWidth) + 2 > 2 * (N + OriginWidth) + 4
                                  ? 2 * (M + OriginWidth) + 2 : 2 * (N + OriginWidth) + 4;
  localparam int unsigned RootW  = rc_pkg::RootBits;
  localparam int unsigned Plain  = 2 * (M + OriginWidth) > 2 * RootW
                                 ? 2 * (M + OriginWidth) : 2 * RootW;
  localparam int unsigned Levels = rc_pkg::SphereLevels;   // of the shift that leaves 2 RootW bits
  localparam int unsigned RightW = Levels > 0 ? Levels : 1;
  localparam int unsigned Cut    = rc_pkg::PathCut;
  localparam int unsigned Mul    = rc_pkg::MulStages;
  localparam int unsigned Every  = rc_pkg::TriInterval;
  localparam int unsigned Three  = rc_pkg::CrossShare;     // of three products, per multiplier
  localparam int unsigned Share  = rc_pkg::PairShare;      // of two products, or their parts
  localparam int unsigned Pair   = rc_pkg::PairStages;     // cycles of two products, without Mul
  localparam bit          Parts  = rc_pkg::PairParts == 1;
  localparam int unsigned Bits   = rc_pkg::QuotientBits;   // of root and quotient, per step
  localparam int unsigned RootSteps = RootW / Bits;
  localparam int unsigned DivSteps  = (TBits + Bits - 1) / Bits;

  // Cycles from a sphere's arrival to each stage.
  localparam int unsigned AtS2 = 1 + Mul + Three;
  localparam int unsigned AtS3 = AtS2 + Mul + Pair;
  localparam int unsigned AtS4 = AtS3 + Cut + 1;
  localparam int unsigned AtS5 = AtS4 + Levels * Cut + 1;
  localparam int unsigned AtR  = AtS5 + RootSteps;
  localparam int unsigned AtW  = AtR + 2 * Cut + 1;
  localparam int unsigned AtT  = AtW + DivSteps + 2 * Cut;
  localparam int unsigned AtP  = AtT + Mul + 1 + (Parts ? 1 + Cut : 0);
  localparam int unsigned End  = AtP + Cut + 1;

  if (End != rc_pkg::SphereStages || RootW % Bits != 0) begin : gen_refuse
    $error("rc_sphere: its stages are not those of model/core/stages.cpp");
  end

  // valid[k]: a sphere came k cycles ago. met, from s4 on: a ray that needs the distance meets it.
  logic [End-1:0]    valid_q;
  logic [End:0]      valid, enable;
  logic [End-1:AtS4] met_q, met_enable, far_q, blocked_q;
  logic              s3_met, s3_blocks, s3_far;

  assign valid = {valid_q, s0_valid_i};

  // In a fast chip the stages always accept, as in rc_tri.
  assign enable     = valid | {(End+1){Cut != 0}};
  assign met_enable = met_q | {(End-AtS4){Cut != 0}};

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid_q   <= '0;
      met_q     <= '0;
      blocked_q <= '0;
    end else begin
      valid_q   <= valid[End-1:0];
      met_q     <= {met_q[End-2:AtS4], s3_met};
      blocked_q <= {blocked_q[End-2:AtS4], s3_blocks};
    end
    far_q     <= {far_q[End-2:AtS4], s3_far};
    blocked_o <= blocked_q[End-1];
    far_o     <= far_q[End-1];
  end

  // ---- s1: the vector from the centre to the origin, 2^OriginBits (o - c); in lattice steps for
  // a shadow ray.
  logic [2*OriginWidth-1:0] s1_rr_q, s2_rr;
  logic                     s0_shadow, s1_any_q, s1_shadow_q, s1_own_q, s1_inside_q, s1_glass_q;
  logic                     s2_any, s2_shadow, s2_own, s2_inside, s2_glass;

  assign s0_shadow = s0_any_i && !s0_leaves_i;

  for (genvar k = 0; k < 3; k++) begin : gen_axis
    localparam int unsigned WiderW = RayDirBits > VectorW ? RayDirBits : VectorW;

    logic signed [OriginWidth-1:0]        s0_o;
    logic signed [N-1:0]                  s0_c;
    logic signed [VectorW-1:0]            s0_s, s1_s_q;
    logic signed [RayDirBits-1:0]         s1_d_q;
    logic signed [RayDirBits+VectorW-1:0] along;
    logic signed [2*RayDirBits-1:0]       square;
    logic signed [2*VectorW-1:0]          power;

    assign s0_o = s0_o_i[k*OriginWidth +: OriginWidth];
    assign s0_c = s0_c_i[k*N +: N];
    assign s0_s = VectorW'(s0_o) - (VectorW'(s0_c) <<< OriginBits);

    always_ff @(posedge clk_i) begin
      if (enable[0]) begin
        s1_d_q <= s0_d_i[k*RayDirBits +: RayDirBits];
        s1_s_q <= s0_shadow ? s0_s >>> OriginBits : s0_s;
      end
    end

    if (Three == 1) begin : gen_at_once
      rc_mul #(.AW(RayDirBits), .BW(VectorW)) u_along (
        .clk_i, .a_i(s1_d_q), .b_i(s1_s_q), .p_o(along));
      rc_mul #(.AW(RayDirBits), .BW(RayDirBits)) u_square (
        .clk_i, .a_i(s1_d_q), .b_i(s1_d_q), .p_o(square));
      rc_mul #(.AW(VectorW), .BW(VectorW)) u_power (
        .clk_i, .a_i(s1_s_q), .b_i(s1_s_q), .p_o(power));
    end else begin : gen_shared
      logic [3*2*WiderW-1:0] products;

      rc_mul_shared #(.AW(WiderW), .BW(WiderW), .Products(3), .Share(Three)) u_products (
        .clk_i, .valid_i(valid[1]), .a_i({WiderW'(s1_d_q), WiderW'(s1_d_q), WiderW'(s1_s_q)}),
        .b_i({WiderW'(s1_s_q), WiderW'(s1_d_q), WiderW'(s1_s_q)}), .p_o(products));

      assign power  = products[0 +: 2*VectorW];
      assign square = products[2*WiderW +: 2*RayDirBits];
      assign along  = products[4*WiderW +: RayDirBits+VectorW];

      logic unused;
      assign unused = ^products;
    end

    logic unused;
    assign unused = ^{along, square, power};
  end

  always_ff @(posedge clk_i) begin
    if (enable[0]) begin
      s1_rr_q <= s0_shadow ? {{(2*OriginBits){1'b0}}, s0_rr_i} : {s0_rr_i, {(2*OriginBits){1'b0}}};
      {s1_any_q, s1_shadow_q}  <= {s0_any_i, s0_shadow};
      {s1_own_q, s1_glass_q}   <= {s0_own_i, s0_glass_i};
      s1_inside_q              <= s0_inside_i && s0_glass_i;
    end
  end

  if (Mul + Three == 1) begin : gen_rr_now
    assign s2_rr = s1_rr_q;
  end else begin : gen_rr_waits   // up to the cycle before s2
    rc_interval_delay #(.Width(2 * OriginWidth), .Stages(Mul + Three - 1), .Every(Every)) u_rr (
      .clk_i, .rst_ni, .enable_i(enable[AtS2-2:1]), .valid_i(valid[AtS2-2:1]), .data_i(s1_rr_q),
      .data_o(s2_rr));
  end

  rc_shift_register #(.Width(5), .Stages(AtS2 - 1)) u_flags (
    .clk_i, .enable_i(enable[AtS2-1:1]),
    .data_i({s1_any_q, s1_shadow_q, s1_own_q, s1_inside_q, s1_glass_q}),
    .data_o({s2_any, s2_shadow, s2_own, s2_inside, s2_glass}));

  // ---- s2: b = d.s, A = d.d, C = s.s - R2.
  logic signed [AlongW-1:0]  s2_along_q;
  logic signed [SquareW-1:0] s2_square_q;
  logic signed [PowerW-1:0]  s2_power_q;

  always_ff @(posedge clk_i) begin
    if (enable[AtS2-1]) begin
      s2_along_q  <= AlongW'(gen_axis[0].along) + AlongW'(gen_axis[1].along)
                     + AlongW'(gen_axis[2].along);
      s2_square_q <= SquareW'(gen_axis[0].square) + SquareW'(gen_axis[1].square)
                     + SquareW'(gen_axis[2].square);
      s2_power_q  <= PowerW'(gen_axis[0].power) + PowerW'(gen_axis[1].power)
                     + PowerW'(gen_axis[2].power)
                     - $signed({{(PowerW-2*OriginWidth){1'b0}}, s2_rr});
    end
  end

  // ---- s3: b b and A C, modulo 2^DiscW, because their difference fits. For a shadow ray A is the
  // long factor, for other rays C.
  localparam int unsigned Short = NearSquareW + 1 > 2 * N + 3 ? NearSquareW + 1 : 2 * N + 3;
  localparam int unsigned Long  = SquareW > PowerW ? SquareW : PowerW;

  logic signed [Long-1:0]       s2_long;
  logic signed [Short-1:0]      s2_short;
  logic signed [2*AlongW-1:0]   s2_bb;
  logic signed [Long+Short-1:0] s2_ac;
  logic signed [DiscW-1:0]      s3_bb_q, s3_ac_q, s3_disc;

  assign s2_long  = s2_shadow ? Long'(s2_square_q) : Long'(s2_power_q);
  assign s2_short = s2_shadow ? Short'(s2_power_q) : Short'(s2_square_q);

  if (Share == 1) begin : gen_at_once
    rc_mul #(.AW(AlongW), .BW(AlongW), .Sums(2)) u_bb (
      .clk_i, .a_i(s2_along_q), .b_i(s2_along_q), .p_o(s2_bb));
    rc_mul #(.AW(Long), .BW(Short), .Sums(2)) u_ac (
      .clk_i, .a_i(s2_long), .b_i(s2_short), .p_o(s2_ac));
  end else begin : gen_shared
    localparam int unsigned WiderW      = Long > AlongW ? Long : AlongW;
    localparam int unsigned WiderShortW = Short > AlongW ? Short : AlongW;
    logic [2*(WiderW+WiderShortW)-1:0] products;
    logic [2*WiderW-1:0]               a;
    logic [2*WiderShortW-1:0]          b;

    assign a = {WiderW'(s2_along_q), WiderW'(s2_long)};
    assign b = {WiderShortW'(s2_along_q), WiderShortW'(s2_short)};

    if (Parts) begin : gen_parts
      rc_mul_parts #(.AW(WiderW), .BW(WiderShortW), .Sums(2), .Products(2), .Share(Share))
      u_products (
        .clk_i, .valid_i(valid[AtS2]), .a_i(a), .b_i(b), .p_o(products));
    end else begin : gen_whole
      rc_mul_shared #(.AW(WiderW), .BW(WiderShortW), .Sums(2), .Share(Share)) u_products (
        .clk_i, .valid_i(valid[AtS2]), .a_i(a), .b_i(b), .p_o(products));
    end

    assign s2_ac = products[0 +: Long+Short];
    assign s2_bb = products[WiderW+WiderShortW +: 2*AlongW];

    logic unused;
    assign unused = ^products;
  end

  always_ff @(posedge clk_i) begin
    if (enable[AtS3-1]) begin
      s3_bb_q <= DiscW'(s2_bb);
      s3_ac_q <= DiscW'(s2_ac);
    end
  end

  rc_path_register #(.Width(DiscW)) u_disc (.clk_i, .data_i(s3_bb_q - s3_ac_q), .data_o(s3_disc));

  // In parallel, for a shadow ray: |O - c|^2 - R2 at its end O, and whether its point nearest to
  // the centre comes before O.
  localparam int unsigned Foot =
      (AlongW + OriginBits > SquareW ? AlongW + OriginBits : SquareW) + 1;

  logic signed [PowerW-1:0] s2_end, sum_end;
  logic signed [Foot-1:0]   s2_foot, sum_foot;
  logic                   s2_on, s2_still, sum_on, sum_still, sum_out, sum_nearing;
  logic                   s3_any, s3_shadow, s3_own, s3_inside, s3_glass;
  logic                   s3_still, s3_nearing, s3_outside, s3_on, s3_before, s3_end_in, s3_end_out;

  assign s2_end   = PowerW'(s2_square_q) + (PowerW'(s2_along_q) <<< (OriginBits + 1))
                  + (s2_power_q <<< (2 * OriginBits));
  assign s2_foot  = (Foot'(s2_along_q) <<< OriginBits) + Foot'(s2_square_q);
  assign s2_on    = s2_power_q == '0;
  assign s2_still = s2_square_q == '0;

  rc_path_register #(.Width(PowerW + Foot + 4)) u_sums (
    .clk_i,
    .data_i({s2_end, s2_foot, s2_on, s2_still, !s2_power_q[PowerW-1], s2_along_q[AlongW-1]}),
    .data_o({sum_end, sum_foot, sum_on, sum_still, sum_out, sum_nearing}));

  rc_shift_register #(.Width(7), .Stages(AtS3 - AtS2)) u_tests (
    .clk_i, .enable_i(enable[AtS3+Cut-1:AtS2+Cut]),
    .data_i({sum_still, sum_nearing, sum_out && !sum_on, sum_on,
             !sum_foot[Foot-1] && sum_foot != '0, sum_end[PowerW-1],
             !sum_end[PowerW-1] && sum_end != '0}),
    .data_o({s3_still, s3_nearing, s3_outside, s3_on, s3_before, s3_end_in, s3_end_out}));

  rc_shift_register #(.Width(5), .Stages(AtS3 + Cut - AtS2)) u_kind (
    .clk_i, .enable_i(enable[AtS3+Cut-1:AtS2]),
    .data_i({s2_any, s2_shadow, s2_own, s2_inside, s2_glass}),
    .data_o({s3_any, s3_shadow, s3_own, s3_inside, s3_glass}));

  // ---- s4: the discriminant, and all decisions.
  logic             s3_meets, s3_goes, s3_blocked;
  logic [Plain-1:0] s4_disc_q;

  assign s3_meets = s3_nearing && !s3_disc[DiscW-1];
  assign s3_goes  = (!s3_own || s3_inside)
                 && (s3_outside ? s3_meets : s3_glass && (s3_on ? s3_nearing : !s3_still));
  assign s3_met   = valid[AtS4-1] && s3_goes && !s3_any;
  assign s3_far   = s3_own || !s3_outside;

  always_comb begin
    if (!s3_shadow)      s3_blocked = s3_goes;
    else if (s3_own)     s3_blocked = s3_inside && s3_outside;
    else if (s3_outside) s3_blocked = s3_meets && (s3_end_in || s3_before)
                                   && (s3_glass || s3_end_out);
    else                 s3_blocked = s3_end_out && (!s3_on || s3_nearing);
  end

  assign s3_blocks = valid[AtS4-1] && s3_any && s3_blocked;

  if (Plain > DiscW) begin : gen_short_disc
    always_ff @(posedge clk_i) if (s3_met || Cut != 0) s4_disc_q <= Plain'(s3_disc);
  end else begin : gen_disc
    always_ff @(posedge clk_i) if (s3_met || Cut != 0) s4_disc_q <= s3_disc[Plain-1:0];
  end

  // ---- s5: the discriminant, shortened to 2 RootW bits by an even shift of 2 s5_right.
  logic [2*RootW-1:0] s5_cut_q, s4_cut;
  logic [RightW:0]    s5_right_lost_q, s4_right_lost;

  rc_normalise #(.Width(Plain), .Levels(Levels), .Kept(2 * RootW)) u_normalise (
    .clk_i, .all_i(s4_disc_q), .cut_o(s4_cut), .right_o(s4_right_lost[RightW:1]),
    .lost_o(s4_right_lost[0]));

  always_ff @(posedge clk_i) begin
    if (met_enable[AtS5-1]) begin
      s5_cut_q        <= s4_cut;
      s5_right_lost_q <= s4_right_lost;
    end
  end

  // ---- Root. The fields that go with it wait, up to the cycle before.
  localparam int unsigned RightLate = (RootSteps - 1 + Every - 1) / Every;
  localparam int unsigned RayLate   = (AtR - 1 - AtS2 + Every - 1) / Every;

  logic [RootW-1:0]            r_root;
  logic                        r_inexact, r_lost;
  logic [RightW-1:0]           r_right;
  logic signed [WayW-1:0]      r_along;
  logic [NearSquareW-1:0]      r_square;
  logic [RightW:0]             late_right_lost;
  logic [WayW-1:0]             s2_near_along;    // wide enough for all rays except shadow rays
  logic [NearSquareW-1:0]      s2_near_square;
  logic [WayW+NearSquareW-1:0] late_ray;

  assign s2_near_along  = s2_along_q[WayW-1:0];
  assign s2_near_square = s2_square_q[NearSquareW-1:0];

  rc_sqrt #(.Stages(RootSteps), .Bits(Bits), .Every(Every)) u_sqrt (
    .clk_i, .valid_i(Every > 1 ? met_q[AtS5] : met_enable[AtS5]), .square_i(s5_cut_q),
    .root_o(r_root), .inexact_o(r_inexact));

  rc_stage_delay #(.Width(RightW + 1), .Stages(RightLate), .Every(Every)) u_right (
    .clk_i, .rst_ni, .enter_i(met_q[AtS5]), .leave_i(met_q[AtR-1]), .data_i(s5_right_lost_q),
    .data_o(late_right_lost));

  rc_stage_delay #(.Width(WayW + NearSquareW), .Stages(RayLate), .Every(Every)) u_ray (
    .clk_i, .rst_ni, .enter_i(valid[AtS2]), .leave_i(valid[AtR-1]),
    .data_i({s2_near_along, s2_near_square}), .data_o(late_ray));

  rc_path_register #(.Width(RightW + 1 + WayW + NearSquareW), .Stages(1)) u_late (
    .clk_i, .data_i({late_right_lost, late_ray}),
    .data_o({r_right, r_lost, r_along, r_square}));

  // ---- The way to the near root, -b - r with r rounded down, or to the far root, -b + r with r
  // rounded up.
  logic [WayW-1:0]   r_size, w_size, w_back, w_way, w_way_q;
  logic [RootW:0]    r_up, up;
  logic [RightW-1:0] up_right;
  logic [WayW-1:0]   up_back;
  logic [NearSquareW-1:0] up_square, w_square, w_square_q;

  assign r_up = {1'b0, r_root} + {{RootW{1'b0}}, far_q[AtR] && (r_inexact || r_lost)};

  rc_path_register #(.Width(RootW + 1 + RightW + WayW + NearSquareW)) u_up (
    .clk_i, .data_i({r_up, r_right, -r_along, r_square}),
    .data_o({up, up_right, up_back, up_square}));

  assign r_size = WayW'(up) << up_right;

  rc_path_register #(.Width(2 * WayW + NearSquareW)) u_size (
    .clk_i, .data_i({r_size, up_back, up_square}), .data_o({w_size, w_back, w_square}));

  rc_addsub #(.Width(WayW)) u_way (
    .minus_i(!far_q[AtW-1]), .a_i(w_back), .b_i(w_size),
    .sum_o(w_way));

  always_ff @(posedge clk_i) begin
    if (met_enable[AtW-1]) begin
      w_way_q    <= w_way;
      w_square_q <= w_square;
    end
  end

  // ---- Distance: ceil(2^(M-1+F-OriginBits) way / d.d), saturated, as in rc_hitdiv.
  localparam int unsigned QuoW  = Bits * DivSteps;
  // Right is at least 2, because M <= N + OriginBits + 1.
  localparam int unsigned Right = N + 3 + OriginBits > M ? N + 3 + OriginBits - M : 1;

  logic [WayW-1:0]        w_above;
  logic [QuoW+WayW-1:0]   w_below;
  logic                   w_beyond, d_beyond, d_inexact, d_up, t_up;
  logic [NearSquareW-1:0] d_rem, d_den;
  logic [QuoW-1:0]        d_low, d_quo;
  logic [TBits-1:0]       t_down, t;

  assign w_above  = w_way_q >> Right;
  assign w_below  = {w_way_q, {QuoW{1'b0}}} >> Right;
  assign w_beyond = w_above >= {{(WayW-NearSquareW){1'b0}}, w_square_q};

  rc_path_register #(.Width(2 * NearSquareW + QuoW)) u_first (
    .clk_i,
    .data_i({w_beyond && Cut == 0 ? '0 : w_above[NearSquareW-1:0], w_square_q,
             w_below[QuoW-1:0]}),
    .data_o({d_rem, d_den, d_low}));

  rc_divide #(
    .Width(NearSquareW), .Stages(DivSteps), .Bits(Bits), .Every(Every),
    .Lows(Right < QuoW ? Right : QuoW)) u_t (
    .clk_i, .valid_i(Every > 1 ? met_q[AtW+Cut] : met_enable[AtW+Cut]), .rem_i(d_rem),
    .low_i(d_low), .den_i(d_den), .quo_o(d_quo), .inexact_o(d_inexact));

  rc_shift_register #(.Width(1), .Stages(AtT - AtW)) u_beyond (
    .clk_i, .enable_i(met_enable[AtT-1:AtW]), .data_i(w_beyond), .data_o(d_beyond));

  if (QuoW > TBits) begin : gen_spare_bit
    assign d_up = d_inexact || d_quo[0];
  end else begin : gen_exact_bits
    assign d_up = d_inexact;
  end

  rc_path_register #(.Width(TBits + 1)) u_last (
    .clk_i, .data_i({d_up, d_quo[QuoW-1 -: TBits]}), .data_o({t_up, t_down}));

  assign t = d_beyond || (&t_down) ? '1 : t_down + {{(TBits-1){1'b0}}, t_up};

  // ---- Comparison: t / 2^(M-1+F) against best_num / best_det. Closer, or equally close with a
  // lower number.
  localparam int unsigned ProductW = TBits + EdgeBits > NumBits + M - 1 + F
                                   ? TBits + EdgeBits : NumBits + M - 1 + F;

  logic [TBits+EdgeBits-1:0] t_mine;
  logic                      t_found, t_first, p_found_q, p_first_q, p_before, last_before;
  logic [NumBits-1:0]        t_num;
  logic [ProductW-1:0] p_mine_q, p_theirs_q;

  assign best_next_o = valid[AtT-1];

  if (Parts) begin : gen_mine_in_parts
    rc_mul_parts #(.AW(TBits), .BW(EdgeBits), .Signed(1'b0), .Sums(2)) u_mine (
      .clk_i, .valid_i(valid[AtT]), .a_i(t), .b_i(best_det_i), .p_o(t_mine));
  end else begin : gen_mine
    rc_mul #(.AW(TBits), .BW(EdgeBits), .Signed(1'b0), .Sums(2)) u_mine (
      .clk_i, .a_i(t), .b_i(best_det_i), .p_o(t_mine));
  end

  rc_path_register #(.Width(NumBits + 2), .Stages(AtP - AtT - 1)) u_theirs (
    .clk_i, .data_i({best_found_i, best_first_i, best_num_i}), .data_o({t_found, t_first, t_num}));

  always_ff @(posedge clk_i) begin
    if (met_enable[AtP-1]) begin
      p_found_q  <= t_found;
      p_first_q  <= t_first;
      p_mine_q   <= {{(ProductW-TBits-EdgeBits){1'b0}}, t_mine};
      p_theirs_q <= {{(ProductW-NumBits){1'b0}}, t_num} << (M - 1 + F);
    end
  end

  assign p_before = !p_found_q || {p_mine_q, 1'b0} < {p_theirs_q, p_first_q};
  rc_path_register #(.Width(1)) u_before (.clk_i, .data_i(p_before), .data_o(last_before));

  always_ff @(posedge clk_i) closer_o <= met_q[End-1] && last_before;

  rc_shift_register #(.Width(TBits), .Stages(End - AtT)) u_end (
    .clk_i, .enable_i(met_enable[End-1:AtT]), .data_i(t), .data_o(t_o));

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) if (rst_ni && met_q[AtW-1])
    a_way_is_ahead: assert (far_q[AtW-1] ? w_size > WayW'(-w_back) || !w_back[WayW-1]
                                         : !w_back[WayW-1] && w_back > w_size)
    else $error("a sphere is met behind the ray's origin");
`endif

  logic unused;
  assign unused = ^{w_below[QuoW+WayW-1:QuoW], s2_bb, s2_ac, s3_disc, s4_cut, valid, enable, up};
endmodule
`default_nettype wire

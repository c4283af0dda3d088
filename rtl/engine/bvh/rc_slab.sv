// One axis of the slab test, for the children of one beat. For each slab it gives the times at
// which the ray enters, rounded down, and leaves, rounded up.
//
// Part of rc_box, which has the valid bits. The ray and the node come with enable_i[0], the planes
// rc_pkg::SlabPlanes later. The intervals come rc_pkg::SlabStages after enable_i[0].
//
// An origin with fraction bits lies between two lattice points. Near planes are measured from the
// point that lies further along the ray, far planes from the other one. This costs at most one
// lattice step (docs/proofs/origins.md, Boxes). Model: model/engine/bvh/slab.hpp and slab.inl.
`default_nettype none
module rc_slab #(
  localparam int unsigned Lanes       = rc_pkg::NodeWidth / rc_pkg::BoxInterval,   // of a beat
  localparam int unsigned N           = rc_pkg::CoordBits,
  localparam int unsigned OriginWidth = rc_pkg::OriginWidth,
  localparam int unsigned BoxBits     = rc_pkg::BoxBits,
  localparam int unsigned R1          = rc_pkg::RecipBits + 1,
  localparam int unsigned ExpBits     = rc_pkg::ExpBits,
  localparam int unsigned TBits       = rc_pkg::TBits,
  // Whole words: a simulation shifts no bits.
  localparam int unsigned PaddedTW    = (TBits + 31) / 32 * 32,
  localparam int unsigned Stages      = rc_pkg::SlabStages
) (
  input  logic                          clk_i,
  // enable_i[i]: stage i holds a node, or the chip is fast
  input  logic [Stages:0]               enable_i,
  // Ray, and the node's corner and exponent
  input  logic signed [OriginWidth-1:0] s0_o_i,
  input  logic signed [N-1:0]           s0_org_i,
  input  logic                          s0_neg_i,
  input  logic [R1-1:0]                 s0_recip_i,
  input  logic [ExpBits-1:0]            s0_len_i,
  input  logic [ExpBits-1:0]            s0_exp_i,
  // Planes of the children
  input  logic [Lanes*BoxBits-1:0]      plane_lo_i,   // rc_pkg::SlabPlanes later than the others
  input  logic [Lanes*BoxBits-1:0]      plane_hi_i,
  // Intervals of the children
  output logic [Lanes*PaddedTW-1:0]     near_o,
  output logic [Lanes*PaddedTW-1:0]     far_o,
  output logic [Lanes-1:0]              miss_o
);
  localparam int unsigned DistanceW = N + 1;               // distance to the node's corner, signed
  localparam int unsigned ProductW  = DistanceW + R1 + 1;  // times r or r + 1 <= 2^R + 1, signed
  localparam int unsigned SumW      = ProductW + 1;        // the product plus plane * r, signed
  localparam int unsigned ShiftW    = 8;                   // shift, signed: -24..62
  localparam int unsigned RightW    = 6;                   // right shift of 2^TBits times the value
  localparam int unsigned Cut       = rc_pkg::PathCut;
  localparam int unsigned Mul       = rc_pkg::MulStages;

  // Stages in which the node's corner is shifted, the children's planes are multiplied, their
  // products are ready, and the sums are ready.
  localparam int unsigned Placed = 2 + Mul + Cut;
  localparam int unsigned Planes = rc_pkg::SlabPlanes;
  localparam int unsigned Ready  = Planes + Mul;
  localparam int unsigned Sum    = Ready + 1;

  // shift = x + e = F + M - len - R + e, where M is the width of a ray's direction. Its constant
  // part:
  localparam logic signed [ShiftW-1:0] ShiftBase =
      ShiftW'(rc_pkg::TFracBits) + ShiftW'(rc_pkg::RayDirBits) - ShiftW'(rc_pkg::RecipBits);

  // s0: the lattice point below the origin, and whether the origin lies above that point.
  logic signed [N-1:0] s0_point;
  logic                s0_between;

  assign s0_point = s0_o_i[OriginWidth-1 -: N];

  if (rc_pkg::OriginBits == 0) begin : gen_on_lattice
    assign s0_between = 1'b0;
  end else begin : gen_between
    assign s0_between = |s0_o_i[OriginWidth-N-1:0];
  end

  // s1: distance from the ray's origin to the node's corner, along the ray. This is the shorter
  // one, for near planes. For far planes it is one more if the origin lies between lattice points.
  logic signed [DistanceW-1:0] s1_distance_q;
  logic                        s1_between_q, s1_neg_q, s1_zero_q;
  logic [R1-1:0]               s1_r_q;
  logic [ExpBits-1:0]          s1_exp_q;
  logic signed [ShiftW-1:0]    s1_shift_q;

  always_ff @(posedge clk_i) begin
    if (enable_i[0]) begin
      s1_distance_q <= s0_neg_i
          ? DistanceW'(s0_point) - DistanceW'(s0_org_i)
          : DistanceW'(s0_org_i) - DistanceW'(s0_point)
              - $signed({{(DistanceW-1){1'b0}}, s0_between});
      s1_between_q  <= s0_between;
      s1_r_q        <= s0_recip_i;
      s1_neg_q      <= s0_neg_i;
      s1_zero_q     <= s0_len_i == '0;
      s1_exp_q      <= s0_exp_i;
      s1_shift_q    <= ShiftBase - $signed({{(ShiftW-ExpBits){1'b0}}, s0_len_i})
          + $signed({{(ShiftW-ExpBits){1'b0}}, s0_exp_i});
    end
  end

  // near: D r. far: D (r + 1), or (D + 1) (r + 1), which is D r + more. The right shift by e rounds
  // up for far planes: more includes 2^e - 1.
  logic signed [DistanceW+R1:0] product;
  logic signed [ProductW-1:0]   s1_more, some, more, sum_near, sum_far, node_near, node_far;
  logic [R1-1:0]                s1_r_up;
  logic [ExpBits-1:0]           some_exp, node_exp;
  logic [ProductW-1:0]          some_unit;

  rc_mul #(.AW(DistanceW), .BW(R1 + 1)) u_product (
    .clk_i, .a_i(s1_distance_q), .b_i($signed({1'b0, s1_r_q})), .p_o(product));

  assign s1_r_up = s1_r_q + {{(R1-1){1'b0}}, !s1_zero_q};
  assign s1_more = (s1_zero_q ? '0 : ProductW'(s1_distance_q))
                 + (s1_between_q ? $signed({{(ProductW-R1){1'b0}}, s1_r_up}) : '0);

  rc_path_register #(.Width(ProductW + ExpBits)) u_some (
    .clk_i, .data_i({s1_more, s1_exp_q}), .data_o({some, some_exp}));

  assign some_unit = ~({ProductW{1'b1}} << some_exp);
  rc_path_register #(.Width(ProductW), .Stages(Mul - Cut)) u_more (
    .clk_i, .data_i(some + $signed(some_unit)), .data_o(more));

  assign sum_near = ProductW'(product);
  assign sum_far  = sum_near + more;

  rc_path_register #(.Width(ProductW)) u_node_near (.clk_i, .data_i(sum_near), .data_o(node_near));
  rc_path_register #(.Width(ProductW)) u_node_far (.clk_i, .data_i(sum_far), .data_o(node_far));
  rc_path_register #(.Width(ExpBits), .Stages(Mul)) u_exp (
    .clk_i, .data_i(some_exp), .data_o(node_exp));

  // The right shift of the node's corner, in units of 2^-shift.
  logic signed [ProductW-1:0] placed_near_q, placed_far_q;

  always_ff @(posedge clk_i) begin
    if (enable_i[Placed-1]) begin
      placed_near_q <= node_near >>> node_exp;
      placed_far_q  <= node_far >>> node_exp;
    end
  end

  // In parallel, the shift becomes a right shift of 2^TBits times the value; left shifts by TBits
  // or more saturate. If the value itself shifts right, rounding up adds 2^right - 1.
  logic signed [ShiftW-1:0] s1_move;
  logic [RightW-1:0]        placed_move, placed_right, ready_move;
  logic                     placed_zero, ready_zero;
  logic [R1-1:0]            placed_up;
  logic signed [SumW-1:0]   far_up, ready_near, ready_far, ready_up;

  assign s1_move = s1_shift_q > $signed(ShiftW'(TBits)) ? '0 : $signed(ShiftW'(TBits)) - s1_shift_q;

  rc_shift_register #(.Width(RightW + 1), .Stages(Placed - 1)) u_move (
    .clk_i, .enable_i(enable_i[Placed-1:1]), .data_i({s1_move[RightW-1:0], s1_zero_q}),
    .data_o({placed_move, placed_zero}));

  assign placed_right = placed_move > RightW'(TBits) ? placed_move - RightW'(TBits) : '0;
  assign placed_up    = ~({R1{1'b1}} << placed_right);
  assign far_up       = SumW'(placed_far_q) + $signed({{(SumW-R1){1'b0}}, placed_up});

  rc_path_register #(.Width(SumW)) u_ready_near (
    .clk_i, .data_i(SumW'(placed_near_q)), .data_o(ready_near));
  rc_path_register #(.Width(SumW)) u_ready_far (
    .clk_i, .data_i(SumW'(placed_far_q)), .data_o(ready_far));
  rc_path_register #(.Width(SumW)) u_ready_up (.clk_i, .data_i(far_up), .data_o(ready_up));
  rc_path_register #(.Width(RightW + 1)) u_ready (
    .clk_i, .data_i({placed_move, placed_zero}), .data_o({ready_move, ready_zero}));

  // Factors of the children's planes. If the ray goes down, r and r + 1 become -r and -(r + 1),
  // once for all children.
  logic [R1-1:0]      plane_r;
  logic signed [R1:0] plane_near, plane_far;
  logic               plane_neg, plane_zero;

  rc_shift_register #(.Width(R1 + 2), .Stages(Planes - 1)) u_way (
    .clk_i, .enable_i(enable_i[Planes-1:1]), .data_i({s1_r_q, s1_neg_q, s1_zero_q}),
    .data_o({plane_r, plane_neg, plane_zero}));

  assign plane_near = {plane_neg, {R1{plane_neg}} ^ plane_r} + {{R1{1'b0}}, plane_neg};
  assign plane_far  = {plane_neg, {R1{plane_neg}} ^ plane_r}
                    + {{R1{1'b0}}, plane_neg == plane_zero};

  // Shift of the sums. over_q: bits that overflow at the top, which saturates.
  logic [SumW-1:0]   over_q;
  logic [RightW-1:0] move_q, fine_move;
  logic              zero_q;

  always_ff @(posedge clk_i) begin
    if (enable_i[Sum-1]) begin
      over_q <= {SumW{1'b1}} << ready_move;
      move_q <= ready_move;
      zero_q <= ready_zero;
    end
  end

  rc_path_register #(.Width(RightW)) u_fine_move (.clk_i, .data_i(move_q), .data_o(fine_move));

  // In a simulation of a relaxed chip, invalid planes cost no work. Silicon has no such condition.
  logic holds, is_there;

`ifdef SYNTHESIS
  assign {holds, is_there} = 2'b11;
`else
  assign holds    = Cut != 0 || enable_i[Sum-1];
  assign is_there = enable_i[Sum];
`endif

  // ---- Children: planes in the order in which the ray meets them, and their products.
  for (genvar i = 0; i < Lanes; i++) begin : gen_child
    logic [BoxBits-1:0]       first, last;
    logic signed [BoxBits+R1+1:0] near_way, far_way;

    assign first = plane_neg ? plane_hi_i[i*BoxBits +: BoxBits] : plane_lo_i[i*BoxBits +: BoxBits];
    assign last  = plane_neg ? plane_lo_i[i*BoxBits +: BoxBits] : plane_hi_i[i*BoxBits +: BoxBits];

    rc_mul #(.AW(BoxBits + 1), .BW(R1 + 1)) u_near (
      .clk_i, .a_i($signed({1'b0, first})), .b_i(plane_near), .p_o(near_way));
    rc_mul #(.AW(BoxBits + 1), .BW(R1 + 1)) u_far (
      .clk_i, .a_i($signed({1'b0, last})), .b_i(plane_far), .p_o(far_way));

    // Sums of the corner and the planes.
    logic signed [SumW-1:0] near_q, up_q, near_path, far_path, far;
    logic                   behind_q;

    assign near_path = holds ? SumW'(near_way) : '0;
    assign far_path  = holds ? SumW'(far_way) : '0;
    assign far       = ready_far + far_path;

    always_ff @(posedge clk_i) begin
      if (enable_i[Sum-1]) begin
        near_q   <= ready_near + near_path;
        up_q     <= ready_up + far_path;
        behind_q <= far[SumW-1];
      end
    end

    // The right shift of 2^TBits times the sums, first by a multiple of eight, then by the
    // remaining three bits.
    logic [TBits+6:0] near_coarse, far_coarse, near_rest, far_rest;
    logic             near_over, far_over, near_zero, miss, near_many, far_many, near_none;
    logic             miss_late;

    always_comb begin
      near_coarse = '0;
      far_coarse  = '0;
      near_over   = 1'b0;
      far_over    = 1'b0;
      near_zero   = 1'b1;
      miss        = 1'b0;
      if (is_there) begin
        near_coarse = (TBits + 7)'({$unsigned(near_q), {TBits{1'b0}}}
                                   >> {move_q[RightW-1:3], 3'd0});
        far_coarse  = (TBits + 7)'({$unsigned(up_q), {TBits{1'b0}}} >> {move_q[RightW-1:3], 3'd0});
        near_over   = |($unsigned(near_q) & over_q);
        far_over    = zero_q || |($unsigned(up_q) & over_q);
        near_zero   = zero_q || near_q[SumW-1];
        miss        = behind_q || (zero_q && !near_q[SumW-1] && near_q != '0);
      end
    end

    rc_path_register #(.Width(TBits + 7)) u_near_rest (
      .clk_i, .data_i(near_coarse), .data_o(near_rest));
    rc_path_register #(.Width(TBits + 7)) u_far_rest (
      .clk_i, .data_i(far_coarse), .data_o(far_rest));
    rc_path_register u_near_many (.clk_i, .data_i(near_over), .data_o(near_many));
    rc_path_register u_far_many (.clk_i, .data_i(far_over), .data_o(far_many));
    rc_path_register u_near_none (.clk_i, .data_i(near_zero), .data_o(near_none));
    rc_path_register u_miss_late (.clk_i, .data_i(miss), .data_o(miss_late));

    logic [TBits-1:0] near_t, far_t;

    assign near_t = near_none ? '0 : TBits'(near_rest >> fine_move[2:0]) | {TBits{near_many}};
    assign far_t  = TBits'(far_rest >> fine_move[2:0]) | {TBits{far_many}};

    rc_path_register #(.Width(PaddedTW)) u_near_out (
      .clk_i, .data_i(PaddedTW'(near_t)), .data_o(near_o[i*PaddedTW +: PaddedTW]));
    rc_path_register #(.Width(PaddedTW)) u_far_out (
      .clk_i, .data_i(PaddedTW'(far_t)), .data_o(far_o[i*PaddedTW +: PaddedTW]));
    rc_path_register u_miss_out (.clk_i, .data_i(miss_late), .data_o(miss_o[i]));
  end

  logic unused;
  assign unused = ^{enable_i, s1_between_q, s1_move[ShiftW-1:RightW], fine_move[RightW-1:3]};
endmodule
`default_nettype wire

// Decides whether a ray meets a globe, and gives the earliest time at which it may. Both are
// conservative. Rounding makes each component of the distance from the centre to the ray's line at
// most too small. It makes the radius and half the chord at most too large.
//
// Part of rc_globe. A globe comes with stage 0, the results of rc_globe_moment at the stages that
// it documents. The answer is ready before the last register of rc_pkg::GlobeStages. Model:
// globe_children() in model/engine/spheres/globe.cpp.
`default_nettype none
module rc_chord #(
  localparam int unsigned N          = rc_pkg::CoordBits,
  localparam int unsigned GlobeBits  = rc_pkg::GlobeBits,
  localparam int unsigned TowardBits = rc_pkg::TowardBits,
  localparam int unsigned TBits      = rc_pkg::TBits,
  localparam int unsigned Stages     = rc_pkg::GlobeStages,
  localparam int unsigned MomentW    = N + TowardBits + 2,   // width of the node's moment
  localparam int unsigned WayW       = N + 7                 // width of the way to the node
) (
  input  logic           clk_i,
  input  logic [Stages-1:0] enable_i,
  // Globe
  input  logic [3*GlobeBits-1:0]  s0_centre_i,
  input  logic [GlobeBits-1:0]    s0_radius_i,
  // From rc_globe_moment
  input  logic [3*TowardBits-1:0] toward_i,
  input  logic [3*MomentW-1:0] moment_i,
  input  logic [WayW-1:0] way_i,
  input  logic [N+3:0]            slack_i,
  input  logic [TowardBits-1:0]   square_i,
  input  logic [16:0]             inverse_i,
  input  logic [5:0]              right_i,
  // Result
  output logic                    met_o,
  output logic [TBits-1:0]        near_o
);
  localparam int unsigned Cut      = rc_pkg::PathCut;
  localparam int unsigned Mul      = rc_pkg::MulStages;
  localparam int unsigned ProductW = GlobeBits + 1 + TowardBits;   // centre times direction, signed
  localparam int unsigned SumW     = MomentW + 1;   // the product plus the node's moment, signed
  localparam int unsigned Frac     = 3;                             // eighths
  localparam int unsigned Drop     = TowardBits - 2 - Frac;
  localparam int unsigned FarW     = TowardBits - 1;  // a distance's component, if the ray may meet
  localparam int unsigned ReachW   = GlobeBits + Frac + 1;   // width of a radius with its slack
  localparam int unsigned SquareW  = 2 * FarW + 2;           // width of a squared distance

  // Stages in which these are ready: the distance, the radius, both squares, half the chord, the
  // way minus half the chord, and its product.
  localparam int unsigned Far   = 3 + Mul + 3 * Cut;
  localparam int unsigned Reach = 2 + 4 * Cut;
  localparam int unsigned Both  = 4 + 2 * Mul + 4 * Cut;
  localparam int unsigned Half  = Both + 1 + 4 * Cut;
  localparam int unsigned Less  = Half + Cut;
  localparam int unsigned Times = Less + Mul + 1;

  logic [3*GlobeBits-1:0] centre_q;
  logic [GlobeBits-1:0]   radius_q, radius;

  always_ff @(posedge clk_i) begin
    if (enable_i[0]) {centre_q, radius_q} <= {s0_centre_i, s0_radius_i};
  end

  // The distance, axis by axis, and its square.
  logic [3*2*FarW-1:0] squares;
  logic [2:0]          over_q, over;

  for (genvar k = 0; k < 3; k++) begin : gen_axis
    localparam int unsigned Axis1 = (k + 1) % 3;   // the other two axes
    localparam int unsigned Axis2 = (k + 2) % 3;
    logic signed [ProductW-1:0] ab, ba, moment_q, moment_late;
    logic signed [SumW-1:0]     all, all_q;
    logic [SumW-1:0]            size;
    logic [FarW-1:0]            far_q;

    rc_mul #(.AW(GlobeBits + 1), .BW(TowardBits)) u_ab (
      .clk_i, .a_i($signed({1'b0, centre_q[Axis1*GlobeBits +: GlobeBits]})),
      .b_i($signed(toward_i[Axis2*TowardBits +: TowardBits])), .p_o(ab));
    rc_mul #(.AW(GlobeBits + 1), .BW(TowardBits)) u_ba (
      .clk_i, .a_i($signed({1'b0, centre_q[Axis2*GlobeBits +: GlobeBits]})),
      .b_i($signed(toward_i[Axis1*TowardBits +: TowardBits])), .p_o(ba));

    always_ff @(posedge clk_i) if (enable_i[Mul+1]) moment_q <= ab - ba;
    rc_path_register #(.Width(ProductW), .Stages(2 * Cut)) u_late (
      .clk_i, .data_i(moment_q), .data_o(moment_late));

    assign all = SumW'($signed(moment_i[k*MomentW +: MomentW])) + SumW'(moment_late);
    rc_path_register #(.Width(SumW)) u_all (.clk_i, .data_i(all), .data_o(all_q));

    assign size = ($unsigned(all_q) ^ {SumW{all_q[SumW-1]}}) >> Drop;

    always_ff @(posedge clk_i) begin
      if (enable_i[Far-1]) begin
        far_q     <= size[FarW-1:0];
        over_q[k] <= |size[SumW-1:FarW];
      end
    end

    rc_mul #(.AW(FarW), .BW(FarW), .Signed(1'b0)) u_square (
      .clk_i, .a_i(far_q), .b_i(far_q), .p_o(squares[k*2*FarW +: 2*FarW]));
  end

  logic [2*FarW:0]    two, two_q;
  logic [2*FarW-1:0]  third_q;
  logic [SquareW-1:0] sum_q;

  assign two = {1'b0, squares[0 +: 2*FarW]} + {1'b0, squares[2*FarW +: 2*FarW]};
  rc_path_register #(.Width(2 * FarW + 1)) u_two (.clk_i, .data_i(two), .data_o(two_q));
  rc_path_register #(.Width(2 * FarW)) u_third (
    .clk_i, .data_i(squares[4*FarW +: 2*FarW]), .data_o(third_q));

  always_ff @(posedge clk_i) begin
    if (enable_i[Both-1]) sum_q <= {1'b0, two_q} + {2'b0, third_q};
  end

  rc_shift_register #(.Width(3), .Stages(Both - Far)) u_over (
    .clk_i, .enable_i(enable_i[Both-1:Far]), .data_i(over_q), .data_o(over));

  // The radius, its square, and that square times the direction's. Rounding costs 3 in any node.
  logic [ReachW-1:0]              reach_q;
  logic [2*ReachW-1:0]            reach_square;
  logic [2*ReachW-2:0]            reach_square_q;
  logic [2*ReachW+TowardBits-2:0] most;
  logic [SquareW-1:0]             most_q;

  rc_path_register #(.Width(GlobeBits), .Stages(4 * Cut)) u_radius (
    .clk_i, .data_i(radius_q), .data_o(radius));
  always_ff @(posedge clk_i) begin
    if (enable_i[Reach-1]) reach_q <= {1'b0, radius, Frac'(3)} + ReachW'(slack_i);
  end

  rc_mul #(.AW(ReachW), .BW(ReachW), .Signed(1'b0)) u_reach (
    .clk_i, .a_i(reach_q), .b_i(reach_q), .p_o(reach_square));
  always_ff @(posedge clk_i) begin
    // less than 2^15.02 squared
    if (enable_i[Reach+Mul]) reach_square_q <= reach_square[2*ReachW-2:0];
  end

  rc_mul #(.AW(2 * ReachW - 1), .BW(TowardBits), .Signed(1'b0)) u_most (
    .clk_i, .a_i(reach_square_q), .b_i(square_i), .p_o(most));
  always_ff @(posedge clk_i) begin
    if (enable_i[Both-1]) most_q <= SquareW'(most[2*ReachW+TowardBits-2:14]);
  end

  // Half the chord, rounded up: a square root from a table.
  logic [SquareW-1:0]   left, left_q, index_left;
  logic [4:0]           g, g_q, index_g, root_g;   // half the bit length of left
  logic [7:0]           index, index_q;
  logic [9:0]           root, root_q;
  logic [FarW+1:0]      half, half_q;
  logic                 there, there_late, there_q;

  assign there = over == '0 && sum_q <= most_q;
  assign left  = most_q - sum_q + SquareW'(1);
  rc_path_register #(.Width(SquareW)) u_left (.clk_i, .data_i(left), .data_o(left_q));

  always_comb begin
    g = '0;
    for (int i = 0; i < SquareW / 2; i++) if (left_q[2*i +: 2] != '0) g = 5'(i);
  end

  rc_path_register #(.Width(SquareW)) u_index_left (.clk_i, .data_i(left_q), .data_o(index_left));
  rc_path_register #(.Width(5)) u_g (.clk_i, .data_i(g), .data_o(g_q));

  assign index = 8'({index_left, 6'd0} >> {g_q, 1'b0});
  rc_path_register #(.Width(8)) u_index (.clk_i, .data_i(index), .data_o(index_q));
  rc_path_register #(.Width(5)) u_index_g (.clk_i, .data_i(g_q), .data_o(index_g));

  logic [9:0] root_mem [256];
  initial for (int i = 0; i < 256; i++)
    root_mem[i] = i < 64 ? '0 : rc_pkg::RootUp[((i + 128) % 192)*10 +: 10];

  assign root = root_mem[index_q];
  rc_path_register #(.Width(10)) u_root (.clk_i, .data_i(root), .data_o(root_q));
  rc_path_register #(.Width(5)) u_root_g (.clk_i, .data_i(index_g), .data_o(root_g));

  // half = root 2^g / 2^8, rounded up
  logic [FarW+9:0] wide;
  assign wide = ({{FarW{1'b0}}, root_q} << root_g) + (FarW + 10)'(255);
  assign half = wide[FarW+9:8];

  rc_path_register #(.Width(1), .Stages(4 * Cut)) u_there (
    .clk_i, .data_i(there), .data_o(there_late));

  always_ff @(posedge clk_i) begin
    if (enable_i[Half-1]) {there_q, half_q} <= {there_late, half};
  end

  // The way to the centre along the ray: the way to the node plus the way from there. A globe is
  // behind the origin if the way plus half the chord is still below Least.
  localparam int unsigned Along = 3 + Mul + 3 * Cut;   // stage in which both ways are ready
  localparam logic signed [WayW+1:0] Least =
      rc_pkg::Shading ? -(WayW + 2)'(99) : -(WayW + 2)'(1);

  logic [3*ProductW-1:0]        parts;
  logic signed [ProductW+1:0]   on_two, on_two_q, on_third_q, on_q;
  logic signed [WayW:0]         on_eighths, on, way_q, way;

  for (genvar k = 0; k < 3; k++) begin : gen_part
    rc_mul #(.AW(GlobeBits + 1), .BW(TowardBits)) u_part (
      .clk_i, .a_i($signed({1'b0, centre_q[k*GlobeBits +: GlobeBits]})),
      .b_i($signed(toward_i[k*TowardBits +: TowardBits])), .p_o(parts[k*ProductW +: ProductW]));
  end

  assign on_two = (ProductW + 2)'($signed(parts[0 +: ProductW]))
                + (ProductW + 2)'($signed(parts[ProductW +: ProductW]));
  rc_path_register #(.Width(ProductW + 2)) u_on_two (.clk_i, .data_i(on_two), .data_o(on_two_q));
  rc_path_register #(.Width(ProductW + 2)) u_on_third (
    .clk_i, .data_i((ProductW + 2)'($signed(parts[2*ProductW +: ProductW]))), .data_o(on_third_q));

  always_ff @(posedge clk_i) if (enable_i[Mul+1+Cut]) on_q <= on_two_q + on_third_q;

  assign on_eighths = (WayW + 1)'(on_q >>> Drop);
  rc_shift_register #(.Width(WayW + 1), .Stages(1 + 2 * Cut)) u_on (
    .clk_i, .enable_i(enable_i[Mul+2+Cut +: 1+2*Cut]), .data_i(on_eighths), .data_o(on));

  always_ff @(posedge clk_i) if (enable_i[Along]) way_q <= (WayW + 1)'($signed(way_i)) + on;

  rc_shift_register #(.Width(WayW + 1), .Stages(Half - Along - 1)) u_way (
    .clk_i, .enable_i(enable_i[Half-1:Along+1]), .data_i(way_q), .data_o(way));

  // The way minus half the chord: where the ray enters the globe.
  logic signed [WayW+1:0] less, more, less_q, more_q;
  logic [WayW-1:0]        times_way;
  logic                   less_there, times_there, met_late;

  assign less = (WayW + 2)'(way) - $signed((WayW + 2)'(half_q));
  assign more = (WayW + 2)'(way) + $signed((WayW + 2)'(half_q));

  rc_path_register #(.Width(WayW + 2)) u_less (.clk_i, .data_i(less), .data_o(less_q));
  rc_path_register #(.Width(WayW + 2)) u_more (.clk_i, .data_i(more), .data_o(more_q));
  rc_path_register u_less_there (.clk_i, .data_i(there_q), .data_o(less_there));

  assign times_there = less_there && more_q >= Least;
  assign times_way   = less_q[WayW+1] ? '0 : less_q[WayW-1:0];

  rc_shift_register #(.Width(1), .Stages(Mul + 1)) u_met (
    .clk_i, .enable_i(enable_i[Less +: Mul+1]), .data_i(times_there), .data_o(met_late));

  // The time of that point. An overflow at the top saturates.
  localparam int unsigned TimesW = WayW + 17;
  logic [TimesW-1:0]       times, times_q, over_mask;
  logic [TimesW+TBits-1:0] moved;
  logic [TBits+6:0]        rest, rest_q;
  logic [2:0]              fine;
  logic                    many, many_q;

  rc_mul #(.AW(WayW), .BW(17), .Signed(1'b0)) u_times (
    .clk_i, .a_i(times_way), .b_i(inverse_i), .p_o(times));

  always_ff @(posedge clk_i) if (enable_i[Times-1]) times_q <= times;

  assign over_mask = {TimesW{1'b1}} << right_i;
  assign moved     = {times_q, {TBits{1'b0}}} >> {right_i[5:3], 3'd0};
  assign rest      = moved[TBits+6:0];
  assign many      = |(times_q & over_mask);

  rc_path_register #(.Width(TBits + 7)) u_rest (.clk_i, .data_i(rest), .data_o(rest_q));
  rc_path_register #(.Width(3)) u_fine (.clk_i, .data_i(right_i[2:0]), .data_o(fine));
  rc_path_register u_many (.clk_i, .data_i(many), .data_o(many_q));
  rc_path_register u_met_o (.clk_i, .data_i(met_late), .data_o(met_o));

  assign near_o = TBits'(rest_q >> fine) | {TBits{many_q}};

  logic unused;
  assign unused = ^{enable_i, reach_square[2*ReachW-1], most[13:0], slack_i, wide[7:0],
                    less_q[WayW], moved[TimesW+TBits-1:TBits+7]};
endmodule
`default_nettype wire

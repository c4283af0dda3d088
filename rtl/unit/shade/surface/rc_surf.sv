// The point where a ray has hit a surface, and the surface's appearance there. Part of rc_pass,
// which has the valid bits: valid_i[i] is set if stage i holds a pass for a surface.
//
// o, n, far, lost and the vector along the normal are in the registers of s5. The albedo is in
// those of s6, the ambient light in those of s7. Model: model/unit/shade/surface/surf.hpp.
`default_nettype none
module rc_surf #(
  localparam int unsigned ValueBits   = rc_pkg::ValueBits,
  parameter  int unsigned UnitW       = 44,   // bits of toward
  localparam int unsigned N           = rc_pkg::CoordBits,
  localparam int unsigned M           = rc_pkg::DirBits,
  localparam int unsigned OriginBits  = rc_pkg::OriginBits,
  localparam int unsigned OriginWidth = rc_pkg::OriginWidth,
  localparam int unsigned PointWidth  = rc_pkg::PointWidth,
  localparam int unsigned NormalBits  = rc_pkg::NormalBits,
  localparam int unsigned TBits       = rc_pkg::TBits,
  localparam int unsigned UvBits      = rc_pkg::UvBits,
  localparam int unsigned Every       = rc_pkg::ShadeInterval
) (
  input  logic                            clk_i,
  input  logic [6:0]                      valid_i,
  input  logic [7*Every-1:0]              phase_i,  // the cycle of each stage
  // Answer, surface and ray
  input  logic [UvBits-1:0]               s0_u_i,
  input  logic [UvBits-1:0]               s0_v_i,
  input  logic [TBits-1:0]                s0_t_i,
  input  logic                            s0_back_i,
  input  rc_pkg::surface_t                s0_surface_i,
  input  logic [3*OriginWidth-1:0]        s0_o_i,
  input  logic [3*M-1:0]                  s0_d_i,
  input  logic [ValueBits-1:0]            s0_weight_i,
  // The same for passes of a surface or of a texture's colour, and the inputs of the latter
  input  logic [6:0]                      tone_valid_i,
  input  logic                            s0_texture_i,
  input  logic [3*rc_pkg::ColourBits-1:0] s0_albedo_i,
  input  logic [rc_pkg::ColourBits-1:0]   s0_share_i,
  input  logic [3*rc_pkg::ColourBits-1:0] s0_texel_i,
  // Results
  output logic [3*PointWidth-1:0]         s5_o_o,
  output logic [3*NormalBits-1:0]         s5_n_o,
  output logic [3*UnitW-1:0]              s5_toward_o,
  output logic                            s5_far_o,  // beyond the lattice,
  output logic                            s5_lost_o,  // and beyond the range of o
  output logic [3*rc_pkg::ColourBits-1:0] s6_albedo_o,
  output logic [3*ValueBits-1:0]          s7_ambient_o
);
  localparam int unsigned CornerBits = rc_pkg::CornerBits;
  localparam int unsigned BaryBits   = rc_pkg::BaryBits;
  // Drop: number of low bits that rounding removes from u and v.
  localparam int unsigned Drop        = BaryBits - OriginBits;
  // MostFine: largest number of these bits that stay, on triangles with coarse edges.
  localparam int unsigned MostFine    = rc_pkg::MaxFine;
  // WeightW: width of u and v after this rounding, signed.
  localparam int unsigned WeightW     = UvBits + 2 - Drop + MostFine;
  // RoundW: width of u and v during it, signed.
  localparam int unsigned RoundW      = UvBits + 2 > WeightW ? UvBits + 2 : WeightW;
  // DiffW: width of a component of an edge, signed.
  localparam int unsigned DiffW       = N + 1;
  // PlanePointW: width of a component of a plane's point, signed.
  localparam int unsigned PlanePointW = WeightW + DiffW + 2;
  // NormalSumW: width of a component of a weighted sum of corner normals, signed.
  localparam int unsigned NormalSumW  = WeightW + 2 + CornerBits + 2;

  // s1: edges; u and v rounded; kind.
  logic                      s0_sphere, s0_plane;
  logic [4:1]                sphere_q;
  logic [4:0]                sphere;   // [stage]
  logic [3*N-1:0]            s0_a, s0_b, s0_c;
  logic                      s0_smooth;
  logic [3*DiffW-1:0]        s1_e1_q, s1_e2_q;
  logic signed [WeightW-1:0] s0_u, s0_v, s1_u_q, s1_v_q;
  logic                      s1_plane_q, s0_ends, s0_odd;
  logic [2:0]                s0_fine, s1_fine_q, s2_fine_q;

  assign s0_fine   = s0_plane ? 3'd0 : s0_surface_i.fine;
  assign s0_sphere = rc_pkg::Spheres && s0_surface_i.kind == rc_pkg::PrimSphere;
  assign s0_plane  = rc_pkg::Planes && s0_surface_i.kind == rc_pkg::PrimPlane;
  assign sphere    = {sphere_q, s0_sphere};

  always_ff @(posedge clk_i) begin
    for (int i = 0; i < 4; i++)
      if (Every == 1 || valid_i[i]) sphere_q[i+1] <= sphere[i];
  end

  assign s0_a      = s0_surface_i.a;
  assign s0_b      = s0_surface_i.b;
  assign s0_c      = s0_surface_i.c;
  assign s0_smooth = rc_pkg::Smooth && s0_surface_i.smooth && !s0_sphere;
  assign s0_ends      = s0_plane && (s0_u_i[UvBits-2:0] == {(UvBits-1){!s0_u_i[UvBits-1]}}
                                     || s0_v_i[UvBits-2:0] == {(UvBits-1){!s0_v_i[UvBits-1]}});

  // A plane's squares: bit 0 of their number along u and along v.
  logic [9*CornerBits-1:0] s0_normal;
  logic [UvBits-1:0]       s0_square_u, s0_square_v;

  assign s0_normal   = s0_surface_i.normal;
  assign s0_square_u =
      (s0_u_i + (UvBits'($signed(s0_normal[0 +: CornerBits])) << BaryBits))
      >> s0_normal[2*CornerBits +: 6];
  assign s0_square_v =
      (s0_v_i + (UvBits'($signed(s0_normal[CornerBits +: CornerBits])) << BaryBits))
      >> s0_normal[3*CornerBits +: 6];
  assign s0_odd      = s0_plane && (s0_square_u[0] ^ s0_square_v[0]);

  // A triangle's u and v are not negative, and at least one step of 2^-(OriginBits + fine). fine
  // is at most Drop.
  logic [5:0] s0_drop, s0_by;

  assign s0_drop = 6'(Drop) - {3'd0, s0_fine};

  rc_path_register #(.Width(6), .Stages(rc_pkg::PassCut)) u_drop (
    .clk_i, .data_i(s0_drop), .data_o(s0_by));

  for (genvar i = 0; i < 2; i++) begin : gen_weight
    logic [UvBits-1:0]         x;
    logic signed [RoundW-1:0]  sum, sum_q, shifted;
    logic signed [WeightW-1:0] moved, weight;

    assign x   = i == 0 ? s0_u_i : s0_v_i;
    assign sum = $signed({{(RoundW-UvBits){s0_plane && x[UvBits-1]}}, x})
               + $signed(RoundW'(1) << s0_by >> 1);

    rc_path_register #(.Width(RoundW), .Stages(rc_pkg::PassCut)) u_sum (
      .clk_i, .data_i(sum), .data_o(sum_q));

    assign shifted = sum_q >>> s0_by;

    rc_path_register #(.Width(WeightW), .Stages(rc_pkg::PassCut)) u_moved (
      .clk_i, .data_i(shifted[WeightW-1:0]), .data_o(moved));

    assign weight = {moved[WeightW-1:1], moved[0] || (!s0_plane && moved == '0)};
    if (i == 0) begin : gen_u
      assign s0_u = weight;
    end else begin : gen_v
      assign s0_v = weight;
    end

    logic unused;
    assign unused = ^shifted;
  end

  always_ff @(posedge clk_i) begin
    if (valid_i[0] && !s0_sphere) begin
      s1_u_q     <= s0_u;
      s1_v_q     <= s0_v;
      s1_plane_q <= s0_plane;
      s1_fine_q  <= s0_fine;
    end
  end

  // s2: a triangle's point is moved off the border.
  logic signed [WeightW-1:0] s1_over, s1_excess, s2_u_q, s2_v_q;
  logic signed [WeightW+1:0] s2_rest;
  logic                      s1_in, s1_more, s1_u_more;   // more: u is greater than v
  logic signed [WeightW-1:0] s1_one;

  assign s1_one  = $signed(WeightW'(1 << OriginBits)) << s1_fine_q;
  assign s1_in   = s1_plane_q || s1_u_q + s1_v_q < s1_one;
  assign s1_over = s1_in ? '0 : s1_u_q + s1_v_q - s1_one + $signed(WeightW'(1));
  assign s1_more = s1_u_q > s1_v_q;

  rc_path_register #(.Width(WeightW + 1), .Stages(rc_pkg::PassCut)) u_excess (
    .clk_i, .data_i({s1_over, s1_more}), .data_o({s1_excess, s1_u_more}));

  assign s2_rest   = ($signed((WeightW+2)'(1 << OriginBits)) << s2_fine_q) - (WeightW+2)'(s2_u_q)
                   - (WeightW+2)'(s2_v_q);

  always_ff @(posedge clk_i) begin
    if (valid_i[1] && !sphere[1]) begin
      s2_fine_q <= s1_fine_q;
      s2_u_q <= s1_u_more ? s1_u_q - s1_excess : s1_u_q;
      s2_v_q <= s1_u_more ? s1_v_q : s1_v_q - s1_excess;
    end
  end

  // Flags are delayed to s4.
  logic s4_back, s4_ends, s4_smooth;

  rc_shift_register #(.Width(3), .Stages(4)) u_flags (
    .clk_i, .enable_i(valid_i[3:0]), .data_i({s0_back_i, s0_ends, s0_smooth}),
    .data_o({s4_back, s4_ends, s4_smooth}));

  // s3: the normal n = (b - a) x (c - a), and products with u, v.
  logic [3*N-1:0]           s3_a;
  logic [3*NormalBits-1:0]  s3_cross, s4_n_q;
  logic [3*PlanePointW-1:0] s4_at_q;
  logic [3*NormalSumW-1:0]  s4_smooth_sum;

  rc_shift_register #(.Width(3 * N), .Stages(3)) u_a (
    .clk_i, .enable_i(valid_i[2:0]), .data_i(s0_a), .data_o(s3_a));

  logic [3*OriginWidth-1:0] s3_ray_point, s4_ray_point;
  logic [2:0]               s4_beyond, s4_outside;

  // Each axis of e1 and of e2 with the next but one: the factors of the cross product come first.
  logic [6*DiffW-1:0]           s1_left, s1_right;
  logic [3*DiffW-1:0]           s2_e1, s2_e2;
  logic [6*2*DiffW-1:0]         s1_product;
  logic [6*(WeightW+DiffW)-1:0] s2_product;

  rc_mul_held #(.AW(DiffW), .BW(DiffW), .Products(6)) u_cross (
    .clk_i, .phase_i(phase_i[Every +: Every]), .a_i(s1_left), .b_i(s1_right), .p_o(s1_product));

  rc_mul_held #(.AW(WeightW), .BW(DiffW), .Products(6)) u_along (
    .clk_i, .phase_i(phase_i[2*Every +: Every]), .a_i({{3{s2_v_q}}, {3{s2_u_q}}}),
    .b_i({s2_e2, s2_e1}), .p_o(s2_product));

  for (genvar k = 0; k < 3; k++) begin : gen_axis
    localparam int unsigned Axis1 = (k + 1) % 3;   // the other two axes
    localparam int unsigned Axis2 = (k + 2) % 3;

    assign s1_left[k*DiffW +: DiffW]      = s1_e1_q[Axis1*DiffW +: DiffW];
    assign s1_right[k*DiffW +: DiffW]     = s1_e2_q[Axis2*DiffW +: DiffW];
    assign s1_left[(3+k)*DiffW +: DiffW]  = s1_e1_q[Axis2*DiffW +: DiffW];
    assign s1_right[(3+k)*DiffW +: DiffW] = s1_e2_q[Axis1*DiffW +: DiffW];

    always_ff @(posedge clk_i) begin
      if (valid_i[0] && !s0_sphere) begin
        s1_e1_q[k*DiffW +: DiffW] <= {s0_b[k*N+N-1], s0_b[k*N +: N]}
                                   - {s0_a[k*N+N-1], s0_a[k*N +: N]};
        s1_e2_q[k*DiffW +: DiffW] <= {s0_c[k*N+N-1], s0_c[k*N +: N]}
                                   - {s0_a[k*N+N-1], s0_a[k*N +: N]};
      end
    end

    logic signed [2*DiffW-1:0]       s2_first_q, s2_second_q;
    logic signed [DiffW-1:0]         s2_e1_q, s2_e2_q;
    logic signed [WeightW+DiffW-1:0] s3_ue1_q, s3_ve2_q;
    logic signed [NormalBits-1:0]    s3_cross_q;

    assign s3_cross[k*NormalBits +: NormalBits] = s3_cross_q;
    assign s2_e1[k*DiffW +: DiffW]              = s2_e1_q;
    assign s2_e2[k*DiffW +: DiffW]              = s2_e2_q;

    always_ff @(posedge clk_i) begin
      if (valid_i[1] && !sphere[1]) begin
        s2_first_q  <= s1_product[k*2*DiffW +: 2*DiffW];
        s2_second_q <= s1_product[(3+k)*2*DiffW +: 2*DiffW];
        s2_e1_q     <= $signed(s1_e1_q[k*DiffW +: DiffW]) >>> s1_fine_q;
        s2_e2_q     <= $signed(s1_e2_q[k*DiffW +: DiffW]) >>> s1_fine_q;
      end
      if (valid_i[2] && !sphere[2]) begin
        s3_cross_q <= NormalBits'(s2_first_q) - NormalBits'(s2_second_q);
        s3_ue1_q   <= s2_product[k*(WeightW+DiffW) +: WeightW+DiffW];
        s3_ve2_q   <= s2_product[(3+k)*(WeightW+DiffW) +: WeightW+DiffW];
      end
    end

    // s4: the point, in units of 2^-OriginBits; for a sphere its normal.
    logic signed [OriginWidth:0] s3_a_wide, s3_out;

    assign s3_a_wide = (OriginWidth+1)'($signed(s3_a[k*N +: N])) <<< OriginBits;
    assign s3_out    = (OriginWidth+1)'($signed(s3_ray_point[k*OriginWidth +: OriginWidth]))
                     - s3_a_wide;

    always_ff @(posedge clk_i) begin
      if (valid_i[3]) begin
        s4_at_q[k*PlanePointW +: PlanePointW] <= PlanePointW'(s3_a_wide) + PlanePointW'(s3_ue1_q)
                                               + PlanePointW'(s3_ve2_q);
        s4_n_q[k*NormalBits +: NormalBits] <= sphere[3] ? NormalBits'(s3_out)
                                            : s3_cross[k*NormalBits +: NormalBits];
      end
    end

    // s5: clamped to the range of o, and turned towards the viewer.
    logic signed [PlanePointW-1:0] s4_at;
    logic signed [NormalBits-1:0]  s4_n;
    logic [PointWidth-1:0]         s4_o;
    logic signed [UnitW-1:0]       s4_toward;
    localparam logic signed [PlanePointW-1:0] Most =
        PlanePointW'((65'(1) << (PointWidth - 1)) - 65'd1);
    localparam logic signed [PlanePointW-1:0] End =
        PlanePointW'(((65'(1) << (N - 1)) - 65'd1) << OriginBits);

    assign s4_at         = $signed(s4_at_q[k*PlanePointW +: PlanePointW]);
    assign s4_beyond[k]  = s4_at > Most || s4_at < -Most;
    assign s4_outside[k] = s4_at > End || s4_at < -End;
    assign s4_o = sphere[4] ? PointWidth'($signed(s4_ray_point[k*OriginWidth +: OriginWidth]))
                : s4_at > Most ? Most[PointWidth-1:0]
                : s4_at < -Most ? -Most[PointWidth-1:0] : s4_at[PointWidth-1:0];

    assign s4_n      = $signed(s4_n_q[k*NormalBits +: NormalBits]);
    assign s4_toward = s4_smooth ? UnitW'($signed(s4_smooth_sum[k*NormalSumW +: NormalSumW]))
                     : UnitW'(s4_n);

    always_ff @(posedge clk_i) begin
      if (valid_i[4]) begin
        s5_o_o[k*PointWidth +: PointWidth]  <= s4_o;
        s5_n_o[k*NormalBits +: NormalBits]  <= s4_back ? -s4_n : s4_n;
        s5_toward_o[k*UnitW +: UnitW]       <= s4_back ? -s4_toward : s4_toward;
      end
    end
  end

  always_ff @(posedge clk_i)
    if (valid_i[4]) begin
      s5_far_o  <= !sphere[4] && (s4_ends || s4_beyond != '0
                                  || (rc_pkg::Planes && s4_outside != '0));
      s5_lost_o <= !sphere[4] && (s4_ends || s4_beyond != '0);
    end

  // Weighted corner normals.
  if (rc_pkg::Smooth) begin : gen_smooth
    rc_corner_normals #(.WeightW(WeightW), .NormalSumW(NormalSumW)) u_corner_normals (
      .clk_i, .valid_i(valid_i[3:0]), .phase_i(phase_i[2*Every +: Every]),
      .s0_normal_i(s0_normal), .s2_rest_i(s2_rest),
      .s2_u_i(s2_u_q), .s2_v_i(s2_v_q), .s4_sum_o(s4_smooth_sum));
  end else begin : gen_flat
    assign s4_smooth_sum = '0;

    logic unused;
    assign unused = ^{s2_rest, s0_normal};
  end

  // A sphere's point: o + t d.
  if (rc_pkg::Spheres) begin : gen_ray_point
    rc_ray_point u_ray_point (
      .clk_i, .valid_i(valid_i[3:0]), .phase_i(phase_i[Every-1:0]), .sphere_i(sphere[3:0]),
      .s0_o_i, .s0_d_i, .s0_t_i,
      .s3_o_o(s3_ray_point), .s4_o_o(s4_ray_point));
  end else begin : gen_no_ray_point
    assign s3_ray_point = '0;
    assign s4_ray_point = '0;

    logic unused;
    assign unused = ^{s0_o_i, s0_d_i, s0_t_i};
  end

  // The colour there.
  rc_ambient u_ambient (
    .clk_i, .valid_i(tone_valid_i), .phase_i, .s0_surface_i, .s0_weight_i, .s0_odd_i(s0_odd),
    .s0_ends_i(s0_ends), .s0_texture_i, .s0_albedo_i, .s0_share_i, .s0_texel_i,
    .s6_albedo_o, .s7_ambient_o);

  logic unused;
  assign unused = ^{s0_surface_i, s0_square_u, s0_square_v, phase_i};
endmodule
`default_nettype wire

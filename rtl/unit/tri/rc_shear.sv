// The sheared triangle test up to its decision: the corners in the ray's plane, with one rounding
// each, then exact 2-D edge functions.
//
// Part of rc_tri, in place of rc_edges. Here num / det is the hit's distance along z; size = |d_z|.
// Latency 6, throughput 1 per cycle; stage k works if enable_i[k] is set. Model, formulas and the
// proof of the widths: model/unit/tri/sheared.hpp (Woop et al. 2013).
`default_nettype none
module rc_shear #(
  localparam int unsigned N        = rc_pkg::CoordBits,
  localparam int unsigned M        = rc_pkg::DirBits,
  localparam int unsigned EdgeBits = 2 * N + 3,   // rc_pkg::EdgeBits
  localparam int unsigned NumBits  = 3 * N + 3    // rc_pkg::NumBits
) (
  input  logic                       clk_i,
  input  logic [5:0]                 enable_i,   // of stages 0..5
  // Ray and triangle
  input  logic [1:0]                 s0_axis_i,
  input  logic                       s0_neg_i,
  input  logic [M-1:0]               s0_size_i,
  input  logic [2*M-1:0]             s0_slope_i,   // {y, x}
  input  logic [3*N-1:0]             s0_o_i,
  input  logic [3*N-1:0]             s0_a_i,
  input  logic [3*N-1:0]             s0_b_i,
  input  logic [3*N-1:0]             s0_c_i,
  // Result
  output logic                       s6_hit_o,
  output logic [M-1:0]               s6_size_o,
  output logic signed [EdgeBits-1:0] s6_det_o,
  output logic signed [NumBits-1:0]  s6_num_o,
  output logic signed [EdgeBits-1:0] s6_u_o,
  output logic signed [EdgeBits-1:0] s6_v_o
);
  localparam int unsigned DiffW         = N + 1;        // difference of two points
  localparam int unsigned SlopeFrac     = M - 2;        // fraction bits of a slope
  // Slope times difference: below 2^(SlopeFrac + N).
  localparam int unsigned SlopeProductW = M + N - 1;
  localparam int unsigned PlanarW       = N + 2;        // coordinate in the ray's plane
  localparam int unsigned PlanarEdgeW   = 2 * PlanarW;  // edge function in the plane

  // Coordinates in the order {z, y, x} that the ray's axis gives.
  function automatic logic [3*N-1:0] turned(input logic [3*N-1:0] p, input logic [1:0] axis);
    turned = axis == 2'd0 ? {p[N-1:0], p[3*N-1:N]}
           : axis == 2'd1 ? {p[2*N-1:0], p[3*N-1:2*N]} : p;
  endfunction

  // ---- s1: corners relative to the origin.
  logic [3*N-1:0] s0_o;
  assign s0_o = turned(s0_o_i, s0_axis_i);

  logic [M-1:0] s1_slope_x_q, s1_slope_y_q;

  always_ff @(posedge clk_i)
    if (enable_i[0]) {s1_slope_y_q, s1_slope_x_q} <= {s0_slope_i[M +: M], s0_slope_i[0 +: M]};

  // Fields that wait for the decision.
  logic         s5_neg;
  logic [M-1:0] s5_size;

  rc_shift_register #(.Width(M + 1), .Stages(5)) u_wait (
    .clk_i, .enable_i(enable_i[4:0]), .data_i({s0_neg_i, s0_size_i}), .data_o({s5_neg, s5_size}));

  logic [3*N*3-1:0]     s0_corners;
  logic [3*DiffW-1:0]   s4_z;
  logic [3*PlanarW-1:0] s3_x, s3_y;

  assign s0_corners = {s0_c_i, s0_b_i, s0_a_i};

  for (genvar k = 0; k < 3; k++) begin : gen_corner
    logic        [3*N-1:0]           s0_p;
    logic signed [DiffW-1:0]         s1_x_q, s1_y_q, s1_z_q, s2_x_q, s2_y_q, s2_z_q, s3_z_q, s4_z_q;
    logic signed [SlopeProductW-1:0] s2_px_q, s2_py_q, s2_up_x, s2_up_y;
    logic signed [PlanarW-1:0]       s3_x_q, s3_y_q;

    assign s0_p = turned(s0_corners[k*3*N +: 3*N], s0_axis_i);

    // s2: slopes times z. s3: one rounding, r - slope z + 1/2, rounded down, Q(N+2).0.
    assign s2_up_x = $signed({{(SlopeProductW-SlopeFrac){1'b0}}, 1'b1, {(SlopeFrac-1){1'b0}}})
                   - s2_px_q;
    assign s2_up_y = $signed({{(SlopeProductW-SlopeFrac){1'b0}}, 1'b1, {(SlopeFrac-1){1'b0}}})
                   - s2_py_q;

    always_ff @(posedge clk_i) begin
      if (enable_i[0]) begin
        s1_x_q <= DiffW'($signed(s0_p[N-1:0])) - DiffW'($signed(s0_o[N-1:0]));
        s1_y_q <= DiffW'($signed(s0_p[2*N-1:N])) - DiffW'($signed(s0_o[2*N-1:N]));
        s1_z_q <= DiffW'($signed(s0_p[3*N-1:2*N])) - DiffW'($signed(s0_o[3*N-1:2*N]));
      end
      if (enable_i[1]) begin
        s2_px_q <= SlopeProductW'($signed(s1_slope_x_q)) * SlopeProductW'(s1_z_q);
        s2_py_q <= SlopeProductW'($signed(s1_slope_y_q)) * SlopeProductW'(s1_z_q);
        {s2_x_q, s2_y_q, s2_z_q} <= {s1_x_q, s1_y_q, s1_z_q};
      end
      if (enable_i[2]) begin
        s3_x_q <= PlanarW'(s2_x_q) + PlanarW'($signed(s2_up_x[SlopeProductW-1:SlopeFrac]));
        s3_y_q <= PlanarW'(s2_y_q) + PlanarW'($signed(s2_up_y[SlopeProductW-1:SlopeFrac]));
        s3_z_q <= s2_z_q;
      end
      if (enable_i[3]) s4_z_q <= s3_z_q;
    end

    assign s3_x[k*PlanarW +: PlanarW] = s3_x_q;
    assign s3_y[k*PlanarW +: PlanarW] = s3_y_q;
    assign s4_z[k*DiffW +: DiffW] = s4_z_q;

    logic unused;
    assign unused = ^{s2_up_x[SlopeFrac-1:0], s2_up_y[SlopeFrac-1:0]};
  end

  // ---- s4: the edge function from corner k to the next, which weighs the third corner: v, w, u. A
  // zero has the sign of a ray that is displaced by (eps, eps^2).
  logic [3*PlanarEdgeW-1:0] s4_edge;
  logic [2:0]               s4_neg;

  for (genvar k = 0; k < 3; k++) begin : gen_edge
    localparam int unsigned To = k == 2 ? 0 : k + 1;
    logic signed [PlanarW-1:0]     s3_px, s3_py, s3_qx, s3_qy;
    logic signed [PlanarEdgeW-1:0] s4_edge_q;
    logic                          s4_tie_q;

    assign s3_px = $signed(s3_x[k*PlanarW +: PlanarW]);
    assign s3_py = $signed(s3_y[k*PlanarW +: PlanarW]);
    assign s3_qx = $signed(s3_x[To*PlanarW +: PlanarW]);
    assign s3_qy = $signed(s3_y[To*PlanarW +: PlanarW]);

    always_ff @(posedge clk_i) begin
      if (enable_i[3]) begin
        s4_edge_q <= PlanarEdgeW'(s3_px) * PlanarEdgeW'(s3_qy)
                   - PlanarEdgeW'(s3_py) * PlanarEdgeW'(s3_qx);
        s4_tie_q  <= s3_py != s3_qy ? s3_py < s3_qy : s3_qx < s3_px;
      end
    end

    assign s4_edge[k*PlanarEdgeW +: PlanarEdgeW] = s4_edge_q;
    assign s4_neg[k] = s4_edge_q != '0 ? s4_edge_q[PlanarEdgeW-1] : s4_tie_q;
  end

  // ---- s5: determinant and numerator. For a hit they fit EdgeBits and NumBits bits. Otherwise
  // only the determinant's sign counts.
  logic signed [PlanarEdgeW-1:0] s4_u, s4_v, s4_w, s5_det_q;
  logic signed [EdgeBits-1:0]    s5_u_q, s5_v_q;
  logic signed [NumBits-1:0]     s5_num_q;
  logic [2:0]                    s5_neg_q;

  assign s4_v = $signed(s4_edge[PlanarEdgeW-1:0]);
  assign s4_w = $signed(s4_edge[2*PlanarEdgeW-1:PlanarEdgeW]);
  assign s4_u = $signed(s4_edge[3*PlanarEdgeW-1:2*PlanarEdgeW]);

  always_ff @(posedge clk_i) begin
    if (enable_i[4]) begin
      s5_det_q <= s4_u + s4_v + s4_w;
      s5_num_q <= NumBits'(s4_w) * NumBits'($signed(s4_z[DiffW-1:0]))
                + NumBits'(s4_u) * NumBits'($signed(s4_z[2*DiffW-1:DiffW]))
                + NumBits'(s4_v) * NumBits'($signed(s4_z[3*DiffW-1:2*DiffW]));
      s5_u_q   <= s4_u[EdgeBits-1:0];
      s5_v_q   <= s4_v[EdgeBits-1:0];
      s5_neg_q <= s4_neg;
    end
  end

  // ---- s6: all edge functions have one sign, and the hit is ahead.
  logic s5_flip, s5_turn;

  assign s5_flip = s5_det_q[PlanarEdgeW-1];
  assign s5_turn = s5_flip != s5_neg;

  always_ff @(posedge clk_i) begin
    if (enable_i[5]) begin
      s6_hit_o  <= s5_det_q != '0 && s5_size != '0 && s5_neg_q == {3{s5_flip}}
                && s5_num_q != '0 && s5_num_q[NumBits-1] == s5_turn;
      s6_size_o <= s5_size;
      s6_det_o  <= s5_flip ? -s5_det_q[EdgeBits-1:0] : s5_det_q[EdgeBits-1:0];
      s6_u_o    <= s5_flip ? -s5_u_q : s5_u_q;
      s6_v_o    <= s5_flip ? -s5_v_q : s5_v_q;
      s6_num_o  <= s5_turn ? -s5_num_q : s5_num_q;
    end
  end
endmodule
`default_nettype wire

// One axis of the slab test for all children of a node: where the ray enters and
// leaves each slab, rounded down and up. Part of rc_box, which has the valid bits:
// operands in s0, planes in s2, interval from the registers of s3 (zero if s3 holds nothing).
// If the origin has fraction bits, near planes are measured from the lattice point before
// or beyond it that lies further along the ray, far planes from the other one: at most a
// lattice step more (docs/origins.md, Boxes). Model: model/bvh/slab.hpp and slab.inl.
`default_nettype none
module rc_slab #(
  localparam int unsigned W  = rc_pkg::NodeWidth,
  localparam int unsigned N  = rc_pkg::CoordBits,
  localparam int unsigned OW = rc_pkg::OriginWidth,
  localparam int unsigned B  = rc_pkg::BoxBits,
  localparam int unsigned R1 = rc_pkg::RecipBits + 1,
  localparam int unsigned E  = rc_pkg::ExpBits,
  localparam int unsigned T  = rc_pkg::TBits
) (
  input  logic                clk_i,
  input  logic                s0_valid_i,
  input  logic                s1_valid_i,
  input  logic                s2_valid_i,
  input  logic                s3_valid_i,
  input  logic signed [OW-1:0] s0_o_i,
  input  logic signed [N-1:0] s0_org_i,
  input  logic                s0_neg_i,
  input  logic [R1-1:0]       s0_recip_i,
  input  logic [E-1:0]        s0_len_i,
  input  logic [E-1:0]        s0_exp_i,
  input  logic [W*B-1:0]      s2_lo_i,
  input  logic [W*B-1:0]      s2_hi_i,
  output logic [W*T-1:0]      s3_near_o,
  output logic [W*T-1:0]      s3_far_o,
  output logic [W-1:0]        s3_miss_o
);
  localparam int unsigned D  = N + 1;       // plane distance, signed
  localparam int unsigned P  = D + R1 + 1;  // its product with r or r + 1 <= 2^R + 1, signed
  localparam int unsigned V  = P + 1;       // plus plane * r, signed
  localparam int unsigned S  = 8;           // shift, signed: -24..62
  // shift = x + e = F + M - len - R + e, M as wide as a ray's direction; the constant part:
  localparam logic signed [S-1:0] ShiftBase = S'(rc_pkg::TFracBits) + S'(rc_pkg::RayDirBits)
      - S'(rc_pkg::RecipBits);

  // s0: the origin's lattice point before, and whether that is not the one beyond as well.
  logic signed [N-1:0] s0_point;
  logic                s0_between;
  assign s0_point = s0_o_i[OW-1 -: N];
  if (rc_pkg::OriginBits == 0) begin : gen_on_lattice
    assign s0_between = 1'b0;
  end else begin : gen_between
    assign s0_between = |s0_o_i[OW-N-1:0];
  end

  // s1: distance from the ray's origin to the node's, along the ray; the shorter one, that
  // of near planes. That of far planes is one more if the origin lies between lattice points.
  logic signed [D-1:0] s1_distance_q;
  logic                s1_between_q;
  logic [R1-1:0]       s1_r_q, s2_r_q;
  logic                s1_neg_q, s1_zero_q, s2_neg_q, s2_zero_q;
  logic [E-1:0]        s1_exp_q;
  logic signed [S-1:0] s1_shift_q, s2_shift_q;
  always_ff @(posedge clk_i) begin
    if (s0_valid_i) begin
      s1_distance_q <= s0_neg_i
          ? D'(s0_point) - D'(s0_org_i)
          : D'(s0_org_i) - D'(s0_point) - $signed({{(D-1){1'b0}}, s0_between});
      s1_between_q  <= s0_between;
      s1_r_q        <= s0_recip_i;
      s1_neg_q      <= s0_neg_i;
      s1_zero_q     <= s0_len_i == '0;
      s1_exp_q      <= s0_exp_i;
      s1_shift_q    <= ShiftBase - $signed({{(S-E){1'b0}}, s0_len_i})
          + $signed({{(S-E){1'b0}}, s0_exp_i});
    end
  end

  // s2: D r / 2^e down, D (r + 1) / 2^e up.
  logic signed [P-1:0] s1_near, s1_far, s2_near_q, s2_far_q;
  logic [R1-1:0]       s1_r_up, s2_r_up;
  assign s1_r_up = s1_r_q + {{(R1-1){1'b0}}, !s1_zero_q};
  assign s2_r_up = s2_r_q + {{(R1-1){1'b0}}, !s2_zero_q};
  assign s1_near = P'(s1_distance_q) * $signed({{(P-R1){1'b0}}, s1_r_q});
  if (rc_pkg::OriginBits == 0) begin : gen_far
    assign s1_far = -(P'(s1_distance_q) * $signed({{(P-R1){1'b0}}, s1_r_up}));
  end else begin : gen_far_between   // the near product, and what it lacks
    assign s1_far = -(s1_near + (s1_zero_q ? '0 : P'(s1_distance_q))
                      + (s1_between_q ? $signed({{(P-R1){1'b0}}, s1_r_up}) : '0));
  end
  always_ff @(posedge clk_i) begin
    if (s1_valid_i) begin
      s2_near_q  <= s1_near >>> s1_exp_q;
      s2_far_q   <= -(s1_far >>> s1_exp_q);
      s2_r_q     <= s1_r_q;
      s2_neg_q   <= s1_neg_q;
      s2_zero_q  <= s1_zero_q;
      s2_shift_q <= s1_shift_q;
    end
  end

  // s3: the children's planes, still in units of 2^-shift.
  logic                s3_zero_q;
  logic [4:0]          s3_left_q, s3_right_q;   // one of them is zero
  logic [R1-1:0]       s3_up_q;                 // 2^right - 1: what rounding up adds
  logic signed [S-1:0] s2_right;                // a shift by T, and all beyond it, saturates
  assign s2_right = s2_shift_q[S-1] ? -s2_shift_q : '0;
  always_ff @(posedge clk_i) begin
    if (s2_valid_i) begin
      s3_zero_q  <= s2_zero_q;
      s3_left_q  <= s2_shift_q[S-1] ? 5'd0 : s2_shift_q > S'(T) ? 5'(T) : s2_shift_q[4:0];
      s3_right_q <= s2_right[4:0];
      s3_up_q    <= ~({R1{1'b1}} << s2_right[4:0]);
    end
  end

  function automatic logic signed [V-1:0] way(input logic [B-1:0] plane, input logic [R1-1:0] r);
    way = $signed({{(V-B){1'b0}}, plane} * {{(V-R1){1'b0}}, r});
  endfunction

  // Distance of a non-negative v, moved to its place and saturated at all ones.
  function automatic logic [T-1:0] scale(input logic [V-1:0] v, input logic [4:0] left,
      input logic [4:0] right);
    logic [V-1:0]   down;
    logic [2*T-1:0] moved;
    down  = v >> right;
    moved = {{T{1'b0}}, down[T-1:0]} << left;
    scale = |down[V-1:T] || |moved[2*T-1:T] ? '1 : moved[T-1:0];
  endfunction

  for (genvar i = 0; i < W; i++) begin : gen_child
    logic signed [V-1:0] s3_near_q, s3_far_q;
    always_ff @(posedge clk_i) begin
      if (s2_valid_i) begin
        s3_near_q <= s2_neg_q ? V'(s2_near_q) - way(s2_hi_i[i*B +: B], s2_r_q)
                              : V'(s2_near_q) + way(s2_lo_i[i*B +: B], s2_r_q);
        s3_far_q  <= s2_neg_q ? V'(s2_far_q) - way(s2_lo_i[i*B +: B], s2_r_up)
                              : V'(s2_far_q) + way(s2_hi_i[i*B +: B], s2_r_up);
      end
    end
    logic [T-1:0] near, far;
    logic         miss;
    always_comb begin
      near = '0;
      far  = '0;
      miss = 1'b0;
      if (s3_valid_i) begin
        if (!s3_zero_q && !s3_near_q[V-1])
          near = scale($unsigned(s3_near_q), s3_left_q, s3_right_q);
        far  = s3_zero_q ? '1
             : scale($unsigned(s3_far_q) + {{(V-R1){1'b0}}, s3_up_q}, s3_left_q, s3_right_q);
        miss = s3_far_q[V-1] || (s3_zero_q && !s3_near_q[V-1] && s3_near_q != '0);
      end
    end
    assign s3_near_o[i*T +: T] = near;
    assign s3_far_o[i*T +: T]  = far;
    assign s3_miss_o[i]        = miss;
  end

  logic unused;
  assign unused = ^{s1_between_q, s2_right[S-1:5]};
endmodule
`default_nettype wire

// The times at which a ray enters and leaves the box around the content of a cell, for treelet,
// slant and bih. Its six planes come in parallel pairs.
//
// Part of rc_cell_answer, which has the valid bits. Operands come with valid_i[0]; the
// answer comes rc_pkg::PlaneStages + 1 + Cut cycles later.
`default_nettype none
module rc_bounds #(
  localparam int unsigned N           = rc_pkg::CoordBits,
  localparam int unsigned OriginWidth = rc_pkg::OriginWidth,
  localparam int unsigned R1          = rc_pkg::RecipBits + 1,
  localparam int unsigned ExpBits     = rc_pkg::ExpBits,
  localparam int unsigned TBits       = rc_pkg::TBits,
  localparam int unsigned PlaneStages = rc_pkg::PlaneStages,
  localparam int unsigned Stages      = PlaneStages + 1 + rc_pkg::PathCut
) (
  input  logic            clk_i,
  input  logic [Stages-1:0] valid_i,   // valid_i[i]: stage i holds a node
  // Ray: origin, signs, reciprocals and lengths of its direction
  input  logic [3*OriginWidth-1:0] s0_o_i,
  input  logic [2:0]               s0_neg_i,
  input  logic [3*R1-1:0]          s0_recip_i,
  input  logic [3*ExpBits-1:0]     s0_len_i,
  // Box
  input  logic                     s0_open_i, // the cell has no box
  input  logic [3*N-1:0]           s0_lo_i,
  input  logic [3*N-1:0]           s0_hi_i,
  // Interval of times in the box
  output logic [TBits-1:0]         enter_o,
  output logic [TBits-1:0]         leave_o,
  output logic                     met_o
);
  logic [3*TBits-1:0] box_from, box_to;
  logic [2:0]         box_there, unused_side;

  // For each axis, the plane that the ray meets first, and the other one.
  for (genvar k = 0; k < 3; k++) begin : gen_side
    logic signed [N-1:0] lo, hi, first, last;
    logic [TBits-1:0] unused_to, unused_from;
    logic             turned, near_last, far_first;
    logic             unused_turned, unused_turned_last, unused_near, unused_far;
    logic [1:0]       axis;

    assign axis   = s0_open_i ? 2'd3 : 2'(k);
    assign turned = s0_neg_i[k] && s0_len_i[ExpBits*k +: ExpBits] != '0;
    assign lo     = $signed(s0_lo_i[N*k +: N]);
    assign hi     = $signed(s0_hi_i[N*k +: N]);
    assign first  = turned ? hi : lo;
    assign last   = turned ? lo : hi;

    rc_plane #(.HasTo(1'b0)) u_first (
      .clk_i, .valid_i(valid_i[PlaneStages-1:0]),
      .s0_o_i, .s0_neg_i, .s0_recip_i, .s0_len_i,
      .s0_axis_i(axis), .s0_at_i(first),
      .turned_o(unused_turned), .near_o(unused_near), .far_o(far_first),
      .near_to_o(unused_to), .far_from_o(box_from[k*TBits +: TBits]));

    rc_plane u_last (
      .clk_i, .valid_i(valid_i[PlaneStages-1:0]),
      .s0_o_i, .s0_neg_i, .s0_recip_i, .s0_len_i,
      .s0_axis_i(axis), .s0_at_i(last),
      .turned_o(unused_turned_last), .near_o(near_last), .far_o(unused_far),
      .near_to_o(box_to[k*TBits +: TBits]), .far_from_o(unused_from));

    assign box_there[k]   = far_first && near_last;
    assign unused_side[k] = ^{unused_turned, unused_turned_last, unused_near, unused_far, unused_to,
                              unused_from};
  end

  rc_span u_box (
    .clk_i, .valid_i(valid_i[Stages-1]), .from_i(box_from), .to_i(box_to), .there_i(box_there),
    .from_o(enter_o), .to_o(leave_o), .there_o(met_o));

  logic unused;
  assign unused = ^{valid_i, unused_side};
endmodule
`default_nettype wire

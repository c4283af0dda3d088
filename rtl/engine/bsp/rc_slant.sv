// The exits of a slant (a treelet whose planes lie in any direction) that a ray meets,
// conservative, and their order.
//
// Latency rc_pkg::SlantLatency + 1 (result queue), throughput 1 slant per cycle, answers in order.
//
// No exit is left out whose cell holds a point of the ray, and an exit's t_near is never beyond
// such a point. Model: model/engine/bsp/slant.hpp, which has the formulas.
`default_nettype none
module rc_slant (
  input  logic                 clk_i,
  input  logic                 rst_ni,
  // From trav
  input  logic                 req_valid_i,
  output logic                 req_ready_o,
  input  rc_pkg::slant_req_t   req_i,
  // To trav
  output logic                 rsp_valid_o,
  input  logic                 rsp_ready_i,
  output rc_pkg::slant_rsp_t   rsp_o
);
  localparam int unsigned W  = rc_pkg::NodeWidth;
  localparam int unsigned Q  = rc_pkg::NodePlanes;
  localparam int unsigned H  = rc_pkg::RayDirBits;
  localparam int unsigned B  = rc_pkg::NormalStepBits;
  localparam int unsigned A  = rc_pkg::PlaneOffsetBits;
  localparam int unsigned T  = rc_pkg::TBits;
  localparam int unsigned L  = rc_pkg::SlantLatency;

  // Stages in which a slant has arrived, its planes' times are ready, and the box's times are
  // ready.
  localparam int unsigned In   = rc_pkg::Cut;
  localparam int unsigned Meet = In + rc_pkg::CrossingStages;
  localparam int unsigned Box  = In + rc_pkg::PlaneStages + 1 + rc_pkg::Cut;

  // Admission: an answer has a place in the result queue. valid[i]: stage i holds a slant.
  logic         admit;
  logic [L-1:0] valid_q;
  logic [L:0]   valid;

  assign valid = {valid_q, admit};

  rc_credited_pipeline #(.Credits(rc_pkg::BoxQueue), .Stages(L)) u_stages (
    .clk_i, .rst_ni, .req_valid_i, .req_ready_o, .rests_i(1'b0),
    .leave_i(rsp_valid_o && rsp_ready_i), .admit_o(admit), .valid_q_o(valid_q));

  // The slant, unpacked.
  rc_pkg::slant_req_t           in;
  logic [rc_pkg::SlantReqW-1:0] in_flat;
  logic [3*B*Q-1:0]             in_normal;
  logic [2:0]                   neg;
  logic [A*Q-1:0]               in_at;

  rc_path_register #(.Width(rc_pkg::SlantReqW)) u_in (.clk_i, .data_i(req_i), .data_o(in_flat));

  assign in        = in_flat;
  assign in_normal = in.normal;
  assign in_at     = in.at;

  // The times at which the ray enters and leaves the box around the content of the slant's cell.
  // They wait for the planes.
  logic [3*H-1:0] in_along;
  logic [T-1:0]   enter, leave, box_enter, box_leave;
  logic           there, box_met;

  assign in_along = in.along;
  assign neg      = {in_along[3*H-1], in_along[2*H-1], in_along[H-1]};

  rc_bounds u_bounds (
    .clk_i, .valid_i(valid[Box-1:In]), .s0_o_i(in.o), .s0_neg_i(neg), .s0_recip_i(in.recip),
    .s0_len_i(in.len), .s0_open_i(in.open), .s0_lo_i(in.lo), .s0_hi_i(in.hi),
    .enter_o(enter), .leave_o(leave), .met_o(there));

  rc_shift_register #(.Width(2 * T + 1), .Stages(Meet + 1 + In - Box)) u_wait (
    .clk_i, .valid_i(valid[Meet+In:Box]), .data_i({enter, leave, there}),
    .data_o({box_enter, box_leave, box_met}));

  // For each plane: the sides that exist, and when the ray changes from one to the other.
  logic [Q-1:0]   turned, near, far;
  logic [Q*T-1:0] near_to, far_from;

  for (genvar i = 0; i < Q; i++) begin : gen_plane
    logic signed [A-1:0] at;   // Yosys 0.23 refuses a whole vector as $signed at a port
    assign at = in_at[A*i +: A];

    rc_crossing u_plane (
      .clk_i, .valid_i(valid[Meet-1:In]), .s0_o_i(in.o), .s0_along_i(in.along),
      .s0_normal_i(in_normal[3*B*i +: 3*B]), .s0_at_i(at),
      .turned_o(turned[i]), .near_o(near[i]), .far_o(far[i]),
      .near_to_o(near_to[i*T +: T]), .far_from_o(far_from[i*T +: T]));
  end

  // The exits that are met.
  logic [W-1:0]   met;
  logic [W*T-1:0] near_t;

  rc_exits u_exits (
    .clk_i, .valid_i(valid[Meet+In]), .turned_i(turned), .near_i(near), .far_i(far),
    .near_to_i(near_to), .far_from_i(far_from), .enter_i(box_enter), .leave_i(box_leave),
    .met_i(box_met), .met_o(met), .near_o(near_t));

  // Their order, and the result queue.
  logic [rc_pkg::SlantRspW-1:0] rsp;

  rc_node_answer #(.Latency(L), .Exits(1'b1)) u_answer (
    .clk_i, .rst_ni, .moves_i(valid[L-1:0]), .ray_i(in.ray), .base_i(in.base), .kind_i(in.kind),
    .met_i(met), .near_i(near_t), .end_valid_i(valid_q[L-1]),
    .rsp_valid_o, .rsp_ready_i, .rsp_o(rsp));

  assign rsp_o = rsp;

  logic unused;
  assign unused = valid[L];
endmodule
`default_nettype wire

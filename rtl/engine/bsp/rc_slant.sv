// Finds and sorts the exits that a ray meets in a slant, which is a treelet whose planes lie in any
// direction.
//
// Latency rc_pkg::SlantLatency + 1 (result queue), throughput 1 slant per cycle, answers in order.
//
// Conservative: it reports every exit whose cell holds a point of the ray, and t_near never exceeds
// the time of such a point. Model: model/engine/bsp/slant.hpp, which has the formulas.
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
  localparam int unsigned NodePlanes      = rc_pkg::NodePlanes;
  localparam int unsigned RayDirBits      = rc_pkg::RayDirBits;
  localparam int unsigned NormalStepBits  = rc_pkg::NormalStepBits;
  localparam int unsigned PlaneOffsetBits = rc_pkg::PlaneOffsetBits;
  localparam int unsigned TBits           = rc_pkg::TBits;
  localparam int unsigned Latency         = rc_pkg::SlantLatency;

  // Stages in which a slant has arrived, and its planes' times are ready.
  localparam int unsigned In   = rc_pkg::PathCut;
  localparam int unsigned Meet = In + rc_pkg::CrossingStages;

  // Admission: an answer has a place in the result queue. valid[i]: stage i holds a slant.
  logic               admit;
  logic [Latency-1:0] valid_q;
  logic [Latency:0]   valid;

  assign valid = {valid_q, admit};

  rc_credited_pipeline #(.Credits(rc_pkg::BoxQueue), .Stages(Latency)) u_stages (
    .clk_i, .rst_ni, .req_valid_i, .req_ready_o, .occupied_i(1'b0),
    .leave_i(rsp_valid_o && rsp_ready_i), .admit_o(admit), .valid_q_o(valid_q));

  // The slant, unpacked.
  rc_pkg::slant_req_t                     in;
  logic [rc_pkg::SlantReqW-1:0]           in_flat;
  logic [3*NormalStepBits*NodePlanes-1:0] in_normal;
  logic [2:0]                             neg;
  logic [PlaneOffsetBits*NodePlanes-1:0]  in_at;

  rc_path_register #(.Width(rc_pkg::SlantReqW)) u_in (.clk_i, .data_i(req_i), .data_o(in_flat));

  assign in        = in_flat;
  assign in_normal = in.normal;
  assign in_at     = in.at;

  logic [3*RayDirBits-1:0] in_along;

  assign in_along = in.along;
  assign neg      = {in_along[3*RayDirBits-1], in_along[2*RayDirBits-1], in_along[RayDirBits-1]};

  // For each plane: the sides that exist, and when the ray changes from one to the other.
  logic [NodePlanes-1:0]       turned, near, far;
  logic [NodePlanes*TBits-1:0] near_to, far_from;

  for (genvar i = 0; i < NodePlanes; i++) begin : gen_plane
    // Yosys 0.23 refuses a whole vector as $signed at a port.
    logic signed [PlaneOffsetBits-1:0] at;
    assign at = in_at[PlaneOffsetBits*i +: PlaneOffsetBits];

    rc_crossing u_plane (
      .clk_i, .valid_i(valid[Meet-1:In]), .s0_o_i(in.o), .s0_along_i(in.along),
      .s0_normal_i(in_normal[3*NormalStepBits*i +: 3*NormalStepBits]), .s0_at_i(at),
      .turned_o(turned[i]), .near_o(near[i]), .far_o(far[i]),
      .near_to_o(near_to[i*TBits +: TBits]), .far_from_o(far_from[i*TBits +: TBits]));
  end

  // The box, the exits, and their order.
  logic [rc_pkg::NodeAnswerW-1:0] rsp;

  rc_cell_answer #(.Latency(Latency), .Meet(Meet)) u_answer (
    .clk_i, .rst_ni, .valid_i(valid), .ray_i(in.ray), .o_i(in.o), .neg_i(neg),
    .recip_i(in.recip), .len_i(in.len), .open_i(in.open), .lo_i(in.lo), .hi_i(in.hi),
    .base_i(in.base), .kind_i(in.kind), .turned_i(turned), .near_i(near), .far_i(far),
    .near_to_i(near_to), .far_from_i(far_from), .rsp_valid_o, .rsp_ready_i, .rsp_o(rsp));

  assign rsp_o = rsp;
endmodule
`default_nettype wire

// Finds and sorts the exits of a treelet that a ray meets.
//
// Latency rc_pkg::TreeletLatency + 1 (result queue), throughput 1 treelet per cycle, answers in
// order.
//
// Conservative: it reports every exit whose cell holds a point of the ray, and t_near never exceeds
// the time of such a point. Model: model/engine/kd/treelet.hpp, which has the formulas.
`default_nettype none
module rc_treelet (
  input  logic                 clk_i,
  input  logic                 rst_ni,
  // From trav
  input  logic                 req_valid_i,
  output logic                 req_ready_o,
  input  rc_pkg::treelet_req_t req_i,
  // To trav
  output logic                 rsp_valid_o,
  input  logic                 rsp_ready_i,
  output rc_pkg::treelet_rsp_t rsp_o
);
  localparam int unsigned NodePlanes = rc_pkg::NodePlanes;
  localparam int unsigned N          = rc_pkg::CoordBits;
  localparam int unsigned TBits      = rc_pkg::TBits;
  localparam int unsigned Latency    = rc_pkg::TreeletLatency;

  // Stages in which a treelet has arrived, and its planes' times are ready.
  localparam int unsigned In   = rc_pkg::PathCut;
  localparam int unsigned Meet = In + rc_pkg::PlaneStages;

  // Admission: an answer has a place in the result queue. valid[i]: stage i holds a treelet.
  logic               admit;
  logic [Latency-1:0] valid_q;
  logic [Latency:0]   valid;

  assign valid = {valid_q, admit};

  rc_credited_pipeline #(.Credits(rc_pkg::BoxQueue), .Stages(Latency)) u_stages (
    .clk_i, .rst_ni, .req_valid_i, .req_ready_o, .occupied_i(1'b0),
    .leave_i(rsp_valid_o && rsp_ready_i), .admit_o(admit), .valid_q_o(valid_q));

  // The treelet, unpacked.
  rc_pkg::treelet_req_t           in;
  logic [rc_pkg::TreeletReqW-1:0] in_flat;
  logic [2*NodePlanes-1:0]        in_axis;
  logic [N*NodePlanes-1:0]        in_at;

  rc_path_register #(.Width(rc_pkg::TreeletReqW)) u_in (.clk_i, .data_i(req_i), .data_o(in_flat));

  assign in      = in_flat;
  assign in_axis = in.axis;
  assign in_at   = in.at;

  // For each plane: the sides that exist, and when the ray changes from one to the other.
  logic [NodePlanes-1:0]       turned, near, far;
  logic [NodePlanes*TBits-1:0] near_to, far_from;

  for (genvar i = 0; i < NodePlanes; i++) begin : gen_plane
    logic signed [N-1:0] at;   // Yosys 0.23 refuses a whole vector as $signed at a port
    assign at = in_at[N*i +: N];

    rc_plane u_plane (
      .clk_i, .valid_i(valid[Meet-1:In]),
      .s0_o_i(in.o), .s0_neg_i(in.neg), .s0_recip_i(in.recip), .s0_len_i(in.len),
      .s0_axis_i(in_axis[2*i +: 2]), .s0_at_i(at),
      .turned_o(turned[i]), .near_o(near[i]), .far_o(far[i]),
      .near_to_o(near_to[i*TBits +: TBits]), .far_from_o(far_from[i*TBits +: TBits]));
  end

  // The box, the exits, and their order.
  logic [rc_pkg::NodeAnswerW-1:0] rsp;

  rc_cell_answer #(.Latency(Latency), .Meet(Meet)) u_answer (
    .clk_i, .rst_ni, .valid_i(valid), .ray_i(in.ray), .o_i(in.o), .neg_i(in.neg),
    .recip_i(in.recip), .len_i(in.len), .open_i(in.open), .lo_i(in.lo), .hi_i(in.hi),
    .base_i(in.base), .kind_i(in.kind), .turned_i(turned), .near_i(near), .far_i(far),
    .near_to_i(near_to), .far_from_i(far_from), .rsp_valid_o, .rsp_ready_i, .rsp_o(rsp));

  assign rsp_o = rsp;
endmodule
`default_nettype wire

// Which exits of a treelet a ray meets, conservative, and their order.
//
// Latency rc_pkg::TreeletLatency + 1 (result queue), throughput 1 treelet per cycle, answers in
// order. Model: model/kd/treelet.hpp, which has the formulas. No exit whose cell holds a point of
// the ray is left out; an exit's t_near is never beyond such a point.
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
  localparam int unsigned W  = rc_pkg::NodeWidth;
  localparam int unsigned Q  = rc_pkg::NodePlanes;
  localparam int unsigned N  = rc_pkg::CoordBits;
  localparam int unsigned T  = rc_pkg::TBits;
  localparam int unsigned L  = rc_pkg::TreeletLatency;
  localparam int unsigned Levels = $clog2(W);
  // Stages: a treelet comes in, its planes' times are there.
  localparam int unsigned In   = rc_pkg::Cut;
  localparam int unsigned Meet = In + rc_pkg::PlaneStages;

  logic admit;
  assign admit = req_valid_i && req_ready_o;
  rc_door #(.Credits(rc_pkg::BoxQueue)) u_door (
    .clk_i, .rst_ni, .admit_i(admit), .leave_i(rsp_valid_o && rsp_ready_i), .open_o(req_ready_o));

  // valid[i]: stage i holds a treelet.
  logic [L-1:0] valid_q;
  logic [L:0]   valid;
  assign valid = {valid_q, admit};
  always_ff @(posedge clk_i) begin
    if (!rst_ni) valid_q <= '0;
    else         valid_q <= valid[L-1:0];
  end

  rc_pkg::treelet_req_t           in;
  logic [rc_pkg::TreeletReqW-1:0] in_flat;
  logic [2*Q-1:0]                 in_axis;
  logic [N*Q-1:0]                 in_at;
  rc_cut #(.Width(rc_pkg::TreeletReqW)) u_in (.clk_i, .data_i(req_i), .data_o(in_flat));
  assign in      = in_flat;
  assign in_axis = in.axis;
  assign in_at   = in.at;

  // Of the box around what the treelet's cell holds: where the ray enters and leaves it.
  logic [3*N-1:0] in_lo, in_hi;
  logic [3*T-1:0] box_from, box_to;
  logic [2:0]     box_there;
  assign in_lo = in.lo;
  assign in_hi = in.hi;
  for (genvar k = 0; k < 3; k++) begin : gen_side
    logic         turned_lo, turned_hi, near_lo, near_hi, far_lo, far_hi;
    logic [T-1:0] to_lo, to_hi, from_lo, from_hi;
    logic [1:0]   axis;
    assign axis = in.open ? 2'd3 : 2'(k);
    rc_plane u_lo (
      .clk_i, .valid_i(valid[Meet-1:In]),
      .s0_o_i(in.o), .s0_neg_i(in.neg), .s0_recip_i(in.recip), .s0_len_i(in.len),
      .s0_axis_i(axis), .s0_at_i($signed(in_lo[N*k +: N])),
      .turned_o(turned_lo), .near_o(near_lo), .far_o(far_lo),
      .near_to_o(to_lo), .far_from_o(from_lo));
    rc_plane u_hi (
      .clk_i, .valid_i(valid[Meet-1:In]),
      .s0_o_i(in.o), .s0_neg_i(in.neg), .s0_recip_i(in.recip), .s0_len_i(in.len),
      .s0_axis_i(axis), .s0_at_i($signed(in_hi[N*k +: N])),
      .turned_o(turned_hi), .near_o(near_hi), .far_o(far_hi),
      .near_to_o(to_hi), .far_from_o(from_hi));
    assign box_from[k*T +: T] = turned_hi ? from_hi : from_lo;
    assign box_to[k*T +: T]   = turned_lo ? to_lo : to_hi;
    assign box_there[k]       = turned_lo ? near_lo && far_hi : far_lo && near_hi;
  end

  // Of each plane: which sides there are, and when the ray changes from one to the other.
  logic [Q-1:0]   turned, near, far;
  logic [Q*T-1:0] near_to, far_from;
  for (genvar i = 0; i < Q; i++) begin : gen_plane
    rc_plane u_plane (
      .clk_i, .valid_i(valid[Meet-1:In]),
      .s0_o_i(in.o), .s0_neg_i(in.neg), .s0_recip_i(in.recip), .s0_len_i(in.len),
      .s0_axis_i(in_axis[2*i +: 2]), .s0_at_i($signed(in_at[N*i +: N])),
      .turned_o(turned[i]), .near_o(near[i]), .far_o(far[i]),
      .near_to_o(near_to[i*T +: T]), .far_from_o(far_from[i*T +: T]));
  end

  // The latest entry and the earliest end, of the box and on the way to each exit: of two axes or
  // levels, of the third, then of both.
  logic [T-1:0] box_enter, box_leave;
  logic         box_met;
  rc_span u_box (
    .clk_i, .valid_i(valid[Meet+In]), .from_i(box_from), .to_i(box_to), .there_i(box_there),
    .from_o(box_enter), .to_o(box_leave), .there_o(box_met));

  // On a plane's upper side the ray is first if it is turned.
  logic [W-1:0]   met;
  logic [W*T-1:0] near_t;
  for (genvar i = 0; i < W; i++) begin : gen_exit
    logic [3*T-1:0] from, to;
    logic [2:0]     there;
    for (genvar l = 0; l < 3; l++) begin : gen_level
      if (l < Levels) begin : gen_plane_there
        // Plane of level l on the way to exit i, and the exit's side of it.
        localparam int unsigned At    = (1 << l) - 1 + (i >> (Levels - l));
        localparam int unsigned Upper = (i >> (Levels - 1 - l)) & 1;
        logic first;
        assign first = turned[At] == (Upper != 0);
        assign from[l*T +: T] = first ? '0 : far_from[At*T +: T];
        assign to[l*T +: T]   = first ? near_to[At*T +: T] : '1;
        assign there[l]       = first ? near[At] : far[At];
      end else begin : gen_no_plane
        assign from[l*T +: T] = '0;
        assign to[l*T +: T]   = '1;
        assign there[l]       = 1'b1;
      end
    end
    logic [T-1:0] way_enter, way_leave, first, last, enter, leave;
    logic         way_met, may_meet;
    rc_span u_way (
      .clk_i, .valid_i(valid[Meet+In]), .from_i(from), .to_i(to), .there_i(there),
      .from_o(way_enter), .to_o(way_leave), .there_o(way_met));
    assign first = way_enter > box_enter ? way_enter : box_enter;
    assign last  = way_leave < box_leave ? way_leave : box_leave;
    rc_cut #(.Width(2 * T + 1)) u_both (
      .clk_i, .data_i({first, last, way_met && box_met}), .data_o({enter, leave, may_meet}));
    assign met[i]           = enter <= leave && may_meet;
    assign near_t[i*T +: T] = enter;
  end

  logic [rc_pkg::TreeletRspW-1:0] rsp;
  rc_answer #(.Latency(L)) u_answer (
    .clk_i, .rst_ni, .moves_i(valid[L-1:0]), .ray_i(in.ray), .base_i(in.base), .kind_i(in.kind),
    .met_i(met), .near_i(near_t), .end_valid_i(valid_q[L-1]),
    .rsp_valid_o, .rsp_ready_i, .rsp_o(rsp));
  assign rsp_o = rsp;

  logic unused;
  assign unused = valid[L];
endmodule
`default_nettype wire

// Slab test of all children of a node, conservative, and their order.
//
// Latency rc_pkg::BoxLatency + 1 (result queue), throughput 1 node per cycle, answers
// in order. Model: model/bvh/box.hpp, which has the formulas. No box that holds a
// point of the ray is left out; a child's t_near is never beyond such a point.
`default_nettype none
module rc_box (
  input  logic             clk_i,
  input  logic             rst_ni,
  // From trav
  input  logic             req_valid_i,
  output logic             req_ready_o,
  input  rc_pkg::box_req_t req_i,
  // To trav
  output logic             rsp_valid_o,
  input  logic             rsp_ready_i,
  output rc_pkg::box_rsp_t rsp_o
);
  localparam int unsigned W  = rc_pkg::NodeWidth;
  localparam int unsigned N  = rc_pkg::CoordBits;
  localparam int unsigned OW = rc_pkg::OriginWidth;
  localparam int unsigned B  = rc_pkg::BoxBits;
  localparam int unsigned R1 = rc_pkg::RecipBits + 1;
  localparam int unsigned E  = rc_pkg::ExpBits;
  localparam int unsigned T  = rc_pkg::TBits;
  localparam int unsigned TW = (T + 31) / 32 * 32;   // as rc_slab gives them
  localparam int unsigned L  = rc_pkg::BoxLatency;
  // Stages: a node comes in, its children's intervals are there.
  localparam int unsigned In   = rc_pkg::Cut;
  localparam int unsigned Meet = In + rc_pkg::SlabStages;

  logic admit;
  assign admit = req_valid_i && req_ready_o;
  rc_door #(.Credits(rc_pkg::BoxQueue)) u_door (
    .clk_i, .rst_ni, .admit_i(admit), .leave_i(rsp_valid_o && rsp_ready_i), .open_o(req_ready_o));

  // valid[i]: stage i holds a node.
  logic [L-1:0] valid_q;
  logic [L:0]   valid;
  assign valid = {valid_q, admit};
  always_ff @(posedge clk_i) begin
    if (!rst_ni) valid_q <= '0;
    else         valid_q <= valid[L-1:0];
  end
  // A stage takes over what comes to it if that is a node. In a fast chip it always does: an
  // enable of hundreds of registers is a long path, and what is nothing's does not matter.
  logic [L:0] moves;
  assign moves = valid | {(L+1){rc_pkg::Cut != 0}};

  rc_pkg::box_req_t           in;
  logic [rc_pkg::BoxReqW-1:0] in_flat;
  rc_cut #(.Width(rc_pkg::BoxReqW)) u_in (.clk_i, .data_i(req_i), .data_o(in_flat));
  assign in = in_flat;

  logic [3*OW-1:0]  in_o;
  logic [3*N-1:0]   in_org;
  logic [2:0]       in_neg;
  logic [3*R1-1:0]  in_recip;
  logic [3*E-1:0]   in_len, in_exp;
  logic [3*W*B-1:0] plane_lo, plane_hi, axis_lo, axis_hi;
  assign in_o     = in.o;
  assign in_org   = in.org;
  assign in_neg   = in.neg;
  assign in_recip = in.recip;
  assign in_len   = in.len;
  assign in_exp   = in.exp;

  // Planes wait until the ray and the node's corner have met. Memory holds them child by child; a
  // slab wants those of its axis.
  rc_delay #(.Width(6 * W * B), .Stages(rc_pkg::SlabPlanes)) u_planes (
    .clk_i, .valid_i(moves[In+rc_pkg::SlabPlanes-1:In]), .data_i({in.lo, in.hi}),
    .data_o({plane_lo, plane_hi}));
  for (genvar i = 0; i < W; i++) begin : gen_child_planes
    for (genvar k = 0; k < 3; k++) begin : gen_plane
      assign axis_lo[(k*W+i)*B +: B] = plane_lo[(3*i+k)*B +: B];
      assign axis_hi[(k*W+i)*B +: B] = plane_hi[(3*i+k)*B +: B];
    end
  end

  // Of each axis and child: interval on that axis.
  logic [3*W*TW-1:0] near, far;
  logic [3*W-1:0]   miss;
  for (genvar k = 0; k < 3; k++) begin : gen_axis
    rc_slab u_slab (
      .clk_i, .valid_i(moves[Meet:In]),
      .s0_o_i($signed(in_o[k*OW +: OW])), .s0_org_i($signed(in_org[k*N +: N])),
      .s0_neg_i(in_neg[k]),
      .s0_recip_i(in_recip[k*R1 +: R1]), .s0_len_i(in_len[k*E +: E]), .s0_exp_i(in_exp[k*E +: E]),
      .plane_lo_i(axis_lo[k*W*B +: W*B]), .plane_hi_i(axis_hi[k*W*B +: W*B]),
      .near_o(near[k*W*TW +: W*TW]), .far_o(far[k*W*TW +: W*TW]), .miss_o(miss[k*W +: W]));
  end

  // The intervals' intersection: the farthest of the near ends, the nearest of the far ones.
  logic [W-1:0]   met;
  logic [W*T-1:0] near_t;
  for (genvar i = 0; i < W; i++) begin : gen_child
    logic [T-1:0] nx, ny, nz, fx, fy, fz, nxy, fxy, nxy_q, fxy_q;
    logic [T-1:0] nz_q, fz_q, first, last, enter, leave;
    logic         there, there_q, may_hit;
    assign nx    = near[i*TW +: T];
    assign ny    = near[(W+i)*TW +: T];
    assign nz    = near[(2*W+i)*TW +: T];
    assign fx    = far[i*TW +: T];
    assign fy    = far[(W+i)*TW +: T];
    assign fz    = far[(2*W+i)*TW +: T];
    assign nxy   = nx > ny ? nx : ny;
    assign fxy   = fx < fy ? fx : fy;
    assign there = !miss[i] && !miss[W+i] && !miss[2*W+i];
    rc_cut #(.Width(T)) u_nxy (.clk_i, .data_i(nxy), .data_o(nxy_q));
    rc_cut #(.Width(T)) u_fxy (.clk_i, .data_i(fxy), .data_o(fxy_q));
    rc_cut #(.Width(T)) u_nz (.clk_i, .data_i(nz), .data_o(nz_q));
    rc_cut #(.Width(T)) u_fz (.clk_i, .data_i(fz), .data_o(fz_q));
    rc_cut u_there (.clk_i, .data_i(there), .data_o(there_q));
    assign first = nxy_q > nz_q ? nxy_q : nz_q;
    assign last  = fxy_q < fz_q ? fxy_q : fz_q;
    rc_cut #(.Width(T)) u_enter (.clk_i, .data_i(first), .data_o(enter));
    rc_cut #(.Width(T)) u_leave (.clk_i, .data_i(last), .data_o(leave));
    rc_cut u_may_hit (.clk_i, .data_i(there_q), .data_o(may_hit));
    assign met[i]           = enter <= leave && may_hit;
    assign near_t[i*T +: T] = enter;
  end

  logic [rc_pkg::BoxRspW-1:0] rsp;
  rc_answer #(.Latency(L)) u_answer (
    .clk_i, .rst_ni, .moves_i(moves[L-1:0]), .ray_i(in.ray), .base_i(in.base), .kind_i(in.kind),
    .met_i(met), .near_i(near_t), .end_valid_i(valid_q[L-1]),
    .rsp_valid_o, .rsp_ready_i, .rsp_o(rsp));
  assign rsp_o = rsp;

  logic unused;
  assign unused = ^{near, far, valid[L], moves[L]};
endmodule
`default_nettype wire

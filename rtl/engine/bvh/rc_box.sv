// Slab test of all children of a node. Sorts the children that a ray meets.
//
// Latency rc_pkg::BoxLatency + 1 (result queue), throughput 1 node every rc_pkg::BoxInterval
// cycles, answers in order.
//
// Conservative: it reports every box that holds a point of the ray, and t_near never exceeds the
// time of such a point. Model: model/engine/bvh/box.hpp, which has the formulas.
//
// If a node has more children than there are lanes, its children are tested in beats, one child per
// lane in each beat. The node stays in the front stage until its last beat, and its planes shift by
// one beat per cycle. Results of earlier beats wait for the last beat.
`default_nettype none
module rc_box (
  input  logic             clk_i,
  input  logic             rst_ni,
  // From trav
  input  logic             req_valid_i,
  output logic             req_ready_o,
  input  rc_pkg::box_req_t req_i,
  output logic             occupied_o,    // accepts no node: the last node's children are in test
  // To trav
  output logic             rsp_valid_o,
  input  logic             rsp_ready_i,
  output rc_pkg::node_answer_t rsp_o
);
  localparam int unsigned NodeWidth   = rc_pkg::NodeWidth;
  localparam int unsigned Beats       = rc_pkg::BoxInterval;   // beats of a node
  localparam int unsigned Lanes       = NodeWidth / Beats;     // lanes: children of a beat
  localparam int unsigned N           = rc_pkg::CoordBits;
  localparam int unsigned OriginWidth = rc_pkg::OriginWidth;
  localparam int unsigned BoxBits     = rc_pkg::BoxBits;
  localparam int unsigned R1          = rc_pkg::RecipBits + 1;
  localparam int unsigned ExpBits     = rc_pkg::ExpBits;
  localparam int unsigned TBits       = rc_pkg::TBits;
  localparam int unsigned PaddedTW    = (TBits + 31) / 32 * 32;   // as rc_slab gives them
  localparam int unsigned Latency     = rc_pkg::BoxLatency;

  // Stages in which a node has arrived, the intervals of a beat's children are ready, and their
  // intersections are ready. The intersections of the last beat are ready when the node itself is
  // Beats - 1 stages further.
  localparam int unsigned In   = rc_pkg::PathCut;
  localparam int unsigned Meet = In + rc_pkg::SlabStages;
  localparam int unsigned Met  = Latency - rc_pkg::RankStages - Beats;

  // Admission: an answer has a place in the result queue. valid[i]: stage i holds a node.
  logic               admit;
  logic [Latency-1:0] valid_q;
  logic [Latency:0]   valid;

  assign valid = {valid_q, admit};

  rc_credited_pipeline #(.Credits(rc_pkg::BoxQueue), .Stages(Latency)) u_stages (
    .clk_i, .rst_ni, .req_valid_i, .req_ready_o, .occupied_i(occupied_o),
    .leave_i(rsp_valid_o && rsp_ready_i), .admit_o(admit), .valid_q_o(valid_q));

  // enable[i]: the register after stage i accepts its input (rtl/README.md, Relaxed and fast).
  logic [Latency:0] enable;

  assign enable = valid | {(Latency+1){rc_pkg::PathCut != 0}};

  // The same for beats, up to Met. A node's first beat is where the node is; its last is Beats - 1
  // behind.
  logic [Met:0] beats, beat_enable;

  for (genvar i = 0; i <= Met; i++) begin : gen_beats
    assign beats[i] = |valid[i+Beats-1:i];
  end

  assign beat_enable = beats | {(Met+1){rc_pkg::PathCut != 0}};

  // The node in the front stage, with its planes from this beat on. With one beat this is the
  // request. Fields that do not go to the slabs are used with the first beat only.
  rc_pkg::box_req_t           held, next, in;
  logic [rc_pkg::BoxReqW-1:0] next_flat, in_flat;

  if (Beats == 1) begin : gen_at_once
    assign occupied_o = 1'b0;
    assign held       = '0;
  end else begin : gen_hold
    assign occupied_o = |valid_q[Beats-2:0];
    if (rc_pkg::PathCut != 0) begin : gen_front
      assign held = in_flat;
    end else begin : gen_behind
      logic [rc_pkg::BoxReqW-1:0] held_q;
      always_ff @(posedge clk_i) if (beats[In]) held_q <= next_flat;
      assign held = held_q;
    end
  end

  always_comb begin
    next = req_i;
    if (occupied_o) begin
      next.o     = held.o;
      next.neg   = held.neg;
      next.recip = held.recip;
      next.len   = held.len;
      next.org   = held.org;
      next.exp   = held.exp;
      next.lo    = held.lo >> 3 * Lanes * BoxBits;
      next.hi    = held.hi >> 3 * Lanes * BoxBits;
    end
  end

  assign next_flat = next;
  rc_path_register #(.Width(rc_pkg::BoxReqW)) u_in (.clk_i, .data_i(next_flat), .data_o(in_flat));

  assign in = in_flat;

  // The node, unpacked.
  logic [3*OriginWidth-1:0]       in_o;
  logic [3*N-1:0]                 in_org;
  logic [2:0]                     in_neg;
  logic [3*R1-1:0]                in_recip;
  logic [3*ExpBits-1:0]           in_len, in_exp;
  logic [3*NodeWidth*BoxBits-1:0] in_lo, in_hi;
  logic [3*Lanes*BoxBits-1:0] plane_lo, plane_hi, axis_lo, axis_hi;

  assign in_o     = in.o;
  assign in_org   = in.org;
  assign in_neg   = in.neg;
  assign in_recip = in.recip;
  assign in_len   = in.len;
  assign in_exp   = in.exp;
  assign in_lo    = in.lo;
  assign in_hi    = in.hi;

  // The children's planes wait until the distance to the node's corner is ready. Memory holds them
  // child by child; each slab uses those of its axis.
  rc_shift_register #(.Width(6 * Lanes * BoxBits), .Stages(rc_pkg::SlabPlanes)) u_planes (
    .clk_i, .enable_i(beat_enable[In+rc_pkg::SlabPlanes-1:In]),
    .data_i({in_lo[3*Lanes*BoxBits-1:0], in_hi[3*Lanes*BoxBits-1:0]}),
    .data_o({plane_lo, plane_hi}));

  for (genvar i = 0; i < Lanes; i++) begin : gen_child_planes
    for (genvar k = 0; k < 3; k++) begin : gen_plane
      assign axis_lo[(k*Lanes+i)*BoxBits +: BoxBits] = plane_lo[(3*i+k)*BoxBits +: BoxBits];
      assign axis_hi[(k*Lanes+i)*BoxBits +: BoxBits] = plane_hi[(3*i+k)*BoxBits +: BoxBits];
    end
  end

  // For each axis and child: its interval on that axis.
  logic [3*Lanes*PaddedTW-1:0] near, far;
  logic [3*Lanes-1:0]          miss;

  for (genvar k = 0; k < 3; k++) begin : gen_axis
    rc_slab u_slab (
      .clk_i, .enable_i(beat_enable[Meet:In]),
      .s0_o_i($signed(in_o[k*OriginWidth +: OriginWidth])), .s0_org_i($signed(in_org[k*N +: N])),
      .s0_neg_i(in_neg[k]),
      .s0_recip_i(in_recip[k*R1 +: R1]), .s0_len_i(in_len[k*ExpBits +: ExpBits]),
      .s0_exp_i(in_exp[k*ExpBits +: ExpBits]),
      .plane_lo_i(axis_lo[k*Lanes*BoxBits +: Lanes*BoxBits]),
      .plane_hi_i(axis_hi[k*Lanes*BoxBits +: Lanes*BoxBits]),
      .near_o(near[k*Lanes*PaddedTW +: Lanes*PaddedTW]),
      .far_o(far[k*Lanes*PaddedTW +: Lanes*PaddedTW]), .miss_o(miss[k*Lanes +: Lanes]));
  end

  // The intersection of a child's intervals: the farthest near end, the nearest far end.
  logic [Lanes-1:0]       met;
  logic [Lanes*TBits-1:0] near_t;

  for (genvar i = 0; i < Lanes; i++) begin : gen_child
    logic [TBits-1:0] nx, ny, nz, fx, fy, fz, nxy, fxy, nxy_q, fxy_q;
    logic [TBits-1:0] nz_q, fz_q, first, last, enter, leave;
    logic             there, there_q, may_hit;

    assign nx    = near[i*PaddedTW +: TBits];
    assign ny    = near[(Lanes+i)*PaddedTW +: TBits];
    assign nz    = near[(2*Lanes+i)*PaddedTW +: TBits];
    assign fx    = far[i*PaddedTW +: TBits];
    assign fy    = far[(Lanes+i)*PaddedTW +: TBits];
    assign fz    = far[(2*Lanes+i)*PaddedTW +: TBits];
    assign nxy   = nx > ny ? nx : ny;
    assign fxy   = fx < fy ? fx : fy;
    assign there = !miss[i] && !miss[Lanes+i] && !miss[2*Lanes+i];

    rc_path_register #(.Width(TBits)) u_nxy (.clk_i, .data_i(nxy), .data_o(nxy_q));
    rc_path_register #(.Width(TBits)) u_fxy (.clk_i, .data_i(fxy), .data_o(fxy_q));
    rc_path_register #(.Width(TBits)) u_nz (.clk_i, .data_i(nz), .data_o(nz_q));
    rc_path_register #(.Width(TBits)) u_fz (.clk_i, .data_i(fz), .data_o(fz_q));
    rc_path_register u_there (.clk_i, .data_i(there), .data_o(there_q));

    assign first = nxy_q > nz_q ? nxy_q : nz_q;
    assign last  = fxy_q < fz_q ? fxy_q : fz_q;

    rc_path_register #(.Width(TBits)) u_enter (.clk_i, .data_i(first), .data_o(enter));
    rc_path_register #(.Width(TBits)) u_leave (.clk_i, .data_i(last), .data_o(leave));
    rc_path_register u_may_hit (.clk_i, .data_i(there_q), .data_o(may_hit));

    assign met[i]                   = enter <= leave && may_hit;
    assign near_t[i*TBits +: TBits] = enter;
  end

  // All children of the node, ready with its last beat.
  logic [NodeWidth-1:0]       all_met;
  logic [NodeWidth*TBits-1:0] all_near;

  if (Beats == 1) begin : gen_all
    assign all_met  = met;
    assign all_near = near_t;
  end else begin : gen_gather
    logic [NodeWidth-Lanes-1:0]         met_q;
    logic [(NodeWidth-Lanes)*TBits-1:0] near_q;
    assign all_met  = {met, met_q};
    assign all_near = {near_t, near_q};

    always_ff @(posedge clk_i) begin
      if (beat_enable[Met]) begin
        met_q  <= all_met[NodeWidth-1:Lanes];
        near_q <= all_near[NodeWidth*TBits-1:Lanes*TBits];
      end
    end
  end

  // Their order, and the result queue.
  logic [rc_pkg::NodeAnswerW-1:0] rsp;

  rc_node_answer #(.Latency(Latency)) u_answer (
    .clk_i, .rst_ni, .enable_i(enable[Latency-1:0]), .ray_i(in.ray), .base_i(in.base),
    .kind_i(in.kind), .met_i(all_met), .near_i(all_near), .end_valid_i(valid_q[Latency-1]),
    .rsp_valid_o, .rsp_ready_i, .rsp_o(rsp));

  assign rsp_o = rsp;

`ifndef SYNTHESIS
  always_ff @(posedge clk_i) if (rst_ni && admit) a_in_turn: assert (!occupied_o)
    else $error("a node came before the children of the last were tested");
`endif

  logic unused;
  assign unused = ^{near, far, valid[Latency], enable[Latency], beats, beat_enable, held, in_lo,
                    in_hi};
endmodule
`default_nettype wire

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
  localparam int unsigned C  = rc_pkg::CountBits;
  localparam int unsigned O  = rc_pkg::OffsetBits;
  localparam int unsigned I  = rc_pkg::RayBits;
  localparam int unsigned A  = rc_pkg::AddrBits;
  localparam int unsigned G  = rc_pkg::GroupBits;
  localparam int unsigned EntryW  = T + O + C;
  localparam int unsigned L  = rc_pkg::BoxLatency;

  logic admit;
  assign admit = req_valid_i && req_ready_o;
  rc_door #(.Credits(rc_pkg::BoxQueue)) u_door (
    .clk_i, .rst_ni, .admit_i(admit), .leave_i(rsp_valid_o && rsp_ready_i), .open_o(req_ready_o));

  logic [L-1:0] valid_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) valid_q <= '0;
    else         valid_q <= {valid_q[L-2:0], admit};
  end

  // s1..s4: ray, base, kinds and planes wait.
  logic [I+A-1:0]   s1_whose_q, s2_whose_q, s3_whose_q, s4_whose_q;   // {ray, base}
  logic [W*C-1:0]   s1_kind_q, s2_kind_q, s3_kind_q, s4_kind_q;
  logic [3*W*B-1:0] s1_lo_q, s1_hi_q, s2_lo_q, s2_hi_q;
  always_ff @(posedge clk_i) begin
    if (admit) begin
      s1_whose_q <= {req_i.ray, req_i.base};
      s1_kind_q  <= req_i.kind;
      s1_lo_q    <= req_i.lo;
      s1_hi_q    <= req_i.hi;
    end
    if (valid_q[0]) begin
      s2_whose_q <= s1_whose_q;
      s2_kind_q  <= s1_kind_q;
      s2_lo_q    <= s1_lo_q;
      s2_hi_q    <= s1_hi_q;
    end
    if (valid_q[1]) {s3_whose_q, s3_kind_q} <= {s2_whose_q, s2_kind_q};
    if (valid_q[2]) {s4_whose_q, s4_kind_q} <= {s3_whose_q, s3_kind_q};
  end

  logic [3*OW-1:0] s0_o;
  logic [3*N-1:0]  s0_org;
  logic [2:0]      s0_neg;
  logic [3*R1-1:0] s0_recip;
  logic [3*E-1:0]  s0_len, s0_exp;
  assign s0_o     = req_i.o;
  assign s0_org   = req_i.org;
  assign s0_neg   = req_i.neg;
  assign s0_recip = req_i.recip;
  assign s0_len   = req_i.len;
  assign s0_exp   = req_i.exp;

  // s4 of each axis and child: interval on that axis.
  logic [3*W*T-1:0] s3_near, s3_far;
  logic [3*W-1:0]   s3_miss;
  for (genvar k = 0; k < 3; k++) begin : gen_axis
    rc_slab u_slab (
      .clk_i,
      .s0_valid_i(admit), .s1_valid_i(valid_q[0]), .s2_valid_i(valid_q[1]), .s3_valid_i(valid_q[2]),
      .s0_o_i($signed(s0_o[k*OW +: OW])), .s0_org_i($signed(s0_org[k*N +: N])),
      .s0_neg_i(s0_neg[k]),
      .s0_recip_i(s0_recip[k*R1 +: R1]), .s0_len_i(s0_len[k*E +: E]), .s0_exp_i(s0_exp[k*E +: E]),
      .s2_lo_i(s2_axis_lo[k*W*B +: W*B]), .s2_hi_i(s2_axis_hi[k*W*B +: W*B]),
      .s3_near_o(s3_near[k*W*T +: W*T]), .s3_far_o(s3_far[k*W*T +: W*T]),
      .s3_miss_o(s3_miss[k*W +: W]));
  end

  // Memory holds planes child by child; a slab wants those of its axis.
  logic [3*W*B-1:0] s2_axis_lo, s2_axis_hi;
  for (genvar i = 0; i < W; i++) begin : gen_child_planes
    for (genvar k = 0; k < 3; k++) begin : gen_plane
      assign s2_axis_lo[(k*W+i)*B +: B] = s2_lo_q[(3*i+k)*B +: B];
      assign s2_axis_hi[(k*W+i)*B +: B] = s2_hi_q[(3*i+k)*B +: B];
    end
  end

  // s4: the intervals' intersection.
  logic [W-1:0]   s4_hit_q;
  logic [W*T-1:0] s4_near_q;
  for (genvar i = 0; i < W; i++) begin : gen_child
    logic [T-1:0] nx, ny, nz, fx, fy, fz, nxy, fxy;
    assign {nx, ny, nz} = {s3_near[i*T +: T], s3_near[(W+i)*T +: T], s3_near[(2*W+i)*T +: T]};
    assign {fx, fy, fz} = {s3_far[i*T +: T], s3_far[(W+i)*T +: T], s3_far[(2*W+i)*T +: T]};
    assign nxy = nx > ny ? nx : ny;
    assign fxy = fx < fy ? fx : fy;
    logic [T-1:0] near, far;
    assign near = nxy > nz ? nxy : nz;
    assign far  = fxy < fz ? fxy : fz;
    always_ff @(posedge clk_i) begin
      if (valid_q[2]) begin
        s4_hit_q[i] <= near <= far && !s3_miss[i] && !s3_miss[W+i] && !s3_miss[2*W+i]
                    && s3_kind_q[i*C +: C] != '0;
        s4_near_q[i*T +: T] <= near;
      end
    end
  end

  // s5, s6: order.
  rc_rank u_rank (
    .clk_i, .s4_valid_i(valid_q[3]), .s5_valid_i(valid_q[4]),
    .s4_hit_i(s4_hit_q), .s4_near_i(s4_near_q), .s4_kind_i(s4_kind_q),
    .s6_inner_o(s6_inner), .s6_leaves_o(s6_leaves), .s6_entries_o(s6_entries));

  logic [I+A-1:0]      s5_whose_q, s6_whose_q;
  logic [G-1:0]        s6_inner, s6_leaves;
  logic [W*EntryW-1:0] s6_entries;
  always_ff @(posedge clk_i) begin
    if (valid_q[3]) s5_whose_q <= s4_whose_q;
    if (valid_q[4]) s6_whose_q <= s5_whose_q;
  end

  logic                       queue_ready;
  logic [rc_pkg::BoxRspW-1:0] queue_data, rsp_data;
  assign queue_data = {s6_whose_q, s6_inner, s6_leaves, s6_entries};
  rc_fifo #(.Width(rc_pkg::BoxRspW), .Depth(rc_pkg::BoxQueue)) u_queue (
    .clk_i, .rst_ni, .valid_i(valid_q[L-1]), .ready_o(queue_ready), .data_i(queue_data),
    .valid_o(rsp_valid_o), .ready_i(rsp_ready_i), .data_o(rsp_data));
  assign rsp_o = rsp_data;

`ifndef SYNTHESIS
  a_never_dropped: assert property (@(posedge clk_i) disable iff (!rst_ni)
      valid_q[L-1] |-> queue_ready)
    else $error("an answer met a full queue");
`endif

  logic unused;
  assign unused = queue_ready;
endmodule
`default_nettype wire

// The walk through the tree. Takes a step (the inner children of the node just tested
// and the distance to beat), goes to the nearest of them that can still matter, keeps
// the others on the ray's stack as one group, or pops.
//
// Stage 0 accepts a step and reads the top of the ray's stack; stage 1 decides the next
// node or the ray's end. A popped group whose nearest child is too far costs another
// turn through both stages (before new steps), unless `below`, the nearest t_near of
// all groups under it, says that nothing there can matter. A new ray starts at the root
// when no other node waits. A node that comes back from memory goes on to box, with its
// ray, in the same cycle. Model: model/trav/trav.hpp. The compiled scene must not need
// more than StackDepth groups.
`default_nettype none
module rc_trav (
  input  logic              clk_i,
  input  logic              rst_ni,
  input  rc_pkg::frame_t    frame_i,
  input  logic              ray_valid_i,
  output logic              ray_ready_o,
  input  rc_pkg::ray_t      ray_i,
  input  logic              step_valid_i,
  output logic              step_ready_o,
  input  rc_pkg::step_t     step_i,
  output logic              node_req_valid_o,
  input  logic              node_req_ready_i,
  output rc_pkg::node_req_t node_req_o,
  input  logic              node_rsp_valid_i,
  output logic              node_rsp_ready_o,
  input  rc_pkg::node_rsp_t node_rsp_i,
  output logic              box_req_valid_o,
  input  logic              box_req_ready_i,
  output rc_pkg::box_req_t  box_req_o,
  output logic              done_valid_o,
  input  logic              done_ready_i,
  output rc_pkg::done_t     done_o
);
  localparam int unsigned I = rc_pkg::RayBits;
  localparam int unsigned A = rc_pkg::AddrBits;
  localparam int unsigned T = rc_pkg::Contexts;
  localparam int unsigned M = rc_pkg::RayDirBits;
  localparam int unsigned TB = rc_pkg::TBits;
  localparam int unsigned S = rc_pkg::SlotBits;

  // Rays: origin, signs and reciprocals wait here for their nodes.
  localparam int unsigned BoxRayW = 3 * rc_pkg::OriginWidth + 3 + 3 * (rc_pkg::RecipBits + 1)
                                  + 3 * rc_pkg::ExpBits;
  logic ray_fires;
  logic [3*M-1:0]     ray_d;
  logic [BoxRayW-1:0] box_ray;
  assign ray_fires = ray_valid_i && ray_ready_o;
  assign ray_d     = ray_i.d;
  rc_ram #(.Width(BoxRayW), .Depth(T)) u_ray (
    .clk_i, .write_i(ray_fires), .write_addr_i(ray_i.ray),
    .write_data_i({ray_i.o, ray_d[3*M-1], ray_d[2*M-1], ray_d[M-1], ray_i.recip, ray_i.len}),
    .read_addr_i(node_rsp_i.ray), .read_data_o(box_ray));
  assign box_req_valid_o  = node_rsp_valid_i;
  assign node_rsp_ready_o = box_req_ready_i;
  assign box_req_o = {node_rsp_i.ray, box_ray, node_rsp_i.org, node_rsp_i.exp, node_rsp_i.base,
                      node_rsp_i.kind, node_rsp_i.lo, node_rsp_i.hi};

  // Stage 0: a returning ray before a new step.
  logic          again_q, step_fires;
  logic [I-1:0]  again_ray_q, s0_ray;
  logic [TB-1:0] again_t_q;
  assign step_ready_o = !again_q;
  assign step_fires   = step_valid_i && step_ready_o;
  assign s0_ray       = again_q ? again_ray_q : step_i.ray;

  // A step without children, of the ray that returns: `stop` is not set, nor anything else.
  rc_pkg::step_t again_step;
  always_comb begin
    again_step        = '0;
    again_step.ray    = again_ray_q;
    again_step.t_best = again_t_q;
  end

  logic                      s1_valid_q;
  logic [rc_pkg::StepW-1:0]  s1_step_q;
  rc_pkg::step_t             s1_step;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) s1_valid_q <= 1'b0;
    else         s1_valid_q <= again_q || step_fires;
    if (again_q)         s1_step_q <= again_step;
    else if (step_fires) s1_step_q <= step_i;
  end
  assign s1_step = s1_step_q;

  // Stage 1: the stack decides.
  logic          visit, done, again;
  logic [A-1:0]  visit_base;
  logic [S-1:0]  visit_slot;
  rc_stack u_stack (
    .clk_i, .rst_ni, .s0_valid_i(again_q || step_fires), .s0_ray_i(s0_ray),
    .s1_valid_i(s1_valid_q), .s1_step_i(s1_step),
    .visit_o(visit), .visit_base_o(visit_base), .visit_slot_o(visit_slot), .done_o(done),
    .again_o(again));
  always_ff @(posedge clk_i) begin
    if (!rst_ni) again_q <= 1'b0;
    else         again_q <= again;
    if (again) {again_ray_q, again_t_q} <= {s1_step.ray, s1_step.t_best};
  end

  // Nodes to fetch; new rays wait for a gap.
  logic           visit_valid, visit_ready, spawn_valid, spawn_ready;
  logic [I+A-1:0] visit_data;
  logic [I-1:0]   spawn_ray;
  rc_queue #(.Width(I + A), .Depth(T)) u_visit (
    .clk_i, .rst_ni, .push_i(visit),
    .data_i({s1_step.ray, visit_base + {{(A-S){1'b0}}, visit_slot}}),
    .valid_o(visit_valid), .pop_i(visit_valid && visit_ready), .data_o(visit_data));
  rc_fifo #(.Width(I), .Depth(2)) u_spawn (
    .clk_i, .rst_ni, .valid_i(ray_valid_i), .ready_o(ray_ready_o), .data_i(ray_i.ray),
    .valid_o(spawn_valid), .ready_i(spawn_ready), .data_o(spawn_ray));
  rc_merge #(.Width(I + A)) u_node (
    .clk_i, .rst_ni,
    .first_valid_i(visit_valid), .first_ready_o(visit_ready), .first_i(visit_data),
    .second_valid_i(spawn_valid), .second_ready_o(spawn_ready),
    .second_i({spawn_ray, frame_i.root}),
    .valid_o(node_req_valid_o), .ready_i(node_req_ready_i), .data_o(node_req_o));

  rc_queue #(.Width(I), .Depth(T)) u_done (
    .clk_i, .rst_ni, .push_i(done), .data_i(s1_step.ray),
    .valid_o(done_valid_o), .pop_i(done_valid_o && done_ready_i), .data_o(done_o));

  logic [rc_pkg::RayW-1:0]   ray_flat;   // what only tri uses of a ray
  logic [rc_pkg::FrameW-1:0] frame_flat;
  logic                      unused;
  assign ray_flat   = ray_i;
  assign frame_flat = frame_i;
  assign unused     = ^{ray_flat, frame_flat};
endmodule
`default_nettype wire

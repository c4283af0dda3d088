// The leaves of a node. Takes the box test's answer, sends the leaves' triangles to tri
// one by one, nearest leaf first and none beyond the best hit, and then hands the inner
// children to trav. Keeps each ray's best hit, and gives it out when trav is done.
//
// A ray that asks for a light (kinds shadow and away) ends with the first primitive in its
// way: no other is tested, and trav is told to stop. A shadow ray also ends at t = 2^-B:
// 2^(N+F) is its distance to beat.
//
// A box answer and a tri answer are accepted in every cycle. Each sends its ray to one of
// two links, prim or step, and has a queue of its own for each, so that neither waits for
// the other; on the link tri's rays go first. One triangle of a ray is under way at a time.
// A triangle that comes back from memory goes on to tri, with its ray, in the same cycle.
// `ray` is listened to: it goes to trav. Model: model/list/list.hpp.
`default_nettype none
module rc_list (
  input  logic              clk_i,
  input  logic              rst_ni,
  input  logic              ray_fires_i,
  input  rc_pkg::ray_t      ray_i,
  input  logic              box_rsp_valid_i,
  output logic              box_rsp_ready_o,
  input  rc_pkg::box_rsp_t  box_rsp_i,
  output logic              prim_req_valid_o,
  input  logic              prim_req_ready_i,
  output rc_pkg::prim_req_t prim_req_o,
  input  logic              prim_rsp_valid_i,
  output logic              prim_rsp_ready_o,
  input  rc_pkg::prim_rsp_t prim_rsp_i,
  output logic              tri_req_valid_o,
  input  logic              tri_req_ready_i,
  output rc_pkg::tri_req_t  tri_req_o,
  input  logic              tri_rsp_valid_i,
  output logic              tri_rsp_ready_o,
  input  rc_pkg::tri_rsp_t  tri_rsp_i,
  output logic              step_valid_o,
  input  logic              step_ready_i,
  output rc_pkg::step_t     step_o,
  input  logic              done_valid_i,
  output logic              done_ready_o,
  input  rc_pkg::done_t     done_i,
  output logic              closest_valid_o,
  input  logic              closest_ready_i,
  output rc_pkg::closest_t  closest_o
);
  localparam int unsigned I  = rc_pkg::RayBits;
  localparam int unsigned A  = rc_pkg::AddrBits;
  localparam int unsigned O  = rc_pkg::OffsetBits;
  localparam int unsigned C  = rc_pkg::CountBits;
  localparam int unsigned G  = rc_pkg::GroupBits;
  localparam int unsigned S  = rc_pkg::SlotBits;
  localparam int unsigned W  = rc_pkg::NodeWidth;
  localparam int unsigned TB = rc_pkg::TBits;
  localparam int unsigned T  = rc_pkg::Contexts;
  localparam int unsigned GroupW = rc_pkg::BoxRspW - I;

  // ---- The two events of a cycle: an answer of box (in), an answer of tri.
  logic             in_fires, tri_fires, in_leaf, tri_prim;
  rc_pkg::box_rsp_t in;
  assign box_rsp_ready_o = 1'b1;
  assign tri_rsp_ready_o = 1'b1;
  assign in_fires        = box_rsp_valid_i;
  assign tri_fires       = tri_rsp_valid_i;
  assign in              = box_rsp_i;

  // ---- Best hits. found_q says whether the memories hold one for a ray; any_q, which rays
  // any hit ends; shadow_q, which of these end at the surface as well. A ray's kind follows
  // its number, if the chip shades.
  localparam logic [TB-1:0] SurfaceT = TB'(1) << (rc_pkg::CoordBits + rc_pkg::TFracBits);
  logic [rc_pkg::RayW-1:0] ray_flat;
  logic [I-1:0] ray_number;
  logic [1:0]   kind;
  logic [T-1:0] found_q, any_q, shadow_q;
  logic         closer, blocked;
  assign ray_flat   = ray_i;
  assign ray_number = ray_i.ray;
  assign closer   = tri_fires && tri_rsp_i.closer;
  assign blocked  = closer && any_q[tri_rsp_i.ray];
  assign kind     = ray_flat[rc_pkg::RayW-I-1 -: 2];
  always_ff @(posedge clk_i) begin
    if (ray_fires_i) found_q[ray_number] <= 1'b0;
    if (closer)      found_q[tri_rsp_i.ray] <= 1'b1;
  end
  if (rc_pkg::Shading != 0) begin : gen_kinds
    always_ff @(posedge clk_i) begin
      if (ray_fires_i) begin
        any_q[ray_number]    <= kind[1];
        shadow_q[ray_number] <= kind == 2'd2;
      end
    end
  end else begin : gen_camera
    assign any_q    = '0;
    assign shadow_q = '0;
  end

  logic [TB-1:0] tri_t_old, in_t_old, tri_t, in_t;
  rc_ram #(.Width(TB), .Depth(T)) u_t_tri (
    .clk_i, .write_i(closer), .write_addr_i(tri_rsp_i.ray), .write_data_i(tri_rsp_i.t),
    .read_addr_i(tri_rsp_i.ray), .read_data_o(tri_t_old));
  rc_ram #(.Width(TB), .Depth(T)) u_t_in (
    .clk_i, .write_i(closer), .write_addr_i(tri_rsp_i.ray), .write_data_i(tri_rsp_i.t),
    .read_addr_i(in.ray), .read_data_o(in_t_old));
  assign tri_t = closer ? tri_rsp_i.t : found_q[tri_rsp_i.ray] ? tri_t_old
                      : shadow_q[tri_rsp_i.ray] ? SurfaceT : '1;
  assign in_t  = found_q[in.ray] ? in_t_old : shadow_q[in.ray] ? SurfaceT : '1;

  // ---- Groups: the node's children per ray, written by box, read by tri's answer and by step.
  logic [GroupW-1:0] in_group, tri_group, step_group;
  assign in_group = {in.base, in.inner, in.leaves, in.t_near, in.offset, in.count};
  rc_ram #(.Width(GroupW), .Depth(T)) u_group_tri (
    .clk_i, .write_i(in_fires), .write_addr_i(in.ray), .write_data_i(in_group),
    .read_addr_i(tri_rsp_i.ray), .read_data_o(tri_group));
  rc_ram #(.Width(GroupW), .Depth(T)) u_group_step (
    .clk_i, .write_i(in_fires), .write_addr_i(in.ray), .write_data_i(in_group),
    .read_addr_i(end_ray), .read_data_o(step_group));

  // ---- Cursors: leaf and triangle under way per ray; 0, 0 until tri has answered once.
  logic [T-1:0] moved_q;
  logic [S-1:0] cursor_leaf, next_leaf;
  logic [C-1:0] cursor_triangle, next_triangle;
  logic [S+C-1:0] cursor;
  rc_ram #(.Width(S + C), .Depth(T)) u_cursor (
    .clk_i, .write_i(tri_fires), .write_addr_i(tri_rsp_i.ray),
    .write_data_i({next_leaf, next_triangle}),
    .read_addr_i(tri_rsp_i.ray), .read_data_o(cursor));
  always_ff @(posedge clk_i) begin
    if (in_fires)  moved_q[in.ray] <= 1'b0;
    if (tri_fires) moved_q[tri_rsp_i.ray] <= 1'b1;
  end
  assign {cursor_leaf, cursor_triangle} = moved_q[tri_rsp_i.ray] ? cursor : '0;

  // ---- Tri's answer: the next triangle of the leaf, the next leaf, or the step.
  logic [A-1:0]   group_base;
  logic [G-1:0]   group_inner, group_leaves;
  logic [W*TB-1:0] group_near;
  logic [W*O-1:0] group_offset;
  logic [W*C-1:0] group_count;
  assign {group_base, group_inner, group_leaves, group_near, group_offset, group_count} = tri_group;

  logic [S-1:0] at_leaf, at_next, at;
  logic         more_triangles, more_leaves;
  assign at_leaf        = group_inner[S-1:0] + cursor_leaf;
  assign at_next        = at_leaf + S'(1);
  assign more_triangles = cursor_triangle + C'(1) < group_count[at_leaf*C +: C];
  assign more_leaves    = {{(G-S){1'b0}}, cursor_leaf} + G'(1) < group_leaves
                       && group_near[at_next*TB +: TB] <= tri_t;
  assign next_leaf      = more_triangles ? cursor_leaf : cursor_leaf + S'(1);
  assign next_triangle  = more_triangles ? cursor_triangle + C'(1) : '0;
  assign at             = more_triangles ? at_leaf : at_next;
  assign tri_prim       = (more_triangles || more_leaves) && !blocked;

  // ---- Box's answer: the first leaf, or the step.
  logic [W*TB-1:0] in_near;
  logic [W*O-1:0]  in_offset;
  logic [S-1:0]    in_first;
  assign in_near   = in.t_near;
  assign in_offset = in.offset;
  assign in_first  = in.inner[S-1:0];
  assign in_leaf   = in.leaves != '0 && in_near[in_first*TB +: TB] <= in_t;

  // ---- Triangles to fetch.
  logic         next_valid, next_ready, first_valid, first_ready;
  logic [I+A:0] next_data, first_data;
  logic [A:0]   next_addr, first_addr;
  assign next_addr  = {group_base, 1'b0} + {{(A+1-O){1'b0}}, group_offset[at*O +: O]}
      + {{(A+1-C){1'b0}}, next_triangle};
  assign first_addr = {in.base, 1'b0} + {{(A+1-O){1'b0}}, in_offset[in_first*O +: O]};
  rc_queue #(.Width(I + A + 1), .Depth(T)) u_next (
    .clk_i, .rst_ni, .push_i(tri_fires && tri_prim), .data_i({tri_rsp_i.ray, next_addr}),
    .valid_o(next_valid), .pop_i(next_valid && next_ready), .data_o(next_data));
  rc_queue #(.Width(I + A + 1), .Depth(T)) u_first (
    .clk_i, .rst_ni, .push_i(in_fires && in_leaf), .data_i({in.ray, first_addr}),
    .valid_o(first_valid), .pop_i(first_valid && first_ready), .data_o(first_data));
  rc_merge #(.Width(I + A + 1)) u_prim (
    .clk_i, .rst_ni,
    .first_valid_i(next_valid), .first_ready_o(next_ready), .first_i(next_data),
    .second_valid_i(first_valid), .second_ready_o(first_ready), .second_i(first_data),
    .valid_o(prim_req_valid_o), .ready_i(prim_req_ready_i), .data_o(prim_req_o));

  // ---- Steps to take: rays whose triangles are tested, and rays without leaves.
  logic            tested_valid, tested_ready, leafless_valid, leafless_ready;
  logic [I+TB-1:0] tested_data, leafless_data;
  logic [I-1:0]    end_ray;
  logic [TB-1:0]   end_t;
  rc_queue #(.Width(I + TB), .Depth(T)) u_tested (
    .clk_i, .rst_ni, .push_i(tri_fires && !tri_prim), .data_i({tri_rsp_i.ray, tri_t}),
    .valid_o(tested_valid), .pop_i(tested_valid && tested_ready), .data_o(tested_data));
  rc_queue #(.Width(I + TB), .Depth(T)) u_leafless (
    .clk_i, .rst_ni, .push_i(in_fires && !in_leaf), .data_i({in.ray, in_t}),
    .valid_o(leafless_valid), .pop_i(leafless_valid && leafless_ready), .data_o(leafless_data));
  rc_merge #(.Width(I + TB)) u_step (
    .clk_i, .rst_ni,
    .first_valid_i(tested_valid), .first_ready_o(tested_ready), .first_i(tested_data),
    .second_valid_i(leafless_valid), .second_ready_o(leafless_ready), .second_i(leafless_data),
    .valid_o(step_valid_o), .ready_i(step_ready_i), .data_o({end_ray, end_t}));
  logic [W*S-1:0] step_slot;
  logic [W*O-1:0] step_offset;
  logic [G-1:0]   step_leaves;
  logic [W*C-1:0] step_count;
  logic [A-1:0]   step_base;
  logic [G-1:0]   step_inner;
  logic [W*TB-1:0] step_near;
  assign {step_base, step_inner, step_leaves, step_near, step_offset, step_count} = step_group;
  for (genvar i = 0; i < W; i++) begin : gen_slot
    assign step_slot[i*S +: S] = step_offset[i*O + 1 +: S];
  end
  logic [rc_pkg::StepW-I-1:0] step_rest;
  if (rc_pkg::Shading != 0) begin : gen_stop
    logic stop;
    assign stop      = any_q[end_ray] && found_q[end_ray];
    assign step_rest = {stop, end_t, step_base, stop ? {G{1'b0}} : step_inner, step_near,
                        step_slot};
  end else begin : gen_go_on
    assign step_rest = {end_t, step_base, step_inner, step_near, step_slot};
  end
  assign step_o = {end_ray, step_rest};

  // ---- Triangle, ray and hit to beat, together to tri.
  localparam int unsigned BestW = rc_pkg::NumBits + rc_pkg::EdgeBits + rc_pkg::PrimBits;
  localparam int unsigned TriRayW = rc_pkg::TriRayBits;   // behind the number in both structs
  logic [rc_pkg::PrimRspW-1:0] prim_flat;
  logic [TriRayW-1:0] tri_ray;
  logic [BestW-1:0] tri_best;
  logic             tri_found;
  assign prim_flat = prim_rsp_i;
  rc_ram #(.Width(TriRayW), .Depth(T)) u_ray (
    .clk_i, .write_i(ray_fires_i), .write_addr_i(ray_i.ray),
    .write_data_i(ray_flat[rc_pkg::RayW-I-1 -: TriRayW]),
    .read_addr_i(prim_rsp_i.ray), .read_data_o(tri_ray));
  rc_ram #(.Width(BestW), .Depth(T)) u_best (
    .clk_i, .write_i(closer), .write_addr_i(tri_rsp_i.ray),
    .write_data_i({tri_rsp_i.num, tri_rsp_i.det, tri_rsp_i.prim}),
    .read_addr_i(prim_rsp_i.ray), .read_data_o(tri_best));
  assign tri_found        = found_q[prim_rsp_i.ray];
  assign tri_req_valid_o  = prim_rsp_valid_i;
  assign prim_rsp_ready_o = tri_req_ready_i;
  assign tri_req_o = {prim_rsp_i.ray, tri_ray, prim_flat[rc_pkg::PrimRspW-I-1:0],
                      tri_found, tri_found ? tri_best : {BestW{1'b0}}};

  // ---- The answer for a ray that trav has finished.
  localparam int unsigned FoundW = rc_pkg::ClosestW - I - 1;
  logic [rc_pkg::TriRspW-1:0] tri_flat;
  logic [FoundW-1:0] new_found, end_found;
  logic              is_found;
  rc_ram #(.Width(FoundW), .Depth(T)) u_found (
    .clk_i, .write_i(closer), .write_addr_i(tri_rsp_i.ray),
    .write_data_i(new_found),
    .read_addr_i(done_i.ray), .read_data_o(end_found));
  assign tri_flat = tri_rsp_i;
  if (rc_pkg::Shading != 0) begin : gen_side   // the side seen, behind number and `closer`
    assign new_found = {tri_flat[rc_pkg::TriRspW-I-2], tri_flat[FoundW-2:0]};
  end else begin : gen_no_side
    assign new_found = tri_flat[FoundW-1:0];
  end
  assign is_found        = found_q[done_i.ray];
  assign closest_valid_o = done_valid_i;
  assign done_ready_o    = closest_ready_i;
  assign closest_o       = {done_i.ray, is_found, is_found ? end_found : {FoundW{1'b0}}};

  logic unused;
  assign unused = ^{ray_flat, kind, tri_flat, prim_flat, group_inner, step_offset, step_leaves,
      step_count};
endmodule
`default_nettype wire

// The leaves of a node. list accepts them from trav, and sends their triangles to tri one by one,
// nearest leaf first and none beyond the best hit. Then it returns the distance to beat to trav. It
// stores each ray's best hit, and outputs it when trav is done. It does not depend on the
// structure.
//
// A ray from or to a light (kinds shadow and away) ends with the first primitive in its way. No
// other is tested, and trav gets a stop. A shadow ray also ends at t = 2^-B: its distance to beat
// is 2^(N+F). With textures a ray to or from a light ignores the first start_i.holes cut-outs that
// it meets. The next one ends it.
//
// Leaves and an answer of tri are accepted in every cycle. trav sends leaves only if the nearest is
// not beyond the distance to beat, so the first triangle of the nearest leaf is always tested. An
// answer of tri sends its ray to one of two links, prim or tested. Each source has its own queue on
// the link prim, so neither waits for the other; tri's rays go first. One triangle per ray is in
// flight. A triangle from memory goes on to tri, with its ray, in the same cycle.
//
// An answer of tri passes through three stages. A signal's prefix names its stage.
//
// - s0 reads the ray's leaves and its cursor, which is the leaf and triangle in flight.
// - s1 stores a closer hit, and decides whether a triangle or a leaf follows.
// - s2 writes the new cursor, and requests the next triangle or returns the ray to trav.
//
// In a relaxed chip the stages lie in one cycle. In a fast chip there is a register before each.
//
// A ray's start clears its hit. When the ray goes to trav, list only stores it for tri. With two
// levels tri gets the ray in the space of the instance that it entered last. list adds the number
// of the instance's first primitive to the number of a primitive. Model: model/unit/list/list.hpp.
`default_nettype none
module rc_list (
  input  logic              clk_i,
  input  logic              rst_ni,
  // A ray starts; a ray goes to trav
  input  logic              start_fires_i,
  input  rc_pkg::start_t    start_i,
  input  logic              ray_fires_i,
  input  rc_pkg::ray_t      ray_i,
  // With two levels: a ray was transformed
  input  logic              change_fires_i,
  input  rc_pkg::change_t   change_i,
  // From trav
  input  logic              leaves_fires_i,
  input  rc_pkg::leaves_t   leaves_i,
  // To and from prim_cache
  output logic              prim_req_valid_o,
  input  logic              prim_req_ready_i,
  output rc_pkg::prim_req_t prim_req_o,
  input  logic              prim_rsp_valid_i,
  output logic              prim_rsp_ready_o,
  input  rc_pkg::prim_rsp_t prim_rsp_i,
  input  logic              prim_next_fires_i,   // in a fast chip: the next one comes, and its ray
  input  logic [rc_pkg::RayBits-1:0] prim_next_i,
  // To and from tri
  output logic              tri_req_valid_o,
  input  logic              tri_req_ready_i,
  output rc_pkg::tri_req_t  tri_req_o,
  input  logic              tri_rsp_valid_i,
  output logic              tri_rsp_ready_o,
  input  rc_pkg::tri_rsp_t  tri_rsp_i,
  // To and from trav
  output logic              tested_valid_o,
  input  logic              tested_ready_i,
  output rc_pkg::tested_t   tested_o,
  input  logic              done_valid_i,
  output logic              done_ready_o,
  input  rc_pkg::done_t     done_i,
  input  logic              done_next_fires_i,   // in a fast chip: the next one comes
  input  rc_pkg::done_t     done_next_i,
  // To sched, or shade
  output logic              closest_valid_o,
  input  logic              closest_ready_i,
  output rc_pkg::closest_t  closest_o
);
  localparam int unsigned RayBits    = rc_pkg::RayBits;
  localparam int unsigned AddrBits   = rc_pkg::AddrBits;
  localparam int unsigned OffsetBits = rc_pkg::OffsetBits;
  localparam int unsigned CountBits  = rc_pkg::CountBits;
  localparam int unsigned GroupBits  = rc_pkg::GroupBits;
  localparam int unsigned SlotBits   = rc_pkg::SlotBits;
  localparam int unsigned NodeWidth  = rc_pkg::NodeWidth;
  localparam int unsigned TBits      = rc_pkg::TBits;
  localparam int unsigned Contexts   = rc_pkg::Contexts;

  // ---- The two events of a cycle: leaves from trav, and an answer from tri. In a fast chip the
  // answer is in a register before s0.
  logic             leaves_fires, s0_fires, s0_closer, tri_prim;
  rc_pkg::leaves_t  leaves;
  rc_pkg::tri_rsp_t s0_rsp;
  logic [rc_pkg::TriRspW-1:0] s0_rsp_flat;

  assign tri_rsp_ready_o = 1'b1;
  assign leaves_fires    = leaves_fires_i;
  assign leaves          = leaves_i;

  rc_path_register #(.Width(rc_pkg::TriRspW)) u_s0_rsp (
    .clk_i, .data_i(tri_rsp_i), .data_o(s0_rsp_flat));
  assign s0_rsp = s0_rsp_flat;

  rc_pulse_register u_s0_fires (.clk_i, .rst_ni, .fires_i(tri_rsp_valid_i), .fires_o(s0_fires));
  rc_pulse_register u_s0_closer (
    .clk_i, .rst_ni, .fires_i(tri_rsp_valid_i && tri_rsp_i.closer), .fires_o(s0_closer));

  // Results of an answer, stored in s1, because a few hundred cells hold them. They are read with
  // the ray's next primitive at the earliest.
  localparam int unsigned BestW    = rc_pkg::BestW;
  localparam int unsigned StoredHitW = rc_pkg::StoredHitW;

  logic                s1_fires, s1_hits, s1_closer;   // s1_hits: closer of tri's answer
  logic [RayBits-1:0]  s1_ray;
  logic [TBits-1:0]    s1_rsp_t;
  rc_pkg::best_t       s0_best;
  logic [BestW-1:0]    s1_best;
  rc_pkg::stored_hit_t   s0_hit;
  logic [StoredHitW-1:0] s1_hit;

  assign s0_best.best_num  = s0_rsp.num;
  assign s0_best.best_det  = s0_rsp.det;
  assign s0_best.best_prim = s0_rsp.prim;

  if (rc_pkg::Shading) begin : gen_side
    assign s0_hit.back = s0_rsp.back;
  end
  if (rc_pkg::HasTextures) begin : gen_cutout
    assign s0_hit.cutout = s0_rsp.cutout;
  end
  assign s0_hit.prim = s0_rsp.prim;
  assign s0_hit.t    = s0_rsp.t;
  assign s0_hit.u    = s0_rsp.u;
  assign s0_hit.v    = s0_rsp.v;

  rc_pulse_register u_s1_fires (.clk_i, .rst_ni, .fires_i(s0_fires), .fires_o(s1_fires));
  rc_pulse_register u_s1_hits (.clk_i, .rst_ni, .fires_i(s0_closer), .fires_o(s1_hits));
  rc_path_register #(.Width(RayBits + TBits + BestW + StoredHitW)) u_s1_results (
    .clk_i, .data_i({s0_rsp.ray, s0_rsp.t, s0_best, s0_hit}),
    .data_o({s1_ray, s1_rsp_t, s1_best, s1_hit}));

  // ---- Best hits. found: the memories hold a hit of the ray.
  logic [RayBits-1:0]  start_ray;
  logic [Contexts-1:0] found;
  logic                ends_at_any, s1_blocked;

  assign start_ray  = start_i.ray;
  assign s1_blocked = s1_closer && ends_at_any;

  rc_flags #(.Flags(Contexts)) u_is_found (
    .clk_i, .rst_ni, .clear_i(start_fires_i), .clear_at_i(start_ray),
    .set_i(s1_closer), .set_at_i(s1_ray), .flags_o(found));

  if (rc_pkg::Shading) begin : gen_kinds
    logic                to_light;
    logic [Contexts-1:0] any_hit;   // rays that any hit ends

    assign to_light = start_i.kind == rc_pkg::RayShadow || start_i.kind == rc_pkg::RayAway;
    rc_bit_array #(.Marks(Contexts)) u_any (
      .clk_i, .rst_ni, .write_i(start_fires_i), .write_at_i(start_ray), .mark_i(to_light),
      .marks_o(any_hit));
    rc_bit_select #(.Flags(Contexts)) u_ends_at_any (
      .clk_i, .flags_i(any_hit), .index_i(s0_rsp.ray), .flag_o(ends_at_any));
  end else begin : gen_camera
    assign ends_at_any = 1'b0;
  end

  // ---- Cut-outs with holes. A ray ignores the first ones. `passed` counts them; it is 0 at first.
  rc_pkg::stored_hit_t s1_hit_fields;

  assign s1_hit_fields = s1_hit;

  if (rc_pkg::HasTextures) begin : gen_holes
    localparam int unsigned HoleBits = rc_pkg::HoleBits;
    logic [HoleBits-1:0] s0_holes, s0_passed, s1_holes, s1_passed, passed;
    logic [Contexts-1:0] has_passed;
    logic                was_passed, s1_passes;

    rc_ram #(.Width(HoleBits), .Depth(Contexts)) u_holes (
      .clk_i, .write_i(start_fires_i), .write_addr_i(start_ray), .write_data_i(start_i.holes),
      .read_addr_i(s0_rsp.ray), .read_data_o(s0_holes));
    rc_ram #(.Width(HoleBits), .Depth(Contexts)) u_passed (
      .clk_i, .write_i(s1_passes), .write_addr_i(s1_ray), .write_data_i(passed + HoleBits'(1)),
      .read_addr_i(s0_rsp.ray), .read_data_o(s0_passed));

    rc_flags #(.Flags(Contexts)) u_has_passed (
      .clk_i, .rst_ni, .clear_i(start_fires_i), .clear_at_i(start_ray),
      .set_i(s1_passes), .set_at_i(s1_ray), .flags_o(has_passed));
    rc_bit_select #(.Flags(Contexts)) u_was_passed (
      .clk_i, .flags_i(has_passed), .index_i(s0_rsp.ray), .flag_o(was_passed));

    rc_path_register #(.Width(2 * HoleBits)) u_s1_holes (
      .clk_i, .data_i({s0_holes, s0_passed}), .data_o({s1_holes, s1_passed}));

    assign passed    = was_passed ? s1_passed : '0;
    assign s1_passes = s1_hits && s1_hit_fields.cutout && passed != s1_holes;
    assign s1_closer = s1_hits && !s1_passes;
  end else begin : gen_no_holes
    assign s1_closer = s1_hits;
  end

  // ---- Distances to beat.
  logic [TBits-1:0]   old_t_best;   // distance to beat of s1's ray
  logic [2*TBits-1:0] nears;        // nearest points of the leaves that may follow
  logic [1:0]         s1_within, old_within;

  rc_t_best #(.Nears(2)) u_t_best (
    .clk_i, .rst_ni, .start_fires_i, .start_i,
    .write_i(s1_closer), .write_ray_i(s1_ray), .write_t_best_i(s1_rsp_t),
    .read_ray_i(s0_rsp.ray), .read_t_best_o(old_t_best), .near_i(nears), .within_o(old_within));

  // ---- Leaves in flight per ray: written by trav's leaves, read by tri's answer.
  localparam int unsigned GroupW = rc_pkg::LeafGroupW;
  rc_pkg::leaf_group_t leaves_group;
  logic [GroupW-1:0]   s0_group;

  assign leaves_group.base   = leaves.base;
  assign leaves_group.leaves = leaves.leaves;
  assign leaves_group.t_near = leaves.t_near;
  assign leaves_group.offset = leaves.offset;
  assign leaves_group.count  = leaves.count;

  rc_ram_prefetch #(.Width(GroupW), .Depth(Contexts)) u_group (
    .clk_i, .rst_ni, .write_i(leaves_fires), .write_addr_i(leaves.ray),
    .write_data_i(leaves_group), .head_addr_i(s0_rsp.ray),
    .next_fires_i(tri_rsp_valid_i), .next_addr_i(tri_rsp_i.ray), .read_data_o(s0_group));

  // ---- Cursors: leaf and triangle in flight per ray. They are 0, 0 until tri has answered once.
  logic [Contexts-1:0] moved;
  logic [SlotBits-1:0]           cursor_leaf, next_leaf;
  logic [CountBits-1:0]          cursor_triangle, next_triangle;
  logic [SlotBits+CountBits-1:0] s0_cursor, s1_cursor;
  logic                          was_moved;
  logic                          s2_fires;
  logic [RayBits-1:0]            s2_ray;

  rc_ram #(.Width(SlotBits + CountBits), .Depth(Contexts)) u_cursor (
    .clk_i, .write_i(s2_fires), .write_addr_i(s2_ray),
    .write_data_i({next_leaf, next_triangle}),
    .read_addr_i(s0_rsp.ray), .read_data_o(s0_cursor));

  rc_flags #(.Flags(Contexts)) u_moved (
    .clk_i, .rst_ni, .clear_i(leaves_fires), .clear_at_i(leaves.ray),
    .set_i(s1_fires), .set_at_i(s1_ray), .flags_o(moved));

  rc_bit_select #(.Flags(Contexts)) u_was_moved (
    .clk_i, .flags_i(moved), .index_i(s0_rsp.ray), .flag_o(was_moved));

  // ---- Tri's answer: the next triangle of the leaf, the next leaf, or the last was tested.
  logic                            s2_blocked;
  logic [TBits-1:0]                s1_t_best, s2_t_best;
  logic [AddrBits-1:0]             s2_base;
  logic [GroupBits-1:0]            group_leaves;
  logic [NodeWidth*TBits-1:0]      group_near;
  logic [NodeWidth*OffsetBits-1:0] group_offset;
  logic [NodeWidth*CountBits-1:0]  group_count;

  rc_path_register #(.Width(SlotBits + CountBits)) u_s1_cursor (
    .clk_i, .data_i(s0_cursor), .data_o(s1_cursor));

  assign s1_t_best = s1_closer ? s1_rsp_t : old_t_best;
  assign {cursor_leaf, cursor_triangle} = was_moved ? s1_cursor : '0;

  rc_pkg::leaf_group_t group;
  logic [GroupW-1:0]   group_flat;

  rc_path_register #(.Width(GroupW)) u_s1_group (
    .clk_i, .data_i(s0_group), .data_o(group_flat));
  assign group        = group_flat;
  assign group_leaves = group.leaves;
  assign group_near   = group.t_near;
  assign group_offset = group.offset;
  assign group_count  = group.count;

  logic [SlotBits-1:0]   at_next, s1_leaf, s1_next, s2_leaf;
  logic [CountBits-1:0]  leaf_count, s2_triangle;
  logic                  more_triangles, more_leaves, s2_more_triangles, s2_more_leaves;
  logic [OffsetBits-1:0] this_offset, next_offset, s2_this_offset, s2_next_offset, s2_offset;

  // Whether another leaf follows: computed for both cursors, because the selection is known late.
  logic [TBits-1:0] s1_near;
  logic             more_after_cursor, more_after_first;

  assign s1_leaf     = s1_cursor[CountBits +: SlotBits];
  assign s1_next     = s1_leaf + SlotBits'(1);
  assign nears       = {s1_near, group_near[TBits +: TBits]};
  assign s1_within   = s1_closer ? {s1_near <= s1_rsp_t, nears[TBits-1:0] <= s1_rsp_t} : old_within;

  always_comb begin
    leaf_count  = '0;
    this_offset = '0;
    next_offset = '0;
    s1_near     = '0;
    for (int i = 0; i < NodeWidth; i++) begin
      if (cursor_leaf == SlotBits'(i))
        leaf_count = leaf_count | group_count[i*CountBits +: CountBits];
      if (cursor_leaf == SlotBits'(i))
        this_offset = this_offset | group_offset[i*OffsetBits +: OffsetBits];
      if (at_next == SlotBits'(i))
        next_offset = next_offset | group_offset[i*OffsetBits +: OffsetBits];
      if (s1_next == SlotBits'(i)) s1_near = s1_near | group_near[i*TBits +: TBits];
    end
  end

  assign at_next           = cursor_leaf + SlotBits'(1);
  assign more_triangles    = cursor_triangle + CountBits'(1) < leaf_count;
  assign more_after_cursor = {{(GroupBits-SlotBits){1'b0}}, s1_leaf} + GroupBits'(1) < group_leaves
                           && s1_within[1];
  assign more_after_first  = group_leaves > GroupBits'(1) && s1_within[0];
  assign more_leaves       = was_moved ? more_after_cursor : more_after_first;

  rc_path_register #(.Width(RayBits + 3 + TBits + AddrBits + SlotBits + CountBits + 2 * OffsetBits))
  u_s2 (
    .clk_i,
    .data_i({s1_ray, s1_blocked, more_triangles, more_leaves, s1_t_best, group.base, cursor_leaf,
             cursor_triangle, this_offset, next_offset}),
    .data_o({s2_ray, s2_blocked, s2_more_triangles, s2_more_leaves, s2_t_best, s2_base, s2_leaf,
             s2_triangle, s2_this_offset, s2_next_offset}));

  rc_pulse_register u_s2_fires (.clk_i, .rst_ni, .fires_i(s1_fires), .fires_o(s2_fires));

  assign next_leaf     = s2_more_triangles ? s2_leaf : s2_leaf + SlotBits'(1);
  assign next_triangle = s2_more_triangles ? s2_triangle + CountBits'(1) : '0;
  assign s2_offset     = s2_more_triangles ? s2_this_offset : s2_next_offset;
  assign tri_prim      = (s2_more_triangles || s2_more_leaves) && !s2_blocked;

  // ---- Triangles to fetch.
  logic                      next_valid, next_ready, first_valid, first_ready;
  logic [RayBits+AddrBits:0] next_data, first_data;
  logic [AddrBits:0]         next_addr, first_addr;

  assign next_addr  = {s2_base, 1'b0} + {{(AddrBits+1-OffsetBits){1'b0}}, s2_offset}
      + {{(AddrBits+1-CountBits){1'b0}}, next_triangle};
  assign first_addr = {leaves.base, 1'b0}
                    + {{(AddrBits+1-OffsetBits){1'b0}}, leaves.offset[OffsetBits-1:0]};

  rc_queue #(.Width(RayBits + AddrBits + 1), .Depth(Contexts)) u_next (
    .clk_i, .rst_ni, .push_i(s2_fires && tri_prim), .data_i({s2_ray, next_addr}),
    .valid_o(next_valid), .pop_i(next_valid && next_ready), .data_o(next_data));
  rc_queue #(.Width(RayBits + AddrBits + 1), .Depth(Contexts)) u_first (
    .clk_i, .rst_ni, .push_i(leaves_fires), .data_i({leaves.ray, first_addr}),
    .valid_o(first_valid), .pop_i(first_valid && first_ready), .data_o(first_data));

  rc_priority_merge #(.Width(RayBits + AddrBits + 1)) u_prim (
    .clk_i, .rst_ni,
    .first_valid_i(next_valid), .first_ready_o(next_ready), .first_i(next_data),
    .second_valid_i(first_valid), .second_ready_o(first_ready), .second_i(first_data),
    .valid_o(prim_req_valid_o), .ready_i(prim_req_ready_i), .data_o(prim_req_o));

  // ---- Rays whose leaves are tested, back to trav.
  rc_pkg::tested_t ended;

  assign ended.ray    = s2_ray;
  assign ended.t_best = s2_t_best;
  if (rc_pkg::Shading) begin : gen_stop   // the first hit of a ray that any hit ends
    assign ended.stop = s2_blocked;
  end

  rc_queue #(.Width(rc_pkg::TestedW), .Depth(Contexts)) u_tested (
    .clk_i, .rst_ni, .push_i(s2_fires && !tri_prim), .data_i(ended),
    .valid_o(tested_valid_o), .pop_i(tested_valid_o && tested_ready_i), .data_o(tested_o));

  // ---- To tri: the ray, the primitive and the hit to beat.
  localparam int unsigned TriRayW = rc_pkg::TriRayW;
  logic               store_valid, write_valid, tri_found;
  logic [RayBits-1:0] store_ray, write_ray;
  rc_pkg::tri_ray_t   ray_for_tri;   // the record omits members that this chip does not use
  logic [TriRayW-1:0] write_for_tri, tri_ray;
  logic [BestW-1:0]   tri_best;

  // Where it is. With two levels that is in the space of an instance.
  if (rc_pkg::Levels == 1) begin : gen_ray
    assign store_valid   = ray_fires_i;
    assign store_ray     = ray_i.ray;
    assign ray_for_tri.o = ray_i.o;
  end else begin : gen_change
    assign store_valid   = change_fires_i;
    assign store_ray     = change_i.ray;
    assign ray_for_tri.o = change_i.o;
  end

  if (rc_pkg::Levels != 1) begin : gen_changed_d
    assign ray_for_tri.d = change_i.d;
  end else if (rc_pkg::PrimitiveTest == rc_pkg::TestSheared) begin : gen_slopes
    assign ray_for_tri.axis  = ray_i.axis;
    assign ray_for_tri.neg   = ray_i.neg;
    assign ray_for_tri.size  = ray_i.size;
    assign ray_for_tri.slope = ray_i.slope;
  end else begin : gen_d
    assign ray_for_tri.d = ray_i.d;
  end

  // Its kind, and the set of primitives that it tests. With two levels the set does not change from
  // space to space, so it is stored as the ray came.
  if (rc_pkg::HasHomes) begin : gen_changed_kind
    assign ray_for_tri.kind = change_i.kind;
  end else if (rc_pkg::Shading) begin : gen_kind
    assign ray_for_tri.kind = ray_i.kind;
  end

  if (rc_pkg::HasPartial && rc_pkg::HasHomes) begin : gen_stored_partial
    rc_ram #(.Width(1), .Depth(Contexts)) u_partial (
      .clk_i, .write_i(ray_fires_i), .write_addr_i(ray_i.ray), .write_data_i(ray_i.is_partial),
      .read_addr_i(change_i.ray), .read_data_o(ray_for_tri.is_partial));
  end else if (rc_pkg::HasPartial) begin : gen_partial
    assign ray_for_tri.is_partial = ray_i.is_partial;
  end

  if (rc_pkg::HasSelf && rc_pkg::HasHomes) begin : gen_stored_self
    rc_ram #(.Width(rc_pkg::PrimBits + 1), .Depth(Contexts)) u_self (
      .clk_i, .write_i(ray_fires_i), .write_addr_i(ray_i.ray),
      .write_data_i({ray_i.self, ray_i.is_inside}), .read_addr_i(change_i.ray),
      .read_data_o({ray_for_tri.self, ray_for_tri.is_inside}));
  end else if (rc_pkg::HasSelf) begin : gen_self
    assign ray_for_tri.self      = ray_i.self;
    assign ray_for_tri.is_inside = ray_i.is_inside;
  end

  // A fast chip stores the ray one cycle later. Its first primitive comes much later.
  rc_pulse_register u_write_valid (.clk_i, .rst_ni, .fires_i(store_valid), .fires_o(write_valid));
  rc_path_register #(.Width(RayBits + TriRayW)) u_write_ray (
    .clk_i, .data_i({store_ray, ray_for_tri}), .data_o({write_ray, write_for_tri}));

  rc_ram_prefetch #(.Width(TriRayW), .Depth(Contexts)) u_ray (
    .clk_i, .rst_ni, .write_i(write_valid), .write_addr_i(write_ray), .write_data_i(write_for_tri),
    .head_addr_i(prim_rsp_i.ray), .next_fires_i(prim_next_fires_i), .next_addr_i(prim_next_i),
    .read_data_o(tri_ray));

  rc_ram_prefetch #(.Width(BestW), .Depth(Contexts)) u_best (
    .clk_i, .rst_ni, .write_i(s1_closer), .write_addr_i(s1_ray), .write_data_i(s1_best),
    .head_addr_i(prim_rsp_i.ray), .next_fires_i(prim_next_fires_i), .next_addr_i(prim_next_i),
    .read_data_o(tri_best));

  // A ray's `found` does not change while its primitive is requested. A fast chip reads the flag
  // with the request, and stores it until the primitive comes. So a primitive must not come in the
  // cycle after its request; every cache is slower.
  if (rc_pkg::PathCut == 0) begin : gen_found_now
    assign tri_found = found[prim_rsp_i.ray];
  end else begin : gen_found_before
    logic               requested_q, was_found;
    logic [RayBits-1:0] requested_ray_q;

    always_ff @(posedge clk_i) begin
      requested_q     <= prim_req_valid_o && prim_req_ready_i;
      requested_ray_q <= prim_req_o.ray;
    end

    rc_bit_select #(.Flags(Contexts)) u_was_found (
      .clk_i, .flags_i(found), .index_i(prim_req_o.ray), .flag_o(was_found));
    rc_ram #(.Width(1), .Depth(Contexts)) u_was (
      .clk_i, .write_i(requested_q), .write_addr_i(requested_ray_q), .write_data_i(was_found),
      .read_addr_i(prim_rsp_i.ray), .read_data_o(tri_found));

`ifndef SYNTHESIS
    always_ff @(posedge clk_i) if (rst_ni && prim_rsp_valid_i && requested_q)
      a_not_at_once: assert (prim_rsp_i.ray != requested_ray_q)
      else $error("a primitive came in the cycle after its request");
`endif
  end

  assign tri_req_valid_o  = prim_rsp_valid_i;
  assign prim_rsp_ready_o = tri_req_ready_i;

  logic [rc_pkg::PrimBits-1:0] prim_number;
  rc_pkg::primitive_t          prim_data;

  if (rc_pkg::Levels == 1) begin : gen_own_number
    assign prim_number = prim_rsp_i.prim;
  end else begin : gen_scene_number
    logic [rc_pkg::PrimBits-1:0] first_number;

    rc_ram_prefetch #(.Width(rc_pkg::PrimBits), .Depth(Contexts)) u_first_number (
      .clk_i, .rst_ni, .write_i(change_fires_i), .write_addr_i(change_i.ray),
      .write_data_i(change_i.first), .head_addr_i(prim_rsp_i.ray),
      .next_fires_i(prim_next_fires_i), .next_addr_i(prim_next_i), .read_data_o(first_number));

    assign prim_number = prim_rsp_i.prim + first_number;
  end

  if (rc_pkg::HasPrimKinds) begin : gen_kind_of_primitive
    assign prim_data.prim_kind = prim_rsp_i.prim_kind;
  end
  assign prim_data.a    = prim_rsp_i.a;
  assign prim_data.b    = prim_rsp_i.b;
  assign prim_data.c    = prim_rsp_i.c;
  assign prim_data.prim = prim_number;

  rc_pkg::tri_req_parts_t tri_req;

  assign tri_req.ray        = prim_rsp_i.ray;
  assign tri_req.ray_fields = tri_ray;
  assign tri_req.prim_data  = prim_data;
  assign tri_req.found      = tri_found;
  assign tri_req.best       = tri_found ? tri_best : '0;
  assign tri_req_o          = tri_req;

  // ---- The answer for a ray that trav has finished. It is read much later, and its memory is
  // placed far from the other state of a hit.
  logic                hit_store_valid, is_found;
  logic [RayBits-1:0]  hit_store_ray;
  logic [StoredHitW-1:0] hit_store, done_hit;
  rc_pkg::stored_hit_t   closest_hit;

  rc_pulse_register #(.Stages(rc_pkg::FarPathCut)) u_hit_store_valid (
    .clk_i, .rst_ni, .fires_i(s1_closer), .fires_o(hit_store_valid));
  rc_path_register #(.Width(RayBits + StoredHitW), .Stages(rc_pkg::FarPathCut)) u_hit_store (
    .clk_i, .data_i({s1_ray, s1_hit}), .data_o({hit_store_ray, hit_store}));

  rc_ram_prefetch #(.Width(StoredHitW), .Depth(Contexts)) u_hit (
    .clk_i, .rst_ni, .write_i(hit_store_valid), .write_addr_i(hit_store_ray),
    .write_data_i(hit_store), .head_addr_i(done_i.ray), .next_fires_i(done_next_fires_i),
    .next_addr_i(done_next_i.ray), .read_data_o(done_hit));

  assign closest_hit     = is_found ? done_hit : '0;
  assign closest_o.ray   = done_i.ray;
  assign closest_o.found = is_found;
  assign closest_o.prim  = closest_hit.prim;
  assign closest_o.t     = closest_hit.t;
  assign closest_o.u     = closest_hit.u;
  assign closest_o.v     = closest_hit.v;

  if (rc_pkg::Shading) begin : gen_side_of_hit
    assign closest_o.back = closest_hit.back;
  end

  if (rc_pkg::HasTextures) begin : gen_cutout_of_hit
    assign closest_o.cutout = closest_hit.cutout;
  end

  if (rc_pkg::HasHomes) begin : gen_place   // line of the instance that the ray is in
    logic [AddrBits-1:0] s0_here, s1_here, done_place;

    rc_path_register #(.Width(AddrBits)) u_s1_here (.clk_i, .data_i(s0_here), .data_o(s1_here));
    rc_ram #(.Width(AddrBits), .Depth(Contexts)) u_here (
      .clk_i, .write_i(change_fires_i), .write_addr_i(change_i.ray), .write_data_i(change_i.here),
      .read_addr_i(s0_rsp.ray), .read_data_o(s0_here));
    rc_ram_prefetch #(.Width(AddrBits), .Depth(Contexts)) u_place (
      .clk_i, .rst_ni, .write_i(s1_closer), .write_addr_i(s1_ray), .write_data_i(s1_here),
      .head_addr_i(done_i.ray), .next_fires_i(done_next_fires_i), .next_addr_i(done_next_i.ray),
      .read_data_o(done_place));

    assign closest_o.place = is_found ? done_place : '0;
  end

  rc_bit_prefetch #(.Flags(Contexts)) u_was_best (
    .clk_i, .rst_ni, .flags_i(found), .head_valid_i(done_valid_i), .head_i(done_i.ray),
    .next_fires_i(done_next_fires_i), .next_i(done_next_i.ray), .flag_o(is_found));

  assign closest_valid_o = done_valid_i;
  assign done_ready_o    = closest_ready_i;

  logic unused;
  assign unused = ^{ray_fires_i, ray_i, change_fires_i, change_i, s0_rsp, s1_hit_fields};
endmodule
`default_nettype wire

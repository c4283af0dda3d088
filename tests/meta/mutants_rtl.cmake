# Faults that the tests must notice. Each row: a name, the file, the exact text (it must be there once), what takes its
# place, and the test program with its arguments. QUICK rows run by default, the others under the label slow.
# How: tests/meta/CMakeLists.txt. RTL rows change a copy of rtl/, model rows one source file of a second test program; a header's
# row names the sources WITH which it is compiled; if there are tests among them, they are the test program.

# ---- box: conservative slabs, total order.
mutant(box_near_below_far QUICK FILE rtl/engine/bvh/rc_box.sv TEST unit [box][lockstep]
  OLD [[= enter <= leave &&]]
  NEW [[= enter < leave &&]])
mutant(slab_far_rounded_down FILE rtl/engine/bvh/rc_slab.sv TEST unit [box][lockstep]
  OLD [[assign placed_up    = ~({R1{1'b1}} << placed_right);]]
  NEW [[assign placed_up    = placed_right == '1 ? '1 : '0;]])
mutant(slab_near_rounded_up FILE rtl/engine/bvh/rc_slab.sv TEST unit [box][lockstep]
  OLD [[.data_i(V'(placed_near_q))]]
  NEW [[.data_i(V'(placed_near_q) + $signed({{(V-R1){1'b0}}, placed_up}))]])
mutant(slab_far_with_r FILE rtl/engine/bvh/rc_slab.sv TEST unit [box][lockstep]
  OLD [[+ {{R1{1'b0}}, plane_neg == plane_zero};]]
  NEW [[+ {{R1{1'b0}}, plane_neg || (plane_zero && !plane_zero)};]])
mutant(slab_near_turned_to_one_more FILE rtl/engine/bvh/rc_slab.sv TEST unit [box][lockstep]
  OLD [[^ plane_r} + {{R1{1'b0}}, plane_neg};]]
  NEW [[^ plane_r};]])
mutant(slab_far_turned_to_one_more FILE rtl/engine/bvh/rc_slab.sv TEST unit [box][lockstep]
  OLD [[+ {{R1{1'b0}}, plane_neg == plane_zero};]]
  NEW [[+ {{R1{1'b0}}, !plane_zero};]])
mutant(slab_zero_direction FILE rtl/engine/bvh/rc_slab.sv TEST unit [box][lockstep]
  OLD [[(zero_q && !near_q[V-1] && near_q != '0)]]
  NEW [[(zero_q && !near_q[V-1])]])
mutant(rank_ignores_offset FILE rtl/unit/trav/rc_rank.sv TEST unit [box][lockstep]
  OLD [[if (holds && (key > other) ==]]
  NEW [[if (holds && (key[KeyW-1:O+C] > other[KeyW-1:O+C]) ==]])
mutant(places_fifth_child_among_the_first_four FILE rtl/unit/trav/rc_child_offsets.sv TEST unit [box][lockstep]
  OLD [[i < 4 ? lines_q : lines_q + half_q]]
  NEW [[i < 5 ? lines_q : lines_q + half_q]])
mutant(rank_leaves_first FILE rtl/unit/trav/rc_rank.sv TEST unit [box][lockstep]
  OLD [[{!s0_hit_i[i], s0_leaf_i[i], s0_near_i]]
  NEW [[{!s0_hit_i[i], !s0_leaf_i[i], s0_near_i]])

# ---- tri: exact decisions.
mutant(edges_zero_is_inside FILE rtl/unit/isect/rc_edges.sv TEST unit [tri][lockstep]
  OLD [[end_u_neg == end_flip && end_v_neg]]
  NEW [[(end_u == '0 || end_u_neg == end_flip) && end_v_neg]])
mutant(edges_tie_turned FILE rtl/unit/isect/rc_edges.sv TEST unit [tri]
  OLD [[assign w_sign[k]  = holds && gen_cross[k].p1_q < gen_cross[k].p2_q;]]
  NEW [[assign w_sign[k]  = (k == 0) != (gen_cross[k].p1_q < gen_cross[k].p2_q);]])
mutant(edges_normal_one_bit_short FILE rtl/unit/isect/rc_edges.sv TEST unit "tri is exact at the corners of the lattice*"
  OLD [[localparam int unsigned X = 2 * D + 1;]]
  NEW [[localparam int unsigned X = 2 * D - 2;]])
mutant(edges_product_one_bit_short FILE rtl/unit/isect/rc_edges.sv TEST unit "tri is exact at the corners of the lattice*"
  OLD [[localparam int unsigned C = M + D + 1;]]
  NEW [[localparam int unsigned C = M + D - 1;]])
mutant(edges_origin_counts FILE rtl/unit/isect/rc_edges.sv TEST unit [tri]
  OLD [[&& !end_here && end_num[U-1] == end_flip]]
  NEW [[&& (end_here || end_num[U-1] == end_flip)]])
mutant(tri_higher_number_wins FILE rtl/unit/isect/rc_tri.sv TEST unit "tri keeps the nearer hit*"
  OLD [[in_first    = in.prim <= in.best_prim &&]]
  NEW [[in_first    = in.prim >= in.best_prim &&]])
mutant(tri_equal_is_not_closer FILE rtl/unit/isect/rc_tri.sv TEST unit [tri]
  OLD [[{f1_theirs_q, wide_first}]]
  NEW [[{f1_theirs_q, wide_first && f1_mine_q == '0}]])
mutant(hitdiv_t_rounded_down FILE rtl/unit/isect/rc_hitdiv.sv TEST unit [tri][lockstep]
  OLD [[t_down + {{(T-1){1'b0}}, t_up}]]
  NEW [[t_down + {{(T-1){1'b0}}, t_up && 1'b0}]])
mutant(hitdiv_u_v_swapped FILE rtl/unit/isect/rc_tri.sv TEST unit [tri][lockstep]
  OLD [[.u_i(pre_u), .v_i(pre_v),]]
  NEW [[.u_i(pre_v), .v_i(pre_u),]])


# ---- tri, sheared, and the slopes that raygen makes for it.
mutant(shear_half_forgotten FILE rtl/unit/isect/rc_shear.sv TEST unit [tri][sheared]
  OLD [[s2_up_x = $signed({{(P-S){1'b0}}, 1'b1, {(S-1){1'b0}}}) - s2_px_q;]]
  NEW [[s2_up_x = -s2_px_q;]])
mutant(shear_tie_turned FILE rtl/unit/isect/rc_shear.sv TEST unit [tri][sheared]
  OLD [[s3_py < s3_qy : s3_qx < s3_px;]]
  NEW [[s3_py < s3_qy : s3_qx > s3_px;]])
mutant(shear_plane_one_bit_short FILE rtl/unit/isect/rc_shear.sv TEST unit [tri][sheared]
  OLD [[s3_x_q <= Q'(s2_x_q) + Q'($signed(s2_up_x[P-1:S]));]]
  NEW [[s3_x_q <= Q'($signed(D'(s2_x_q) + D'($signed(s2_up_x[P-1:S]))));]])
mutant(shear_slope_product_one_bit_short FILE rtl/unit/isect/rc_shear.sv TEST unit [tri][sheared]
  OLD [[localparam int unsigned P = M + N - 1;]]
  NEW [[localparam int unsigned P = M + N - 2;]])
mutant(shear_origin_counts FILE rtl/unit/isect/rc_shear.sv TEST unit [tri][sheared]
  OLD [[&& s5_num_q != '0 && s5_num_q[U-1] == s5_turn;]]
  NEW [[&& (s5_num_q == '0 || s5_num_q[U-1] == s5_turn);]])
mutant(shear_axes_swapped FILE rtl/unit/isect/rc_shear.sv TEST unit [tri][sheared]
  OLD [[{p[2*N-1:0], p[3*N-1:2*N]} : p;]]
  NEW [[{p[2*N-1:N], p[3*N-1:2*N], p[N-1:0]} : p;]])
mutant(tri_sheared_den_forgets_direction FILE rtl/unit/isect/rc_tri.sv TEST unit [tri][sheared]
  OLD [[.b_i(f0_size), .p_o(f0_den));]]
  NEW [[.b_i({M{|f0_size}}), .p_o(f0_den));]])
mutant(slope_rounded_down FILE rtl/unit/raygen/rc_slope.sv TEST unit [raygen][sheared]
  OLD [[({x_one, x_quo[2*Stages-1 -: M-1]} + M'(1)) >> 1;]]
  NEW [[{x_one, x_quo[2*Stages-1 -: M-1]} >> 1;]])
mutant(slope_upper_axis_wins FILE rtl/unit/raygen/rc_slope.sv TEST unit [raygen][sheared]
  OLD [[end else if (s0_1 >= s0_2) begin]]
  NEW [[end else if (s0_1 > s0_2) begin]])
mutant(slope_of_nothing_is_one FILE rtl/unit/raygen/rc_slope.sv TEST unit [raygen][sheared]
  OLD [[assign y_size = z == '0 ? '0 :]]
  NEW [[assign y_size =]])

# ---- trav, list, sched: who goes where.
mutant(stack_below_of_top_only QUICK FILE rtl/unit/trav/rc_stack.sv TEST unit [trav][lockstep]
  OLD [[below = top_near[T-1:0] < top_below ? top_near[T-1:0] : top_below;]]
  NEW [[below = top_near[T-1:0];]])
mutant(stack_pop_writes_one_up FILE rtl/unit/trav/rc_stack.sv TEST unit [trav][lockstep]
  OLD [[level    = end_height - H'(1);]]
  NEW [[level    = end_height;]])
mutant(stack_equal_does_not_matter FILE rtl/unit/trav/rc_stack.sv TEST unit [trav]
  OLD [[assign top_matters   = top_near[T-1:0] <= tested.t_best;]]
  NEW [[assign top_matters   = top_near[T-1:0] < tested.t_best;]])
mutant(stack_gives_up_early FILE rtl/unit/trav/rc_stack.sv TEST unit [trav][lockstep]
  OLD [[below_matters = top_below <= tested.t_best;]]
  NEW [[below_matters = top_below < tested.t_best;]])
mutant(trav_gives_leaves_that_are_too_far FILE rtl/unit/trav/rc_trav.sv TEST unit [trav][lockstep]
  OLD [[leaves.leaves != '0 && leaves_near[TB-1:0] <= leaves_beat;]]
  NEW [[leaves.leaves != '0;]])
mutant(trav_keeps_leaves_exactly_as_far FILE rtl/unit/trav/rc_trav.sv TEST unit [trav]
  OLD [[leaves_near[TB-1:0] <= leaves_beat;]]
  NEW [[leaves_near[TB-1:0] < leaves_beat;]])
mutant(trav_gives_the_second_leaf FILE rtl/unit/trav/rc_trav.sv TEST unit [trav]
  OLD [[leaf_offset = leaf_offset >> (O << b);]]
  NEW [[leaf_offset = leaf_offset >> (O << (b + 1));]])
mutant(reach_is_not_reset_by_a_start FILE rtl/unit/trav/rc_ray_t_max.sv TEST unit [trav]
  OLD [[.clear_i(start_fires_i),]]
  NEW [[.clear_i(start_fires_i && start_ray != '1),]])
mutant(list_skips_last_triangle FILE rtl/unit/list/rc_list.sv TEST unit [list][lockstep]
  OLD [[assign more_triangles   = cursor_triangle + C'(1) <]]
  NEW [[assign more_triangles   = cursor_triangle + C'(2) <]])
mutant(list_ignores_t_best FILE rtl/unit/list/rc_list.sv TEST unit [list][lockstep]
  OLD [[&& it_within[1];]]
  NEW [[&& (it_within[1] || it_t != '0);]])
mutant(list_forgets_its_hit_when_a_ray_changes FILE rtl/unit/list/rc_list.sv TEST unit [list]
  OLD [[.clear_i(start_fires_i), .clear_at_i(start_ray),]]
  NEW [[.clear_i(start_fires_i || ray_fires_i), .clear_at_i(ray_fires_i ? ray_i.ray : start_ray),]])
mutant(list_keeps_old_hit FILE rtl/unit/list/rc_list.sv TEST unit [list][lockstep]
  OLD [[.clear_i(start_fires_i),]]
  NEW [[.clear_i(start_fires_i && !closer),]])
mutant(sched_frees_another_context QUICK FILE rtl/unit/sched/rc_sched.sv TEST unit [sched][lockstep]
  OLD [[.push_i(freed), .data_i(pixel_i.ray)]]
  NEW [[.push_i(freed), .data_i(pixel_i.ray ^ I'(1))]])
mutant(sched_one_row_more FILE rtl/unit/sched/rc_sched.sv TEST unit [sched]
  OLD [[next_y < height[K-1:0]));]]
  NEW [[next_y <= height[K-1:0]));]])
mutant(sched_tile_begins_inside FILE rtl/unit/sched/rc_sched.sv TEST unit [sched]
  OLD [[(tile_lies[0] && height[K-1:0] != '0));]]
  NEW [[tile_lies[0]);]])
mutant(sched_begins_a_frame_within_a_tile FILE rtl/unit/sched/rc_sched.sv TEST unit [sched]
  OLD [[if (!rst_ni || start_i) first_q <= 1'b1;]]
  NEW [[if (!rst_ni) first_q <= 1'b1;]])
mutant(sched_edge_tile_is_outside FILE rtl/unit/sched/rc_sched.sv TEST unit [sched]
  OLD [[{1'b0, tile_i.x} == width[P:K],]]
  NEW [[{1'b0, tile_i.x} > width[P:K],]])
mutant(sched_order_transposed FILE rtl/unit/sched/rc_sched.sv TEST unit [sched]
  OLD [[      assign x[i] = at_q[2*i];
      assign y[i] = at_q[2*i+1];]]
  NEW [[      assign y[i] = at_q[2*i];
      assign x[i] = at_q[2*i+1];]])
mutant(sched_waits_outside FILE rtl/unit/sched/rc_sched.sv TEST unit [sched]
  OLD [[else if (give || pass)  at_q]]
  NEW [[else if (give)          at_q]])
mutant(sched_gives_a_pixel_at_the_start FILE rtl/unit/sched/rc_sched.sv TEST unit [sched]
  OLD [[assign at_hand  = tile_valid && in_frame && !start_i;]]
  NEW [[assign at_hand  = tile_valid && in_frame;]])
mutant(sched_keeps_the_last_frames_tile FILE rtl/unit/sched/rc_sched.sv TEST unit [sched]
  OLD [[if (!rst_ni || start_i) at_q <= '0;]]
  NEW [[if (!rst_ni) at_q <= '0;]])
mutant(dispatch_one_row_more FILE rtl/unit/sched/rc_dispatch.sv TEST unit [dispatch]
  OLD [[<< rc_pkg::TileBits >= frame_i.height;]]
  NEW [[<< rc_pkg::TileBits > frame_i.height;]])
mutant(dispatch_same_again FILE rtl/unit/sched/rc_dispatch.sv TEST unit [dispatch]
  OLD [[next_q <= (to + 1'b1) & PB'(P - 1);]]
  NEW [[next_q <= to & PB'(P - 1);]])
mutant(arbiter_prefers_one FILE rtl/mem/rc_arbiter.sv TEST unit [machine][lockstep]
  OLD [[if (valid_o && ready_i) last_q <= source_o;]]
  NEW [[if (valid_o && ready_i) last_q <= source_o & '0;]])
mutant(arbiter_changes_its_mind FILE rtl/mem/rc_arbiter.sv TEST unit [machine][lockstep]
  OLD [[assign source_o = held_q ? held_source_q : turn;]]
  NEW [[assign source_o = held_q && valid_i == '0 ? held_source_q : turn;]])
mutant(top_pops_without_asking FILE rtl/rc_pipeline.sv TEST system "model and RTL agree for every memory and every back-pressure"
  OLD [[.closest_ready_i(closest_ready)]]
  NEW [[.closest_ready_i(closest_ready || closest.found)]])

# ---- What stands still, and what counts wrongly.
mutant(top_never_serves_primitives FILE rtl/rc_top.sv TEST unit [machine][lockstep]
  OLD [[.valid_i(miss_valid), .ready_o(miss_ready)]]
  NEW [[.valid_i(miss_valid & {P{2'b01}}), .ready_o(miss_ready)]])
mutant(sched_loses_hits_of_used_contexts FILE rtl/unit/sched/rc_sched.sv TEST unit [machine][lockstep]
  OLD [[assign hit_valid_o   = pixel_valid_i;]]
  NEW [[assign hit_valid_o   = pixel_valid_i && fresh;]])
mutant(tally_of_box_blames_trav QUICK FILE rtl/unit/trav/rc_node_test.sv TEST unit "model and rtl of the machine count the same"
  OLD [[cause_o = node_waits_i ?]]
  NEW [[cause_o = !node_waits_i ?]])
mutant(tally_skips_a_cause FILE rtl/cells/rc_cause_counters.sv TEST unit "model and rtl of the machine count the same"
  OLD [[counts_q ? count_o + 1'b1 : '0;]]
  NEW [[counts_q ? count_o + {{(rc_pkg::TallyBits-1){1'b0}}, cause_q != 3'd5} : '0;]])
mutant(tally_is_not_cleared FILE rtl/cells/rc_cause_counters.sv TEST unit "model and rtl of the machine count the same"
  OLD [[if (counts_q || clear_i)]]
  NEW [[if (counts_q || (clear_i && counts_q))]])
mutant(counters_swap_group_and_unit FILE rtl/host/rc_counters.sv TEST unit "model and rtl of the machine count the same"
  OLD [[{4'(Group), 4'(Unit)}]]
  NEW [[{4'(Unit), 4'(Group)}]])
mutant(sched_cause_blames_dispatch FILE rtl/unit/sched/rc_sched.sv TEST unit [sched]
  OLD [[: at_hand ? rc_pkg::SchedStarvedContexts]]
  NEW [[: !at_hand ? rc_pkg::SchedStarvedContexts]])

# ---- doors and queues.
mutant(fifo_full_one_early FILE rtl/cells/rc_fifo_peek.sv TEST unit [box][lockstep]
  OLD [[assign ready_o = head_q != {~tail_q[IndexW], tail_q[IndexW-1:0]};]]
  NEW [[assign ready_o = tail_q - head_q < (IndexW+1)'(Depth - 1);]])
mutant(door_one_credit_more QUICK FILE rtl/cells/rc_credit_counter.sv TEST unit [tri][lockstep]
  OLD [[Full = CountW'(Credits);]]
  NEW [[Full = CountW'(Credits + 1);]])
mutant(merge_changes_its_mind FILE rtl/cells/rc_priority_merge.sv TEST unit [list][lockstep]
  OLD [[assign second         = held_q ? held_second_q : !first_valid_i;]]
  NEW [[assign second         = held_q && first_valid_i && held_second_q ? 1'b0 : !first_valid_i;]])
mutant(raygen_direction_rounded_down FILE rtl/unit/raygen/rc_direction.sv TEST unit [raygen]
  OLD [[assign rounded = whole + {{(M-1){1'b0}}, up};]]
  NEW [[assign rounded = whole + {{(M-1){1'b0}}, up && 1'b0};]])
mutant(raygen_direction_wraps FILE rtl/unit/raygen/rc_direction.sv TEST unit [raygen]
  OLD [[= !whole[M-1] && rounded[M-1] ? whole : rounded;]]
  NEW [[= rounded;]])
mutant(raygen_shift_off_by_one QUICK FILE rtl/unit/raygen/rc_direction.sv TEST unit [raygen]
  OLD [[if (s0_used[G-2-i]) s0_shift = S'(i);]]
  NEW [[if (s0_used[G-2-i]) s0_shift = i > 0 ? S'(i - 1) : '0;]])
mutant(raygen_shift_one_bit_short FILE rtl/unit/raygen/rc_direction.sv TEST unit [raygen]
  OLD [[s0_shift = S'(Most);]]
  NEW [[s0_shift = S'(Most - 1);]])
mutant(raygen_shift_of_the_last_axis FILE rtl/unit/raygen/rc_direction.sv TEST unit [raygen]
  OLD [[s0_used = s0_used | (s0_sum]]
  NEW [[s0_used = (s0_sum]])
mutant(raygen_shift_by_the_sums_sign FILE rtl/unit/raygen/rc_direction.sv TEST unit [raygen]
  OLD [[^ {(G-1){s0_sum[k*G+G-1]}});]]
  NEW [[^ {(G-1){s0_sum[G-1]}});]])

# ---- one cycle late, each unit.
mutant(raygen_one_cycle_late FILE rtl/unit/raygen/rc_raygen.sv TEST unit [raygen][lockstep]
  OLD [[  rc_fifo #(.Width(rc_pkg::RayW), .Depth(rc_pkg::RaygenQueue)) u_queue (
    .clk_i, .rst_ni, .valid_i(valid_q[Latency-1]), .ready_o(queue_ready), .data_i(queue_data),]]
  NEW [[  logic late_q;
  logic [rc_pkg::RayW-1:0] late_data_q;
  always_ff @(posedge clk_i) begin
    late_q      <= rst_ni && valid_q[Latency-1];
    late_data_q <= queue_data;
  end
  rc_fifo #(.Width(rc_pkg::RayW), .Depth(rc_pkg::RaygenQueue)) u_queue (
    .clk_i, .rst_ni, .valid_i(late_q), .ready_o(queue_ready), .data_i(late_data_q),]])
mutant(box_one_cycle_late FILE rtl/unit/trav/rc_node_answer.sv TEST unit [box][lockstep]
  OLD [[  rc_fifo #(.Width(rc_pkg::BoxRspW), .Depth(rc_pkg::BoxQueue)) u_queue (
    .clk_i, .rst_ni, .valid_i(end_valid_i), .ready_o(queue_ready), .data_i(queue_data),]]
  NEW [[  logic late_q;
  logic [rc_pkg::BoxRspW-1:0] late_data_q;
  always_ff @(posedge clk_i) begin
    late_q      <= rst_ni && end_valid_i;
    late_data_q <= queue_data;
  end
  rc_fifo #(.Width(rc_pkg::BoxRspW), .Depth(rc_pkg::BoxQueue)) u_queue (
    .clk_i, .rst_ni, .valid_i(late_q), .ready_o(queue_ready), .data_i(late_data_q),]])
mutant(tri_one_cycle_late FILE rtl/unit/isect/rc_tri.sv TEST unit [tri][lockstep]
  OLD [[  rc_fifo #(.Width(rc_pkg::TriRspW), .Depth(rc_pkg::TriQueue)) u_queue (
    .clk_i, .rst_ni, .valid_i(valid_q[L-1]), .ready_o(queue_ready), .data_i(queue_data),]]
  NEW [[  logic late_q;
  logic [rc_pkg::TriRspW-1:0] late_data_q;
  always_ff @(posedge clk_i) begin
    late_q      <= rst_ni && valid_q[L-1];
    late_data_q <= queue_data;
  end
  rc_fifo #(.Width(rc_pkg::TriRspW), .Depth(rc_pkg::TriQueue)) u_queue (
    .clk_i, .rst_ni, .valid_i(late_q), .ready_o(queue_ready), .data_i(late_data_q),]])
mutant(trav_one_cycle_late FILE rtl/unit/trav/rc_trav.sv TEST unit [trav][lockstep]
  OLD [[  rc_fifo_peek #(.Width(I), .Depth(T < 2 ? 2 : T), .Second(1)) u_done (
    .clk_i, .rst_ni, .valid_i(ends), .ready_o(done_place), .data_i(ends_ray),]]
  NEW [[  logic late_q;
  logic [I-1:0] late_ray_q;
  always_ff @(posedge clk_i) begin
    late_q     <= rst_ni && ends;
    late_ray_q <= ends_ray;
  end
  rc_fifo_peek #(.Width(I), .Depth(T < 2 ? 2 : T), .Second(1)) u_done (
    .clk_i, .rst_ni, .valid_i(late_q), .ready_o(done_place), .data_i(late_ray_q),]])
mutant(leafless_ray_one_cycle_late FILE rtl/unit/trav/rc_trav.sv TEST unit [trav][lockstep]
  OLD [[  rc_queue #(.Width(I + TB), .Depth(T)) u_leafless (
    .clk_i, .rst_ni, .push_i(leafless_fires), .data_i({leaves.ray, leaves_beat}),]]
  NEW [[  logic late_q;
  logic [I+TB-1:0] late_data_q;
  always_ff @(posedge clk_i) begin
    late_q      <= rst_ni && leafless_fires;
    late_data_q <= {leaves.ray, leaves_beat};
  end
  rc_queue #(.Width(I + TB), .Depth(T)) u_leafless (
    .clk_i, .rst_ni, .push_i(late_q), .data_i(late_data_q),]])
mutant(sched_one_cycle_late FILE rtl/unit/sched/rc_sched.sv TEST unit [sched][lockstep]
  OLD [[  rc_queue #(.Width(I), .Depth(T)) u_free (
    .clk_i, .rst_ni, .push_i(freed), .data_i(pixel_i.ray),]]
  NEW [[  logic late_q;
  logic [I-1:0] late_ray_q;
  always_ff @(posedge clk_i) begin
    late_q     <= rst_ni && freed;
    late_ray_q <= pixel_i.ray;
  end
  rc_queue #(.Width(I), .Depth(T)) u_free (
    .clk_i, .rst_ni, .push_i(late_q), .data_i(late_ray_q),]])

mutant(dispatch_one_cycle_late FILE rtl/unit/sched/rc_dispatch.sv TEST unit [dispatch][lockstep]
  OLD [[  assign give         = more_q && want_i != '0;]]
  NEW [[  logic late_q;
  always_ff @(posedge clk_i) late_q <= rst_ni && more_q;
  assign give         = more_q && late_q && want_i != '0;]])
mutant(arbiter_one_cycle_late FILE rtl/mem/rc_arbiter.sv TEST unit [machine][lockstep]
  OLD [[  assign valid_o  = valid_i != '0;]]
  NEW [[  logic late_q;
  always_ff @(posedge clk_i) late_q <= rst_ni && valid_i != '0;
  assign valid_o  = valid_i != '0 && late_q;]])

# ---- What every operand of a small width shows.
mutant(small_slab_distance_one_bit_short FILE rtl/engine/bvh/rc_slab.sv TEST unit [box][small]
  OLD [[localparam int unsigned D   = N + 1; ]]
  NEW [[localparam int unsigned D   = N; ]])
mutant(small_slab_saturation_wraps FILE rtl/engine/bvh/rc_slab.sv TEST unit [box][small]
  OLD [[over_q <= {V{1'b1}} << ready_move;]]
  NEW [[over_q <= {V{1'b1}} << 1 << ready_move;]])
mutant(small_slab_zero_is_rounded_up FILE rtl/engine/bvh/rc_slab.sv TEST unit [box][small]
  OLD [[assign s1_more = (s1_zero_q ? '0 : P'(s1_distance_q))]]
  NEW [[assign s1_more = P'(s1_distance_q)]])
mutant(small_recip_of_a_power_of_two FILE rtl/unit/raygen/rc_recip.sv TEST unit [raygen][small]
  OLD [[assign mag_power = (mag & (mag - 1'b1)) == '0;]]
  NEW [[assign mag_power = (mag & (mag - 1'b1)) == '0 && mag == '0;]])
mutant(small_raygen_halves_go_down FILE rtl/unit/raygen/rc_direction.sv TEST unit [raygen][small]
  OLD [[assign s1_up = s1_moved[G-M-1];]]
  NEW [[assign s1_up = s1_moved[G-M-1] && s1_moved[G-M-2:0] != '0;]])
mutant(small_edges_third_tie_turned FILE rtl/unit/isect/rc_edges.sv TEST unit [tri][small]
  OLD [[assign w_sign[k]  = holds && gen_cross[k].p1_q < gen_cross[k].p2_q;]]
  NEW [[assign w_sign[k]  = (k == 2) != (gen_cross[k].p1_q < gen_cross[k].p2_q);]])
mutant(small_tri_compares_the_cut_product FILE rtl/unit/isect/rc_tri.sv TEST unit [tri][small]
  OLD [[{f1_mine_q, 1'b0} < {f1_theirs_q, wide_first};]]
  NEW [[{f1_mine_q >> 1, 1'b0} < {f1_theirs_q >> 1, wide_first};]])

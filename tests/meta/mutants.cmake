# Faults that the tests must notice. Each row: a name, the file, the exact text (it must be there once), what takes its
# place, and the test program with its arguments. QUICK rows run by default, the others under the label slow.
# How: tests/meta/CMakeLists.txt. RTL rows change a copy of rtl/, model rows one source file of a second test program; a header's
# row names the sources WITH which it is compiled, and these are the test program.

# ---- box: conservative slabs, total order.
mutant(box_near_below_far QUICK FILE rtl/trav/rc_box.sv TEST unit [box][lockstep]
  OLD [[s4_hit_q[i] <= near <= far &&]]
  NEW [[s4_hit_q[i] <= near < far &&]])
mutant(slab_far_rounded_down QUICK FILE rtl/trav/rc_slab.sv TEST unit [box][lockstep]
  OLD [[s3_up_q    <= ~({R1{1'b1}} << s2_right[5:0]);]]
  NEW [[s3_up_q    <= '0;]])
mutant(slab_near_rounded_up FILE rtl/trav/rc_slab.sv TEST unit [box][lockstep]
  OLD [[near = scale($unsigned(s3_near_q), s3_left_q]]
  NEW [[near = scale($unsigned(s3_near_q) + {{(V-R1){1'b0}}, s3_up_q}, s3_left_q]])
mutant(slab_far_with_r QUICK FILE rtl/trav/rc_slab.sv TEST unit [box][lockstep]
  OLD [[assign s2_r_up = s2_r_q + {{(R1-1){1'b0}}, !s2_zero_q};]]
  NEW [[assign s2_r_up = s2_r_q;]])
mutant(slab_zero_direction FILE rtl/trav/rc_slab.sv TEST unit [box][lockstep]
  OLD [[(s3_zero_q && !s3_near_q[V-1] && s3_near_q != '0)]]
  NEW [[(s3_zero_q && !s3_near_q[V-1])]])
mutant(rank_ignores_offset QUICK FILE rtl/trav/rc_rank.sv TEST unit [box][lockstep]
  OLD [[if ((i ^ 1) > i && s5_key[i] > s5_key[i ^ 1]) begin]]
  NEW [[if ((i ^ 1) > i && s5_key[i][KeyW-1:O+C] > s5_key[i ^ 1][KeyW-1:O+C]) begin]])
mutant(rank_leaves_first FILE rtl/trav/rc_rank.sv TEST unit [box][lockstep]
  OLD [[{!s4_hit_i[i], s4_leaf, s4_near_i]]
  NEW [[{!s4_hit_i[i], !s4_leaf, s4_near_i]])

# ---- tri: exact decisions.
mutant(edges_zero_is_inside QUICK FILE rtl/isect/rc_edges.sv TEST unit [tri][lockstep]
  OLD [[s3_u_neg == s3_flip && s3_v_neg]]
  NEW [[(s3_u_q == '0 || s3_u_neg == s3_flip) && s3_v_neg]])
mutant(edges_tie_turned FILE rtl/isect/rc_edges.sv TEST unit [tri]
  OLD [[s3_p1x_q != s3_p2x_q ? s3_p1x_q < s3_p2x_q :]]
  NEW [[s3_p1x_q != s3_p2x_q ? s3_p1x_q > s3_p2x_q :]])
mutant(edges_normal_one_bit_short QUICK FILE rtl/isect/rc_edges.sv TEST unit "tri is exact at the corners of the lattice*"
  OLD [[localparam int unsigned X = 2 * D + 1;]]
  NEW [[localparam int unsigned X = 2 * D - 2;]])
mutant(edges_product_one_bit_short FILE rtl/isect/rc_edges.sv TEST unit "tri is exact at the corners of the lattice*"
  OLD [[localparam int unsigned C = M + D + 1;]]
  NEW [[localparam int unsigned C = M + D - 1;]])
mutant(edges_origin_counts FILE rtl/isect/rc_edges.sv TEST unit [tri]
  OLD [[&& s3_num_q != '0 && s3_num_q[U-1] == s3_flip]]
  NEW [[&& (s3_num_q == '0 || s3_num_q[U-1] == s3_flip)]])
mutant(tri_higher_number_wins QUICK FILE rtl/isect/rc_tri.sv TEST unit "tri keeps the nearer hit*"
  OLD [[s5_first_q <= s4_prim <= s4_best_prim;]]
  NEW [[s5_first_q <= s4_prim >= s4_best_prim;]])
mutant(tri_equal_is_not_closer FILE rtl/isect/rc_tri.sv TEST unit [tri]
  OLD [[(s5_mine_q == s5_theirs_q && s5_first_q)]]
  NEW [[(s5_mine_q == s5_theirs_q && s5_first_q && s5_mine_q == '0)]])
mutant(hitdiv_t_rounded_down QUICK FILE rtl/isect/rc_hitdiv.sv TEST unit [tri][lockstep]
  OLD [[t_down + {{(T-1){1'b0}}, t_up}]]
  NEW [[t_down + {{(T-1){1'b0}}, t_up && 1'b0}]])
mutant(hitdiv_u_v_swapped FILE rtl/isect/rc_tri.sv TEST unit [tri][lockstep]
  OLD [[.u_i(s6_u_q), .v_i(s6_v_q),]]
  NEW [[.u_i(s6_v_q), .v_i(s6_u_q),]])

# ---- trav, list, sched: who goes where.
mutant(stack_below_of_top_only QUICK FILE rtl/trav/rc_stack.sv TEST unit [trav][lockstep]
  OLD [[below = top_near[T-1:0] < top_below ? top_near[T-1:0] : top_below;]]
  NEW [[below = top_near[T-1:0];]])
mutant(stack_pop_writes_one_up FILE rtl/trav/rc_stack.sv TEST unit [trav][lockstep]
  OLD [[level    = s1_height_q - H'(1);]]
  NEW [[level    = s1_height_q;]])
mutant(stack_equal_does_not_matter FILE rtl/trav/rc_stack.sv TEST unit [trav]
  OLD [[assign top_matters  = top_near[T-1:0] <= s1_step_i.t_best;]]
  NEW [[assign top_matters  = top_near[T-1:0] < s1_step_i.t_best;]])
mutant(stack_gives_up_early FILE rtl/trav/rc_stack.sv TEST unit [trav][lockstep]
  OLD [[top_below > s1_step_i.t_best]]
  NEW [[top_below >= s1_step_i.t_best]])
mutant(list_skips_last_triangle QUICK FILE rtl/list/rc_list.sv TEST unit [list][lockstep]
  OLD [[assign more_triangles = cursor_triangle + C'(1) <]]
  NEW [[assign more_triangles = cursor_triangle + C'(2) <]])
mutant(list_ignores_t_best FILE rtl/list/rc_list.sv TEST unit [list][lockstep]
  OLD [[&& group_near[at_next*TB +: TB] <= tri_t;]]
  NEW [[&& (group_near[at_next*TB +: TB] <= tri_t || tri_t != '0);]])
mutant(list_keeps_old_hit FILE rtl/list/rc_list.sv TEST unit [list][lockstep]
  OLD [[if (ray_fires_i) found_q[ray_i.ray] <= 1'b0;]]
  NEW [[if (ray_fires_i && !closer) found_q[ray_i.ray] <= 1'b0;]])
mutant(sched_frees_another_context QUICK FILE rtl/sched/rc_sched.sv TEST unit [sched][lockstep]
  OLD [[.push_i(freed), .data_i(closest_i.ray)]]
  NEW [[.push_i(freed), .data_i(closest_i.ray ^ I'(1))]])
mutant(sched_one_row_more FILE rtl/sched/rc_sched.sv TEST unit [sched]
  OLD [[{1'b0, y} < frame_i.height;]]
  NEW [[{1'b0, y} <= frame_i.height;]])
mutant(sched_order_transposed FILE rtl/sched/rc_sched.sv TEST unit [sched]
  OLD [[      assign x[i] = at_q[2*i];
      assign y[i] = at_q[2*i+1];]]
  NEW [[      assign y[i] = at_q[2*i];
      assign x[i] = at_q[2*i+1];]])
mutant(sched_waits_outside FILE rtl/sched/rc_sched.sv TEST unit [sched]
  OLD [[else if (give || pass)  at_q]]
  NEW [[else if (give)          at_q]])
mutant(sched_keeps_the_last_frames_tile FILE rtl/sched/rc_sched.sv TEST unit [sched]
  OLD [[if (!rst_ni || start_i) at_q <= '0;]]
  NEW [[if (!rst_ni) at_q <= '0;]])
mutant(dispatch_one_row_more QUICK FILE rtl/sched/rc_dispatch.sv TEST unit [dispatch]
  OLD [[<< rc_pkg::TileBits >= frame_i.height;]]
  NEW [[<< rc_pkg::TileBits > frame_i.height;]])
mutant(dispatch_same_again FILE rtl/sched/rc_dispatch.sv TEST unit [dispatch]
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
  OLD [[.clk_i, .rst_ni, .valid_i(miss_valid), .ready_o(miss_ready)]]
  NEW [[.clk_i, .rst_ni, .valid_i(miss_valid & {P{2'b01}}), .ready_o(miss_ready)]])
mutant(sched_loses_hits_of_used_contexts FILE rtl/sched/rc_sched.sv TEST unit [machine][lockstep]
  OLD [[assign hit_valid_o     = closest_valid_i;]]
  NEW [[assign hit_valid_o     = closest_valid_i && fresh;]])
mutant(tally_of_box_blames_trav QUICK FILE rtl/rc_pipeline.sv TEST unit "model and rtl of the machine count the same"
  OLD [[(box_req_ready ? 3'd0 : 3'd3) : node_waits ? 3'd1 : 3'd2;]]
  NEW [[(box_req_ready ? 3'd0 : 3'd3) : node_waits ? 3'd2 : 3'd1;]])
mutant(tally_skips_a_cause FILE rtl/prim/rc_tally.sv TEST unit "model and rtl of the machine count the same"
  OLD [[count_q[cause_i] + 1'b1;]]
  NEW [[count_q[cause_i] + {{(CountW-1){1'b0}}, cause_i != 3'd5};]])
mutant(sched_cause_blames_dispatch FILE rtl/sched/rc_sched.sv TEST unit [sched]
  OLD [[: pixel_valid ? 3'd1 : 3'd2;]]
  NEW [[: !pixel_valid ? 3'd1 : 3'd2;]])

# ---- doors and queues.
mutant(fifo_full_one_early QUICK FILE rtl/prim/rc_fifo.sv TEST unit [box][lockstep]
  OLD [[assign ready_o = head_q != {~tail_q[IndexW], tail_q[IndexW-1:0]};]]
  NEW [[assign ready_o = tail_q - head_q < (IndexW+1)'(Depth - 1);]])
mutant(door_one_credit_more QUICK FILE rtl/prim/rc_door.sv TEST unit [tri][lockstep]
  OLD [[Full = CountW'(Credits);]]
  NEW [[Full = CountW'(Credits + 1);]])
mutant(merge_changes_its_mind FILE rtl/prim/rc_merge.sv TEST unit [list][lockstep]
  OLD [[assign second         = held_q ? held_second_q : !first_valid_i;]]
  NEW [[assign second         = held_q && first_valid_i && held_second_q ? 1'b0 : !first_valid_i;]])
mutant(raygen_direction_rounded_down FILE rtl/raygen/rc_raygen.sv TEST unit [raygen]
  OLD [[$signed({{(M){1'b0}}, 1'b1, {(rc_pkg::GuardBits-1){1'b0}}});]]
  NEW [[$signed({{(M){1'b0}}, 1'b0, {(rc_pkg::GuardBits-1){1'b0}}});]])

# ---- one cycle late, each unit.
mutant(raygen_one_cycle_late FILE rtl/raygen/rc_raygen.sv TEST unit [raygen][lockstep]
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
mutant(box_one_cycle_late QUICK FILE rtl/trav/rc_box.sv TEST unit [box][lockstep]
  OLD [[  rc_fifo #(.Width(rc_pkg::BoxRspW), .Depth(rc_pkg::BoxQueue)) u_queue (
    .clk_i, .rst_ni, .valid_i(valid_q[L-1]), .ready_o(queue_ready), .data_i(queue_data),]]
  NEW [[  logic late_q;
  logic [rc_pkg::BoxRspW-1:0] late_data_q;
  always_ff @(posedge clk_i) begin
    late_q      <= rst_ni && valid_q[L-1];
    late_data_q <= queue_data;
  end
  rc_fifo #(.Width(rc_pkg::BoxRspW), .Depth(rc_pkg::BoxQueue)) u_queue (
    .clk_i, .rst_ni, .valid_i(late_q), .ready_o(queue_ready), .data_i(late_data_q),]])
mutant(tri_one_cycle_late FILE rtl/isect/rc_tri.sv TEST unit [tri][lockstep]
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
mutant(trav_one_cycle_late FILE rtl/trav/rc_trav.sv TEST unit [trav][lockstep]
  OLD [[  rc_queue #(.Width(I), .Depth(T)) u_done (
    .clk_i, .rst_ni, .push_i(done), .data_i(s1_step.ray),]]
  NEW [[  logic late_q;
  logic [I-1:0] late_ray_q;
  always_ff @(posedge clk_i) begin
    late_q     <= rst_ni && done;
    late_ray_q <= s1_step.ray;
  end
  rc_queue #(.Width(I), .Depth(T)) u_done (
    .clk_i, .rst_ni, .push_i(late_q), .data_i(late_ray_q),]])
mutant(list_one_cycle_late FILE rtl/list/rc_list.sv TEST unit [list][lockstep]
  OLD [[  rc_queue #(.Width(I + TB), .Depth(T)) u_leafless (
    .clk_i, .rst_ni, .push_i(in_fires && !in_leaf), .data_i({in.ray, in_t}),]]
  NEW [[  logic late_q;
  logic [I+TB-1:0] late_data_q;
  always_ff @(posedge clk_i) begin
    late_q      <= rst_ni && in_fires && !in_leaf;
    late_data_q <= {in.ray, in_t};
  end
  rc_queue #(.Width(I + TB), .Depth(T)) u_leafless (
    .clk_i, .rst_ni, .push_i(late_q), .data_i(late_data_q),]])
mutant(sched_one_cycle_late FILE rtl/sched/rc_sched.sv TEST unit [sched][lockstep]
  OLD [[  rc_queue #(.Width(I), .Depth(T)) u_free (
    .clk_i, .rst_ni, .push_i(freed), .data_i(closest_i.ray),]]
  NEW [[  logic late_q;
  logic [I-1:0] late_ray_q;
  always_ff @(posedge clk_i) begin
    late_q     <= rst_ni && freed;
    late_ray_q <= closest_i.ray;
  end
  rc_queue #(.Width(I), .Depth(T)) u_free (
    .clk_i, .rst_ni, .push_i(late_q), .data_i(late_ray_q),]])

mutant(dispatch_one_cycle_late FILE rtl/sched/rc_dispatch.sv TEST unit [dispatch][lockstep]
  OLD [[  assign give         = more_q && want_i != '0;]]
  NEW [[  logic late_q;
  always_ff @(posedge clk_i) late_q <= rst_ni && more_q;
  assign give         = more_q && late_q && want_i != '0;]])
mutant(arbiter_one_cycle_late FILE rtl/mem/rc_arbiter.sv TEST unit [machine][lockstep]
  OLD [[  assign valid_o  = valid_i != '0;]]
  NEW [[  logic late_q;
  always_ff @(posedge clk_i) late_q <= rst_ni && valid_i != '0;
  assign valid_o  = valid_i != '0 && late_q;]])

# ---- caches: who waits, which line goes, what is read.
mutant(cache_one_cycle_late FILE rtl/mem/rc_cache.sv TEST unit "a hit is answered exactly*"
  OLD [[  rc_fifo #(.Width(IdBits + PartW), .Depth(Queue)) u_answers (
    .clk_i, .rst_ni, .valid_i(s1_valid_q), .ready_o(rsp_place), .data_i({s1_id_q, s1_data}),]]
  NEW [[  logic late_q;
  logic [IdBits+PartW-1:0] late_data_q;
  always_ff @(posedge clk_i) begin
    late_q      <= rst_ni && s1_valid_q;
    late_data_q <= {s1_id_q, s1_data};
  end
  rc_fifo #(.Width(IdBits + PartW), .Depth(Queue)) u_answers (
    .clk_i, .rst_ni, .valid_i(late_q), .ready_o(rsp_place), .data_i(late_data_q),]])
mutant(cache_line_filled_one_cycle_late FILE rtl/mem/rc_mshr.sv TEST unit "a miss asks memory*"
  OLD [[  rc_queue #(.Width(MshrW + SetW + WayW), .Depth(Mshrs)) u_filled (
    .clk_i, .rst_ni, .push_i(filled), .data_i({fill_mshr_i, fill_set_o, fill_way_o}),]]
  NEW [[  logic late_q;
  logic [MshrW+SetW+WayW-1:0] late_data_q;
  always_ff @(posedge clk_i) begin
    late_q      <= rst_ni && filled;
    late_data_q <= {fill_mshr_i, fill_set_o, fill_way_o};
  end
  rc_queue #(.Width(MshrW + SetW + WayW), .Depth(Mshrs)) u_filled (
    .clk_i, .rst_ni, .push_i(late_q), .data_i(late_data_q),]])
mutant(cache_hit_reads_wrong_way FILE rtl/mem/rc_cache.sv TEST unit [cache]
  OLD [[place(set, way, read_word)]]
  NEW [[place(set, way & WayW'(Ways - 2), read_word)]])
mutant(cache_fill_in_wrong_word FILE rtl/mem/rc_cache.sv TEST unit [cache]
  OLD [[fill_id_i[WordW-1:0] & WordW'(Words - 1)]]
  NEW [[~fill_id_i[WordW-1:0] & WordW'(Words - 1)]])
mutant(cache_wrong_half FILE rtl/mem/rc_cache.sv TEST unit [cache]
  OLD [[s1_part_q ? gen_part[1].data : gen_part[0].data]]
  NEW [[s1_part_q ? gen_part[0].data : gen_part[1].data]])
mutant(cache_waiter_gets_word_of_the_head FILE rtl/mem/rc_cache.sv TEST unit [cache]
  OLD [[.write_i(merge || miss), .write_addr_i(id)]]
  NEW [[.write_i(miss), .write_addr_i(id)]])
mutant(cache_looks_up_without_a_place FILE rtl/mem/rc_cache.sv TEST unit [cache]
  OLD [[assign look  = valid && !draining && open;]]
  NEW [[assign look  = valid && !draining;]])
mutant(tags_touch_turned QUICK FILE rtl/mem/rc_tags.sv TEST unit "a set gives up*"
  OLD [[= !way_o[Levels-1-l];]]
  NEW [[= way_o[Levels-1-l];]])
mutant(tags_waiting_way_given_away FILE rtl/mem/rc_tags.sv TEST unit [cache]
  OLD [[: waiting_i[oldest] ? gen_way]]
  NEW [[: waiting_i[oldest] && 1'b0 ? gen_way]])
mutant(tags_highest_free_way FILE rtl/mem/rc_tags.sv TEST unit "a way that waits*"
  OLD [[assign lowest = gen_way[w-1].full ? WayW'(w) : gen_way[w-1].lowest;]]
  NEW [[assign lowest = !waiting_i[w] || gen_way[w-1].full ? WayW'(w) : gen_way[w-1].lowest;]])
mutant(tags_not_cleared FILE rtl/mem/rc_tags.sv TEST unit [cache][lockstep]
  OLD [[.clk_i, .write_i(!rst_ni || (take_i && way_o == WayW'(w))), .write_addr_i(write_set),]]
  NEW [[.clk_i, .write_i(take_i && way_o == WayW'(w)), .write_addr_i(write_set),]])
mutant(tags_tree_not_cleared FILE rtl/mem/rc_tags.sv TEST unit [cache][lockstep]
  OLD [[.clk_i, .write_i(!rst_ni || touch_i), .write_addr_i(write_set),]]
  NEW [[.clk_i, .write_i(touch_i), .write_addr_i(write_set),]])
mutant(mshr_chain_loses_the_last QUICK FILE rtl/mem/rc_mshr.sv TEST unit "misses to one line*"
  OLD [[assign is_last    = head == tail;]]
  NEW [[assign is_last    = head == tail || next == tail;]])
mutant(mshr_tail_stays FILE rtl/mem/rc_mshr.sv TEST unit [cache]
  OLD [[.clk_i, .write_i(take_i || merge_i), .write_addr_i(take_i ? free_o : joined),]]
  NEW [[.clk_i, .write_i(take_i), .write_addr_i(take_i ? free_o : joined),]])
mutant(mshr_joins_any_of_the_set FILE rtl/mem/rc_mshr.sv TEST unit [cache]
  OLD [[assign match   = here && way_q == way_i ? MshrW'(m)]]
  NEW [[assign match   = here && (way_q == way_i || m > 0) ? MshrW'(m)]])
mutant(mshr_line_filled_one_word_early FILE rtl/mem/rc_mshr.sv TEST unit [cache]
  OLD [[words == WordW'(Words - 1);]]
  NEW [[words == WordW'(Words - 2);]])
mutant(mshr_words_not_cleared FILE rtl/mem/rc_mshr.sv TEST unit [cache]
  OLD [[words_q[m] <= '0;]]
  NEW [[words_q[m] <= words_q[m];]])
mutant(mshr_highest_is_taken FILE rtl/mem/rc_mshr.sv TEST unit [cache][lockstep]
  OLD [[assign free    = gen_mshr[m-1].full ? MshrW'(m) : gen_mshr[m-1].free;]]
  NEW [[assign free    = !busy_q || gen_mshr[m-1].full ? MshrW'(m) : gen_mshr[m-1].free;]])

# ---- The model and scene compilation.
mutant(model_tri_epsilon QUICK FILE model/isect/tri.cpp TEST unit [tri]
  OLD [[if (num <= 0) return;]]
  NEW [[if (num <= size >> 12) return;]])
mutant(model_tri_tie_turned QUICK FILE model/isect/tri.cpp TEST unit [tri]
  OLD [[edge != 0 ? edge : gradient[0] != 0 ? gradient[0] :]]
  NEW [[edge != 0 ? edge : gradient[0] != 0 ? -gradient[0] :]])
mutant(model_tri_higher_number_wins FILE model/isect/tri.cpp TEST unit [tri]
  OLD [[triangle.prim > best.prim]]
  NEW [[triangle.prim < best.prim]])
mutant(model_tri_t_rounded_down FILE model/isect/tri.hpp WITH model/isect/tri.cpp TEST unit [tri]
  OLD [[q.whole + q.rest]]
  NEW [[q.whole]])
mutant(model_box_near_rounded_up FILE model/trav/slab.inl WITH model/trav/box.cpp TEST unit [box]
  OLD [[near_0 = round_down(]]
  NEW [[near_0 = round_up(]])
mutant(model_box_far_with_r QUICK FILE model/trav/slab.hpp WITH model/trav/box.cpp TEST unit [box]
  OLD [[std::int32_t(ray.recip[k]) + (ray.len[k] != 0));]]
  NEW [[std::int32_t(ray.recip[k]));]])
mutant(model_raygen_direction_rounded_down FILE model/raygen/raygen.cpp TEST unit [raygen]
  OLD [[(sum + (std::int64_t(1) << (guard_bits - 1))) >> guard_bits]]
  NEW [[sum >> guard_bits]])
mutant(model_list_skips_last_triangle FILE model/list/leaves.cpp TEST unit [list]
  OLD [[if (triangle_ + 1 < group_.count]]
  NEW [[if (triangle_ + 2 < group_.count]])
mutant(model_trav_gives_up_early FILE model/trav/stack.cpp TEST unit [trav]
  OLD [[top.below > t_best]]
  NEW [[top.below >= t_best]])
mutant(model_trav_equal_does_not_matter FILE model/trav/stack.cpp TEST unit [trav]
  OLD [[if (top.t_near[0] <= t_best) {]]
  NEW [[if (top.t_near[0] < t_best) {]])
mutant(model_child_box_rounded_inward QUICK FILE model/accel/encode.cpp TEST accel ~[none]
  OLD [[node.hi[3 * i + k] = ceil_shift(std::uint32_t(children[i].box.hi[k] - node.org[k]), node.exp[k]);]]
  NEW [[node.hi[3 * i + k] = std::uint32_t(children[i].box.hi[k] - node.org[k]) >> node.exp[k];]])
mutant(model_lattice_rounds_down FILE model/accel/lattice.cpp TEST accel ~[none]
  OLD [[std::round((point[k] - centre[k]) / pitch)]]
  NEW [[std::floor((point[k] - centre[k]) / pitch)]])
mutant(model_cache_touch_turned FILE model/mem/cache.cpp TEST unit "a set gives up*"
  OLD [[if (!(node & 1)) turn_]]
  NEW [[if (node & 1) turn_]])
mutant(model_cache_waiting_way_given_away FILE model/mem/cache.cpp TEST unit "a way that waits*"
  OLD [[if (of_set[way].mshr == 0) return int(way);]]
  NEW [[if (of_set[way].mshr == 0 || way > 0) return int(way);]])
mutant(model_cache_chain_turned FILE model/mem/cache.hpp WITH tests/unit/cache_test.cpp model/mem/cache.cpp TEST unit "misses to one line*"
  OLD [[        next_[mshrs_[m - 1].tail] = request.id;
        mshrs_[m - 1].tail = request.id;]]
  NEW [[        Mshr& chain = mshrs_[m - 1];
        if (chain.head == chain.tail) chain.tail = request.id;
        next_[request.id] = next_[chain.head];
        next_[chain.head] = request.id;]])

# ---- The model in time: headers, and the machine around them.
mutant(model_frame_one_row_less FILE model/sched/dispatch.hpp WITH tests/unit/dispatch_test.cpp TEST unit [dispatch]
  OLD [[if (++tile_.y == rows_) more_ = false;]]
  NEW [[if (++tile_.y + 1 == rows_) more_ = false;]])
mutant(model_sched_order_wrong QUICK FILE model/sched/sched.hpp WITH tests/unit/sched_test.cpp TEST unit [sched]
  OLD [[<< tile_bits_ | even_bits(at_ >> 1);]]
  NEW [[<< tile_bits_ | even_bits(at_ >> 2);]])
mutant(model_trav_takes_a_step_in_a_second_turn FILE model/trav/trav.hpp WITH tests/unit/trav_test.cpp TEST unit [trav]
  OLD [[bool step_ready() const { return !again_; }]]
  NEW [[bool step_ready() const { return true; }]])
mutant(model_list_queues_mixed FILE model/list/list.hpp WITH tests/unit/list_test.cpp TEST unit [list][lockstep]
  OLD [[(tri_prim ? next_ : tested_).push(]]
  NEW [[(tri_prim ? first_ : tested_).push(]])
mutant(model_arbiter_changes_its_mind FILE model/mem/arbiter.hpp WITH tests/unit/arbiter_test.cpp TEST unit [arbiter]
  OLD [[if (held_) return chosen_;]]
  NEW [[if (held_ && valid == 0) return chosen_;]])
mutant(model_memport_answers_late FILE model/mem/memport.cpp TEST unit [memport]
  OLD [[now_ + latency_]]
  NEW [[now_ + latency_ + 1]])
mutant(model_sched_keeps_the_last_frames_pixel FILE model/sched/sched.hpp WITH tests/unit/sched_test.cpp TEST unit [sched]
  OLD [[        height_ = frame.height;
        look();]]
  NEW [[        height_ = frame.height;]])
mutant(model_blames_trav FILE model/pipeline.hpp WITH tests/unit/machine_test.cpp model/machine.cpp model/pipeline.cpp TEST unit "model and rtl of the machine count the same"
  OLD [[: node_cache_.waits() ? 1 : 2;]]
  NEW [[: node_cache_.waits() ? 2 : 1;]])
mutant(model_sleeps_through_an_answer QUICK FILE model/machine.cpp TEST unit "idle cycles that are passed over*"
  OLD [[wake = std::min(wake, memory_.quiet_until());]]
  NEW [[wake = std::min(wake, memory_.quiet_until() + 1);]])
mutant(model_sleeps_beside_an_l2 FILE model/machine.cpp TEST unit "idle cycles that are passed over*"
  OLD [[if (l2_deed_ <= CacheDeed::drain) return;]]
  NEW [[]])
mutant(model_where_forgets_trav FILE model/pipeline.cpp TEST unit [stuck]
  OLD [[    if (const char* place = trav_.where(ray)) return place;
]]
  NEW [[]])
mutant(model_takes_no_hit FILE model/pipeline.hpp WITH tests/unit/machine_test.cpp model/machine.cpp model/pipeline.cpp TEST unit "a machine makes*"
  OLD [[if ((m.hit = trav_.done_valid() && sink_.ready()))]]
  NEW [[if ((m.hit = trav_.done_valid() && sink_.ready() && trav_.done_ray() != 7))]])
mutant(model_trace_forgets_turns FILE model/trace/record.inl WITH model/trace/record.cpp TEST unit [trace]
  OLD [[flags |= turns << Trace::turns_shift;]]
  NEW [[flags |= std::uint32_t(turns > 0) << Trace::turns_shift;]])

# ---- DRAM: gates between commands, refresh, and the order of requests.
mutant(dram_trrd_ignored QUICK FILE model/mem/dram_banks.cpp TEST unit [dram]
  OLD [[activate_ = clock + trrd_;]]
  NEW [[activate_ = clock + 1;]])
mutant(dram_tras_ignored FILE model/mem/dram_banks.cpp TEST unit [dram]
  OLD [[own.precharge = clock + tras_;]]
  NEW [[own.precharge = clock + 1;]])
mutant(dram_never_refreshes FILE model/mem/dram.cpp TEST unit [dram]
  OLD [[refresh_at_(trefi_),]]
  NEW [[refresh_at_(trefi_ << 24),]])
mutant(dram_hit_across_rows FILE model/mem/dram.cpp TEST unit [dram]
  OLD [[if (banks_.is_open(e.bank) && banks_.row(e.bank) == e.row) {]]
  NEW [[if (banks_.is_open(e.bank)) {]])
mutant(dram_starves FILE model/mem/dram.cpp TEST unit [dram]
  OLD [[if (e.overtaken >= part_.age_cap) break;]]
  NEW [[if (e.overtaken > part_.age_cap) break;]])

# ---- The same, judged by whole frames against exact integers: that test has an edge of its own.
mutant(frames_tri_tie_turned FILE model/isect/tri.cpp TEST system "every pixel*"
  OLD [[edge != 0 ? edge : gradient[0] != 0 ? gradient[0] :]]
  NEW [[edge != 0 ? edge : gradient[0] != 0 ? -gradient[0] :]])
mutant(frames_child_box_rounded_inward FILE model/accel/encode.cpp TEST system "every pixel*"
  OLD [[node.hi[3 * i + k] = ceil_shift(std::uint32_t(children[i].box.hi[k] - node.org[k]), node.exp[k]);]]
  NEW [[node.hi[3 * i + k] = std::uint32_t(children[i].box.hi[k] - node.org[k]) >> node.exp[k];]])
mutant(frames_list_skips_last_triangle FILE model/list/leaves.cpp TEST system "every pixel*"
  OLD [[if (triangle_ + 1 < group_.count]]
  NEW [[if (triangle_ + 2 < group_.count]])

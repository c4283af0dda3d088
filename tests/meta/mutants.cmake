# Faults that the tests must notice. Each row: a name, the file, the exact text (it must be there once), what takes its
# place, and the test program with its arguments. QUICK rows run by default, the others under the label slow.
# How: tests/meta/CMakeLists.txt. RTL rows change a copy of rtl/, model rows one source file of a second test program.

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
  OLD [[assign last_y = {1'b0, y_q} + 1'b1 == frame_i.height;]]
  NEW [[assign last_y = {1'b0, y_q} == frame_i.height;]])
mutant(top_pops_without_asking FILE rtl/rc_top.sv TEST system "model and RTL agree for every memory and every back-pressure"
  OLD [[.closest_ready_i(closest_ready)]]
  NEW [[.closest_ready_i(closest_ready || closest.found)]])

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
mutant(model_tri_t_rounded_down FILE model/isect/tri.cpp TEST unit [tri]
  OLD [[(scaled + size - 1) / size]]
  NEW [[scaled / size]])
mutant(model_box_near_rounded_up FILE model/trav/box.cpp TEST unit [box]
  OLD [[(distance * r) >> e]]
  NEW [[-((-distance * r) >> e)]])
mutant(model_box_far_with_r QUICK FILE model/trav/box.cpp TEST unit [box]
  OLD [[r_up = r + (ray.len[k] != 0);]]
  NEW [[r_up = r;]])
mutant(model_raygen_direction_rounded_down FILE model/raygen/raygen.cpp TEST unit [raygen]
  OLD [[(sum + (std::int64_t(1) << (guard_bits - 1))) >> guard_bits]]
  NEW [[sum >> guard_bits]])
mutant(model_list_skips_last_triangle FILE model/list/list.cpp TEST unit [list]
  OLD [[if (at.triangle + 1 < group.count]]
  NEW [[if (at.triangle + 2 < group.count]])
mutant(model_trav_gives_up_early FILE model/trav/trav.cpp TEST unit [trav]
  OLD [[top.below > t_best]]
  NEW [[top.below >= t_best]])
mutant(model_trav_equal_does_not_matter FILE model/trav/trav.cpp TEST unit [trav]
  OLD [[if (top.t_near[0] <= t_best) {]]
  NEW [[if (top.t_near[0] < t_best) {]])
mutant(model_child_box_rounded_inward QUICK FILE model/accel/encode.cpp TEST accel ~[none]
  OLD [[node.hi[3 * i + k] = ceil_shift(std::uint32_t(children[i].box.hi[k] - node.org[k]), node.exp[k]);]]
  NEW [[node.hi[3 * i + k] = std::uint32_t(children[i].box.hi[k] - node.org[k]) >> node.exp[k];]])
mutant(model_lattice_rounds_down FILE model/accel/lattice.cpp TEST accel ~[none]
  OLD [[std::round((point[k] - centre[k]) / pitch)]]
  NEW [[std::floor((point[k] - centre[k]) / pitch)]])
mutant(model_frame_one_row_less FILE model/sched/sched.cpp TEST unit [sched]
  OLD [[if (++y_ == height_) more_ = false;]]
  NEW [[if (++y_ + 1 == height_) more_ = false;]])

# ---- The same, judged by whole frames against exact integers: that test has an edge of its own.
mutant(frames_tri_tie_turned FILE model/isect/tri.cpp TEST system "every pixel*"
  OLD [[edge != 0 ? edge : gradient[0] != 0 ? gradient[0] :]]
  NEW [[edge != 0 ? edge : gradient[0] != 0 ? -gradient[0] :]])
mutant(frames_child_box_rounded_inward FILE model/accel/encode.cpp TEST system "every pixel*"
  OLD [[node.hi[3 * i + k] = ceil_shift(std::uint32_t(children[i].box.hi[k] - node.org[k]), node.exp[k]);]]
  NEW [[node.hi[3 * i + k] = std::uint32_t(children[i].box.hi[k] - node.org[k]) >> node.exp[k];]])
mutant(frames_list_skips_last_triangle FILE model/list/list.cpp TEST system "every pixel*"
  OLD [[if (at.triangle + 1 < group.count]]
  NEW [[if (at.triangle + 2 < group.count]])

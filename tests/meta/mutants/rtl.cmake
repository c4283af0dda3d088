# Faults that the tests must notice: RTL. A row has a name, the file, the exact text (which must occur exactly
# once), its replacement, and the test program with its arguments. QUICK rows run by default, the others have
# the label slow. A row of the RTL changes a copy of rtl/. A row of the model or the program changes one
# source file of a second test program. If that file is a header, the row names the sources to compile WITH
# it; tests among them replace the program's. tests/README.md says which faults get a row.
# tests/meta/CMakeLists.txt defines mutant().

# ---- Boxes: < for <=, and widths at their ends.
mutant(box_near_below_far QUICK FILE rtl/engine/bvh/rc_box.sv TEST unit [box][lockstep]
  OLD [[= enter <= leave &&]]
  NEW [[= enter < leave &&]])
mutant(small_slab_distance_one_bit_short FILE rtl/engine/bvh/rc_slab.sv TEST unit [box][small]
  OLD [[localparam int unsigned DistanceW = N + 1; ]]
  NEW [[localparam int unsigned DistanceW = N; ]])
mutant(small_slab_saturation_wraps FILE rtl/engine/bvh/rc_slab.sv TEST unit [box][small]
  OLD [[over_q <= {SumW{1'b1}} << ready_move;]]
  NEW [[over_q <= {SumW{1'b1}} << 1 << ready_move;]])

# ---- Triangles: exact decisions at the corners of the lattice, and the first of equal hits.
mutant(edges_normal_one_bit_short FILE rtl/unit/tri/rc_edges.sv TEST unit
  "tri is exact at the corners of the lattice*"
  OLD [[localparam int unsigned EdgeCrossW  = 2 * DiffW + 1;]]
  NEW [[localparam int unsigned EdgeCrossW  = 2 * DiffW - 2;]])
mutant(small_edges_third_tie_turned FILE rtl/unit/tri/rc_edges.sv TEST unit [tri][small]
  OLD [[assign w_sign[k]  = holds && gen_cross[k].p1_q < gen_cross[k].p2_q;]]
  NEW [[assign w_sign[k]  = (k == 2) != (gen_cross[k].p1_q < gen_cross[k].p2_q);]])
mutant(tri_equal_is_not_closer FILE rtl/unit/tri/rc_tri.sv TEST unit [tri]
  OLD [[{f1_theirs_q, wide_first}]]
  NEW [[{f1_theirs_q, wide_first && f1_mine_q == '0}]])
mutant(small_tri_compares_the_cut_product FILE rtl/unit/tri/rc_tri.sv TEST unit [tri][small]
  OLD [[{f1_mine_q, 1'b0} < {f1_theirs_q, wide_first};]]
  NEW [[{f1_mine_q >> 1, 1'b0} < {f1_theirs_q >> 1, wide_first};]])
mutant(hitdiv_t_wraps FILE rtl/unit/tri/rc_hitdiv.sv TEST unit "t ends where its bits do - Rtl*"
  OLD [[assign t_o = end_beyond || (&t_down)]]
  NEW [[assign t_o = (end_beyond && 1'b0) || (&t_down)]])

# ---- Spheres: the last bit of a root, exact contact, and the sphere that a ray leaves.
mutant(sphere_far_root_rounded_down FILE rtl/unit/tri/rc_sphere.sv TEST unit
  "tri of a chip that shades decides exactly and measures within its bound - Rtl*"
  OLD [[far_q[AtR] && (r_inexact || r_lost)};]]
  NEW [[far_q[AtR] && (r_inexact || r_lost) && 1'b0};]])
mutant(sphere_forgets_what_was_cut FILE rtl/unit/tri/rc_sphere.sv TEST unit
  "a discriminant next to a square is not*"
  OLD [[far_q[AtR] && (r_inexact || r_lost)};]]
  NEW [[far_q[AtR] && (r_inexact || (r_lost && 1'b0))};]])
mutant(sphere_disc_one_bit_short FILE rtl/unit/tri/rc_sphere.sv TEST unit
  "tri of a chip that shades is exact at the ends of every width - Rtl*"
  OLD [[? 2 * (M + OriginWidth) + 2 : 2 * (N + OriginWidth) + 4;]]
  NEW [[? 2 * (M + OriginWidth) + 1 : 2 * (N + OriginWidth) + 3;]])
mutant(sphere_own_is_met FILE rtl/unit/tri/rc_sphere.sv TEST unit "the sphere test distinguishes inside*"
  OLD [[assign s3_goes  = (!s3_own || s3_inside)]]
  NEW [[assign s3_goes  = (!s3_own || s3_inside || s3_outside)]])
mutant(sphere_touched_at_the_end_blocks FILE rtl/unit/tri/rc_sphere.sv
  TEST unit "a sphere that is touched where a shadow ray ends is not in its way - Rtl*"
  OLD [[!sum_foot[Foot-1] && sum_foot != '0, sum_end[PowerW-1],]]
  NEW [[!sum_foot[Foot-1], sum_end[PowerW-1],]])

# ---- Traversal, lists, tiles and camera rays: state that belongs to another ray or frame.
mutant(stack_below_of_top_only QUICK FILE rtl/unit/trav/rc_stack.sv TEST unit [trav][lockstep]
  OLD [[below = top_near[TBits-1:0] < top_below ? top_near[TBits-1:0] : top_below;]]
  NEW [[below = top_near[TBits-1:0];]])
mutant(list_goes_on_behind_a_blocker QUICK FILE rtl/unit/list/rc_list.sv TEST unit [list][shading]
  OLD [[(s2_more_triangles || s2_more_leaves) && !s2_blocked;]]
  NEW [[s2_more_triangles || (s2_more_leaves && !s2_blocked);]])
mutant(sched_frees_another_context FILE rtl/unit/sched/rc_sched.sv TEST unit [sched][lockstep]
  OLD [[.push_i(freed), .data_i(pixel_i.ray)]]
  NEW [[.push_i(freed), .data_i(pixel_i.ray ^ RayBits'(1))]])
mutant(sched_begins_a_frame_within_a_tile FILE rtl/unit/sched/rc_sched.sv TEST unit [sched]
  OLD [[if (!rst_ni || start_i) first_q <= 1'b1;]]
  NEW [[if (!rst_ni) first_q <= 1'b1;]])
mutant(raygen_shift_off_by_one FILE rtl/unit/raygen/rc_direction.sv TEST unit [raygen]
  OLD [[if (s0_used[GuardSumW-2-i]) s0_shift = ShiftW'(i);]]
  NEW [[if (s0_used[GuardSumW-2-i]) s0_shift = i > 0 ? ShiftW'(i - 1) : '0;]])
mutant(raygen_keeps_the_first_eye FILE rtl/unit/raygen/rc_raygen.sv TEST torture
  "model and RTL agree under torture"
  OLD [[assign eye    = frame_i.eye;]]
  NEW [[logic [3*rc_pkg::CoordBits-1:0] kept_q;
  logic is_kept_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) is_kept_q <= 1'b0;
    else if (slot_valid_i) is_kept_q <= 1'b1;
    if (!is_kept_q) kept_q <= frame_i.eye;
  end
  assign eye = is_kept_q ? kept_q : frame_i.eye;]])
mutant(sample_cell_not_reduced_twice FILE rtl/unit/raygen/rc_sample.sv TEST unit [raygen][shading]
  OLD [[take = once >= {1'b0, all} ? SampleBits'(once - {1'b0, all}) : SampleBits'(once);]]
  NEW [[take = once >= {1'b0, all} ? SampleBits'(once) : SampleBits'(once);]])

# ---- Shading: cells, a pass, and the contexts.
mutant(power_of_nothing FILE rtl/fixed/rc_power.sv TEST unit [power]
  OLD [[s5_none_q  <= s4_none_q ||]]
  NEW [[s5_none_q  <= (s4_none_q && s4_y_q[0]) ||]])
mutant(pass_pending_forgets_the_answer QUICK FILE rtl/unit/shade/pass/rc_pass_begin.sv TEST unit [pass][all]
  OLD [[(state_i.pending == rc_pkg::PendingAnswer && !found)]]
  NEW [[(state_i.pending == rc_pkg::PendingAnswer)]])
mutant(pass_end_slack_comes_late FILE rtl/unit/shade/pass/rc_pass_end.sv TEST unit [pass][interval]
  OLD [[  always_comb begin   // 3 (depth + 1), as a table: two additions before a comparison are long
    slack = '0;
    for (int i = 0; i < 1 << rc_pkg::DepthBits; i++)
      if (begin_state_i.depth == rc_pkg::DepthBits'(i)) slack = 6'(3 * i + 3);
  end]]
  NEW [[  rc_path_register #(.Width(6), .Stages(Cut)) u_slack (
    .clk_i, .data_i(6'd3 * ({2'd0, begin_state_i.depth} + 6'd1)), .data_o(slack));]])
mutant(side_in_the_plane_is_above FILE rtl/unit/shade/surface/rc_normal_side.sv TEST unit [pass][all]
  OLD [[&& sum != '0;]]
  NEW [[&& sum[ProductW:0] != '1;]])
mutant(finish_contrast_itself_is_too_much FILE rtl/unit/shade/pass/rc_finish.sv TEST torture
  "model and RTL agree under torture"
  OLD [[s1_apart <= contrast &&]]
  NEW [[s1_apart < contrast &&]])
mutant(contexts_stack_half_as_deep FILE rtl/unit/shade/pass/rc_contexts.sv TEST torture
  "model and RTL agree under torture"
  OLD [[assign new_top_at = write_state_i.waiting - 4'd1;]]
  NEW [[assign new_top_at = (write_state_i.waiting - 4'd1) & 4'd3;]])

# ---- Caches and credits.
mutant(mshr_chain_loses_the_last QUICK FILE rtl/mem/rc_mshr.sv TEST unit "misses to one line*"
  OLD [[assign is_last    = head == last;]]
  NEW [[assign is_last    = head == last || next == last;]])
mutant(tags_not_cleared FILE rtl/mem/rc_tags.sv TEST unit [cache][lockstep]
  OLD [[u_tag (
        .clk_i, .write_i(!rst_ni || takes), .write_addr_i(write_set),
        .write_data_i(rst_ni ? {1'b1, tag_i} : '0), .read_addr_i(ahead_set_i),]]
  NEW [[u_tag (
        .clk_i, .write_i(takes), .write_addr_i(write_set),
        .write_data_i(rst_ni ? {1'b1, tag_i} : '0), .read_addr_i(ahead_set_i),]])
mutant(tags_fast_line_that_came_meanwhile_is_not_found FILE rtl/mem/rc_tags.sv TEST unit [cache][fast]
  OLD [[took_q && same_late ? same_took : same_entry;]]
  NEW [[took_q && same_late && 1'b0 ? same_took : same_entry;]])
mutant(credit_counter_one_more QUICK FILE rtl/cells/flow/rc_credit_counter.sv TEST unit [tri][lockstep]
  OLD [[Full = CountW'(Credits);]]
  NEW [[Full = CountW'(Credits + 1);]])

# ---- Counters and the registers of the host.
mutant(tally_of_box_blames_trav FILE rtl/engine/rc_node_unit.sv TEST unit
  "model and RTL of the machine count the same"
  OLD [[cause_o = node_waits_i ?]]
  NEW [[cause_o = !node_waits_i ?]])
mutant(tally_is_not_cleared FILE rtl/cells/flow/rc_cause_counters.sv TEST unit
  "model and RTL of the machine count the same"
  OLD [[if (counts_q || clear_i)]]
  NEW [[if (counts_q || (clear_i && counts_q))]])
mutant(host_starts_while_busy FILE rtl/host/rc_host.sv TEST unit [host]
  OLD [[|| (is_idle && (adr_q == AddrW'(rc_pkg::RegStart) || frame_word < AddrW'(FrameWords)));]]
  NEW [[|| adr_q == AddrW'(rc_pkg::RegStart) || (is_idle && frame_word < AddrW'(FrameWords));]])
mutant(host_loses_a_word FILE rtl/host/rc_host.sv TEST unit [host]
  OLD [[frame_word < AddrW'(FrameWords)));]]
  NEW [[frame_word < AddrW'(FrameWords - 1)));]])
mutant(host_swaps_the_words_of_a_counter FILE rtl/host/rc_host.sv TEST unit [host]
  OLD [[upper_word ? 32'(counter_i >> 32) : counter_i[31:0];]]
  NEW [[upper_word ? counter_i[31:0] : 32'(counter_i >> 32);]])
mutant(host_starts_an_empty_frame FILE rtl/host/rc_host.sv TEST unit [host]
  OLD [[&& start_pending_q && some_q;]]
  NEW [[&& start_pending_q;]])
mutant(host_writes_a_running_frame FILE rtl/host/rc_host.sv TEST unit [host]
  OLD [[write_q <= fires && we_q && is_idle && adr_q]]
  NEW [[write_q <= fires && we_q && adr_q]])
mutant(host_clears_a_cycle_late FILE rtl/host/rc_host.sv TEST unit [host]
  OLD [[assign clear_o = Counters != 0 && state_q == StPrepare;]]
  NEW [[logic late_q; always_ff @(posedge clk_i) late_q <= state_q == StPrepare; assign clear_o = Counters != 0 && late_q;]])

# ---- Fast chips and shared multipliers.
mutant(fast_hitdiv_loses_a_stage FILE rtl/unit/tri/rc_hitdiv.sv TEST unit [tri][fast]
  OLD [[rc_path_register #(.Width(TBits + 1)) u_t_last]]
  NEW [[rc_path_register #(.Width(TBits + 1), .Stages(0)) u_t_last]])
mutant(tri_accepts_a_cycle_early QUICK FILE rtl/unit/tri/rc_tri.sv TEST unit [tri][interval]
  OLD [[|valid_q[Interval-2:0];]]
  NEW [[|valid_q[(Interval-1)/2:0];]])
mutant(shared_products_wait_alike FILE rtl/fixed/multipliers/rc_mul_shared.sv TEST unit [tri][interval]
  OLD [[.Stages(Share - 1 - i)) u_early]]
  NEW [[.Stages(Own - 1)) u_early]])

# ---- Random configurations are linted.
mutant(lint_sees_an_unused_signal FILE rtl/unit/shade/surface/rc_surf.sv TEST system
  "the RTL of random configurations*"
  OLD [[logic signed [RoundW-1:0]  sum, sum_q, shifted;]]
  NEW [[logic signed [RoundW-1:0]  sum, sum_q, shifted, spare;]])

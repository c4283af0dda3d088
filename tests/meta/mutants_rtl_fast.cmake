# Faults in what only a fast chip has (timing=fast): registers, and what passes by them. At the end, those of a tri that shares
# its multipliers (tri_interval), and of a box of few lanes.

# ---- A register is taken away.
mutant(fast_hitdiv_loses_a_stage FILE rtl/unit/isect/rc_hitdiv.sv TEST unit [tri][fast]
  OLD [[rc_path_register #(.Width(T + 1)) u_t_last]]
  NEW [[rc_path_register #(.Width(T + 1), .Stages(0)) u_t_last]])
mutant(fast_recip_loses_a_stage FILE rtl/unit/raygen/rc_recip.sv TEST unit [raygen][fast]
  OLD [[rc_path_register #(.Width(M + E + 3)) u_coarse]]
  NEW [[rc_path_register #(.Width(M + E + 3), .Stages(0)) u_coarse]])

mutant(list_fast_loses_a_stage FILE rtl/unit/list/rc_list.sv TEST unit [list][lockstep]
  OLD [[rc_path_register #(.Width(GroupW)) u_it_group]]
  NEW [[rc_path_register #(.Width(GroupW), .Stages(0)) u_it_group]])
mutant(trav_fast_tells_an_end_before_its_ray FILE rtl/unit/trav/rc_trav.sv TEST unit [trav][lockstep]
  OLD [[rc_pulse_register u_ends (]]
  NEW [[rc_pulse_register #(.Stages(0)) u_ends (]])
mutant(list_fast_keeps_the_next_ray FILE rtl/unit/list/rc_list.sv TEST unit [list][lockstep]
  OLD [[rc_pulse_register u_keeps (]]
  NEW [[rc_pulse_register #(.Stages(2)) u_keeps (]])
mutant(stack_fast_writes_where_another_ray_does FILE rtl/unit/trav/rc_stack.sv TEST unit [trav][lockstep]
  OLD [[.write_addr_i(late_addr), .write_data_i(late_group),]]
  NEW [[.write_addr_i(write_addr | (late_addr & '0)), .write_data_i(late_group),]])
mutant(fast_pick_forgets_the_part FILE rtl/cells/rc_bit_select.sv TEST unit [trav][lockstep]
  OLD [[which_q <= index[3 +: PartW];]]
  NEW [[which_q <= '0 & index[3 +: PartW];]])
mutant(list_fast_finds_a_hit_too_early FILE rtl/unit/list/rc_list.sv TEST unit [list][lockstep]
  OLD [[.write_data_i(was_found),]]
  NEW [[.write_data_i(was_found || asked_q),]])

# ---- What a fast cache compares a cycle early, and the request before it changes in that cycle.
mutant(tags_fast_old_line_is_found FILE rtl/mem/rc_tags.sv TEST unit [cache][fast]
  OLD [[mine_q <= takes && same_set ? same_new :]]
  NEW [[mine_q <= takes && same_set && 1'b0 ? same_new :]])
mutant(tags_fast_line_that_came_meanwhile_is_not_found FILE rtl/mem/rc_tags.sv TEST unit [cache][fast]
  OLD [[took_q && same_late ? same_took : same_entry;]]
  NEW [[took_q && same_late && 1'b0 ? same_took : same_entry;]])
mutant(tags_fast_old_tree FILE rtl/mem/rc_tags.sv TEST unit [cache][fast]
  OLD [[recent_q <= touch_i && same_set ? recent_d]]
  NEW [[recent_q <= 1'b0 ? recent_d]])
mutant(tags_fast_tree_that_is_written FILE rtl/mem/rc_tags.sv TEST unit [cache][fast]
  OLD [[: touched_q && same_late ? late_recent : kept;]]
  NEW [[: kept;]])
mutant(mshr_fast_new_line_is_not_waited_for FILE rtl/mem/rc_mshr.sv TEST unit [cache][fast]
  OLD [[takes ? set_i == ahead_set_i : set_q == ahead_set_i;]]
  NEW [[set_q == ahead_set_i;]])
mutant(trav_fast_keeps_leaves_exactly_as_far FILE rtl/unit/trav/rc_ray_t_max.sv TEST unit [trav][lockstep]
  OLD [[within_o[i] = was_written ? near <= kept_then]]
  NEW [[within_o[i] = was_written ? near < kept_then]])
mutant(trav_fast_takes_leaves_behind_the_light FILE rtl/unit/trav/rc_ray_t_max.sv TEST unit [trav][shading]
  OLD [[!was_shadow || near <= SurfaceT;]]
  NEW [[!was_shadow || near <= SurfaceT || near != '0;]])
mutant(trav_fast_takes_another_childs_distance FILE rtl/unit/trav/rc_trav.sv TEST unit [trav][lockstep]
  OLD [[if (in_inner == S'(i) && in_within[i]) matters]]
  NEW [[if (in_inner == S'(i) && in_within[W-1-i]) matters]])
mutant(cache_fast_loads_while_one_waits FILE rtl/mem/rc_cache.sv TEST unit [cache][fast]
  OLD [[assign load        = !valid_q || pop;]]
  NEW [[assign load        = !valid_q || pop || full;]])

# ---- tri that takes a primitive every few cycles: products and quotients one after the other.
mutant(shared_second_operands_stay FILE rtl/fixed/rc_mul_shared.sv TEST unit [tri][interval]
  OLD [[: a_q >> AW;]]
  NEW [[: a_q;]])
mutant(shared_products_wait_alike FILE rtl/fixed/rc_mul_shared.sv TEST unit [tri][interval]
  OLD [[.Stages(Share - 1 - i)) u_early]]
  NEW [[.Stages(Own - 1)) u_early]])
mutant(shared_divider_always_begins FILE rtl/unit/isect/rc_hitdiv.sv TEST unit [tri][interval]
  OLD [[assign begins = Every > 1 ? there : valid[Cut];]]
  NEW [[assign begins = Every > 1 && there ? 1'b1 : valid[Cut];]])
mutant(aside_half_the_places FILE rtl/cells/rc_interval_delay.sv TEST unit [tri][interval]
  OLD [[.Stages((Stages + Every - 2) / Every)]]
  NEW [[.Stages((Stages + 2 * Every - 2) / Every / 2)]])
mutant(aside_leaves_a_cycle_early FILE rtl/cells/rc_interval_delay.sv TEST unit [tri][interval]
  OLD [[.leave_i(there_i[Stages-1])]]
  NEW [[.leave_i(there_i[Stages-2])]])
mutant(raygen_rests_a_cycle_less FILE rtl/unit/raygen/rc_raygen.sv TEST unit [raygen][interval]
  OLD [[|valid[Every-2:0];]]
  NEW [[|valid[(Every-1)/2:0];]])
mutant(raygen_divides_what_is_not_there FILE rtl/unit/raygen/rc_raygen.sv TEST unit [raygen][interval]
  OLD [[valid_i(Every > 1 ? valid[Dir] :]]
  NEW [[valid_i(Every > 1 ? moves[Dir] :]])
mutant(raygen_is_idle_while_it_rests FILE rtl/rc_pipeline.sv TEST unit "model and rtl of the machine count the same"
  OLD [[raygen_rests || raygen_begins ?]]
  NEW [[(raygen_rests && ray_valid) || raygen_begins ?]])
mutant(beside_one_place_forgets FILE rtl/cells/rc_stage_delay.sv TEST unit [raygen][shading]
  OLD [[if (come_i) data_q <= data_i;]]
  NEW [[data_q <= come_i || !leave_i ? data_i : data_q;]])
mutant(tri_rests_a_cycle_less QUICK FILE rtl/unit/isect/rc_tri.sv TEST unit [tri][interval]
  OLD [[|valid_q[Interval-2:0];]]
  NEW [[|valid_q[(Interval-1)/2:0];]])

mutant(parts_lower_has_no_sign FILE rtl/fixed/rc_mul_parts.sv TEST unit [tri][any][interval]
  OLD [[assign lower = Signed ? PW'($signed(last[2*i*HW +: HW]))]]
  NEW [[assign lower = Signed && 1'b0 ? PW'($signed(last[2*i*HW +: HW]))]])
mutant(parts_lie_side_by_side FILE rtl/fixed/rc_mul_parts.sv TEST unit [tri][interval]
  OLD [[assign p_o[i*PW +: PW] = upper + lower;]]
  NEW [[assign p_o[i*PW +: PW] = upper | lower;]])
mutant(sphere_meets_the_next_ones_best FILE rtl/unit/isect/rc_sphere.sv TEST unit [tri][any][interval]
  OLD [[assign best_next_o = there[AtT-1];]]
  NEW [[assign best_next_o = there[AtT-2];]])
mutant(sphere_waits_for_another_ray FILE rtl/unit/isect/rc_sphere.sv TEST unit [tri][any][interval]
  OLD [[.leave_i(there[AtR-1])]]
  NEW [[.leave_i(met_q[AtR-1])]])

# ---- box that tests a node's children beat by beat.
mutant(box_rests_a_cycle_less FILE rtl/engine/bvh/rc_box.sv TEST unit [box][lanes]
  OLD [[|valid_q[K-2:0];]]
  NEW [[|valid_q[(K-1)/2:0];]])
mutant(box_planes_do_not_move_on FILE rtl/engine/bvh/rc_box.sv TEST unit [box][lanes]
  OLD [[held.lo >> 3 * S * B;]]
  NEW [[held.lo;]])
mutant(box_beats_are_gathered_backwards FILE rtl/engine/bvh/rc_box.sv TEST unit [box][lanes]
  OLD [[assign all_met  = {met, met_q};]]
  NEW [[assign all_met  = {met_q, met};]])

mutant(list_ignores_t_best_after_the_first_leaf FILE rtl/unit/list/rc_list.sv TEST unit [list][lockstep]
  OLD [[&& it_within[0];]]
  NEW [[&& (it_within[0] || it_t != '0);]])
mutant(list_has_found_what_another_ray_has FILE rtl/cells/rc_bit_prefetch.sv TEST unit [list][lockstep]
  OLD [[flag_q <= flags_i[next_i];]]
  NEW [[flag_q <= flags_i[next_i ^ {{(IndexW-1){1'b0}}, head_i[0]}];]])
mutant(divide_forgets_what_is_kept_apart FILE rtl/fixed/rc_divide.sv TEST unit [tri][interval]
  OLD [[valid_q <= valid[Stages-1:0] ^ {Stages{Apart}};]]
  NEW [[valid_q <= valid[Stages-1:0];]])
mutant(list_takes_the_first_leaf_for_all FILE rtl/unit/list/rc_list.sv TEST unit [list][lockstep]
  OLD [[was_moved ? more_after_it : more_after_first;]]
  NEW [[was_moved && !it_leaf[0] ? more_after_it : more_after_first;]])
mutant(list_reads_the_ray_before FILE rtl/cells/rc_ram_prefetch.sv TEST unit [list][lockstep]
  OLD [[.read_i(next_fires_i),]]
  NEW [[.read_i(next_fires_i && next_addr_i != head_addr_i),]])
mutant(mark_stays FILE rtl/cells/rc_bit_array.sv TEST unit [list][lockstep]
  OLD [[at == IndexW'(m)) mark_q <= mark;]]
  NEW [[at == IndexW'(m)) mark_q <= mark || mark_q;]])

# ---- shade that makes a pass every few cycles.
mutant(shade_rests_a_cycle_less FILE rtl/unit/shade/rc_shade.sv TEST unit [shade][interval]
  OLD [[|entered_q;]]
  NEW [[|entered_q[(Every-1)/2:0];]])
mutant(contexts_top_of_the_last_state FILE rtl/unit/shade/rc_contexts.sv TEST unit [shade][interval]
  OLD [[.write_data_i(pushed_i), .read_i(there_o),]]
  NEW [[.write_data_i(pushed_i), .read_i(reads),]])
mutant(pass_keeps_a_waiting_ray_before_it_came FILE rtl/unit/shade/rc_pass.sv TEST unit [pass][interval]
  OLD [[turn[Every < 2 ? 0 : Every-2] : ends[0];]]
  NEW [[turn[0] : ends[0];]])
mutant(list_keeps_an_answer_for_another_ray FILE rtl/unit/list/rc_list.sv TEST unit [list][lockstep]
  OLD [[.write_i(it_closer), .write_addr_i(it_ray), .write_data_i(it_best),]]
  NEW [[.write_i(it_closer), .write_addr_i(came.ray), .write_data_i(it_best),]])
mutant(contexts_answer_for_another_ray FILE rtl/unit/shade/rc_contexts.sv TEST unit [shade][interval]
  OLD [[.write_i(answers), .write_addr_i(answer_ray),]]
  NEW [[.write_i(answers), .write_addr_i(answer_ray & closest_ray_i),]])
mutant(contexts_write_before_it_came FILE rtl/unit/shade/rc_contexts.sv TEST unit [shade][interval]
  OLD [[  rc_pulse_register #(.Stages(rc_pkg::ShadeCut)) u_looks (]]
  NEW [[  rc_pulse_register #(.Stages(0)) u_looks (]])
mutant(bounce_unit_of_the_last_one FILE rtl/unit/shade/rc_bounce.sv TEST unit [pass][interval]
  OLD [[    rc_path_register #(.Width(26), .Stages(rc_pkg::ShadeCut)) u_unit (]]
  NEW [[    rc_path_register #(.Width(26), .Stages(9 * rc_pkg::ShadeCut)) u_unit (]])
mutant(beside_gives_a_weight_too_late FILE rtl/cells/rc_stage_delay.sv TEST unit [pass][interval]
  OLD [[.Stages(Parts > 1 ? 1 : 0)) u_read (]]
  NEW [[.Stages(Parts > 1 ? 9 : 0)) u_read (]])
mutant(ball_is_what_the_last_one_was FILE rtl/unit/shade/rc_ball.sv TEST unit [pass][interval]
  OLD [[.Stages(rc_pkg::ShadeCut)) u_sphere (]]
  NEW [[.Stages(9 * rc_pkg::ShadeCut)) u_sphere (]])
mutant(side_of_the_last_one FILE rtl/unit/shade/rc_side.sv TEST unit [pass][interval]
  OLD [[  rc_path_register #(.Width(Q + 2), .Stages(rc_pkg::ShadeCut)) u_sum (]]
  NEW [[  rc_path_register #(.Width(Q + 2), .Stages(9 * rc_pkg::ShadeCut)) u_sum (]])
mutant(contexts_begin_as_the_last_one FILE rtl/unit/shade/rc_contexts.sv TEST unit [shade][interval]
  OLD [[if (reads) read_fresh_q <= all_fresh[reads_ray];]]
  NEW [[if (reads) read_fresh_q <= all_fresh[write_ray_i];]])
mutant(shade_surface_of_the_next_pass FILE rtl/unit/shade/rc_shade.sv TEST unit [shade][interval]
  OLD [[if (enters) surface_q <= surface_found;]]
  NEW [[if (passes) surface_q <= surface_found;]])
mutant(held_product_is_the_next_ones FILE rtl/fixed/rc_mul_held.sv TEST unit [pass][interval]
  OLD [[if (turn_i[i+Inside]) p_q <= p;]]
  NEW [[if (turn_i[i+1]) p_q <= p;]])
mutant(beside_leaves_with_any_pass FILE rtl/unit/shade/rc_pass.sv TEST unit [pass][interval]
  OLD [[.come_i(surf_at[7]), .leave_i(surf_at[Out])]]
  NEW [[.come_i(surf_at[7]), .leave_i(ends[Out])]])
mutant(beside_reads_what_has_left FILE rtl/cells/rc_stage_delay.sv TEST unit [pass][interval]
  OLD [[assign out_d  = !leave_i ? out_q :]]
  NEW [[assign out_d  = !leave_i || leave_i ? out_q :]])
mutant(parts_are_kept_before_they_are_read FILE rtl/cells/rc_ram_parts.sv TEST unit [pass][interval]
  OLD [[if (came_q == PartB'(p)) kept_q <= read_q;]]
  NEW [[if ((came_q & read_part_i) == PartB'(p)) kept_q <= read_q;]])
mutant(parts_are_written_over_what_still_waits FILE rtl/cells/rc_stage_delay.sv TEST unit [pass][interval]
  OLD [[InParts ? Stages + 1 : Stages,]]
  NEW [[InParts ? Stages : Stages,]])
mutant(kept_forgets_its_last_part FILE rtl/unit/shade/rc_context_ram.sv TEST unit [shade][interval]
  OLD [[(write_i || goes_on_q) && write_part != '1;]]
  NEW [[(write_i || goes_on_q) && write_part + 1'b1 != '1;]])
mutant(approach_steps_alike FILE rtl/unit/shade/rc_approach.sv TEST unit [pass][interval]
  OLD [[comes ? twice[k*R +: R] : now[k*R +: R] >> 1;]]
  NEW [[comes ? twice[k*R +: R] : now[k*R +: R];]])
mutant(approach_tells_of_the_last_pass FILE rtl/unit/shade/rc_approach.sv TEST unit [pass][interval]
  OLD [[InTurn ? began[Took] :]]
  NEW [[InTurn ? began[Took-1] :]])
mutant(pass_end_is_taken_before_its_stage FILE rtl/unit/shade/rc_pass.sv TEST unit [pass][interval]
  OLD [[.take_i(ends[L-1])]]
  NEW [[.take_i(ends[L-2])]])
mutant(approach_adds_from_the_near_side FILE rtl/unit/shade/rc_approach.sv TEST unit [pass][interval]
  OLD [[d[M-1] ? End - p : p + End;]]
  NEW [[d[M-1] ? End + p : p + End;]])
mutant(held_operands_are_taken_before_they_come FILE rtl/unit/shade/rc_pass.sv TEST unit [pass][interval]
  OLD [[Side*Every+rc_pkg::ShadeCut +: Every]]
  NEW [[Side*Every +: Every]])
mutant(shade_spawns_what_came_before FILE rtl/unit/shade/rc_shade.sv TEST unit [shade][interval]
  OLD [[        if (end_valid) begin
          spawn_then]]
  NEW [[        if (out_valid) begin
          spawn_then]])
mutant(sqrt_goes_on_at_once FILE rtl/fixed/rc_sqrt.sv TEST unit [pass][interval]
  OLD [[.Stages(Held)) u_step]]
  NEW [[.Stages(Held < 4 ? Held : 1)) u_step]])
mutant(shade_starves_while_it_rests FILE rtl/unit/shade/rc_shade.sv TEST unit [shade][interval]
  OLD [[    if (rests)
      cause_o]]
  NEW [[    if (rests && 1'b0)
      cause_o]])

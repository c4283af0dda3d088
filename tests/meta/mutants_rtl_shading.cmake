# Faults of a chip that shades; how a row reads: mutants_rtl.cmake.

# ---- box, list, trav, raygen, sched of a chip that shades.
mutant(slab_near_from_the_point_before FILE rtl/engine/bvh/rc_slab.sv TEST unit [box][lockstep][shading]
  OLD [[D'(s0_org_i) - D'(s0_point) - $signed({{(D-1){1'b0}}, s0_between});]]
  NEW [[D'(s0_org_i) - D'(s0_point);]])
mutant(slab_far_from_the_nearer_point FILE rtl/engine/bvh/rc_slab.sv TEST unit [box][lockstep][shading]
  OLD [[(s1_between_q ? $signed({{(P-R1){1'b0}}, s1_r_up}) : '0)]]
  NEW [[(s1_between_q && s1_zero_q ? $signed({{(P-R1){1'b0}}, s1_r_up}) : '0)]])
mutant(slab_far_shift_wraps FILE rtl/engine/bvh/rc_slab.sv TEST unit "model and rtl of box make the same moves with bounces and shadow rays*"
  OLD [[s1_shift_q > $signed(S'(T)) ? '0 :]]
  NEW [[1'b0 ? '0 :]])
mutant(list_goes_on_behind_a_blocker QUICK FILE rtl/unit/list/rc_list.sv TEST unit [list][shading]
  OLD [[(end_more_triangles || end_more_leaves) && !end_blocked;]]
  NEW [[end_more_triangles || (end_more_leaves && !end_blocked);]])
mutant(list_forgets_to_stop FILE rtl/unit/list/rc_list.sv TEST unit [list][shading]
  OLD [[ended = {end_ray, end_blocked, end_t};]]
  NEW [[ended = {end_ray, end_blocked && !end_ray[0], end_t};]])
mutant(list_ends_a_ray_away_at_the_surface FILE rtl/unit/trav/rc_ray_t_max.sv TEST unit [list][shading]
  OLD [[is_shadow = start_i.kind == rc_pkg::RayShadow;]]
  NEW [[is_shadow = start_i.kind == rc_pkg::RayShadow || start_i.kind == rc_pkg::RayAway;]])
mutant(trav_looks_beyond_the_surface FILE rtl/unit/trav/rc_ray_t_max.sv TEST unit [trav][shading]
  OLD [[kept_then : was_shadow ? SurfaceT : '1;]]
  NEW [[kept_then : was_shadow && read_ray_i[0] ? SurfaceT : '1;]])
mutant(stack_stop_keeps_the_stack FILE rtl/unit/trav/rc_stack.sv TEST unit [trav][shading]
  OLD [[(end_stop || end_height == '0)) begin
      done_o   = 1'b1;
      height_d = '0;]]
  NEW [[(end_stop || end_height == '0)) begin
      done_o   = 1'b1;]])
mutant(stack_visits_a_child_when_stopped FILE rtl/unit/trav/rc_stack.sv TEST unit [trav][shading]
  OLD [[forward       = !stop &&]]
  NEW [[forward       =]])
mutant(raygen_away_counts_as_long FILE rtl/unit/raygen/rc_raygen.sv TEST unit [raygen][lockstep][shading]
  OLD [[is_short = dir_kind_q != rc_pkg::RayShadow;]]
  NEW [[is_short = dir_kind_q != rc_pkg::RayShadow && dir_kind_q != rc_pkg::RayAway;]])
mutant(raygen_new_pixel_before_shade FILE rtl/unit/raygen/rc_raygen.sv TEST unit [raygen][shading]
  OLD [[.first_valid_i(spawn_valid_i),]]
  NEW [[.first_valid_i(spawn_valid_i && !slot_valid_i),]])
mutant(raygen_bounce_from_the_eye FILE rtl/unit/raygen/rc_raygen.sv TEST unit [raygen][lockstep][shading]
  OLD [[is_camera ? camera_o : given_o;]]
  NEW [[is_camera || kind == rc_pkg::RayBounce ? camera_o : given_o;]])
mutant(recip_zero_is_long FILE rtl/unit/raygen/rc_recip.sv TEST unit [raygen][lockstep][shading]
  OLD [[len_short && len != '0 ?]]
  NEW [[len_short ?]])
mutant(sample_share_rounded_down FILE rtl/unit/raygen/rc_sample.sv TEST unit [raygen][shading]
  OLD [[15'((16383 + i) / i)]]
  NEW [[15'(16384 / i)]])
mutant(sample_cell_not_reduced_twice FILE rtl/unit/raygen/rc_sample.sv TEST unit [raygen][shading]
  OLD [[take = once >= {1'b0, all} ? S'(once - {1'b0, all}) : S'(once);]]
  NEW [[take = once >= {1'b0, all} ? S'(once) : S'(once);]])
mutant(sample_hash_cut_short FILE rtl/unit/raygen/rc_sample.sv TEST unit [raygen][shading]
  OLD [[^ {s2_turned[0] ^ s2_turned[11], 15'd0};]]
  NEW [[^ {s2_turned[0], 15'd0};]])
mutant(sched_loses_a_colour FILE rtl/unit/sched/rc_sched.sv TEST unit [sched][shading]
  OLD [[= {place, pixel_i};]]
  NEW [[= {place, pixel_i & ~rc_pkg::PixelW'(1)};]])

# ---- tri of a chip that shades: rays that leave surfaces, rays from and to lights, planes, spheres.
mutant(edges_fraction_forgotten FILE rtl/unit/isect/rc_edges.sv TEST unit "tri of a chip that shades is exact at the ends of every width - Rtl*"
  OLD [[dot_leaves ? det_sum <<< B : det_sum;]]
  NEW [[dot_leaves && 1'b0 ? det_sum <<< B : det_sum;]])
mutant(edges_plane_has_edges FILE rtl/unit/isect/rc_edges.sv TEST unit "tri of a chip that shades is exact at the ends of every width - Rtl*"
  OLD [[&& (end_plane || (end_u_neg]]
  NEW [[&& ((end_plane && 1'b0) || (end_u_neg]])
mutant(tri_end_of_the_way_blocks FILE rtl/unit/isect/rc_tri.sv TEST unit "tri of a chip that shades decides exactly and measures within its bound - Rtl*"
  OLD [[in.prim <= in.best_prim && !in_any && !in_skips;]]
  NEW [[in.prim <= in.best_prim || in_any;]])
mutant(hitdiv_negative_rounded_up FILE rtl/unit/isect/rc_hitdiv.sv TEST unit "tri of a chip that shades is exact at the ends of every width - Rtl*"
  OLD [[u_neg ? ~u_size + {{(V-1){1'b0}}, !u_left} : u_size;]]
  NEW [[u_neg ? ~u_size + {{(V-1){1'b0}}, !u_left || 1'b1} : u_size;]])
mutant(hitdiv_plane_wraps FILE rtl/unit/isect/rc_hitdiv.sv TEST unit "tri of a chip that shades is exact at the ends of every width - Rtl*"
  OLD [[v_many ? {v_neg, {(V-1){!v_neg}}} : v_end};]]
  NEW [[v_many && 1'b0 ? {v_neg, {(V-1){!v_neg}}} : v_end};]])
mutant(sphere_touch_is_no_hit FILE rtl/unit/isect/rc_sphere.sv TEST unit "a sphere is told from its inside*"
  OLD [[assign s3_meets = s3_nearing && !s3_disc[D-1];]]
  NEW [[assign s3_meets = s3_nearing && !s3_disc[D-1] && s3_disc != '0;]])
mutant(sphere_far_root_rounded_down FILE rtl/unit/isect/rc_sphere.sv TEST unit "tri of a chip that shades decides exactly and measures within its bound - Rtl*"
  OLD [[far_q[AtR] && (r_inexact || r_lost)};]]
  NEW [[far_q[AtR] && (r_inexact || r_lost) && 1'b0};]])
mutant(sphere_on_its_rim_is_behind FILE rtl/unit/isect/rc_sphere.sv TEST unit "a sphere is told from its inside*"
  OLD [[!sum_end[C-1] && sum_end != '0}),]]
  NEW [[!sum_end[C-1]}),]])
mutant(sphere_disc_one_bit_short FILE rtl/unit/isect/rc_sphere.sv TEST unit "tri of a chip that shades is exact at the ends of every width - Rtl*"
  OLD [[? 2 * (M + W) + 2 : 2 * (N + W) + 4;]]
  NEW [[? 2 * (M + W) + 1 : 2 * (N + W) + 3;]])
mutant(sphere_opaque_met_by_bounces FILE rtl/unit/isect/rc_sphere.sv TEST unit "*its rim and its own rays - Rtl*"
  OLD [[s3_meets : s3_glass && (s3_on]]
  NEW [[s3_meets : (s3_on]])
mutant(sphere_opaque_about_a_point_shades_it FILE rtl/unit/isect/rc_sphere.sv TEST unit "*its rim and its own rays - Rtl*"
  OLD [[&& (s3_glass || s3_end_out);]]
  NEW [[;]])
mutant(sphere_opaque_own_is_met FILE rtl/unit/isect/rc_sphere.sv TEST unit "*its rim and its own rays - Rtl*"
  OLD [[s1_inside_q              <= s0_inside_i && s0_glass_i;]]
  NEW [[s1_inside_q              <= s0_inside_i;]])
mutant(sphere_clear_is_the_opaque_one FILE rtl/unit/isect/rc_tri.sv TEST unit "*its rim and its own rays - Rtl*"
  OLD [[.s0_glass_i(in_b[2*N])]]
  NEW [[.s0_glass_i(!in_b[2*N])]])
mutant(sphere_own_is_met FILE rtl/unit/isect/rc_sphere.sv TEST unit "a sphere is told from its inside*"
  OLD [[assign s3_goes  = (!s3_own || s3_inside)]]
  NEW [[assign s3_goes  = (!s3_own || s3_inside || s3_outside)]])

# ---- shade's cells.
mutant(unit_length_of_two_axes FILE rtl/fixed/rc_unit.sv TEST unit [unit_vector]
  OLD [[s1_size_q[0 +: W] | s1_size_q[W +: W] | s1_size_q[2*W +: W];]]
  NEW [[s1_size_q[0 +: W] | s1_size_q[W +: W];]])
mutant(unit_sum_of_squares_wraps FILE rtl/fixed/rc_unit.sv TEST unit [unit_vector]
  OLD [[assign s4_low = s4_sum[35:34] == '0;]]
  NEW [[assign s4_low = !s4_sum[34];]])
mutant(unit_not_rounded FILE rtl/fixed/rc_unit.sv TEST unit [unit_vector]
  OLD [[+ 38'h40000;]]
  NEW [[+ 38'h3ffff;]])
mutant(unit_not_clamped FILE rtl/fixed/rc_unit.sv TEST unit [unit_vector]
  OLD [[whole[37:35] != '0 ? 17'h10000 : {1'b0, whole[34:19]};]]
  NEW [[&whole[37:35] ? 17'h10000 : {1'b0, whole[34:19]};]])
mutant(unit_components_wait_for_others FILE rtl/fixed/rc_unit.sv TEST unit [unit_vector]
  OLD [[.valid_i(ends[6:4]), .data_i(s4_a_q)]]
  NEW [[.valid_i(ends[5:3]), .data_i(s4_a_q)]])
mutant(power_of_nothing QUICK FILE rtl/fixed/rc_power.sv TEST unit [power]
  OLD [[s5_none_q  <= s4_none_q ||]]
  NEW [[s5_none_q  <= (s4_none_q && s4_y_q[0]) ||]])
mutant(power_17_whole_bits_leave_nothing FILE rtl/fixed/rc_power.sv TEST unit [power]
  OLD [[s4_y_q[32:18] > 15'd17;]]
  NEW [[s4_y_q[32:18] > 15'd15;]])
mutant(power_not_rounded FILE rtl/fixed/rc_power.sv TEST unit [power]
  OLD [[{1'b0, s6_g_q} + (19'd1 << s6_whole_q);]]
  NEW [[{1'b0, s6_g_q};]])

# ---- shade: a pass, and the contexts around it.
mutant(pass_pending_forgets_the_answer QUICK FILE rtl/unit/shade/rc_pass_begin.sv TEST unit [pass][all]
  OLD [[(state_i.pending == rc_pkg::PendingAnswer && !found)]]
  NEW [[(state_i.pending == rc_pkg::PendingAnswer)]])
mutant(pass_first_hit_of_any_depth FILE rtl/unit/shade/rc_pass_begin.sv TEST unit [pass][all]
  OLD [[arrives && state_i.depth == '0 && state_i.sample]]
  NEW [[arrives && state_i.sample]])
mutant(pass_leaves_with_the_ratio_of_entering FILE rtl/unit/shade/rc_pass_begin.sv TEST unit [pass][all]
  OLD [[back ? surface_i.leave : surface_i.enter]]
  NEW [[back ? surface_i.enter : surface_i.leave]])
mutant(pass_end_light_behind_counts FILE rtl/unit/shade/rc_pass_end.sv TEST unit [pass][all]
  OLD [[positive_i && (light_near_i ? below_i : above_i)]]
  NEW [[positive_i && (light_near_i ? !above_i : above_i)]])
mutant(pass_end_last_light_is_left_out FILE rtl/unit/shade/rc_pass_end.sv TEST unit [pass][all]
  OLD [[next_light < frame_i.lights]]
  NEW [[next_light + 7'd1 < frame_i.lights]])
mutant(pass_end_threshold_is_not_enough FILE rtl/unit/shade/rc_pass_end.sv TEST unit [pass][all]
  OLD [[+ 19'(slack) >= {1'b0, frame_i.threshold}]]
  NEW [[+ 19'(slack) > {1'b0, frame_i.threshold}]])
mutant(pass_end_slack_comes_late FILE rtl/unit/shade/rc_pass_end.sv TEST unit [pass][interval]
  OLD [[  always_comb begin   // 3 (depth + 1), as a table: two additions before a comparison are long
    slack = '0;
    for (int i = 0; i < 1 << rc_pkg::DepthBits; i++)
      if (was_i.depth == rc_pkg::DepthBits'(i)) slack = 6'(3 * i + 3);
  end]]
  NEW [[  rc_path_register #(.Width(6), .Stages(Cut)) u_slack (
    .clk_i, .data_i(6'd3 * ({2'd0, was_i.depth} + 6'd1)), .data_o(slack));]])
mutant(pass_end_slack_is_one_short FILE rtl/unit/shade/rc_pass_end.sv TEST unit [pass][all]
  OLD [[slack = 6'(3 * i + 3);]]
  NEW [[slack = 6'(3 * i + 2);]])
mutant(pass_end_writes_no_share FILE rtl/unit/shade/rc_pass_end.sv TEST unit [pass][all]
  OLD [[surf_i || turned, turn_i, surf_i, is_light}]]
  NEW [[surf_i || turned, turn_i, surf_i, is_arrive}]])
mutant(pass_end_writes_what_was_not_hit FILE rtl/unit/shade/rc_pass_end.sv TEST unit [pass][all]
  OLD [[surf_i || turned, turn_i, surf_i, is_light}]]
  NEW [[is_arrive || turned, turn_i, surf_i, is_light}]])
mutant(pass_tells_a_material_of_nothing FILE rtl/unit/shade/rc_pass.sv TEST unit [pass][all]
  OLD [[look_valid_o = valid && looks;]]
  NEW [[look_valid_o = valid && s0_purpose_arrives;
  logic s0_purpose_arrives;
  assign s0_purpose_arrives = state.purpose == rc_pkg::EventArrive || looks;]])
mutant(known_forgets_the_mirror FILE rtl/unit/shade/rc_pass_state.sv TEST unit [pass][all]
  OLD [[known_i.mirror != '0,]]
  NEW [[known_i.mirror[16:1] != '0,]])
mutant(known_is_far_only_if_lost FILE rtl/unit/shade/rc_pass_state.sv TEST unit [pass][all]
  OLD [[    was_o.is_far    = is_far;]]
  NEW [[    was_o.is_far    = is_far && is_lost;]])
mutant(contexts_keep_an_old_face FILE rtl/unit/shade/rc_contexts.sv TEST unit [shade][all]
  OLD [[.write_i(writes_face)]]
  NEW [[.write_i(writes_face && writes_share)]])
mutant(contexts_material_of_another_context FILE rtl/unit/shade/rc_contexts.sv TEST unit [shade][all]
  OLD [[u_look (
      .clk_i, .rst_ni, .write_i(looks), .write_addr_i(look_ray),
      .write_data_i({new_look, new_bend})]]
  NEW [[u_look (
      .clk_i, .rst_ni, .write_i(look_i), .write_addr_i(write_ray_i),
      .write_data_i({new_look, new_bend})]])
mutant(pass_end_far_mirror_is_black FILE rtl/unit/shade/rc_pass_end.sv TEST unit [pass][all]
  OLD [[is_arrive || escapes]]
  NEW [[is_arrive || (escapes && 1'b0)]])
mutant(pass_end_far_glass_is_traced FILE rtl/unit/shade/rc_pass_end.sv TEST unit [pass][all]
  OLD [[refracted && (starts || beyond),]]
  NEW [[refracted,]])
mutant(pass_end_far_light_behind_a_plane_counts FILE rtl/unit/shade/rc_pass_end.sv TEST unit [pass][all]
  OLD [[&& (!far || light_clear_i);]]
  NEW [[;]])
mutant(pass_end_lost_point_asks_its_light FILE rtl/unit/shade/rc_pass_end.sv TEST unit [pass][all]
  OLD [[light_near_i ? !was_i.is_lost : starts;]]
  NEW [[light_near_i || starts;]])
mutant(pass_end_far_light_asks_planes FILE rtl/unit/shade/rc_pass_end.sv TEST unit [pass][all]
  OLD [[is_light ? !to_point && light_clear_i :]]
  NEW [[is_light ? !light_near_i && light_clear_i :]])
mutant(light_far_point_is_turned_round FILE rtl/unit/shade/rc_light.sv TEST unit [pass][all]
  OLD [[s15_near ? -wide : wide;]]
  NEW [[wide;]])
mutant(approach_end_is_ahead FILE rtl/unit/shade/rc_approach.sv TEST unit [pass][all]
  OLD [[else if (comes) twice_q[k*R +: R] <= now[k*R +: R] >> 1;]]
  NEW [[else if (comes) twice_q[k*R +: R] <= now[k*R +: R] >> (1 + 32'(i == 7));]])
mutant(approach_passes_by_and_enters FILE rtl/unit/shade/rc_approach.sv TEST unit [pass][all]
  OLD [[fits == 3'b111;]]
  NEW [[fits != 3'b000;]])
mutant(surf_far_is_lost FILE rtl/unit/shade/rc_surf.sv TEST unit [pass][all]
  OLD [[s5_lost_o <= !sphere[4] && (s4_ends || s4_beyond != '0);]]
  NEW [[s5_lost_o <= !sphere[4] && (s4_ends || s4_outside != '0);]])
mutant(tri_finite_ray_meets_planes FILE rtl/unit/isect/rc_tri.sv
  TEST unit "tri of a chip that shades decides exactly and measures within its bound - Rtl*"
  OLD [[in.is_partial && (in_plane ? in_any : in_far);]]
  NEW [[in.is_partial && !in_plane && in_far;]])
mutant(tri_far_ray_meets_triangles FILE rtl/unit/isect/rc_tri.sv
  TEST unit "tri of a chip that shades decides exactly and measures within its bound - Rtl*"
  OLD [[in.is_partial && (in_plane ? in_any : in_far);]]
  NEW [[in.is_partial && in_plane && in_any;]])
mutant(tri_far_ray_meets_spheres FILE rtl/unit/isect/rc_tri.sv
  TEST unit "tri of a chip that shades decides exactly and measures within its bound - Rtl*"
  OLD [[assign in_own        = in_far
]]
  NEW [[assign in_own        = 1'b0
]])
mutant(edges_far_plane_twice_as_far FILE rtl/unit/isect/rc_edges.sv
  TEST unit "tri of a chip that shades decides exactly and measures within its bound - Rtl*"
  OLD [[(s0_far_i ? Far : B)]]
  NEW [[(s0_far_i ? Far + 1 : B)]])
mutant(edges_far_distance_halved FILE rtl/unit/isect/rc_edges.sv
  TEST unit "tri of a chip that shades decides exactly and measures within its bound - Rtl*"
  OLD [[dot_far ? det_sum <<< Far : ]]
  NEW [[dot_far ? det_sum <<< (Far + 1) : ]])
mutant(pass_end_far_ray_rounded_down FILE rtl/unit/shade/rc_pass_end.sv TEST unit [pass][all]
  OLD [[ + P'(up_i[k]);]]
  NEW [[ + P'(up_i[k] && 1'b0);]])
mutant(pass_end_cell_is_kept_by_what_waits FILE rtl/unit/shade/rc_pass_end.sv TEST unit [pass][all]
  OLD [[if (is_pop) sided.in_cell = top_i.in_cell;]]
  NEW [[]])
mutant(light_is_clear_in_every_cell FILE rtl/unit/shade/rc_light.sv TEST unit [pass][all]
  OLD [[clear[i] && cells[i*C +: C] == cell_here;]]
  NEW [[clear[i] && (cells[i*C +: C] == cell_here || 1'b1);]])
mutant(start_pane_is_no_border FILE rtl/unit/shade/rc_pass_begin.sv TEST unit [pass][all]
  OLD [[state_i.in_cell ^ pane;]]
  NEW [[state_i.in_cell ^ (pane & {rc_pkg::Panes{1'b0}});]])
mutant(pass_end_one_bounce_more FILE rtl/unit/shade/rc_pass_end.sv TEST unit [pass][all]
  OLD [[was_i.depth >= frame_i.depth]]
  NEW [[was_i.depth > frame_i.depth]])
mutant(pass_end_pushed_ray_stays_outside FILE rtl/unit/shade/rc_pass_end.sv TEST unit [pass][all]
  OLD [[!was_i.is_inside}]]
  NEW [[was_i.is_inside}]])
mutant(lint_sees_an_unused_signal FILE rtl/unit/shade/rc_surf.sv TEST system "the RTL of random configurations*"
  OLD [[logic signed [X-1:0] sum, told, shifted;]]
  NEW [[logic signed [X-1:0] sum, told, shifted, spare;]])
mutant(surf_point_on_the_border FILE rtl/unit/shade/rc_surf.sv TEST unit [pass][all]
  OLD [[s1_u_q + s1_v_q < s1_one;]]
  NEW [[s1_u_q + s1_v_q <= s1_one;]])
mutant(surf_normal_is_not_turned FILE rtl/unit/shade/rc_surf.sv TEST unit [pass][all]
  OLD [[<= s4_back ? -s4_n : s4_n;]]
  NEW [[<= s4_back && s4_smooth ? -s4_n : s4_n;]])
mutant(surf_checkers_by_u_alone FILE rtl/unit/shade/rc_surf.sv TEST unit [pass][all]
  OLD [[(s0_square_u[0] ^ s0_square_v[0]);]]
  NEW [[(s0_square_u[0] ^ (s0_square_v[0] && s0_smooth));]])
mutant(ball_rounded_down FILE rtl/unit/shade/rc_ball.sv TEST unit [pass][all]
  OLD [[Q'(65'(1) << Drop >> 1))]]
  NEW [[Q'(65'(1) << Drop >> 2))]])
mutant(corners_third_subtracted FILE rtl/unit/shade/rc_corners.sv TEST unit [pass][all]
  OLD [[S'(s3_b_q) + S'(s3_c_q);]]
  NEW [[S'(s3_b_q) - S'(s3_c_q);]])
mutant(side_in_the_plane_is_above FILE rtl/unit/shade/rc_side.sv TEST unit [pass][all]
  OLD [[&& sum != '0;]]
  NEW [[&& sum[Q:0] != '1;]])
mutant(light_share_wraps FILE rtl/unit/shade/rc_light.sv TEST unit [pass][all]
  OLD [[s27_rounded[52:44] != '0 ? 17'h10000]]
  NEW [[&s27_rounded[52:44] ? 17'h10000]])
mutant(light_phong_of_a_light_behind FILE rtl/unit/shade/rc_light.sv TEST unit [pass][all]
  OLD [[s16_phong[20] ? '0 :]]
  NEW [[s16_phong[20] && s16_phong[0] ? '0 :]])
mutant(snell_never_total FILE rtl/unit/shade/rc_snell.sv TEST unit [pass][all]
  OLD [[s13_total_o <= s12_refract && s12_total;]]
  NEW [[s13_total_o <= s12_refract && s12_total && s12_long[0];]])
mutant(snell_ratio_not_rounded FILE rtl/unit/shade/rc_snell.sv TEST unit [pass][all]
  OLD [[s1_long_q + 33'h800;]]
  NEW [[s1_long_q + 33'h0;]])
mutant(schlick_fourth_power FILE rtl/unit/shade/rc_schlick.sv TEST unit [pass][all]
  OLD [[s3_q5, s2_q,]]
  NEW [[s3_q5, s2_q | 17'h10000,]])
mutant(bounce_component_above_one FILE rtl/unit/shade/rc_bounce.sv TEST unit [pass][all]
  OLD [[s14_unit > 26'sh10000 ? 18'sh10000]]
  NEW [[s14_unit > 26'sh18000 ? 18'sh10000]])
mutant(turn_short_direction_cut FILE rtl/unit/shade/rc_turn.sv TEST unit "the rtl's pass is the model's with directions shorter than unit vectors"
  OLD [[$signed(19'(1 << (17 - M)));]]
  NEW [[$signed(19'(0));]])
mutant(finish_first_samples_never_agree FILE rtl/unit/shade/rc_finish.sv TEST unit [pass][all]
  OLD [[s1_apart <= contrast &&]]
  NEW [[s1_apart > contrast &&]])
mutant(finish_share_of_all_samples FILE rtl/unit/shade/rc_finish.sv TEST unit [pass][all]
  OLD [[s0_some ? frame_i.first_share : frame_i.share;]]
  NEW [[s0_some ? frame_i.share : frame_i.first_share;]])
mutant(wait_one_cycle_less FILE rtl/cells/rc_delay_ram.sv TEST unit [pass][all]
  OLD [[at_q == IndexW'(Stages - 1))]]
  NEW [[at_q == IndexW'(Stages - 2))]])
mutant(shade_shadow_hit_fetches_its_surface FILE rtl/unit/shade/rc_shade.sv TEST unit [shade][all]
  OLD [[way_found && !any_hit}]]
  NEW [[way_found && !(any_hit && kind[0])}]])
mutant(shade_arrived_before_again FILE rtl/unit/shade/rc_shade.sv TEST unit [shade][all]
  OLD [[open && !came && !again_valid && arrived_valid;]]
  NEW [[open && !came && (!again_valid || push) && arrived_valid;]])
mutant(shade_is_busy_behind_a_closed_door FILE rtl/unit/shade/rc_shade.sv TEST unit [shade]~[slow]
  OLD [[cause_o = open ? rc_pkg::ShadeBusyWork : rc_pkg::ShadeStalledQueue;]]
  NEW [[cause_o = rc_pkg::ShadeBusyWork;]])
mutant(contexts_keep_the_last_pixels_state FILE rtl/unit/shade/rc_contexts.sv TEST unit [shade][all]
  OLD [[.set_i(begins), .set_at_i(begins_ray), .flags_o(all_fresh)]]
  NEW [[.set_i(begins && begins_pixel[0]), .set_at_i(begins_ray), .flags_o(all_fresh)]])
mutant(contexts_bounces_are_forgotten FILE rtl/unit/shade/rc_contexts.sv TEST unit [shade][all]
  OLD [[is_kept = kind_o == rc_pkg::RayCamera || kind_o == rc_pkg::RayBounce;]]
  NEW [[is_kept = kind_o == rc_pkg::RayCamera;]])
mutant(contexts_stack_of_one_place FILE rtl/unit/shade/rc_contexts.sv TEST unit [shade][all]
  OLD [[& AW'((1 << Up) - 1));]]
  NEW [[& AW'((1 << Up) - 2));]])

# ---- What nothing quick saw before the torture set and operands aimed at it (issue 12).
mutant(raygen_keeps_the_first_eye FILE rtl/unit/raygen/rc_raygen.sv TEST torture "model and RTL agree under torture"
  OLD [[assign eye = frame_i.eye;]]
  NEW [[logic [3*rc_pkg::CoordBits-1:0] kept_q;
  logic is_kept_q;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) is_kept_q <= 1'b0;
    else if (slot_valid_i) is_kept_q <= 1'b1;
    if (!is_kept_q) kept_q <= frame_i.eye;
  end
  assign eye = is_kept_q ? kept_q : frame_i.eye;]])
mutant(contexts_stack_half_as_deep FILE rtl/unit/shade/rc_contexts.sv TEST torture "model and RTL agree under torture"
  OLD [[assign new_top_at = write_state_i.waiting - 4'd1;]]
  NEW [[assign new_top_at = (write_state_i.waiting - 4'd1) & 4'd3;]])
mutant(finish_contrast_itself_is_too_much FILE rtl/unit/shade/rc_finish.sv TEST torture "model and RTL agree under torture"
  OLD [[s1_apart <= contrast &&]]
  NEW [[s1_apart < contrast &&]])
mutant(hitdiv_t_wraps FILE rtl/unit/isect/rc_hitdiv.sv TEST unit "t ends where its bits do - Rtl*"
  OLD [[assign t_o = end_beyond || (&t_down)]]
  NEW [[assign t_o = (end_beyond && 1'b0) || (&t_down)]])
mutant(sphere_forgets_what_was_cut FILE rtl/unit/isect/rc_sphere.sv TEST unit "a discriminant that is all but a square*"
  OLD [[far_q[AtR] && (r_inexact || r_lost)};]]
  NEW [[far_q[AtR] && (r_inexact || (r_lost && 1'b0))};]])
mutant(sphere_touched_at_the_end_blocks FILE rtl/unit/isect/rc_sphere.sv
  TEST unit "a sphere that is touched where a shadow ray ends is not in its way - Rtl*"
  OLD [[!sum_foot[Foot-1] && sum_foot != '0, sum_end[C-1],]]
  NEW [[!sum_foot[Foot-1], sum_end[C-1],]])

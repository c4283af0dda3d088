# Faults of two levels: mutants_rtl.cmake says what a row is.

# ---- The map: one rounding, one t, nothing kept from the wrong space.
mutant(xform_rounds_down FILE model/unit/xform/xform.cpp TEST accel [levels]
  OLD [[(std::int64_t(1) << config.origin_frac()) + (std::int64_t(1) << (frac - 1));]]
  NEW [[(std::int64_t(1) << config.origin_frac());]])
mutant(xform_moves_directions_as_points FILE model/unit/xform/xform.cpp TEST accel [levels]
  OLD [[unrounded(p, d, {half, half, half});]]
  NEW [[unrounded(p, d, p.b);]])
mutant(xform_mixes_rows_and_columns FILE model/unit/xform/xform.cpp TEST accel [levels]
  OLD [[(p.a[3 * i + k])]]
  NEW [[(p.a[i + 3 * k])]])
mutant(walk_keeps_the_scenes_reciprocals FILE model/trace/inside.hpp WITH tests/accel/levels_test.cpp tests/accel/levels_frame_test.cpp
  TEST accel [levels]
  OLD [[from = box_ray(change);]]
  NEW [[from = box_ray(change), from.recip = ray.recip, from.len = ray.len;]])
mutant(walk_goes_back_in_the_wrong_space FILE model/trace/inside.hpp WITH tests/accel/levels_test.cpp tests/accel/levels_frame_test.cpp
  TEST accel [levels]
  OLD [[xform({ray.ray, ray.o, ray.d, placement, ray.kind, ray.home}, config);]]
  NEW [[xform({ray.ray, change.first ? change.o : ray.o, change.first ? change.d : ray.d, placement, ray.kind, ray.home}, config);]])
mutant(walk_forgets_the_first_number FILE model/trace/walk.hpp WITH tests/accel/levels_test.cpp tests/accel/levels_frame_test.cpp
  TEST accel [levels]
  OLD [[prim.prim += inside.change.first;]]
  NEW [[prim.prim += 0 * inside.change.first;]])
mutant(walk_starts_where_it_changes FILE model/trace/walk.hpp WITH tests/accel/levels_test.cpp tests/accel/levels_frame_test.cpp
  TEST accel [levels]
  OLD [[if (inside.enters) return inside.enter(]]
  NEW [[if (inside.enters) hit = BestHit({ray.ray, ray.kind}, reach_of(RayKind(ray.kind), config));
        if (inside.enters) return inside.enter(]])

mutant(walk_keeps_the_scenes_direction_for_globes FILE model/trace/inside.hpp WITH tests/accel/levels_test.cpp tests/accel/levels_frame_test.cpp
  TEST accel [levels]
  OLD [[toward = globe_ray(moved, config);]]
  NEW [[toward = globe_ray(ray, config);]])
mutant(walk_keeps_the_scenes_direction_for_planes FILE model/trace/inside.hpp WITH tests/accel/levels_test.cpp tests/accel/levels_frame_test.cpp
  TEST accel [levels]
  OLD [[along = aligned(moved, config);]]
  NEW [[along = aligned(ray, config);]])
mutant(levels_moves_no_node_behind_a_leaf FILE model/compile/levels/compile.cpp TEST accel [levels]
  OLD [[if (kind == 1) pending.push_back(next++);]]
  NEW [[if (kind == 1 && next - node.base < 2) pending.push_back(next++);]])

# ---- The scene's tree of the other structures.
mutant(upper_cells_forget_what_reaches_over FILE model/engine/kd/cell.cpp TEST accel [levels]
  OLD [[if (reach.hi > cut.plane || (flat]]
  NEW [[if ((reach.hi > cut.plane && reach.lo >= cut.plane) || (flat]])
mutant(upper_globes_hold_no_upper_corner FILE model/compile/levels/upper.cpp TEST accel [levels]
  OLD [[box.hi[2] : box.lo[2]},]]
  NEW [[box.lo[2] : box.lo[2]},]])
mutant(upper_calls_an_instance_by_every_line FILE model/compile/levels/upper.cpp TEST accel [secondary]
  OLD [[if (here[at.entry] == none) here]]
  NEW [[here]])
mutant(upper_boxes_reach_out_of_space FILE model/compile/levels/fit.cpp TEST accel [levels]
  OLD [[std::max({fitted.beyond, -largest - least, most - largest});]]
  NEW [[std::max({fitted.beyond, -2 * largest - least, most - 2 * largest});]])

# ---- The same in RTL, and what its neighbours keep of a ray.
mutant(rtl_xform_rounds_down FILE rtl/unit/xform/rc_xform.sv TEST unit [xform]
  OLD [[Half = SW'(1) << (K - 1);]]
  NEW [[Half = '0;]])
mutant(rtl_xform_mixes_rows_and_columns FILE rtl/unit/xform/rc_xform.sv TEST unit [xform]
  OLD [[in_o[(i%3)*N +:]]
  NEW [[in_o[(i/3)*N +:]])
mutant(rtl_xform_drops_a_bit FILE rtl/unit/xform/rc_xform.sv TEST unit [xform]
  OLD [[X'($signed(in_d[(i%3)*M +: M]))]]
  NEW [[X'($signed(in_d[(i%3)*M +: M])) & ~X'(1)]])
mutant(rtl_xform_divides_one_axis_only FILE rtl/unit/xform/rc_xform.sv TEST unit [xform]
  OLD [[valid[Moved] ? d[First*M +: M] : wait_q[M-1:0];]]
  NEW [[valid[Moved] || wait_q[0] ? d[First*M +: M] : wait_q[M-1:0];]])
mutant(rtl_xform_rests_too_little FILE rtl/unit/xform/rc_xform.sv TEST unit [xform]
  OLD [[RestW'(rc_pkg::XformInterval - 1)]]
  NEW [[RestW'(rc_pkg::XformInterval - 2)]])
mutant(rtl_xform_rests_too_little_every_2 FILE rtl/unit/xform/rc_xform.sv TEST unit [xform]
  OLD [[RestW'(rc_pkg::XformInterval - 1)]]
  NEW [[RestW'(rc_pkg::XformInterval - (rc_pkg::XformInterval == 2 ? 2 : 1))]])
mutant(rtl_trav_keeps_the_scenes_reciprocals FILE rtl/unit/trav/rc_trav.sv TEST system "model and RTL walk instances alike"
  OLD [[.recip_i(change_i.recip)]]
  NEW [[.recip_i(ray_i.recip)]])
mutant(rtl_trav_takes_shadow_rays_for_short FILE rtl/unit/trav/rc_trav.sv TEST system "model and RTL draw instances alike"
  OLD [[changed_short = change_i.kind != rc_pkg::RayShadow;]]
  NEW [[changed_short = change_i.kind != rc_pkg::RayShadow || 1'b1;]])
mutant(rtl_trav_does_not_restore_the_ray FILE rtl/unit/trav/rc_trav.sv TEST system "model and RTL walk instances alike"
  OLD [[{node_rsp_i.ray, in_mesh ? changed_ray : kept_ray,]]
  NEW [[{node_rsp_i.ray, in_mesh || !is_instance ? changed_ray : kept_ray,]])
mutant(rtl_list_forgets_the_first_number FILE rtl/unit/list/rc_list.sv TEST system "model and RTL walk instances alike"
  OLD [[prim_rsp_i.prim + first_number;]]
  NEW [[prim_rsp_i.prim | first_number;]])
mutant(rtl_list_starts_where_a_ray_changes FILE rtl/unit/list/rc_list.sv TEST system "model and RTL walk instances alike"
  OLD [[.clk_i, .rst_ni, .clear_i(start_fires_i), .clear_at_i(start_ray),
    .set_i(it_closer)]]
  NEW [[.clk_i, .rst_ni, .clear_i(start_fires_i || change_fires_i),
    .clear_at_i(change_fires_i ? change_i.ray : start_ray), .set_i(it_closer)]])
mutant(rtl_direction_without_opposite FILE rtl/unit/raygen/rc_direction.sv TEST unit "a camera ray of two levels has an opposite*"
  OLD [[s1_up = s1_moved[G-M-1] || s1_whole ==]]
  NEW [[s1_up = s1_moved[G-M-1] && s1_whole ==]])

# ---- Its compiler: boxes hold what is rounded, rows keep within 1, classes keep apart.
mutant(levels_boxes_without_what_is_rounded FILE model/compile/levels/fit.cpp TEST accel [levels]
  OLD [[map.is_whole ? 0 : 0.5 + 0.5 * last;]]
  NEW [[0 * last;]])
mutant(levels_boxes_forget_the_direction FILE model/compile/levels/fit.cpp TEST accel [levels]
  OLD [[map.is_whole ? 0 : 0.5 + 0.5 * last;]]
  NEW [[map.is_whole ? 0 : 0.5 + 0 * last;]])
mutant(levels_all_in_one_class FILE model/compile/levels/maps.cpp TEST accel [levels]
  OLD [[lessThanEqual(most, 2.0 * least)]]
  NEW [[lessThanEqual(most, 2e9 * least)]])

# ---- Finished pictures: where a ray begins in the instance that it leaves, and on which side.
mutant(xform_forgets_home FILE model/unit/xform/xform.cpp TEST accel [secondary]
  OLD [[req.home.line == p.here;]]
  NEW [[req.home.line == p.here + 1;]])
mutant(xform_is_at_home_everywhere FILE model/unit/xform/xform.cpp TEST accel [secondary]
  OLD [[kind != RayKind::camera && req.home.line == p.here;]]
  NEW [[kind != RayKind::camera;]])
mutant(xform_moves_lights_between_points FILE model/unit/xform/xform.cpp TEST accel [secondary]
  OLD [[const int whole = kind == RayKind::shadow ? config.origin_frac() : 0,]]
  NEW [[const int whole = 0,]])
mutant(bounce_side_of_the_scenes_direction FILE model/unit/shade/bounce.cpp TEST accel [secondary]
  OLD [[return side_of(state.n, out.home.d);]]
  NEW [[return side_of(state.n, out.d);]])
mutant(light_side_of_the_scenes_direction FILE model/unit/shade/light.cpp TEST accel [secondary]
  OLD [[c.has_homes() ? out.home.d : out.d;]]
  NEW [[out.d;]])
mutant(shadow_ray_ends_beside_its_point FILE model/unit/shade/light.cpp TEST accel [secondary]
  OLD [[state.inner[k] - home.o[k]);]]
  NEW [[state.inner[k] - home.o[k] + 1);]])
mutant(normal_is_turned_as_a_direction FILE model/unit/shade/surf.cpp TEST accel [secondary]
  OLD [[in.placement.a[3 * i + k]) * state.normal[i];]]
  NEW [[in.placement.a[3 * k + i]) * state.normal[i];]])
mutant(corner_normals_scaled_as_points FILE model/compile/levels/compile.cpp TEST accel [secondary]
  OLD [[normal *= made.lattice.pitch / length;]]
  NEW [[normal /= made.lattice.pitch * length;]])
mutant(levels_boxes_of_camera_rays_only FILE model/compile/levels/fit.cpp TEST accel [secondary]
  OLD [[if (config.shading && !map.is_same) map.off =]]
  NEW [[if (config.shading && made.longest < 0) map.off =]])
mutant(levels_boxes_forget_where_bounces_begin FILE model/compile/levels/fit.cpp TEST accel [secondary]
  OLD [[off = begin + slope * reach(begin, bounce);]]
  NEW [[off = slope * reach(begin, bounce);]])
mutant(levels_boxes_forget_the_longest_edge FILE model/compile/levels/fit.cpp TEST accel [secondary]
  OLD [[+ 2.5 * frac * made.longest;]]
  NEW [[+ 0 * made.longest;]])

# ---- What a ray is the same in, planes and spheres.
mutant(surface_is_turned_where_it_is_the_same FILE model/unit/shade/surf.cpp TEST accel "what is not placed is drawn by two levels as by one*"
  OLD [[if (in.placement.same) return;]]
  NEW [[if (in.placement.same && in.placement.here == 0) return;]])
mutant(camera_ray_leaves_a_sphere FILE model/unit/isect/any.cpp TEST accel "what is not placed is drawn by two levels as by one*"
  OLD [[RayKind(ray.kind) != RayKind::camera && sphere]]
  NEW [[sphere]])
mutant(planes_have_an_end_above FILE model/compile/levels/maps.cpp TEST accel "what is not placed is drawn by two levels as by one*"
  OLD [[if (box.lo[0] <= box.hi[0]) made.points = {box.lo, box.hi};]]
  NEW [[if (box.lo[0] <= box.hi[0]) made.points = {box.lo, {0, 0, 0}};]])

# ---- Their judge.
set(round_judge "every ray of planes and true spheres beside instances*")
mutant(oracle_of_levels_forgets_planes FILE sim/judge/oracle/placed.cpp TEST system ${round_judge}
  OLD [[all.is_endless = true;]]
  NEW [[all.is_endless = false;]])
mutant(oracle_of_levels_forgets_the_surface_left FILE sim/judge/oracle/placed.cpp TEST system ${round_judge}
  OLD [[seen.self = is_own ?]]
  NEW [[seen.self = is_own && place == 0 ?]])
mutant(oracle_of_levels_forgets_spheres FILE sim/judge/oracle/placed.cpp TEST system "an answer of planes and true spheres*"
  OLD [[best.sphere_place = place, best.sphere = found.sphere;]]
  NEW [[best.sphere_place = PlacedRay::nowhere;]])
mutant(judge_of_levels_turns_what_is_the_same FILE sim/judge/paths/path_placed.cpp TEST system ${round_judge}
  OLD [[if (!is_turned()) {]]
  NEW [[if (!is_turned() && visit_.place == 0) {]])
mutant(judge_of_levels_believes_any_identity FILE sim/judge/paths/placed.cpp TEST system "the judge sees memory*"
  OLD [[if (is_there && config_.shading && (map.same != 0) != placed.is_same)]]
  NEW [[if (is_there && config_.shading && map.same == 2)]])
mutant(judge_of_levels_takes_any_sphere FILE sim/judge/paths/answer.cpp TEST system "an answer of planes and true spheres*"
  OLD [[const char* const wrong = met.shape == Solid::Shape::sphere]]
  NEW [[const char* const wrong = met.shape == Solid::Shape::sphere ? nullptr : met.shape == Solid::Shape::sphere]])

# ---- The same in RTL.
mutant(rtl_list_forgets_the_instance_that_was_hit FILE rtl/unit/list/rc_list.sv TEST system "model and RTL draw instances alike"
  OLD [[.write_i(it_closer), .write_addr_i(it_ray), .write_data_i(it_here),]]
  NEW [[.write_i(change_fires_i), .write_addr_i(change_i.ray), .write_data_i(change_i.here | (it_here & {A{1'b0}})),]])
mutant(rtl_surface_is_turned_where_it_is_the_same FILE rtl/unit/shade/rc_pass_end.sv TEST system "model and RTL draw planes and true spheres*"
  OLD [[turn_i && home_i != '0;]]
  NEW [[turn_i && home_i != '1;]])
mutant(rtl_camera_ray_leaves_a_sphere FILE rtl/unit/isect/rc_tri.sv TEST system "model and RTL draw planes and true spheres*"
  OLD [[(in_any || in.kind == rc_pkg::RayBounce) && in.self]]
  NEW [[(in_any || in_leaves) && in.self]])
mutant(rtl_list_forgets_what_a_ray_asks FILE rtl/unit/list/rc_list.sv TEST system "model and RTL draw planes and true spheres*"
  OLD [[.read_addr_i(change_i.ray), .read_data_o(kept_asks));]]
  NEW [[.read_addr_i(~change_i.ray), .read_data_o(kept_asks));]])
mutant(rtl_xform_forgets_home FILE rtl/unit/xform/rc_xform.sv TEST system "model and RTL draw instances alike"
  OLD [[in.kind != rc_pkg::RayCamera && in.home == in.here;]]
  NEW [[1'b0 && in.home == in.here;]])
mutant(rtl_xform_moves_lights_between_points FILE rtl/unit/xform/rc_xform.sv TEST system "model and RTL draw instances alike"
  OLD [[rounded = sum_shadow ?]]
  NEW [[rounded = 1'b0 && sum_shadow ?]])
mutant(rtl_xform_takes_shadow_rays_for_short FILE rtl/unit/xform/rc_xform.sv TEST system "model and RTL draw instances alike"
  OLD [[assign is_short = valid[Moved] ? !moved_shadow : short_q;]]
  NEW [[assign is_short = !valid[Moved] || !moved_shadow || short_q;]])
mutant(rtl_tri_drops_a_camera_rays_fraction FILE rtl/unit/isect/rc_tri.sv TEST system "model and RTL draw instances alike"
  OLD [[|| (rc_pkg::Levels == 2 && in.kind]]
  NEW [[|| (rc_pkg::Levels == 3 && in.kind]])
mutant(rtl_shade_keeps_the_last_material FILE rtl/unit/shade/rc_shade.sv TEST system "model and RTL draw instances alike"
  OLD [[lent_q[came_ray]  <= lends ||]]
  NEW [[lent_q[came_ray]  <= lent_q[came_ray] || lends ||]])
mutant(rtl_homes_mix_rows_and_columns FILE rtl/unit/shade/rc_homes.sv TEST unit "the rtl's pass is the model's with instances"
  OLD [[s0_a_i[(3*i+k)*E +: E];]]
  NEW [[s0_a_i[(3*k+i)*E +: E];]])
mutant(rtl_homes_round_lights_down FILE rtl/unit/shade/rc_homes.sv TEST unit "the rtl's pass is the model's with instances"
  OLD [[SW'($signed(s15_b[k*(N+K) +: N+K])) + Half : Half;]]
  NEW [[SW'($signed(s15_b[k*(N+K) +: N+K])) : Half;]])
mutant(rtl_homes_tell_of_a_sphere_for_a_cycle FILE rtl/unit/shade/rc_homes.sv TEST unit "the rtl's pass is the model's with instances"
  OLD [[.sphere_i(4'b1111),]]
  NEW [[.sphere_i(turn_valid_i[3:0]),]])

# ---- What the judge of two levels must call a bug, without RTL and without a golden picture.
set(gears_levels "gearbox:2 --depth 3 --set levels=2")
mutant(none_in_simulate_of_levels FILE model/unit/xform/xform.cpp TEST simulate "${gears_levels} | gearbox:2 --set levels=2")
mutant(judge_levels_ray_rounded_down FILE model/unit/xform/xform.cpp TEST simulate "gearbox:2 --set levels=2"
  OLD [[(std::int64_t(1) << config.origin_frac()) + (std::int64_t(1) << (frac - 1));]]
  NEW [[(std::int64_t(1) << config.origin_frac());]])
mutant(judge_levels_home_is_forgotten FILE model/unit/xform/xform.cpp TEST simulate "${gears_levels}"
  OLD [[req.home.line == p.here;]]
  NEW [[req.home.line == p.here + 1;]])
mutant(judge_levels_shadow_ray_ends_beside_its_point FILE model/unit/shade/light.cpp TEST simulate "flight:8 --depth 2 --set levels=2"
  OLD [[state.inner[k] - home.o[k]);]]
  NEW [[state.inner[k] - home.o[k] + 1);]])
mutant(judge_levels_side_of_the_scenes_direction FILE model/unit/shade/light.cpp TEST simulate "${gears_levels}"
  OLD [[c.has_homes() ? out.home.d : out.d;]]
  NEW [[out.d;]])
mutant(judge_levels_normal_turned_as_a_direction FILE model/unit/shade/surf.cpp TEST simulate "${gears_levels}"
  OLD [[in.placement.a[3 * i + k]) * state.normal[i];]]
  NEW [[in.placement.a[3 * k + i]) * state.normal[i];]])
mutant(judge_levels_point_is_not_kept FILE model/unit/shade/surf.cpp TEST simulate "${gears_levels}"
  OLD [[    if (in.placement.same) return;
    ray_at(in, c, state.o);]]
  NEW [[    if (in.placement.same) return;
    ray_at(in, c, state.o);
    state.inner = state.o;]])
mutant(judge_levels_map_is_cut FILE model/compile/levels/fit.cpp TEST simulate "gearbox:2 --set levels=2"
  OLD [[sum > one ? std::trunc(exact[k]) : std::round(exact[k]);]]
  NEW [[std::trunc(exact[k]);]])
mutant(judge_levels_place_of_another_time FILE model/compile/levels/moving.cpp TEST simulate "crowd:2 --set levels=2 --frames 3 --fps 8"
  OLD [[        map = map_at(places[i], map.mesh_class, levels_.maps, config_);]]
  NEW [[        if (frame_ < 2) map = map_at(places[i], map.mesh_class, levels_.maps, config_);]])
mutant(judge_levels_material_of_the_mesh FILE model/compile/levels/compile.cpp TEST simulate "flight:8 --depth 2 --set levels=2"
  OLD [[entry.material = material_of(*own);]]
  NEW [[entry.material = 0 * material_of(*own);]])

# ---- A refracted ray that boxes do not hold.
mutant(short_refracted_ray_goes FILE model/unit/shade/bounce.cpp TEST unit [bounce]
  OLD [[&& is_held(c, out.d);]]
  NEW [[&& (is_held(c, out.d) || c.has_homes());]])
mutant(rtl_short_refracted_ray_goes FILE rtl/unit/shade/rc_pass_end.sv TEST system "model and RTL send no refracted ray*"
  OLD [[assign held = holds != '0;]]
  NEW [[assign held = holds != '1;]])
mutant(judge_of_levels_misses_short_refracted_rays FILE sim/judge/paths/path_bounce.cpp TEST system "every ray and colour of a sound picture of instances*"
  OLD [[if (rules_.placed && std::max(]]
  NEW [[if (!rules_.placed && std::max(]])

# ---- The judge itself, its oracle and its causes.
mutant(oracle_of_levels_has_no_margin FILE sim/judge/oracle/placed.cpp TEST system "a small mesh is found*"
  OLD [[whole_above(reach * (1 + std::max<Int128>(longest, 1)), 2) + 1;]]
  NEW [[whole_above(reach * (1 + std::max<Int128>(longest, 1)), 1 << 20) + 1;]])
mutant(oracle_of_levels_rounds_down FILE sim/judge/oracle/placed.cpp TEST system "the oracle of two levels*"
  OLD [[2 * n + (Int128(1) << bits)]]
  NEW [[2 * n]])
mutant(oracle_of_levels_takes_the_last_of_equals FILE sim/judge/oracle/placed.cpp TEST system "the oracle of two levels*"
  OLD [[(order == 0 && place > best.place)]]
  NEW [[(order == 0 && place < best.place)]])
mutant(judge_of_levels_takes_any_map FILE sim/judge/paths/placed.cpp TEST system "the judge sees memory*"
  OLD [[if (!good) faults_]]
  NEW [[if (false) faults_]])
mutant(judge_of_levels_misses_an_instance FILE sim/judge/paths/placed.cpp TEST system "the judge sees memory*"
  OLD [[if (placed.found.size() != (is_there ? 1u : 0u))]]
  NEW [[if (placed.found.size() > 1)]])
mutant(seams_are_everywhere FILE sim/judge/cause/seam.cpp TEST system [cause][levels]
  OLD [[if (first.place == question.answer.place) return RayFinding::one_line;]]
  NEW [[if (first.place == question.answer.place) continue;]])
mutant(seams_are_nowhere FILE sim/judge/cause/seam.cpp TEST system [cause][levels]
  OLD [[return is_bounded ? RayFinding::seam : RayFinding::none;]]
  NEW [[return is_bounded ? RayFinding::one_line : RayFinding::none;]])
mutant(seams_may_be_a_tenth_apart FILE sim/judge/cause/seam.cpp TEST system [cause][levels]
  OLD [[return share <= 1 + 1e-6;]]
  NEW [[return share <= 0.1;]])

# ---- Two structures: each level's nodes go to its own unit, and one answer comes in a cycle.
mutant(rtl_mesh_node_goes_to_the_upper_unit FILE rtl/unit/trav/rc_trav.sv TEST system "model and RTL walk two structures alike"
  OLD [[assign mesh_req_valid_o   = node_rsp_valid_i && in_mesh;]]
  NEW [[assign mesh_req_valid_o   = node_rsp_valid_i && node_rsp_i.what == rc_pkg::LineSceneNode;]])
mutant(rtl_quicker_unit_does_not_wait FILE rtl/unit/trav/rc_tree.sv TEST system "model and RTL walk two structures alike"
  OLD [[.Pad(rc_pkg::MeshPad)]]
  NEW [[.Pad(rc_pkg::MeshPad / 2)]])
mutant(rtl_two_units_have_two_doors FILE rtl/unit/trav/rc_tree.sv TEST system "model and RTL walk two structures alike"
  OLD [[.leave_i(decide_rsp_valid || mesh_rsp_valid), .open_o(open));]]
  NEW [[.leave_i(decide_rsp_valid), .open_o(open));]])
mutant(rtl_both_units_rest FILE rtl/unit/trav/rc_tree.sv TEST system "model and RTL walk two structures alike"
  OLD [[.req_i(mesh_req), .open_i(open),]]
  NEW [[.req_i(mesh_req), .open_i(open && decide_req_ready),]])
mutant(rtl_exits_keep_the_order_of_boxes FILE rtl/unit/trav/rc_child_offsets.sv TEST system "model and RTL walk two structures alike"
  OLD [[Exits ? exits : O'(2 * i)]]
  NEW [[(rc_pkg::Structure == rc_pkg::StructureKd) && Exits ? exits : O'(2 * i)]])
mutant(model_one_unit_rests_for_both FILE model/machine/pipeline.inl WITH model/machine/machine.cpp model/machine/pipeline.cpp TEST system "model and RTL walk two structures alike"
  OLD [[((box_rest_ == 0) | (m.low_asks != box_is_low_))]]
  NEW [[(box_rest_ == 0)]])
mutant(model_counts_the_lower_unit_as_the_upper FILE model/machine/pipeline.hpp WITH model/machine/machine.cpp model/machine/pipeline.cpp TEST system "model and RTL walk two structures alike"
  OLD [[const bool own = m.low_asks == low;]]
  NEW [[const bool own = m.low_asks == false || low;]])
mutant(levels_compile_meshes_as_the_scene FILE model/compile/levels/compile.cpp TEST system "two levels of any two structures*"
  OLD [[compile_triangles(prims, config_.lower(), name_);]]
  NEW [[compile_triangles(prims, config_.upper(), name_);]])
mutant(film_has_room_for_its_first_tree FILE model/compile/levels/moving.cpp TEST motion "frames of a film write*"
  OLD [[for (const Places& places : times) {]]
  NEW [[for (const Places& places : times.first(1)) {]])
mutant(film_leaves_out_lines_of_zeros FILE model/compile/refit/flat.cpp TEST motion "the chip has what the host means*"
  OLD [[{held.begin(), part(written_)}, upload);]]
  NEW [[{held.begin(), part(tree)}, upload);]])
mutant(film_writes_surfaces_once FILE model/compile/refit/flat.cpp TEST motion "a mesh that deforms has finished pictures*"
  OLD [[take_differences(image_, tree_lines_,]]
  NEW [[if (is_first) take_differences(image_, tree_lines_,]])

# ---- Scenes that are placed.
mutant(boughs_have_their_cones_inside_out FILE model/scene/generate/tree.cpp TEST scene "The boughs are*"
  OLD [[base_radius * ring.start, base_radius * ring.quarter]]
  NEW [[base_radius * ring.quarter, base_radius * ring.start]])
mutant(flake_has_balls_of_one_size FILE model/scene/generate/mesh_writer.cpp TEST scene "The flake is*"
  OLD [[place{glm::dmat3(radius)};]]
  NEW [[place{glm::dmat3(radius < 1 ? 0.5 : 1.0)};]])
mutant(reference_forgets_where_instances_stand FILE sim/judge/reference/instances.cpp TEST reference "Embree's instances*"
  OLD [[placed.back * (origin - placed.origin), turned]]
  NEW [[placed.back * origin, turned]])
mutant(reference_numbers_instances_from_zero FILE sim/judge/reference/instances.cpp TEST reference "Embree's instances*"
  OLD [[static_cast<std::uint32_t>(first),]]
  NEW [[static_cast<std::uint32_t>(first * 0),]])

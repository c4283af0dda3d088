# Faults of the structures other than the box tree: mutants_rtl.cmake says what a row is.

# ---- spheres: globes are rounded outward, in the compiler and in the unit.
mutant(globe_radius_rounded_down FILE model/engine/globe/encode.cpp TEST accel "globes are written outward*"
  OLD [[std::ceil((globe.radius + glm::length(moved)) / step)]]
  NEW [[std::floor((globe.radius + glm::length(moved)) / step)]])
mutant(globe_forgets_that_its_centre_moved FILE model/engine/globe/encode.cpp TEST accel "globes are written outward*"
  OLD [[(globe.radius + glm::length(moved)) / step]]
  NEW [[(globe.radius + 0 * glm::length(moved)) / step]])
mutant(globe_encloses_all_but_the_last FILE model/engine/globe/around.cpp TEST accel "images of globes hold what they say"
  OLD [[n < order.count[node]; ++n)]]
  NEW [[n + 1 < order.count[node] || n == 0; ++n)]])
mutant(model_globe_without_slack FILE model/engine/globe/globe.cpp TEST unit "globe is right*"
  OLD [[>> node.exp) + 3;]]
  NEW [[>> node.exp) - 6;]])
mutant(model_globe_half_chord_rounded_down FILE model/engine/globe/tables.cpp TEST unit "globe*"
  OLD [[(i + 65) << 10]]
  NEW [[(i + 57) << 10]])
mutant(model_globe_ends_too_early FILE model/engine/globe/globe.cpp TEST unit "globe is right*"
  OLD [[if (way + half < sight.least) continue;]]
  NEW [[if (way < sight.least) continue;]])
mutant(globe_moment_of_the_wrong_sign QUICK FILE rtl/engine/globe/rc_chord.sv TEST unit [globe][lockstep]
  OLD [[moment_q <= ab - ba;]]
  NEW [[moment_q <= ba - ab;]])
mutant(globe_half_chord_is_not_rounded_up FILE rtl/engine/globe/rc_chord.sv TEST unit [globe][lockstep]
  OLD [[<< root_g) + (F + 10)'(255);]]
  NEW [[<< root_g) + (F + 10)'(0);]])
mutant(globe_forgets_an_axis_that_is_far FILE rtl/engine/globe/rc_chord.sv TEST unit [globe][lockstep]
  OLD [[assign there = over == '0 &&]]
  NEW [[assign there = (over[1:0] == '0 || &over) &&]])
mutant(globe_slack_forgets_an_axis FILE rtl/engine/globe/rc_sight.sv TEST unit [globe][lockstep]
  OLD [[assign first = size_q[0 +: Sum] + size_q[Sum +: Sum];]]
  NEW [[assign first = size_q[0 +: Sum] + (size_q[Sum +: Sum] >> 1);]])
mutant(toward_rounds_down FILE rtl/engine/globe/rc_toward.sv TEST system "model and RTL agree on globes"
  OLD [[assign rounded = whole + {{(G-1){1'b0}}, moved_q[H-G-1]};]]
  NEW [[assign rounded = whole + {{(G-1){1'b0}}, moved_q[H-G-1] && moved_q[H-1]};]])
mutant(trav_keeps_a_long_ray_as_a_short_one FILE rtl/unit/trav/rc_trav.sv TEST system "model and RTL agree on finished pictures of globes"
  OLD [[assign is_short = ray_i.kind != rc_pkg::RayShadow;]]
  NEW [[assign is_short = ray_i.kind != rc_pkg::RayBounce;]])
mutant(model_globe_leaf_off_by_one FILE model/engine/globe/globe.cpp TEST system "rays of every family hit the same in every structure"
  OLD [[2 * i : 2 * inner + primitives)]]
  NEW [[2 * i : 2 * inner + primitives + 1)]])
mutant(model_globe_is_met_when_the_ray_leaves_it FILE model/engine/globe/globe.cpp TEST system "rays of every family hit the same in every structure"
  OLD [[std::max<std::int64_t>(way - half, 0)]]
  NEW [[std::max<std::int64_t>(way + half, 0)]])

# ---- kd: planes are rounded outward, exits keep their places.
mutant(plane_far_side_from_rounded_up FILE rtl/engine/kd/rc_plane.sv TEST unit [treelet][lockstep]
  OLD [[D'(way_at) - D'(way_point) - $signed({{(D-1){1'b0}}, way_between});]]
  NEW [[D'(way_at) - D'(way_point);]])
mutant(plane_near_side_to_rounded_down FILE rtl/engine/kd/rc_plane.sv TEST unit [treelet][lockstep]
  OLD [[(from_q >> (R1 - 2)) + T'(2) + step]]
  NEW [[(from_q >> R1) + T'(2) + step]])
mutant(plane_near_side_without_the_origins_step FILE rtl/engine/kd/rc_plane.sv TEST unit [treelet][lockstep]
  OLD [[HasTo && between_end_q && end_len_q == E'(Time - i);]]
  NEW [[HasTo && between_end_q && end_len_q == E'(Time - i) && neg_end_q;]])
mutant(plane_far_away_does_not_saturate FILE rtl/engine/kd/rc_plane.sv TEST unit [treelet][lockstep]
  OLD [[{T{rest_many || fine[T+6:T] != '0}}]]
  NEW [[{T{rest_many || fine[T+6:T] == '1}}]])
mutant(plane_with_the_origin_on_it_is_ahead FILE rtl/engine/kd/rc_plane.sv TEST unit [treelet][lockstep]
  OLD [[at_or_ahead && (between_q || way_q != '0);]]
  NEW [[at_or_ahead;]])
mutant(bounds_enter_by_the_last_plane FILE rtl/engine/kd/rc_bounds.sv TEST unit [treelet][lockstep]
  OLD [[assign first  = turned ? hi : lo;]]
  NEW [[assign first  = lo;]])
mutant(treelet_exits_in_another_order FILE rtl/engine/kd/rc_exits.sv TEST unit [treelet][lockstep]
  OLD [[localparam int unsigned Upper = (i >> (Levels - 1 - l)) & 1;]]
  NEW [[localparam int unsigned Upper = (i >> l) & 1;]])
mutant(treelet_exit_ends_too_early FILE rtl/engine/kd/rc_exits.sv TEST unit [treelet][lockstep]
  OLD [[= enter <= leave &&]]
  NEW [[= enter < leave &&]])
mutant(treelet_box_forgets_an_axis FILE rtl/engine/kd/rc_bounds.sv TEST unit [treelet][lockstep]
  OLD [[assign box_there[k]   = far_first && near_last;]]
  NEW [[assign box_there[k]   = k == 2 || (far_first && near_last);]])
mutant(places_exit_off_by_one FILE rtl/unit/trav/rc_child_offsets.sv TEST unit [treelet][lockstep]
  OLD [[Exits ? exits : O'(2 * i)]]
  NEW [[Exits ? exits + O'(2) : O'(2 * i)]])
mutant(model_plane_from_rounded_up FILE model/engine/kd/treelet.cpp TEST unit [treelet]
  OLD [[std::uint32_t(std::min(way, double(beyond)))]]
  NEW [[std::uint32_t(std::ceil(std::min(way, double(beyond))))]])
mutant(model_plane_to_without_what_rounding_loses FILE model/engine/kd/treelet.cpp TEST unit [treelet]
  OLD [[(sides.far_from >> (c.recip_bits - 1)) + 2 + step;]]
  NEW [[step;]])
mutant(model_plane_to_without_the_origins_step FILE model/engine/kd/treelet.cpp TEST unit [treelet]
  OLD [[(sides.far_from >> (c.recip_bits - 1)) + 2 + step;]]
  NEW [[(sides.far_from >> (c.recip_bits - 1)) + 2;]])
mutant(model_treelet_children_in_wrong_order FILE model/engine/kd/treelet.cpp TEST unit [treelet]
  OLD [[const bool upper = treelet.exit[child] & half;]]
  NEW [[const bool upper = !(treelet.exit[child] & half);]])
mutant(model_treelet_early_end_too_early FILE model/engine/kd/treelet.cpp TEST system "rays of every family hit the same in every structure"
  OLD [[hits |= std::uint32_t(span.met && span.from <= span.to) << child;]]
  NEW [[hits |= std::uint32_t(span.met && span.from + 4 <= span.to) << child;]])
# Of kd, octrees and bsp.
mutant(model_leaf_of_an_exit_off_by_one FILE model/engine/kd/treelet.cpp TEST system "rays of every family hit the same in every structure"
  OLD [[place(i, half_lines, kind[i] - 1);]]
  NEW [[place(i, half_lines + 1, kind[i] - 1);]])
mutant(cells_change_sides FILE model/engine/kd/exits.hpp WITH model/compile/emit_cells.cpp TEST system "rays of every family hit the same in every structure"
  OLD [[fill(cut ? place.lower() : place, 2 * plane + 1, exit, exits / 2, line);
        fill(cut ? place.upper() : Place(), 2 * plane + 2,]]
  NEW [[fill(cut ? place.upper() : place, 2 * plane + 1, exit, exits / 2, line);
        fill(cut ? place.lower() : Place(), 2 * plane + 2,]])
mutant(cells_one_line_too_far FILE model/compile/emit_cells.cpp TEST system "rays of every family hit the same in every structure"
  OLD [[std::uint32_t(--line)]]
  NEW [[std::uint32_t(line--)]])

# ---- bsp: planes in any direction are rounded outward, in the unit and in its model.
mutant(crossing_far_side_from_too_late FILE rtl/engine/bsp/rc_crossing.sv TEST unit [slant][lockstep]
  OLD [[assign from_d = {1'b0, quo} - (V+1)'(2);]]
  NEW [[assign from_d = {1'b0, quo} + (V+1)'(2);]])
mutant(crossing_near_side_to_too_early FILE rtl/engine/bsp/rc_crossing.sv TEST unit [slant][lockstep]
  OLD [[|| &to_t ? '1 : to_t + T'(1);]]
  NEW [[|| &to_t ? '1 : to_t;]])
mutant(crossing_with_the_origin_on_it_is_ahead FILE rtl/engine/bsp/rc_crossing.sv TEST unit [slant][lockstep]
  OLD [[assign ahead = !on && num_q[NW-1] == neg;]]
  NEW [[assign ahead = num_q[NW-1] == neg;]])
mutant(crossing_of_a_ray_in_the_plane_has_one_side FILE rtl/engine/bsp/rc_crossing.sv TEST unit [slant][lockstep]
  OLD [[assign near  = zero ? ahead || on : ahead;]]
  NEW [[assign near  = ahead;]])
mutant(crossing_divisor_one_bit_too_far FILE rtl/engine/bsp/rc_crossing.sv TEST unit [slant][lockstep]
  OLD [[if (den_abs[i]) den_len = E'(i + 1);]]
  NEW [[if (den_abs[i]) den_len = E'(i == 0 ? 2 : i + 1);]])
mutant(slant_box_comes_too_early FILE rtl/engine/bsp/rc_slant.sv TEST unit [slant][lockstep]
  OLD [[.valid_i(valid[Meet+In:Box]), .data_i({enter, leave, there}),]]
  NEW [[.valid_i(valid[Meet+In:Box]), .data_i({leave, enter, there}),]])
mutant(trav_keeps_a_shadow_rays_direction_moved_up FILE rtl/unit/trav/rc_node_ray.sv TEST system "model and RTL agree on finished pictures of planes in any direction"
  OLD [[<< (short_i ? M - rc_pkg::DirBits : 0);]]
  NEW [[<< (short_i ? 0 : M - rc_pkg::DirBits);]])
mutant(model_crossing_from_too_late FILE model/engine/bsp/slant.cpp TEST unit [slant]
  OLD [[moved(q - 2, x, beyond)]]
  NEW [[moved(q + 2, x, beyond)]])
mutant(model_crossing_to_too_early FILE model/engine/bsp/slant.cpp TEST unit [slant]
  OLD [[moved(q + 2, x, beyond - 1) + 1]]
  NEW [[moved(q - 2, x, beyond - 1) + 1]])
mutant(model_crossing_ends_at_a_plane_that_it_begins_on FILE model/engine/bsp/slant.cpp TEST unit [slant]
  OLD [[sides.near = num > 0;]]
  NEW [[sides.near = num >= 0;]])
mutant(model_crossing_changes_sides FILE model/engine/bsp/slant.cpp TEST system "lines meet as many cells of planes in any direction*"
  OLD [[sides.turned = den < 0;]]
  NEW [[sides.turned = den > 0;]])
mutant(model_crossing_never_ends_the_near_side FILE model/engine/bsp/slant.cpp TEST system "lines meet as many cells of planes in any direction*"
  OLD [[moved(q + 2, x, beyond - 1) + 1]]
  NEW [[beyond]])

# ---- The compiler of bsp: nothing is lost.
mutant(bsp_normal_on_other_axes FILE model/engine/kd/exits.hpp WITH model/compile/emit_cells.cpp TEST system "rays of every family hit the same in every structure"
  OLD [[slant.normal[3 * plane + k] = cell.normal[k];]]
  NEW [[slant.normal[3 * plane + k] = cell.normal[2 - k];]])
mutant(bsp_clips_inward FILE model/engine/kd/clip.cpp TEST accel [slant]
  OLD [[wall.at + (wall.upper ? -beside : beside)]]
  NEW [[wall.at + (wall.upper ? 40 : -40)]])
mutant(bsp_loses_a_straddler FILE model/engine/kd/cell.cpp TEST accel [slant]
  OLD [[if (reach.hi > cut.plane || (flat && cut.flat_above)) take(item, above, upper);]]
  NEW [[if ((reach.hi > cut.plane && (cut.axis != no_axis || reach.lo >= cut.plane)) || (flat && cut.flat_above))
            take(item, above, upper);]])
mutant(bsp_cuts_what_it_should_not FILE model/engine/bsp/facets.cpp TEST accel "images of planes in any direction hold what they say"
  OLD [[if (stops_ && below + above + flat > all) return;]]
  NEW [[if (stops_ && below + above + flat > all + 1) return;]])
mutant(bsp_knows_no_plane_but_across_axes FILE model/engine/bsp/facets.cpp TEST accel "some planes of real scenes lie across no axis"
  OLD [[(normal[2] != 0) < 2) continue;]]
  NEW [[(normal[2] != 0) < 4) continue;]])

# ---- The compiler of kd: nothing is lost.
mutant(kd_clips_inward FILE model/engine/kd/clip.cpp TEST system "rays of every family hit the same in every structure"
  OLD [[constexpr double slack = 1.0 / 1024, outward = 1.0 / (1 << 20);]]
  NEW [[constexpr double slack = 1.0 / 1024, outward = -3.0;]])
mutant(kd_loses_a_straddler FILE model/engine/kd/cell.cpp TEST system "rays of every family hit the same in every structure"
  OLD [[if (reach.hi > cut.plane || (flat && cut.flat_above)) take(item, above, upper);]]
  NEW [[if ((reach.hi > cut.plane && (cut.axis == no_axis || reach.lo >= cut.plane)) || (flat && cut.flat_above))
            take(item, above, upper);]])
mutant(kd_loses_what_lies_in_a_plane FILE model/engine/kd/cell.cpp TEST system "rays of every family hit the same in every structure"
  OLD [[if (reach.hi > cut.plane || (flat && cut.flat_above)) take(item, above, upper);]]
  NEW [[if (reach.hi > cut.plane) take(item, above, upper);]])
mutant(kd_loses_the_last_of_a_leaf FILE model/compile/emit_cells.cpp TEST system "rays of every family hit the same in every structure"
  OLD [[treelet.kind[i] > 1 && p < exits[i].count]]
  NEW [[treelet.kind[i] > 1 && p + 1 < exits[i].count]])
mutant(kd_sweep_ends_a_step_late FILE model/engine/kd/split.cpp TEST accel "no plane of a cell is cheaper*"
  OLD [[hi_[ended] <= plane) ++ended;]]
  NEW [[hi_[ended] < plane) ++ended;]])
mutant(kd_sweep_tries_the_lower_ends_alone FILE model/engine/kd/split.cpp TEST accel "no plane of a cell is cheaper*"
  OLD [[{lo(plane), hi(plane), before(plane), after(plane)}]]
  NEW [[{lo(plane), before(plane), after(plane)}]])
mutant(kd_sweep_leaves_out_what_is_beside_the_flat FILE model/engine/kd/split.cpp TEST accel "no plane of a cell is cheaper*"
  OLD [[{lo(plane), hi(plane), before(plane), after(plane)}]]
  NEW [[{lo(plane), hi(plane)}]])
mutant(kd_sorts_by_the_low_digit_alone FILE model/engine/kd/split.cpp TEST accel "no plane of a cell is cheaper*"
  OLD [[shift < 32 && extent >> shift > 0]]
  NEW [[shift < digit && extent >> shift > 0]])
mutant(treelets_have_a_level_too_many FILE model/engine/kd/treelets.cpp TEST accel "no choice of treelets costs less*"
  OLD [[cell.is_leaf() ? 0 : parts(cell, {cell.bounds}, levels_ - 1);]]
  NEW [[cell.is_leaf() ? 0 : parts(cell, {cell.bounds}, levels_);]])
mutant(treelets_are_never_leaves FILE model/engine/kd/treelets.cpp TEST accel "no choice of treelets costs less*"
  OLD [[if (cell.count <= leaf_most && tests <= best.cost)]]
  NEW [[if (cell.count <= 1 && tests <= best.cost)]])
mutant(treelets_lose_half_of_a_leaf FILE model/engine/kd/treelets.cpp TEST accel "no choice of treelets costs less*"
  OLD [[gather(*cell.upper, prims);]]
  NEW [[]])
mutant(treelets_have_a_primitive_twice FILE model/engine/kd/treelets.cpp TEST accel "no choice of treelets costs less*"
  OLD [[cell.prims.erase(std::unique(cell.prims.begin(), cell.prims.end()), cell.prims.end());]]
  NEW [[]])
mutant(cells_ignore_where_a_treelet_begins FILE model/engine/kd/exits.hpp WITH model/compile/emit_cells.cpp TEST accel "a treelet begins where it was decided*"
  OLD [[(plane == 0 || !place.cell->begins)]]
  NEW [[(plane == 0 || plane > 0)]])

# ---- Boxes with spatial splits: no part is lost, and no leaf has a primitive twice.
mutant(splits_lose_the_upper_part FILE model/engine/bvh/splits.cpp TEST accel "boxes with spatial splits hold what lies in them"
  OLD [[upper.items.push_back({s.above, s.whole.index});]]
  NEW [[upper.box.add(s.above);]])
mutant(splits_box_the_wrong_part FILE model/engine/bvh/splits.cpp TEST accel "boxes with spatial splits hold what lies in them"
  OLD [[lower.items.push_back({s.below, s.whole.index});]]
  NEW [[lower.items.push_back({s.above, s.whole.index});]])
mutant(splits_leave_a_primitive_in_a_leaf_twice FILE model/compile/emit.cpp TEST accel "boxes with spatial splits hold what lies in them"
  OLD [[once(before);]]
  NEW [[static_cast<void>(before);]])

# ---- The compiler of octrees: octants in their places, straddlers in every one of them or in the node.
mutant(octree_octants_change_places FILE model/engine/octree/build.cpp TEST system "rays of every family hit the same in every structure"
  OLD [[beside(joined(octants, below, axis + 1), joined(octants + half, above, axis + 1))]]
  NEW [[beside(joined(octants + half, above, axis + 1), joined(octants, below, axis + 1))]])
mutant(octree_straddler_is_on_one_side FILE model/engine/octree/build.cpp TEST system "rays of every family hit the same in every structure"
  OLD [[pieces_.divide(part.items, {part.box}, cut, lower.items, upper.items);]]
  NEW [[for (const kd::Item& item : part.items)
                (item.box.hi[axis] > cut.plane ? upper : lower).items.push_back(item);]])
mutant(octree_loses_the_straddlers_of_a_node FILE model/engine/octree/build.cpp TEST system "rays of every family hit the same in every structure"
  OLD [[return own.empty() ? std::move(tree) : beside(leaf_of(own), std::move(tree));]]
  NEW [[return tree;]])
mutant(octree_cuts_beside_the_middle FILE model/engine/octree/build.cpp TEST accel "an octree halves its cells*"
  OLD [[(box.lo[axis] + box.hi[axis]) >> 1]]
  NEW [[(3 * box.lo[axis] + box.hi[axis]) >> 2]])

# ---- none: every page, and no more than the light asks for.
mutant(none_page_beyond_the_last FILE rtl/engine/none/rc_none.sv TEST system "model and RTL agree on a list of all primitives"
  OLD [[assign more = next < {1'b0, listed}]]
  NEW [[assign more = next <= {1'b0, listed}]])
mutant(none_last_leaf_is_full FILE rtl/engine/none/rc_none.sv TEST system "model and RTL agree on a list of all primitives"
  OLD [[: {{(C-2){1'b0}}, left[1:0]};]]
  NEW [[: C'(Leaf);]])
mutant(none_goes_on_when_told_to_stop FILE rtl/engine/none/rc_none.sv TEST system "model and RTL agree on finished pictures of every structure"
  OLD [[&& !s1_stop_q;]]
  NEW [[&& (!s1_stop_q || s1_ray_q[0]);]])

# ---- Octrees by published rules.
mutant(published_octree_without_room_around FILE sim/judge/reference/octree.cpp TEST reference "octrees of Haines' scenes are those that were published"
  OLD [[around_root = 0.001]]
  NEW [[around_root = 0.0001]])
mutant(published_octree_forgets_thin_boxes FILE sim/judge/reference/octree.cpp TEST reference "octrees of Haines' scenes are those that were published"
  OLD [[if (box.hi[k] - box.lo[k] < thin)]]
  NEW [[if (box.hi[k] - box.lo[k] < 0.9 * thin)]])
mutant(published_rays_meet_glass FILE sim/study/spd_octree.cpp TEST cli "rays do in octrees what was published*"
  OLD [[return scene.materials[material].transmit > 0;]]
  NEW [[return scene.materials[material].transmit > 1;]])
mutant(published_rays_find_the_last_in_the_way FILE sim/judge/reference/octree.cpp TEST reference "a shadow ray ends at the first test of what is in its way"
  OLD [[last = std::min(last, std::uint32_t(at - list));]]
  NEW [[last = std::uint32_t(at - list);]])
mutant(published_rays_of_another_camera FILE sim/study/spd.cpp TEST cli "rays do in octrees what was published*"
  OLD [[between_corners = 512;]]
  NEW [[between_corners = 450;]])
mutant(published_lights_inside_of_glass FILE sim/study/spd_octree.cpp TEST cli "rays do in octrees what was published*"
  OLD [[.lights_outside_of_glass = true]]
  NEW [[.lights_outside_of_glass = false]])
mutant(published_octree_joins_what_is_not_connected FILE sim/judge/reference/octree.cpp TEST reference "what was one polygon is one object of an octree"
  OLD [[connect(first, end);]]
  NEW [[for (std::uint32_t i = first; i < end; ++i) of_[i] = first;]])

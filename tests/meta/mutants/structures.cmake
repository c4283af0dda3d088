# Faults of the structures other than the box tree. rtl.cmake explains a row.

# ---- Globes: rounded outward, in the compiler and in the unit.
mutant(globe_radius_rounded_down FILE model/engine/spheres/encode.cpp TEST compile
  "globes are written outward*"
  OLD [[std::ceil((globe.radius + glm::length(moved)) / step)]]
  NEW [[std::floor((globe.radius + glm::length(moved)) / step)]])
mutant(model_globe_without_slack FILE model/engine/spheres/globe.cpp TEST unit "globe is right*"
  OLD [[>> node.exp) + 3;]]
  NEW [[>> node.exp) - 6;]])
mutant(globe_moment_of_the_wrong_sign QUICK FILE rtl/engine/spheres/rc_chord.sv TEST unit [globe][lockstep]
  OLD [[moment_q <= ab - ba;]]
  NEW [[moment_q <= ba - ab;]])

# ---- Treelets of kd: planes are rounded outward.
mutant(model_plane_from_rounded_up FILE model/engine/space_cells/decide.cpp TEST unit [treelet]
  OLD [[std::uint32_t(std::min(way, double(beyond)))]]
  NEW [[std::uint32_t(std::ceil(std::min(way, double(beyond))))]])
mutant(model_plane_to_without_the_origins_step FILE model/engine/space_cells/decide.cpp TEST unit [treelet]
  OLD [[(sides.far_from >> (c.recip_bits - 1)) + 2 + step;]]
  NEW [[(sides.far_from >> (c.recip_bits - 1)) + 2;]])

# ---- Slants of bsp: planes in any direction are rounded outward, and no further than necessary.
mutant(model_crossing_from_too_late FILE model/engine/bsp/slant.cpp TEST unit [slant]
  OLD [[moved(q - 2, x, beyond)]]
  NEW [[moved(q + 2, x, beyond)]])
mutant(model_crossing_ends_at_a_plane_that_it_begins_on FILE model/engine/bsp/slant.cpp TEST unit [slant]
  OLD [[sides.near = num > 0;]]
  NEW [[sides.near = num >= 0;]])
mutant(model_crossing_never_ends_the_near_side FILE model/engine/bsp/slant.cpp TEST system
  "lines meet as many cells of planes in any direction*"
  OLD [[moved(q + 2, x, beyond - 1) + 1]]
  NEW [[beyond]])

# ---- Their compilers: no primitive is lost, none is in a leaf twice, and the cheapest plane is found.
mutant(bsp_normal_on_other_axes FILE model/engine/bsp/engine.hpp WITH model/compile/emit_cells.cpp TEST system
  "rays of every family hit the same in every structure"
  OLD [[slant.normal[3 * plane + k] = cell.normal[k];]]
  NEW [[slant.normal[3 * plane + k] = cell.normal[2 - k];]])
mutant(bsp_clips_inward FILE model/engine/space_cells/clip.cpp TEST compile [slant]
  OLD [[wall.at + (wall.upper ? -margin : margin)]]
  NEW [[wall.at + (wall.upper ? 40 : -40)]])
mutant(kd_loses_what_lies_in_a_plane FILE model/engine/space_cells/cell.cpp TEST system
  "rays of every family hit the same in every structure"
  OLD [[if (reach.hi > cut.plane || (flat && cut.flat_above)) take(item, above, upper);]]
  NEW [[if (reach.hi > cut.plane) take(item, above, upper);]])
mutant(kd_sweep_ends_a_step_late FILE model/engine/space_cells/split.cpp TEST compile
  "no plane of a cell is cheaper*"
  OLD [[hi_[ended] <= plane) ++ended;]]
  NEW [[hi_[ended] < plane) ++ended;]])
mutant(kd_sweep_leaves_out_what_is_beside_the_flat FILE model/engine/space_cells/split.cpp TEST compile
  "no plane of a cell is cheaper*"
  OLD [[{lo(plane), hi(plane), before(plane), after(plane)}]]
  NEW [[{lo(plane), hi(plane)}]])
mutant(treelets_have_a_primitive_twice FILE model/engine/space_cells/treelets.cpp TEST compile
  "no choice of treelets costs less*"
  OLD [[cell.prims.erase(std::unique(cell.prims.begin(), cell.prims.end()), cell.prims.end());]]
  NEW [[]])
mutant(splits_lose_the_upper_part FILE model/engine/bvh/splits.cpp TEST compile
  "boxes with spatial splits hold what lies in them"
  OLD [[upper.items.push_back({s.above, s.whole.index});]]
  NEW [[upper.box.add(s.above);]])
mutant(octree_straddler_is_on_one_side FILE model/engine/octree/build.cpp TEST system
  "rays of every family hit the same in every structure"
  OLD [[pieces_.divide(part.items, {part.box}, cut, lower.items, upper.items);]]
  NEW [[for (const space_cells::Item& item : part.items)
                (item.box.hi[axis] > cut.plane ? upper : lower).items.push_back(item);]])

# ---- Lists of all primitives.
mutant(none_page_beyond_the_last FILE rtl/engine/none/rc_none.sv TEST system
  "model and RTL agree on a list of all primitives"
  OLD [[assign more = next < {1'b0, listed}]]
  NEW [[assign more = next <= {1'b0, listed}]])

# ---- Pairs of planes of bih: each half ends where its primitives end.
mutant(bih_meets_the_other_half_first FILE rtl/engine/bih/rc_bih.sv TEST unit "bih loses no exit*"
  OLD [[assign first_at   = neg ? upper_from : lower_to;]]
  NEW [[assign first_at   = neg ? lower_to : upper_from;]])
mutant(model_bih_far_half_starts_at_the_near_plane FILE model/engine/bih/bih.cpp TEST unit
  "bih loses no exit*"
  OLD [[axis, neg ? lower_to : upper_from, config);]]
  NEW [[axis, neg ? upper_from : lower_to, config);]])
mutant(model_bih_without_a_turn FILE model/engine/bih/bih.cpp TEST unit "bih is right for every pair*"
  OLD [[const bool neg = axis < no_axis && ray.neg[axis] != 0;]]
  NEW [[const bool neg = false;]])
mutant(model_bih_bounds_are_swapped FILE model/engine/bih/build.cpp TEST system
  "rays of every family hit the same*"
  OLD [[if (left->bounds.centre(cell->axis) > right->bounds.centre(cell->axis)) std::swap(left, right);]]
  NEW [[if (left->bounds.centre(cell->axis) > right->bounds.centre(cell->axis)) std::swap(left->bounds, right->bounds);]])

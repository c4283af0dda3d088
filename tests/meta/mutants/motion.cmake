# Faults of instances, films and deforming meshes. rtl.cmake explains a row.

# ---- Two levels: the compiler. Its boxes hold every rounded ray.
mutant(upper_globes_hold_no_upper_corner FILE model/compile/levels/upper.cpp TEST compile [levels]
  OLD [[box.hi[2] : box.lo[2]},]]
  NEW [[box.lo[2] : box.lo[2]},]])
mutant(upper_boxes_reach_out_of_space FILE model/compile/levels/fit.cpp TEST compile [levels]
  OLD [[std::max({fitted.beyond, -largest - least, most - largest});]]
  NEW [[std::max({fitted.beyond, -2 * largest - least, most - 2 * largest});]])
mutant(levels_moves_no_node_behind_a_leaf FILE model/compile/levels/compile.cpp TEST compile [levels]
  OLD [[if (kind == 1) pending.push_back(next++);]]
  NEW [[if (kind == 1 && next - node.base < 2) pending.push_back(next++);]])
mutant(levels_boxes_forget_the_direction FILE model/compile/levels/fit.cpp TEST compile [levels]
  OLD [[map.is_whole ? 0 : 0.5 + 0.5 * last;]]
  NEW [[map.is_whole ? 0 : 0.5 + 0 * last;]])
mutant(levels_boxes_forget_where_bounces_begin FILE model/compile/levels/fit.cpp TEST compile [secondary]
  OLD [[off = begin + slope * reach(begin, bounce);]]
  NEW [[off = slope * reach(begin, bounce);]])
mutant(levels_boxes_forget_the_longest_edge FILE model/compile/levels/fit.cpp TEST compile [secondary]
  OLD [[+ 2.5 * frac * made.longest;]]
  NEW [[+ 0 * made.longest;]])
mutant(planes_have_an_end_above FILE model/compile/levels/maps.cpp TEST compile
  "two levels draw a scene without instances as one level does*"
  OLD [[if (box.lo[0] <= box.hi[0]) made.points = {box.lo, box.hi};]]
  NEW [[if (box.lo[0] <= box.hi[0]) made.points = {box.lo, {0, 0, 0}};]])

# ---- Two levels: the units.
mutant(short_refracted_ray_goes FILE model/unit/shade/bounce/bounce.cpp TEST unit [bounce]
  OLD [[&& is_held(c, out.d);]]
  NEW [[&& (is_held(c, out.d) || c.has_homes());]])
mutant(rtl_xform_rests_too_little_every_2 FILE rtl/unit/xform/rc_xform.sv TEST unit [xform]
  OLD [[LeftW'(rc_pkg::XformInterval - 1)]]
  NEW [[LeftW'(rc_pkg::XformInterval - (rc_pkg::XformInterval == 2 ? 2 : 1))]])
mutant(rtl_quicker_unit_does_not_wait FILE rtl/engine/rc_tree.sv TEST system
  "model and RTL walk two structures alike*"
  OLD [[.Pad(rc_pkg::MeshPad)]]
  NEW [[.Pad(rc_pkg::MeshPad / 2)]])
mutant(model_one_unit_rests_for_both FILE model/machine/pipeline.inl WITH model/machine/machine.cpp
  model/machine/pipeline.cpp TEST system "model and RTL walk two structures alike*"
  OLD [[(!is_held<plain>(box_hold_left_) | (m.lower_request != box_is_low_))]]
  NEW [[!is_held<plain>(box_hold_left_)]])

# ---- Keyframes, shapes and skins.
mutant(keyframes_may_stand_still FILE sim/load/json/motion.cpp TEST motion [motion]
  OLD [[!(t > times.back())]]
  NEW [[!(t >= times.back())]])
mutant(buffers_share_a_cache_line FILE model/compile/levels/compile.cpp TEST motion [deform][textures]
  OLD [[            if (made.deforms) align();
            one.records]]
  NEW [[            one.records]])
mutant(shapes_jump_at_the_last_key FILE model/scene/deform.cpp TEST motion [deform]
  OLD [[if (k + 1 < times.size()) key(k + 1, 0);]]
  NEW [[if (k + 2 < times.size()) key(k + 1, 0);]])
mutant(deform_takes_corners_that_are_not_finite FILE model/scene/deform.cpp TEST motion [deform]
  OLD [[if (!(std::abs(mesh.vertices[i][k]) <= most))]]
  NEW [[if (false)]])
mutant(gltf_joints_may_be_out_of_range FILE sim/load/gltf/deform.cpp TEST motion [deform]
  OLD [[is_joint = joint < double(to.joints.size());]]
  NEW [[is_joint = joint <= double(to.joints.size());]])
mutant(gltf_sparse_indices_may_fall FILE sim/load/gltf/buffers.cpp TEST motion [deform]
  OLD [[(i > 0 && !(at[i] > at[i - 1]))]]
  NEW [[false]])

# ---- Films: what the host computes again for each frame, and where it writes it.
mutant(film_boxes_are_too_small FILE model/compile/levels/fit.cpp TEST motion [film]
  OLD [=[size[k] * half[k] + disc[k]]=]
  NEW [=[size[k] * half[k] + 0.9 * disc[k]]=])
mutant(film_scene_lattice_of_the_first_frame FILE model/compile/levels/maps.cpp TEST motion [film]
  OLD [[for (std::size_t t = 0; t < (moves_[i] ? times_.size() : 1); ++t)
                    for]]
  NEW [[for (std::size_t t = 0; t < 1; ++t)
                    for]])
mutant(film_mesh_lattices_of_the_first_frame FILE model/compile/levels/maps.cpp TEST motion [film]
  OLD [[for (std::size_t t = 1; t < times; ++t) add(own, needs_of(seen_at(i, t)));]]
  NEW [[for (std::size_t t = 1; t < 1; ++t) add(own, needs_of(seen_at(i, t)));]])
mutant(film_has_room_for_its_first_tree FILE model/compile/levels/moving.cpp TEST motion
  "frames of a film write*"
  OLD [[for (const InstancePlaces& places : times) {]]
  NEW [[for (const InstancePlaces& places : times.first(1)) {]])
mutant(film_leaves_out_lines_of_zeros FILE model/compile/refit/flat.cpp TEST motion
  "uploads give the chip the host's image*"
  OLD [[{held.begin(), part(written_)}, upload);]]
  NEW [[{held.begin(), part(tree)}, upload);]])
mutant(film_writes_one_line_less FILE model/compile/levels/moving.cpp TEST motion [film]
  OLD [[part(root_, levels_.upper_lines, nullptr);]]
  NEW [[part(root_ + 1, levels_.upper_lines - 1, nullptr);]])
mutant(film_resets_leave_surfaces FILE model/core/config.cpp TEST motion
  "model and RTL draw the same finished film*"
  OLD [[prim_sets, has_shade() ? surf_sets : 0, is_stream()]]
  NEW [[prim_sets, is_stream()]])

# ---- Writes through the memory.
mutant(dram_reads_too_soon_after_a_write FILE model/mem/dram_banks.cpp TEST motion [dram]
  OLD [[to_read_(part.cwl + part.burst_clocks() + clocks(part.twtr))]]
  NEW [[to_read_(part.cwl + part.burst_clocks())]])
mutant(memory_is_done_too_soon FILE model/mem/memory.hpp WITH tests/motion/writes_test.cpp TEST motion [dram]
  OLD [[return left_ > 0 || (dram_ && dram_->writes());]]
  NEW [[return left_ > 0;]])

# ---- Trees that are refitted.
mutant(refit_keeps_the_boxes_of_parents FILE model/compile/refit/refit.cpp TEST motion [refit]
  OLD [[        node.box = {};]]
  NEW [[        if (node.inner == 0 || built_cost_ == 0) node.box = {};
        else continue;]])
mutant(refit_has_room_for_good_trees_only FILE model/compile/refit/refit.cpp TEST motion [refit]
  OLD [[return nodes + (prims + nodes) / 2;]]
  NEW [[return nodes / 2 + (prims + nodes) / 2;]])
mutant(refit_leaves_out_what_has_no_area FILE model/compile/levels/compile.cpp TEST motion [deform]
  OLD [[if (made.deforms || counts(prim, config))]]
  NEW [[if (counts(prim, config))]])
mutant(refit_of_levels_draws_into_one_buffer FILE model/compile/levels/moving.cpp TEST motion [deform]
  OLD [[root = levels_.roots[c] + std::uint32_t(buffer) * room;
    std::vector]]
  NEW [[root = levels_.roots[c];
    std::vector]])

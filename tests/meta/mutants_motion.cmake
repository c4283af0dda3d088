# Faults of scenes that move: mutants_rtl.cmake says what a row is.

# ---- Values over time, and what hangs at what.
mutant(motion_rotations_cut_the_corner FILE model/scene/motion.cpp TEST motion [motion]
  OLD [[return glm::slerp(a, b, s);]]
  NEW [[return glm::normalize(a * (1 - s) + b * s);]])
mutant(motion_steps_too_early FILE model/scene/motion.cpp TEST motion [motion]
  OLD [[times.end() || between == Between::step) return tidy(values[width * k + own]);]]
  NEW [[times.end() || between == Between::step) return tidy(values[width * std::min(k + 1, times.size() - 1) + own]);]])
mutant(motion_splines_forget_the_span FILE model/scene/motion.cpp TEST motion [motion]
  OLD [[leaves * (span * (s3]]
  NEW [[leaves * (1 * (s3]])
mutant(motion_parents_go_last FILE model/scene/motion.cpp TEST motion [motion]
  OLD [=[places[*node.parent] * local]=]
  NEW [=[local * places[*node.parent]]=])
mutant(motion_takes_singular_places FILE model/scene/motion.cpp TEST motion [motion]
  OLD [[if (!is_bounded(instance.place))]]
  NEW [[if (false)]])
mutant(keyframes_may_stand_still FILE sim/load/json_motion.cpp TEST motion [motion]
  OLD [[!(t > times.back())]]
  NEW [[!(t >= times.back())]])
mutant(keyframes_take_the_short_way FILE sim/load/json_motion.cpp TEST motion [motion]
  OLD [[std::ceil(std::abs(far) / 90)]]
  NEW [[std::ceil(std::abs(far) / 9000)]])
mutant(gltf_rotations_begin_with_x FILE sim/load/gltf_motion.cpp TEST motion [motion]
  OLD [[glm::dquat(v[3], v[0], v[1], v[2])]]
  NEW [[glm::dquat(v[0], v[1], v[2], v[3])]])

# ---- Films: what the host makes anew, and where it lies.
mutant(film_keeps_old_maps FILE model/compile/levels/moving.cpp TEST motion [film]
  OLD [[        map = map_at(places[i], map.mesh_class, levels_.maps, config_);]]
  NEW [[        if (frame_ < 2) map = map_at(places[i], map.mesh_class, levels_.maps, config_);]])
mutant(film_resets_leave_surfaces FILE model/core/config.cpp TEST motion "model and RTL draw the same finished film*"
  OLD [[prim_sets, shading ? surf_sets : 0, l2_sets});]]
  NEW [[prim_sets, l2_sets});]])
mutant(film_never_resets_the_chip FILE model/compile/levels/moving.cpp TEST motion [film]
  OLD [[upload.resets = !upload.lines.empty() && is_read_[buffer];]]
  NEW [[upload.resets = false;]])
mutant(film_writes_one_line_less FILE model/compile/levels/moving.cpp TEST motion [film]
  OLD [[part(root_, levels_.upper_lines, nullptr);]]
  NEW [[part(root_ + 1, levels_.upper_lines - 1, nullptr);]])
mutant(film_boxes_are_too_small FILE model/compile/levels/fit.cpp TEST motion [film]
  OLD [=[size[k] * half[k] + disc[k]]=]
  NEW [=[size[k] * half[k] + 0.9 * disc[k]]=])
mutant(film_lights_stand_still FILE sim/run/film/film.cpp TEST motion [film]
  OLD [[if (job_.config.shading)]]
  NEW [[if (job_.config.shading && frame_ == 1)]])
mutant(film_forgets_that_images_are_mirrored FILE sim/run/engine/engine.cpp TEST motion [film]
  OLD [[std::swap(picture.hits.back().u, picture.hits.back().v);]]
  NEW [[void();]])

# ---- Lattices serve all frames.
mutant(film_scene_lattice_of_the_first_frame FILE model/compile/levels/maps.cpp TEST motion [film]
  OLD [[for (std::size_t t = 0; t < (moves_[i] ? times_.size() : 1); ++t)
                    for]]
  NEW [[for (std::size_t t = 0; t < 1; ++t)
                    for]])
mutant(film_mesh_lattices_of_the_first_frame FILE model/compile/levels/maps.cpp TEST motion [film]
  OLD [[for (std::size_t t = 1; t < times; ++t) add(own, needs_of(seen_at(i, t)));]]
  NEW [[for (std::size_t t = 1; t < 1; ++t) add(own, needs_of(seen_at(i, t)));]])
mutant(film_lattice_of_the_first_eye FILE model/compile/levels/maps.cpp TEST motion [film]
  OLD [[for (const glm::dvec3& eye : eyes_) box.add(glm::dmat4(1), eye);]]
  NEW [[box.add(glm::dmat4(1), eyes_[0]);]])

# ---- Uploads through the memory.
mutant(dram_reads_too_soon_after_a_write FILE model/mem/dram_banks.cpp TEST motion [dram]
  OLD [[to_read_(part.cwl + part.burst_clocks() + clocks(part.twtr))]]
  NEW [[to_read_(part.cwl + part.burst_clocks())]])
mutant(dram_closes_too_soon_after_a_write FILE model/mem/dram_banks.cpp TEST motion [dram]
  OLD [[to_precharge_(part.cwl + part.burst_clocks() + clocks(part.twr))]]
  NEW [[to_precharge_(part.cwl + part.burst_clocks())]])
mutant(dram_writes_into_what_is_read FILE model/mem/dram_banks.cpp TEST motion [dram]
  OLD [[write_ = clock + std::max(tccd_, to_write_);]]
  NEW [[write_ = clock + tccd_;]])
mutant(memory_writes_for_nothing FILE model/mem/memory.cpp TEST motion [dram]
  OLD [[        if (writes) ideal_.write();]]
  NEW [[]])
mutant(memory_is_done_too_soon FILE model/mem/memory.hpp WITH tests/motion/writes_test.cpp TEST motion [dram]
  OLD [[return left_ > 0 || (dram_ && dram_->writes());]]
  NEW [[return left_ > 0;]])
mutant(uploads_are_not_waited_for FILE model/compile/upload.hpp WITH sim/run/engine/engine.cpp sim/run/lockstep/lockstep.cpp TEST motion [film]
  OLD [[    machine.finish_writes();]]
  NEW [[    (void)0;]])

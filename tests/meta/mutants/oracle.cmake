# Faults of the judges themselves: oracles, stages of causes, and reference tracer. rtl.cmake explains
# a row.

# ---- The oracle of one level.
mutant(oracle_fraction_by_boost FILE tests/support/oracle/fractions.hpp
  WITH tests/unit/judge/fractions_test.cpp TEST unit
  "a fraction and a whole number*"
  OLD [[eval_divide(quotient, cpp_rational_backend(b));]]
  NEW [[quotient.negate();]])
mutant(oracle_way_ends_halfway FILE sim/judge/oracle/surface.hpp WITH tests/system/geometry/shadows_test.cpp
  TEST system "the search around a way*"
  OLD [[near > 2 * way.main_size()]]
  NEW [[near > way.main_size()]])
mutant(stress_oracle_search_skips FILE sim/judge/oracle/search.inl WITH sim/judge/oracle/surface.cpp
  TEST system "the oracle's search*"
  OLD [[meet(node.child[i] & ~leaf);]]
  NEW [[if (node.child[i] % 97 != 5) meet(node.child[i] & ~leaf);]])
mutant(model_overlap_open_box FILE sim/judge/oracle/overlap.cpp TEST unit [overlap]
  OLD [[if (less(leave[i], enter)) return std::nullopt;]]
  NEW [[if (!less(enter, leave[i])) return std::nullopt;]])

# ---- The oracle of two levels, and its judge of memory.
mutant(oracle_of_levels_has_no_margin FILE sim/judge/oracle/placed.cpp TEST system "a small mesh is found*"
  OLD [[whole_above(reach * (1 + std::max<Int128>(longest, 1)), 2) + 1;]]
  NEW [[whole_above(reach * (1 + std::max<Int128>(longest, 1)), 1 << 20) + 1;]])
mutant(oracle_of_levels_rounds_down FILE sim/judge/oracle/placed.cpp TEST system "the oracle of two levels*"
  OLD [[2 * n + (Int128(1) << bits)]]
  NEW [[2 * n]])
mutant(oracle_of_levels_takes_the_last_of_equals FILE sim/judge/oracle/placed.cpp TEST system
  "the oracle of two levels*"
  OLD [[(order == 0 && place > best.place)]]
  NEW [[(order == 0 && place < best.place)]])
mutant(judge_of_levels_takes_any_map FILE sim/judge/paths/placed.cpp TEST system "the judge sees memory*"
  OLD [[if (!good) faults_]]
  NEW [[if (false) faults_]])
mutant(judge_of_levels_misses_short_refracted_rays FILE sim/judge/paths/path_bounce.cpp TEST system
  "every ray and colour of a sound picture of instances*"
  OLD [[if (rules_.placed && std::max(]]
  NEW [[if (!rules_.placed && std::max(]])

# ---- Causes of differing pixels.
mutant(stages_forget_ties_of_rays_to_far_lights FILE sim/judge/cause/guide.cpp TEST system
  "where the rounded direction*"
  OLD [[        if (is_blocking_tied(moved, distance, machine)) {
            tie();]]
  NEW [[        if (is_blocking_tied(moved, distance, machine)) {]])
mutant(judge_planes_turn_less_than_proven FILE sim/judge/paths/world.cpp TEST system
  "a distant light close to a plane*"
  OLD [[return half * (a + b + half) / glm::length(glm::cross(p, q));]]
  NEW [[return std::exp2(6 - lattice.coord_bits);]])
mutant(seams_are_nowhere FILE sim/judge/cause/seam.cpp TEST system [cause][levels]
  OLD [[return is_bounded ? RayFinding::seam : RayFinding::none;]]
  NEW [[return is_bounded ? RayFinding::one_line : RayFinding::none;]])

# ---- The reference tracer.
mutant(whitted_weight_must_be_above_the_threshold FILE sim/judge/reference/whitted.cpp TEST reference
  "two mirrors*"
  OLD [[weighs_enough(reflected, settings_.threshold),]]
  NEW [[reflected > settings_.threshold || settings_.threshold == 0,]])
mutant(reference_sphere_box_too_small FILE sim/judge/reference/geometry.cpp TEST reference [round]
  OLD [[float_above(spheres[i].centre[k] + spheres[i].radius)]]
  NEW [[float_above(spheres[i].centre[k] + 0.99 * spheres[i].radius)]])
mutant(reference_forgets_where_instances_stand FILE sim/judge/reference/instances.cpp TEST reference
  "Embree's instances*"
  OLD [[placed.back * (origin - placed.origin), turned]]
  NEW [[placed.back * origin, turned]])

# ---- Octrees by published rules.
mutant(published_octree_without_room_around FILE sim/judge/reference/octree.cpp TEST reference
  "octrees of Haines' scenes are those that were published"
  OLD [[around_root = 0.001]]
  NEW [[around_root = 0.0001]])
mutant(published_rays_find_the_last_in_the_way FILE sim/judge/reference/octree.cpp TEST reference
  "a shadow ray ends at the first test of what is in its way"
  OLD [[last = std::min(last, std::uint32_t(at - list));]]
  NEW [[last = std::uint32_t(at - list);]])

# Faults of the searches (fit, stress, sweeps, balance) and in reading a routed chip. rtl.cmake
# explains a row.

# ---- fit: intervals that are too small, and a search that stops early.
mutant(fit_box_far_with_r FILE sim/explore/fit/ranges_box.cpp TEST sweep "box's intervals*"
  OLD [[const Interval up = ray.len == 0 ? ray.recip : ray.recip + point(1);]]
  NEW [[const Interval up = ray.recip;]])
mutant(fit_hit_distance_short FILE sim/explore/fit/ranges_tri.cpp TEST sweep "every value that the rays*"
  OLD [[(c.dir_bits - 1 + c.t_frac_bits)) + least - 1) / least}]]
  NEW [[(c.dir_bits - 2 + c.t_frac_bits)) + least - 1) / least}]])
mutant(fit_forgets_depth FILE sim/explore/fit/search.cpp TEST sweep "what fit finds*"
  OLD [[2 * (config.dir_bits - 1 + config.t_frac_bits))]]
  NEW [[2 * (config.dir_bits + config.t_frac_bits))]])

# ---- stress: faults of the machine that it must notice by itself, and faults of its own.
mutant(stress_sheared_rounds_by_triangle FILE model/unit/tri/sheared.cpp TEST system "controls are noticed*"
  OLD [[const Corner a = sheared(triangle.a, o, shear, frac),]]
  NEW [[const Corner a = sheared({triangle.a[0] + int(triangle.prim & 1), triangle.a[1], triangle.a[2]}, o, shear, frac),]])
mutant(stress_stack_need_one_short FILE model/layout/node_statistics.hpp WITH model/compile/emit.cpp
  TEST system "the exact test meets*"
  OLD [[image.report.stack_need = nodes_[0].need;]]
  NEW [[image.report.stack_need = nodes_[0].need - 1;]])
mutant(stress_judge_forgets_leaks FILE sim/explore/stress/judge.cpp TEST system "controls are noticed*"
  OLD [[counts.leaks += !missing.empty();]]
  NEW [[]])
mutant(stress_finds_few_rays_wrong FILE sim/explore/stress/tests.cpp TEST system
  "the study distinguishes a test that*"
  OLD [[found.is_exact() && !found.leaks_where_it_must() && found.leaky.rays < enough_rays]]
  NEW [[false]])

# ---- The study of textures: blocks, and the lines of larger tiles.
mutant(study_blocks_have_halves FILE sim/study/textures/block.cpp TEST sweep "a block has four colours*"
  OLD [[(a[k] + 2 * b[k] + 1) / 3]]
  NEW [[(a[k] + b[k] + 1) / 2]])
mutant(study_levels_share_lines FILE sim/study/textures/block.cpp TEST sweep "the texels of four lines*"
  OLD [[        first += 1u << level_lines_log(record, level, block_tile_log);]]
  NEW [[]])
mutant(study_moves_the_record FILE sim/study/textures/block.cpp TEST cli "the page of textures*"
  OLD [[const_cast<std::uint32_t&>(at[1]);]]
  NEW [[const_cast<std::uint32_t&>(at[0]);]])

# ---- Sweeps and their parts.
mutant(sweep_believes_a_broken_entry FILE sim/files/cache/results.cpp TEST sweep "an entry*"
  OLD [[entry["check"] != hash_text(entry["value"].dump())]]
  NEW [[false]])
mutant(sweep_takes_one_clock_for_another FILE sim/explore/sweep/evaluate_points.cpp TEST sweep
  "another parameter*"
  OLD [[scene_key_, r.point.khz, timing_of]]
  NEW [[scene_key_, 0, timing_of]])
mutant(shard_drops_a_point FILE sim/explore/sweep/shard.cpp TEST cli "the parts of a sweep*"
  OLD [[cut(std::size_t(shard.part)));]]
  NEW [[cut(std::size_t(shard.part)) - (shard.part == 2));]])
mutant(merge_takes_what_was_interrupted FILE sim/explore/sweep/merge.cpp TEST cli
  "files that are not all parts*"
  OLD [[checked["partial"] != false]]
  NEW [[checked["partial"] == 1]])

# ---- balance.
mutant(balance_never_exchanges FILE sim/explore/balance/search.cpp TEST sweep "a step is given back*"
  OLD [[if (up.parameter != down.parameter)]]
  NEW [[if (up.parameter == down.parameter)]])
mutant(balance_keeps_what_brings_nothing FILE sim/explore/balance/search.cpp TEST sweep
  "a step is given back*"
  OLD [[return gain(m) < 0;]]
  NEW [[return gain(m) < 10;]])

# ---- A routed chip: delays, sources, sites, and when a run is stopped.
mutant(chip_way_from_a_pad_counts FILE sim/silicon/chip/timing.cpp TEST chip "delays of a file by hand*"
  OLD [[if (begin >= 0 &&]]
  NEW [[if (begin >= -1 &&]])
mutant(chip_source_is_the_outermost_instance FILE sim/silicon/chip/cells.cpp TEST chip "the source of a cell*"
  OLD [[!line.empty()) found = line;]]
  NEW [[!line.empty() && found.empty()) found = line;]])
mutant(chip_full_device_is_too_small FILE sim/silicon/chip/place_and_route.cpp TEST chip
  "the message about a*"
  OLD [[if (needs <= has) continue;]]
  NEW [[if (needs < has) continue;]])
mutant(chip_mixed_is_kept_as_static FILE sim/silicon/chip/place_and_route.cpp TEST cli
  "the report of a chip that*"
  OLD [[last == first ? "" :]]
  NEW [[true ? "" :]])
mutant(chip_anchors_take_a_site_twice FILE sim/silicon/chip/anchor.cpp TEST chip "anchors are the sites*"
  OLD [[std::swap(takes[i], takes[j]);]]
  NEW [[takes[j] = takes[i];]])
mutant(chip_anchors_pass_each_other FILE sim/silicon/chip/anchor.cpp TEST chip "anchors are the sites*"
  OLD [[const bool better = wiring.length() < before;]]
  NEW [[const bool better = wiring.length() < before + (1 << 30);]])
mutant(chip_else_of_a_simulation_is_lost FILE sim/silicon/synth/yosys.cpp TEST chip "a word in a comment*"
  OLD [[(word == "`endif" || (left_out == 1 && word == "`else"))]]
  NEW [[word == "`endif"]])
mutant(chip_takes_a_tables_head_for_no_wires_left FILE sim/silicon/chip/nextpnr.cpp TEST chip
  "a run's log shows its*"
  OLD [[if (arcs > 0 && has_number)]]
  NEW [[if (arcs > 0 && (has_number || parts.size() >= 5))]])
mutant(chip_waits_for_static_without_end FILE sim/silicon/chip/nextpnr.cpp TEST chip "a run's log shows its*"
  OLD [[if (!routes && line.starts_with("Info: overlap: "))]]
  NEW [[if (routes && line.starts_with("Info: overlap: "))]])

# ---- Samples: intervals that are too narrow.
mutant(sample_intervals_of_half_the_width FILE sim/run/sample/estimate.cpp TEST sample "95 % intervals*"
  OLD [[variance == 0 ? 0 : student_975(degrees) * std::sqrt]]
  NEW [[variance == 0 ? 0 : student_975(degrees) / 2 * std::sqrt]])
mutant(sample_runs_tiles_twice FILE sim/run/sample/sample.cpp TEST sample "samples of neighbouring parts*"
  OLD [[std::max(last_end, part - std::min(part, u.lengths.warm_up))]]
  NEW [[part - std::min(part, u.lengths.warm_up)]])
mutant(sample_expects_no_latency FILE sim/run/sample/sample.cpp TEST sample "with few contexts*"
  OLD [[contexts_(std::uint64_t(config.contexts)),]]
  NEW [[contexts_(std::uint64_t(1) << 40),]])
mutant(sample_expects_no_wait_for_xform FILE sim/run/sample/sample.cpp TEST sample "the expected cycles of*"
  OLD [[instance_(std::uint64_t(config.xform_interval) - 1)]]
  NEW [[instance_(0)]])
mutant(sample_counts_no_instances FILE sim/run/sample/sampled.cpp TEST sample
  "a sample counts visits of instances*"
  OLD [[if (unit == Unit::xform) return Work::instances;]]
  NEW [[]])
mutant(sample_film_adds_no_variances FILE sim/run/sample/estimate.cpp TEST sample "95 % intervals of a mean*"
  OLD [[        variance += e.variance;]]
  NEW [[        variance = std::max(variance, e.variance);]])
mutant(sample_film_has_one_seed FILE sim/app/run/sample_run.cpp TEST cli "a sampled film has the keys*"
  OLD [[seed + f}]]
  NEW [[seed}]])
mutant(sample_film_starts_cold FILE sim/app/run/sample_run.cpp TEST cli "the caches of a sampled film*"
  OLD [[f > 0 && !upload.resets ? &previous : nullptr]]
  NEW [[false ? &previous : nullptr]])

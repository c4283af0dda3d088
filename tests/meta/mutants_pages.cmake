# Faults of pages, parts of sweeps, stories, comparisons and the page of a divergence. As mutants_rtl.cmake has it; where
# the TEST is of `cli`, the fault is in the program itself.
mutant(none_in_the_program FILE sim/view/page/html.cpp TEST cli "names with markup in them*")
mutant(page_map_is_transposed FILE sim/view/page/data.cpp TEST cli "the maps of a report*"
  OLD [[        for (const PixelCost& p : costs.pixels) planes += char(map.value(p) >> 8 * b & 255);]]
  NEW [[        for (std::size_t i = 0; i < costs.pixels.size(); ++i)
            planes += char(map.value(costs.pixels[i % costs.height * costs.width + i / costs.height]) >> 8 * b & 255);]])
mutant(page_map_is_upside_down FILE sim/view/page/data.cpp TEST cli "the maps of a report*"
  OLD [[        for (const PixelCost& p : costs.pixels) planes += char(map.value(p) >> 8 * b & 255);]]
  NEW [[        for (std::size_t i = 0; i < costs.pixels.size(); ++i)
            planes += char(map.value(costs.pixels[(costs.height - 1 - i / costs.width) * costs.width + i % costs.width]) >> 8 * b & 255);]])
mutant(page_map_has_its_bytes_reversed FILE sim/view/page/data.cpp TEST cli "the maps of a report*"
  OLD [[char(map.value(p) >> 8 * b & 255);]]
  NEW [[char(map.value(p) >> 8 * (bytes - 1 - b) & 255);]])
mutant(page_shows_tests_as_visits FILE sim/view/page/data.cpp TEST cli "a report is one file*"
  OLD [[[](const PixelCost& p) { return p.visits; }]]
  NEW [[[](const PixelCost& p) { return p.tests; }]])
mutant(page_names_the_fastest_pixels FILE sim/view/page/data.cpp TEST cli "the maps of a report*"
  OLD [[return x != y ? x > y : a < b;]]
  NEW [[return x != y ? x < y : a < b;]])
mutant(page_loses_its_last_window FILE sim/view/page/data.cpp TEST cli "a report is one file*"
  OLD [[for (const Window& w : costs.windows) windows]]
  NEW [[for (const Window& w : costs.windows) if (&w != &costs.windows.back()) windows]])
mutant(page_escapes_no_markup FILE sim/view/page/html.cpp TEST cli "names with markup in them*"
  OLD [[case '<': out += "&lt;"; break;]]
  NEW [[case '<': out += '<'; break;]])
mutant(page_data_ends_its_element FILE sim/view/page/html.cpp TEST cli "names with markup in them*"
  OLD [[out += "\\u003c";]]
  NEW [[out += '<';]])
mutant(page_kinds_are_shifted FILE sim/view/page/data.cpp TEST cli "a report is one file*"
  OLD [[const PurposeCost& p = costs.purposes[k];]]
  NEW [[const PurposeCost& p = costs.purposes[3 - k];]])

mutant(shard_drops_a_point FILE sim/explore/sweep/shard.cpp TEST cli "the parts of a sweep*"
  OLD [[cut(std::size_t(shard.part)));]]
  NEW [[cut(std::size_t(shard.part)) - (shard.part == 2));]])
mutant(shard_has_its_neighbours_point FILE sim/explore/sweep/shard.cpp TEST cli "the parts of a sweep*"
  OLD [[cut(std::size_t(shard.part) - 1), ]]
  NEW [[cut(std::size_t(shard.part) - 1) - (shard.part == 2), ]])
mutant(merge_puts_points_elsewhere FILE sim/explore/sweep/merge.cpp TEST cli "the parts of a sweep*"
  OLD [=[fill(outcome.results[mine[k]], rows.at(k), axes);]=]
  NEW [=[fill(outcome.results[mine[k]], rows.at(mine.size() - 1 - k), axes);]=])
mutant(merge_takes_what_was_interrupted FILE sim/explore/sweep/merge.cpp TEST cli "files that are not all parts*"
  OLD [[checked["partial"] != false]]
  NEW [[checked["partial"] == 1]])

mutant(sweep_takes_one_depth_for_another FILE sim/explore/sweep/run.cpp TEST cli "what is drawn decides*"
  OLD [[w.depth, w.threshold]]
  NEW [[0, w.threshold]])
mutant(sweep_takes_one_film_for_another FILE sim/explore/sweep/key.cpp TEST cli "what is drawn decides*"
  OLD [[        pose(scene, time);]]
  NEW [[        pose(scene, 0 * time);]])
mutant(sweep_draws_with_usual_settings FILE sim/run/film/choice.cpp TEST cli "a sweep's row*"
  OLD [[choice.finished || config.shading, choice.settings}]]
  NEW [[choice.finished || config.shading, Whitted{}}]])
mutant(sweep_shows_the_first_frame FILE sim/explore/sweep/run.cpp TEST cli "a sweep's row*"
  OLD [[compare_picture(film, frames.back())]]
  NEW [[compare_picture(film, frames.front())]])
mutant(sweep_lets_too_few_lights_pass FILE sim/explore/sweep/axes.cpp TEST cli "a sweep's row*"
  OLD [[if (!p.timing_only) text]]
  NEW [[if (!p.timing_only && !p.is("lights")) text]])
mutant(sweep_has_one_cost FILE sim/explore/sweep/front.cpp TEST sweep "the automatic cost*"
  OLD [[    if (differs(results, bits_of)) {]]
  NEW [[    if (false) {]])
mutant(chart_cuts_its_title FILE sim/view/plot/chart.cpp TEST sweep "title and note*"
  OLD [[text_width(longer, size) <= width)]]
  NEW [[text_width(longer, size) <= 4 * width)]])
mutant(compare_ranks_side_effects_first FILE sim/view/compare/compare.cpp TEST cli "compare finds*"
  OLD [[is_key_figure(d.figure) ? 0 : ]]
  NEW [[is_key_figure(d.figure) ? 3 : ]])

mutant(compare_takes_better_for_worse FILE sim/view/compare/compare.cpp TEST cli "compare finds*"
  OLD [[d.verdict = (last > first) == (direction > 0) ?]]
  NEW [[d.verdict = (last > first) != (direction > 0) ?]])
mutant(compare_has_its_sign_turned FILE sim/view/compare/compare.cpp TEST cli "compare finds*"
  OLD [[(last - first) / std::fabs(first);]]
  NEW [[(first - last) / std::fabs(first);]])
mutant(compare_lets_a_bound_pass FILE sim/view/compare/compare.cpp TEST cli "compare finds*"
  OLD [[std::fabs(d.change) > share]]
  NEW [[std::fabs(d.change) > 100 * share + 1]])
mutant(compare_gains_what_it_loses FILE sim/view/compare/page.cpp TEST cli "pages of simulate*"
  OLD [[        if (b[i] < a[i]) ++change.faster, change.gained += a[i] - b[i];
        if (b[i] > a[i]) ++change.slower, change.lost += b[i] - a[i];]]
  NEW [[        if (b[i] > a[i]) ++change.faster, change.gained += b[i] - a[i];
        if (b[i] < a[i]) ++change.slower, change.lost += a[i] - b[i];]])

mutant(explain_mean_is_of_rays FILE sim/view/explain/json.cpp TEST cli "the mean that explain*"
  OLD [[{"node_visits", double(sums.visits) / pixels},]]
  NEW [[{"node_visits", double(sums.visits) / double(sums.rays + 1)},]])
mutant(explain_forgets_merged_misses FILE sim/view/explain/json.cpp TEST cli "explain counts look-ups*"
  OLD [[{"cache_misses", ray.misses + ray.merges},]]
  NEW [[{"cache_misses", ray.misses},]])
mutant(explain_counts_a_cycle_twice FILE sim/view/explain/json.cpp TEST cli "explain tells every ray*"
  OLD [[{"work", step.work()}, ]]
  NEW [[{"work", step.work() + 1}, ]])
mutant(timeline_loses_a_cycle FILE sim/view/timeline/timeline.cpp TEST observe "a timeline of a whole frame*"
  OLD [[last = std::min(cycle, choice_.last);]]
  NEW [[last = std::min(cycle - 1, choice_.last);]])
mutant(timeline_takes_a_pixel_more FILE sim/view/timeline/timeline.cpp TEST cli "trace writes a timeline*"
  OLD [[x <= choice_.x1 && y]]
  NEW [[x <= choice_.x1 + 1 && y]])

mutant(divergence_says_late_for_early FILE sim/run/lockstep/lockstep.cpp TEST meta "lockstep names the first cycle in which the RTL is early"
  OLD [[later_text(watched_->by_rtl ? "the model" : "the RTL", now]]
  NEW [[later_text(watched_->by_rtl ? "the RTL" : "the model", now]])
mutant(divergence_is_a_cycle_later FILE sim/run/lockstep/lockstep.cpp TEST meta "lockstep names the first cycle*"
  OLD [[now - watched_->cycle, same);]]
  NEW [[now - watched_->cycle + 1, same);]])
mutant(divergence_page_takes_values_for_times FILE sim/view/divergence/page.cpp TEST cli "verify names the first divergence*"
  OLD [[    if (!d.on) return "An assertion of the RTL failed.";
]]
  NEW [[    if (!d.on) return "An assertion of the RTL failed.";
    if (d.expected != d.got) return "One machine offers or accepts what the other does not.";
]])
mutant(divergence_waveform_has_the_sides_swapped FILE sim/view/divergence/waveform.cpp TEST cli "verify names the first divergence*"
  OLD [[                set(signals_[i].model[f], field, link.model);
                set(signals_[i].rtl[f], field, link.rtl);]]
  NEW [[                set(signals_[i].model[f], field, link.rtl);
                set(signals_[i].rtl[f], field, link.model);]])

mutant(line_is_not_drawn_again FILE sim/view/report/text.cpp TEST cli "nobody waits*"
  OLD [[if (seconds_since_line() > silence) draw]]
  NEW [[if (seconds_since_line() < 0) draw]])

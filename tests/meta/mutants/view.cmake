# Faults of observers, pages, stories and comparisons, and of the page of a divergence. rtl.cmake
# explains a row. With TEST cli the fault is in the program itself.

# ---- Observers, timelines and waveforms.
mutant(observer_counts_no_merge FILE sim/view/observe/observer.cpp TEST observe "a watched frame*"
  OLD [[    ++(outcome == CacheOutcome::miss ? sums.misses : sums.merges)[cache];]]
  NEW [[    ++sums.misses[cache];]])
mutant(pixels_of_cycles_leave_a_cycle_early FILE sim/view/observe/costs.cpp TEST observe
  "the pixels of some cycles*"
  OLD [[std::uint64_t(pixel.cycles) >= first;]]
  NEW [[std::uint64_t(pixel.cycles) > first;]])
mutant(observer_is_a_cycle_late FILE sim/view/observe/observer.cpp TEST observe "a watched frame*"
  OLD [[    context.since = now_;
    context.place = place_after(link, streams_);]]
  NEW [[    context.since = now_ + 1;
    context.place = place_after(link, streams_);]])
mutant(path_of_a_light_sent_again_is_a_bounce FILE sim/view/observe/path.cpp TEST observe
  "each ray of a pixel*"
  OLD [[event_of(in);]]
  NEW [[in.state.next_event;]])
mutant(story_waits_for_its_own_work FILE sim/view/observe/story.cpp TEST observe "a pixel*"
  OLD [[std::uint64_t left = lookup_cycle - begin - times.before;]]
  NEW [[std::uint64_t left = lookup_cycle - begin;]])
mutant(timeline_misses_the_first_cycle FILE sim/view/timeline/timeline.cpp TEST observe
  "a timeline of a whole frame*"
  OLD [[note_accounts(machine, now_ > choice_.first);]]
  NEW [[note_accounts(machine, now_ > choice_.first + 1);]])
mutant(timeline_takes_a_pixel_more FILE sim/view/timeline/timeline.cpp TEST cli "trace writes a timeline*"
  OLD [[x <= choice_.x1 && y]]
  NEW [[x <= choice_.x1 + 1 && y]])
mutant(kanata_retires_too_early FILE sim/view/timeline/kanata.cpp TEST observe "a Kanata file*"
  OLD [[last = ray.stays.back().last;]]
  NEW [[last = ray.stays.back().first;]])
mutant(perfetto_has_another_field FILE sim/view/timeline/perfetto.cpp TEST observe "protobuf*"
  OLD [[sequence = 10,]]
  NEW [[sequence = 12,]])

# ---- Pages.
mutant(none_in_the_program FILE sim/view/page/html.cpp TEST cli "names with markup in them*")
mutant(page_map_is_upside_down FILE sim/view/page/data.cpp TEST cli "the maps of a report*"
  OLD [[        for (const PixelCost& p : costs.pixels) planes += char(map.value(p) >> 8 * b & 255);]]
  NEW [[        for (std::size_t i = 0; i < costs.pixels.size(); ++i)
            planes += char(map.value(costs.pixels[(costs.height - 1 - i / costs.width) * costs.width + i % costs.width]) >> 8 * b & 255);]])
mutant(page_kinds_are_shifted FILE sim/view/page/data.cpp TEST cli "a report is one file*"
  OLD [[const PurposeCost& p = costs.purposes[k];]]
  NEW [[const PurposeCost& p = costs.purposes[3 - k];]])
mutant(page_escapes_no_markup FILE sim/view/page/html.cpp TEST cli "names with markup in them*"
  OLD [[case '<': out += "&lt;"; break;]]
  NEW [[case '<': out += '<'; break;]])
mutant(page_data_ends_its_element FILE sim/view/page/html.cpp TEST cli "names with markup in them*"
  OLD [[out += "\\u003c";]]
  NEW [[out += '<';]])
mutant(explain_forgets_merged_misses FILE sim/view/explain/json.cpp TEST cli "explain counts look-ups that*"
  OLD [[{"cache_misses", ray.misses + ray.merges},]]
  NEW [[{"cache_misses", ray.misses},]])
mutant(compare_lets_a_bound_pass FILE sim/view/compare/compare.cpp TEST cli "compare finds*"
  OLD [[std::fabs(d.change) > share]]
  NEW [[std::fabs(d.change) > 100 * share + 1]])

# ---- The first divergence, and the way of a wrong value back through the RTL.
mutant(divergence_is_a_cycle_later FILE sim/run/lockstep/lockstep.cpp TEST meta
  "lockstep names the first cycle*"
  OLD [[now - watched_->cycle, same);]]
  NEW [[now - watched_->cycle + 1, same);]])
mutant(divergence_waveform_has_the_sides_swapped FILE sim/view/divergence/waveform.cpp TEST cli
  "verify names the first divergence*"
  OLD [[set(signals_[i].model[f], field, link.model);]]
  NEW [[set(signals_[i].model[f], field, link.rtl);]])
mutant(cone_goes_before_the_first_cycle FILE sim/view/divergence/cone.cpp TEST observe
  "a register that has held the value*"
  OLD [[return since > 0 ? std::make_optional(since - 1) : std::nullopt;]]
  NEW [[return std::make_optional(since - 1);]])

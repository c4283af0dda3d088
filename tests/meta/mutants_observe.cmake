# Faults of those who watch the model: costs, stories, timelines. As mutants_rtl.cmake has it.
mutant(observer_counts_no_merge FILE sim/view/observe/observer.cpp TEST observe "a watched frame*"
  OLD [[    ++(deed == CacheDeed::miss ? sums.misses : sums.merges)[cache];]]
  NEW [[    ++sums.misses[cache];]])
mutant(observer_is_a_cycle_late FILE sim/view/observe/observer.cpp TEST observe "a watched frame*"
  OLD [[    context.since = now_;
    context.place = place_after(link);]]
  NEW [[    context.since = now_ + 1;
    context.place = place_after(link);]])
mutant(observer_lets_camera_rays_pay FILE sim/view/observe/observer.cpp TEST observe "a watched frame*"
  OLD [[    costs_.purposes[std::size_t(purpose)].bytes += line_bytes;]]
  NEW [[    costs_.purposes[0].bytes += line_bytes;]])
mutant(observer_lets_the_last_ray_pay FILE sim/view/observe/observer.cpp TEST observe "a watched frame*"
  OLD [[p.contexts[queue.missing.front()];]]
  NEW [[p.contexts[queue.missing.back()];]])
mutant(observer_takes_reflection_for_refraction FILE model/unit/shade/shader.cpp TEST observe "a watched frame*"
  OLD [[last_ == ShadeEvent::reflect ?]]
  NEW [[last_ == ShadeEvent::pop ?]])
mutant(story_waits_for_its_own_work FILE sim/view/observe/story.cpp TEST observe "a pixel*"
  OLD [[std::uint64_t left = look - begin - times.before;]]
  NEW [[std::uint64_t left = look - begin;]])
mutant(story_forgets_what_caches_did FILE sim/view/observe/observer.cpp TEST observe "a pixel that waits*"
  OLD [[            ++state.waits.deeds[c][std::size_t(deed)];
]]
  NEW [[]])
mutant(story_forgets_refusals FILE sim/view/observe/observer.cpp TEST observe "a pixel that waits*"
  OLD [[++state.waits.refused[std::size_t(link)];]]
  NEW [[state.waits.refused[std::size_t(link)] = 0;]])
mutant(story_shadows_belong_to_the_first_ray FILE sim/view/observe/path.cpp TEST observe "the rays of a pixel*"
  OLD [[values.parent = surface_;]]
  NEW [[values.parent = 0;]])
mutant(timeline_does_not_cut FILE sim/view/timeline/timeline.cpp TEST observe "a stretch*"
  OLD [[std::max(begin.cycle, choice_.first)]]
  NEW [[begin.cycle]])
mutant(timeline_misses_the_first_cycle FILE sim/view/timeline/timeline.cpp TEST observe "a timeline of a whole frame*"
  OLD [[note_accounts(machine, now_ > choice_.first);]]
  NEW [[note_accounts(machine, now_ > choice_.first + 1);]])
mutant(kanata_retires_too_early FILE sim/view/timeline/kanata.cpp TEST observe "a Kanata file*"
  OLD [[last = ray.stays.back().last;]]
  NEW [[last = ray.stays.back().first;]])
mutant(perfetto_has_another_field FILE sim/view/timeline/perfetto.cpp TEST observe "protobuf*"
  OLD [[sequence = 10,]]
  NEW [[sequence = 12,]])
mutant(waveform_forgets_what_changed FILE sim/view/wave/fst_writer.cpp TEST observe "a waveform*"
  OLD [[if (known == value) return false;]]
  NEW [[if (!known.empty()) return false;]])
mutant(waveform_digits_are_reversed FILE sim/view/wave/fst_writer.cpp TEST observe "bits of a payload*"
  OLD [[const int bit = at + count - 1 - i;]]
  NEW [[const int bit = at + i;]])
mutant(gtkw_marks_the_left_edge FILE sim/view/wave/gtkw.cpp TEST observe "a save file*"
  OLD [[cycles_zoom, gtkw.marker,]]
  NEW [[cycles_zoom, gtkw.first,]])
mutant(fst_timeline_lets_a_ray_stay FILE sim/view/timeline/fst.cpp TEST observe "GTKWave's reader*"
  OLD [[{s.pixel, s.ray, s.place}) ends]]
  NEW [[{s.pixel, s.ray}) ends]])

# ---- The way of a wrong value back through the RTL.
mutant(cone_goes_before_the_first_cycle FILE sim/view/divergence/cone.cpp TEST observe "a register that has held the value*"
  OLD [[return since > 0 ? std::make_optional(since - 1) : std::nullopt;]]
  NEW [[return std::make_optional(since - 1);]])
mutant(cone_sees_the_first_element_alone FILE sim/view/divergence/cone.cpp TEST observe "the way leads through a register*"
  OLD [[return has_range ? name.substr(0, bracket) : name;]]
  NEW [[return has_range ? name.substr(0, name.find('[', name.rfind('.') + 1)) : name;]])
mutant(rtl_text_reads_comments FILE sim/view/divergence/rtl_text.cpp TEST observe "comments and directives*"
  OLD [[if (text.compare(at, 2, "/*") == 0)]]
  NEW [[if (text.compare(at, 3, "/**") == 0)]])
mutant(rtl_text_takes_an_index_for_a_target FILE sim/view/divergence/rtl_text.cpp TEST observe "elements of arrays*"
  OLD [[if (depth == 0) outside += c;]]
  NEW [[outside += c;]])

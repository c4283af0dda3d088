# Faults in what is read of a placed and routed chip. A row is as in mutants_model.cmake.
mutant(chip_way_from_a_pad_counts FILE sim/silicon/chip/timing.cpp TEST chip "delays of a file by hand*"
  OLD [[if (begin >= 0 &&]]
  NEW [[if (begin >= -1 &&]])
mutant(chip_setup_is_forgotten FILE sim/silicon/chip/timing.cpp TEST chip "delays of a file by hand*"
  OLD [[return pins_[std::size_t(p)].arrival + pins_[std::size_t(p)].setup;]]
  NEW [[return pins_[std::size_t(p)].arrival;]])
mutant(chip_harness_is_the_chip FILE sim/silicon/chip/route.cpp TEST chip "cells are counted*"
  OLD [[if (unit != harness_unit)]]
  NEW [[if (!unit.empty())]])
mutant(chip_carry_ends_are_lost FILE sim/silicon/chip/cells.cpp TEST chip "a cell belongs*"
  OLD [[if (cell.starts_with("$nextpnr_CCU2C_"))]]
  NEW [[if (cell.starts_with("$nextpnr_CARRY_"))]])
mutant(chip_source_is_an_instance FILE sim/silicon/chip/cells.cpp TEST chip "the source of a cell*"
  OLD [[is_instance((fs::path(sources) / file).string(), line, column) == instances)]]
  NEW [[(column > 0 || is_instance((fs::path(sources) / file).string(), line, column) == instances))]])
mutant(chip_source_is_the_outermost_instance FILE sim/silicon/chip/cells.cpp TEST chip "the source of a cell*"
  OLD [[!line.empty()) found = line;]]
  NEW [[!line.empty() && found.empty()) found = line;]])
mutant(chip_full_device_is_too_small FILE sim/silicon/chip/run.cpp TEST chip "what does not fit*"
  OLD [[if (needs <= has) continue;]]
  NEW [[if (needs < has) continue;]])
mutant(chip_mixed_is_kept_as_static FILE sim/silicon/chip/run.cpp TEST cli "a chip that does not fit*"
  OLD [[last == first ? "" :]]
  NEW [[true ? "" :]])
mutant(chip_mixed_weighs_time_as_nextpnr_does FILE sim/silicon/chip/nextpnr.cpp TEST cli "a chip that does not fit*"
  OLD [[methods.placer == "mixed" && last)]]
  NEW [[methods.placer == "mixed" && !last)]])
mutant(chip_mixed_places_by_heap_too_early FILE sim/silicon/chip/nextpnr.cpp TEST cli "a chip that does not fit*"
  OLD [[const bool last = placement == methods.placements;]]
  NEW [[const bool last = placement > 1;]])
mutant(chip_places_again_what_it_knows FILE sim/silicon/chip/nextpnr.cpp TEST cli "a chip that is stopped while*"
  OLD [[std::optional<Sites> sites = kept.find(placement);]]
  NEW [[std::optional<Sites> sites;]])
mutant(chip_sites_are_those_of_any_seed FILE sim/silicon/chip/run.cpp TEST cli "a chip that is stopped while*"
  OLD [[nextpnr_options(request_.device, methods), seed, placement);]]
  NEW [[nextpnr_options(request_.device, methods), 1, placement);]])
mutant(chip_mixed_never_places_by_heap FILE sim/silicon/chip/nextpnr.cpp TEST cli "a chip that does not fit*"
  OLD [[last ? "heap" : "static";]]
  NEW [[last ? "static" : "static";]])
mutant(balance_takes_what_is_too_large FILE sim/explore/balance/search.cpp TEST sweep "what the search finds*"
  OLD [[return use.*resource.member <= room.*resource.member;]]
  NEW [[return use.*resource.member <= room.*resource.member + room.*resource.member / 8;]])
mutant(balance_never_exchanges FILE sim/explore/balance/search.cpp TEST sweep "a step is given back*"
  OLD [[if (up.ladder != down.ladder)]]
  NEW [[if (up.ladder == down.ladder)]])
mutant(balance_keeps_what_brings_nothing FILE sim/explore/balance/search.cpp TEST sweep "a step is given back*"
  OLD [[return gain(m) < 0;]]
  NEW [[return gain(m) < 10;]])
mutant(balance_stays_with_one_pipeline FILE sim/explore/balance/search.cpp TEST sweep "the brute-force best*"
  OLD [[return value(a) > value(b);]]
  NEW [[return value(a) < value(b);]])
mutant(chip_route_loses_its_seed FILE sim/silicon/chip/route.cpp TEST chip "a route that was kept*"
  OLD [[route.seed = json.at("seed").get<int>();]]
  NEW [[]])
mutant(chip_names_tell_the_folder FILE sim/silicon/synth/yosys.cpp TEST chip "a netlist is the same*"
  OLD [[const fs::path name = fs::path("rtl") / source.name;]]
  NEW [[const fs::path name = path_ / "rtl" / source.name;]])
mutant(chip_anchors_take_a_site_twice FILE sim/silicon/chip/anchor.cpp TEST chip "anchors are the sites*"
  OLD [[std::swap(takes[i], takes[j]);]]
  NEW [[takes[j] = takes[i];]])
mutant(chip_anchors_see_no_height FILE sim/silicon/chip/anchor.cpp TEST chip "half the perimeter*"
  OLD [[right - left + bottom - top;]]
  NEW [[right - left;]])
mutant(chip_anchors_overlook_nets FILE sim/silicon/chip/cells.cpp TEST chip "a netlist's cells are wired*"
  OLD [[cell_.nets.push_back(int(number));]]
  NEW [[if (cell_.nets.empty()) cell_.nets.push_back(int(number));]])
mutant(chip_anchors_pass_each_other FILE sim/silicon/chip/anchor.cpp TEST chip "anchors are the sites*"
  OLD [[const bool better = wiring.length() < before;]]
  NEW [[const bool better = wiring.length() < before + (1 << 30);]])
mutant(chip_else_of_a_simulation_is_lost FILE sim/silicon/synth/yosys.cpp TEST chip "a word in a comment*"
  OLD [[(word == "`endif" || (left_out == 1 && word == "`else"))]]
  NEW [[word == "`endif"]])
mutant(chip_waits_for_router1_no_longer_than_for_router2 FILE sim/silicon/chip/nextpnr.cpp TEST chip "how far a run is*"
  OLD [[tool == "router1" ? 300 : 100]]
  NEW [[100]])
mutant(chip_takes_a_tables_head_for_no_wires_left FILE sim/silicon/chip/nextpnr.cpp TEST chip "how far a run is*"
  OLD [[if (arcs > 0 && has_number)]]
  NEW [[if (arcs > 0 && (has_number || parts.size() >= 5))]])
mutant(chip_waits_for_static_without_end FILE sim/silicon/chip/nextpnr.cpp TEST chip "how far a run is*"
  OLD [[if (!routes && line.starts_with("Info: overlap: "))]]
  NEW [[if (routes && line.starts_with("Info: overlap: "))]])

# Faults in parsers that the fuzzing must find: TARGET is the fuzz target, RUNS the most inputs that it may
# need. As in tests/meta, the text must occur in the file exactly once. A file that includes this table sets
# `for_each_mutant` to its own function. That function gets the name of a row, and reads the row as ARG_FILE,
# ARG_OLD and so on.
function(fuzz_mutant name)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "" "FILE;TARGET;RUNS;OLD;NEW" "")
  cmake_language(CALL ${for_each_mutant} ${name})
endfunction()

fuzz_mutant(ply_index_unchecked FILE sim/load/mesh/read_ply.cpp TARGET ply RUNS 20000
  OLD [[index < static_cast<double>(vertices_)]]
  NEW [[index >= 0]])
fuzz_mutant(cache_key_not_compared FILE sim/files/cache/results.cpp TARGET cache RUNS 20000
  OLD [[entry["key"] != key || ]]
  NEW [[]])
fuzz_mutant(mtl_more_light_than_came FILE sim/load/surface.cpp TARGET mtl RUNS 100000
  OLD [[std::min(fraction(out.mirror), 1 - out.transmit)]]
  NEW [[fraction(out.mirror)]])
fuzz_mutant(obj_index_one_beyond FILE sim/load/mesh/read_obj.cpp TARGET obj RUNS 100000
  OLD [[            if (index > count_)]]
  NEW [[            if (index > count_ + 1)]])
fuzz_mutant(stl_one_triangle_beyond FILE sim/load/mesh/read_stl.cpp TARGET stl RUNS 100000
  OLD [[if (bytes.size() < needed)]]
  NEW [[if (bytes.size() + facet_bytes < needed)]])
fuzz_mutant(gltf_accessor_beyond_its_view FILE sim/load/gltf/buffers.cpp TARGET gltf RUNS 100000
  OLD [[if (needed > length)]]
  NEW [[if (needed > 2 * length)]])
fuzz_mutant(scene_index_one_beyond FILE sim/load/json/parts.cpp TARGET scene RUNS 100000
  OLD [[corners[k].whole(mesh.vertices.size())]]
  NEW [[corners[k].whole(mesh.vertices.size() + 1)]])
fuzz_mutant(config_value_above_its_range FILE model/core/check.cpp TARGET config RUNS 100000
  OLD [[if (value < p.lo || value > p.hi)]]
  NEW [[if (value < p.lo)]])
fuzz_mutant(state_of_other_rays FILE sim/explore/stress/state.cpp TARGET state RUNS 100000
  OLD [[if (c.rays != rays)]]
  NEW [[if (c.rays > 2 * rays)]])
fuzz_mutant(options_clock_of_any_rate FILE sim/app/run/typed_values.cpp TARGET options RUNS 100000
  OLD [[ || mhz > 100000)]]
  NEW [[)]])
fuzz_mutant(rays_one_beyond FILE sim/load/rays/rays.cpp TARGET rays RUNS 100000
  OLD [[        shape = {head.shape[0], ]]
  NEW [[        shape = {head.shape[0] + 1, ]])
fuzz_mutant(link_answer_of_any_length FILE sim/board/protocol.cpp TARGET link RUNS 100000
  OLD [[(has_lines && (answer.count < 1 || answer.count > link_lines_most))]]
  NEW [[(has_lines && answer.count < 1)]])

// Computes memory sizes of configurations, and counts cells with Yosys.
#include "sim/explore/sweep/cost.hpp"

#include "model/base/error.hpp"
#include "model/base/nearest.hpp"
#include "sim/explore/fit/cost.hpp"
#include "sim/explore/sweep/evaluate_points.hpp"
#include "sim/silicon/area/synthesise_units.hpp"
#include "sim/silicon/synth/netlist.hpp"

namespace rayclock::sweep {

namespace {

std::uint64_t bytes_of(int sets, int ways, int line) {
    return std::uint64_t(sets) * std::uint64_t(ways) * std::uint64_t(line);
}

}   // namespace

Cost parse_cost(const std::string& word) {
    const std::vector<std::string> words{"multipliers", "lut", "dsp", "bram", "bits", "auto"};
    for (std::size_t i = 0; i < words.size(); ++i)
        if (words[i] == word) return Cost(i);
    throw UserError("--cost: no cost is called " + shown(word) + did_you_mean(word, words) +
                    "; there are multipliers, lut, dsp, bram, bits and auto");
}

std::uint64_t pipeline_cache_bytes(const Config& c) {
    return (c.is_list() ? 0 : bytes_of(c.node_sets, c.node_ways, c.node_line)) +
           bytes_of(c.prim_sets, c.prim_ways, c.prim_line) +
           (c.shading ? bytes_of(c.surf_sets, c.surf_ways, c.surf_line) : 0);
}

std::uint64_t chip_cache_bytes(const Config& c) {
    return std::uint64_t(c.pipelines) * pipeline_cache_bytes(c) + bytes_of(c.l2_sets, c.l2_ways, c.l2_line);
}

std::uint64_t chip_memory_bits(const Config& c) {
    const fit::Cost one = fit::cost_of(c);
    const std::uint64_t surfaces = c.shading ? 8 * bytes_of(c.surf_sets, c.surf_ways, c.surf_line) : 0;
    return std::uint64_t(c.pipelines) * (one.ray_bits + one.cache_bits + surfaces) +
           8 * bytes_of(c.l2_sets, c.l2_ways, c.l2_line);
}

void count_areas(Evaluation& outcome, int threads, results::Cache& cache, const Progress& progress) {
    std::vector<area::Variant> variants;
    std::vector<Result*> counted;
    for (Result& r : outcome.results) {
        if (!r.complete() || !synth::exists_in_rtl(r.point.config)) continue;
        variants.push_back({std::to_string(variants.size()), r.point.config});
        counted.push_back(&r);
    }
    if (variants.empty()) return;
    const area::Areas areas = area::run(std::move(variants), {}, threads, cache, progress);
    if (areas.partial) outcome.partial = true;
    for (std::size_t v = 0; v < counted.size() && !areas.partial; ++v)
        counted[v]->area = area::chip_count(areas, v);
}

}   // namespace rayclock::sweep

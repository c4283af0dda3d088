#pragma once
// What a machine costs: memory, which follows from the configuration, and cells, which Yosys counts.
#include <cstdint>
#include <string>

#include "model/core/config.hpp"
#include "sim/files/cache/results.hpp"
#include "model/base/progress.hpp"

namespace rayclock::sweep {

/// What a front takes as cost. `multipliers`: those of all pipelines, or the memory image if there are none.
/// `automatic`: the first of multipliers, memory on the chip and memory image that differs between points.
enum class Cost { multipliers, lut, dsp, bram, bits, automatic };

/// A word of --cost. Throws UserError with the nearest.
Cost parse_cost(const std::string& word);

/// Whether Yosys must map all units for it.
constexpr bool needs_area(Cost cost) { return cost == Cost::lut || cost == Cost::dsp || cost == Cost::bram; }

/// Data that the caches of one pipeline hold, and those of the chip with the one that pipelines share.
std::uint64_t pipeline_cache_bytes(const Config& config);
std::uint64_t chip_cache_bytes(const Config& config);

/// Memory of the chip in bits: what contexts keep of their rays, stacks, and caches with their tags.
std::uint64_t chip_memory_bits(const Config& config);

struct Outcome;

/// Counts the cells of every point's units that has RTL, each different unit once. Throws UserError if there
/// is no Yosys. Stops early when interrupted(), and the outcome is partial then.
void count_areas(Outcome& outcome, int threads, jobs::Cache& cache, const Progress& progress);

}   // namespace rayclock::sweep

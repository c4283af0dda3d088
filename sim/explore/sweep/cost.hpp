#pragma once
// The cost of a machine: memory, which follows from the configuration, and cells, which Yosys counts.
#include <cstdint>
#include <string>

#include "model/base/progress.hpp"
#include "model/core/config.hpp"
#include "sim/files/cache/results.hpp"

namespace rayclock::sweep {

/// The cost measure of a front. `multipliers` counts those of all pipelines, or uses the memory image if they
/// were not counted. `automatic` uses the first of multipliers, on-chip memory and memory image that differs
/// between points.
enum class Cost { multipliers, lut, dsp, bram, bits, automatic };

/// Parses the argument of --cost. Throws UserError that names the nearest word.
Cost parse_cost(const std::string& word);

/// Returns true if Yosys must map all units to get this cost.
constexpr bool needs_area(Cost cost) { return cost == Cost::lut || cost == Cost::dsp || cost == Cost::bram; }

/// Return the bytes of data in the caches of one pipeline, and in all caches of the chip including the shared
/// one.
std::uint64_t pipeline_cache_bytes(const Config& config);
std::uint64_t chip_cache_bytes(const Config& config);

/// Returns the chip's memory in bits: ray state of contexts, stacks, and caches with their tags.
std::uint64_t chip_memory_bits(const Config& config);

struct Evaluation;

/// Counts the cells of all points that have RTL, each distinct unit once. Throws UserError if Yosys is
/// missing. Stops early when interrupted(); the outcome is then partial.
void count_areas(Evaluation& outcome, int threads, results::Cache& cache, const Progress& progress);

}   // namespace rayclock::sweep

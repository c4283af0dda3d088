#pragma once
// The figures of a sampled frame: their estimates, their tables and their JSON. docs/guide/sampling.md.
#include <functional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "sim/run/sample/sample.hpp"

namespace rayclock {

/// A figure, as a sample estimates it and as the simulation of a whole frame gives it.
struct SampledFigure {
    std::string key;    ///< as in the report, for example "dram_bytes" or "units.box.busy_with.work"
    std::string unit;   ///< "cycles", "bytes", "share" ...
    std::function<sample::Estimate(const sample::Sampled&)> estimate;
    std::function<double(const FrameResult&)> exact;
};
/// Returns the figures that a sample estimates for this configuration: cycles first, then rates, work, memory
/// and the accounts of all units.
std::vector<SampledFigure> sampled_figures(const Config& config, int khz);

/// Returns the estimates with their intervals as text, one column for each clock.
std::string sampled_table(const Config& config, const std::vector<sample::Sampled>& clocks);
/// Returns sentences that say what was measured, and what is left out.
std::string sampled_lines(const sample::Effort& effort);
/// Returns the key `sampling` of a report.
nlohmann::ordered_json sampling_json(const Config& config, const sample::Ask& ask,
                                     const std::vector<sample::Sampled>& clocks);

}   // namespace rayclock

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
/// and the accounts of all units. `waits` are cycles of the host's writes and resets before the frame.
std::vector<SampledFigure> sampled_figures(const Config& config, int khz, std::uint64_t waits = 0);

/// A sampled frame, alone or of a film.
struct SampledFrame {
    double time = 0;   ///< seconds of the scene
    sample::Ask ask;
    sample::Effort effort;
    std::vector<std::vector<sample::Estimate>> estimates;   ///< [clock][figure of sampled_figures()]
};
/// Returns the widest relative interval of the cycles.
double widest_of(const SampledFrame& frame);

/// Returns the estimates with their intervals as text, one column for each clock. Those of several frames are
/// means.
std::string sampled_table(const Config& config, const std::vector<int>& khz,
                          const std::vector<SampledFrame>& frames);
/// Returns a row for each frame at the first clock, and their mean and sum.
std::string sampled_film_table(const Config& config, const std::vector<int>& khz,
                               const std::vector<SampledFrame>& frames);
/// Returns sentences that say what was measured, and what is left out.
std::string sampled_lines(const std::vector<SampledFrame>& frames);
/// Returns the key `sampling` of a report. `moves`: the scene moves.
nlohmann::ordered_json sampling_json(const Config& config, const std::vector<int>& khz,
                                     const std::vector<SampledFrame>& frames, bool moves);

}   // namespace rayclock

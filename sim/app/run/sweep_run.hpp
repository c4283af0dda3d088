#pragma once
// A sweep: the points of a grid, their figures, and the report. The command sweep and the Python module call
// it.
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "sim/explore/sweep/merge.hpp"
#include "sim/explore/sweep/shard.hpp"
#include "sim/run/film/film.hpp"
#include "sim/view/report/limits.hpp"

namespace rayclock {

/// The input of a sweep.
struct SweepRequest {
    const Request& request;
    FrameSize size;
    std::vector<sweep::Axis> axes;
    std::string clock, cost = "auto";
    std::optional<int> cache_bytes;   ///< keep only points whose caches hold this many bytes
    sweep::Shard shard{};
    bool netlists = true;   ///< count multipliers and flip-flops
    bool fresh = false;     ///< take nothing from the cache
    int threads = 0;
    FramesOptions frames{};
    ViewChoice view{};
    const StreamInput* stream = nullptr;   ///< traced in place of a picture
    std::optional<sample::Ask> sample{};   ///< estimates each point from a sample of its frame
};

/// The results of a sweep.
struct SweepResult {
    sweep::MergedSweep swept;
    nlohmann::ordered_json shard;
    std::string cache_trouble;   ///< the reason why nothing is kept for the next run, or empty
};
/// Runs a sweep. The result is partial if Ctrl-C stopped it. Throws UserError.
SweepResult run_sweep(SweepRequest ask, const Progress& progress);

/// Parses a value of the axis `clock` to kHz. Throws UserError.
int axis_clock(const std::string& value);

/// Returns the report of `sweep --json`: docs/guide/report.md.
nlohmann::ordered_json sweep_json(const sweep::MergedSweep& swept, const Limits& limits,
                                  const nlohmann::ordered_json& shard);

}   // namespace rayclock

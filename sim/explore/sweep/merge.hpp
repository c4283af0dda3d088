#pragma once
// Merges the reports of a sweep's parts.
#include "sim/explore/sweep/evaluate_points.hpp"
#include "sim/explore/sweep/shard.hpp"

namespace rayclock::sweep {

/// A sweep as read from its reports.
struct MergedSweep {
    nlohmann::ordered_json scene;   ///< the value in the report
    Config config;
    FrameSize size;   ///< 0 x 0 for a stream of rays
    SweepSettings settings;
    Evaluation outcome;
};

/// Merges reports written by `sweep --json`: all parts in any order, or one report of a whole sweep. Throws
/// UserError that names a wrong file or the missing parts. `clock` is as for make_points().
MergedSweep merge(const std::vector<std::string>& files, int (*clock)(const std::string&));

}   // namespace rayclock::sweep

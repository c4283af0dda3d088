#pragma once
// Reports of a sweep's parts, made one again.
#include "sim/explore/sweep/run.hpp"
#include "sim/explore/sweep/shard.hpp"

namespace rayclock::sweep {

/// A sweep as its report has it.
struct Merged {
    nlohmann::ordered_json scene;   ///< as the report has it
    Config config;
    FrameSize size;
    Asked asked;
    Outcome outcome;
};

/// Reports that `sweep --json` wrote: those of all parts, in any order, or a single one of the whole. Throws
/// UserError that names the file that is no such report or belongs to another sweep, or the parts that are
/// missing. `clock` as of make_points().
Merged merge(const std::vector<std::string>& files, int (*clock)(const std::string&));

}   // namespace rayclock::sweep

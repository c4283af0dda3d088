#pragma once
// A stream of rays on random chips: model and RTL in lockstep, and every answer judged exactly.
#include <optional>
#include <string>
#include <vector>

#include "sim/run/lockstep/lockstep.hpp"
#include "sim/run/stream/input.hpp"

namespace rayclock {

/// A random chip that can trace a stream, with a random clock, memory and back-pressure.
struct StreamChip {
    std::uint64_t seed = 1;
    Config config;
    int khz = default_khz;
    Disturbance disturbance;
};
/// Draws chips that can hold the scene and the rays, each with its own RTL. The chip number i depends only on
/// the input and on seed + i. A list without a tree is drawn only if the scene or the stream is small. Throws
/// UserError if no chip can be found.
std::vector<StreamChip> random_stream_chips(const StreamInput& input, std::uint64_t seed, int count,
                                            const Progress& progress = {});

/// The result of a chip.
struct StreamChipRun {
    LockstepResult lockstep;
    std::optional<StreamJudgement> judged;   ///< of the RTL's answers; nothing if the run was interrupted
    bool is_good() const { return lockstep.agrees() && judged && judged->wrong == 0; }
};
/// Runs a stream on a chip in lockstep and judges the answers.
StreamChipRun run_stream_chip(const StreamInput& input, const StreamChip& chip,
                              const Progress& progress = {});

}   // namespace rayclock

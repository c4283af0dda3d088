#pragma once
// Elastic verification: compares values, not cycles. The timing of the RTL may differ from the model's.
#include <array>
#include <optional>
#include <vector>

#include "sim/run/lockstep/lockstep.hpp"

namespace rayclock {

/// The units that the user replaced. Their don't-care outputs (dont_care.hpp) are not compared; those of all
/// other units are.
using FreeUnits = std::array<bool, unit_count>;

/// The result of an elastic verification. `model` and `rtl` are those of the last frame.
struct ElasticResult {
    std::vector<FrameResult> runs;       ///< the model's for all frames, without hits and answers
    std::vector<FrameResult> rtl_runs;   ///< the RTL's, without hits and answers
    FrameResult model, rtl;
    std::uint64_t events_compared = 0;    ///< transfers of the RTL that were judged
    std::uint64_t value_mismatches = 0;   ///< wrong transfers, and pixels that differ in the end
    std::optional<Divergence> first;      ///< `cycle` counts the RTL's cycles
    bool agrees() const { return value_mismatches == 0 && !first; }
};

/// Runs frames on the model and then on the RTL. Judges every transfer of the RTL: rays one by one
/// (ray_judge.hpp), memory lines by id (line_judge.hpp). Compares all pixels. The frame ends if no ray of the
/// RTL moves for patience() cycles. Then the transfer that has been due longest counts as a difference.
/// Throws std::runtime_error if the model hangs.
ElasticResult run_elastic(const Job& job, const std::vector<RecordedFrame>& frames, const FreeUnits& free,
                          Disturbance disturbance = {}, const Progress& progress = {}, int seed = 1);
ElasticResult run_elastic(const Job& job, Disturbance disturbance = {}, const Progress& progress = {},
                          int seed = 1);

/// Returns the units of a chip, for messages: "sched, raygen, ...".
std::string unit_names(const Config& config);

/// Parses "tri,box" or "all". Throws UserError if the configuration has no such unit.
FreeUnits parse_free_units(const std::string& text, const Config& config);

}   // namespace rayclock

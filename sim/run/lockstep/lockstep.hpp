#pragma once
// Model and RTL in lockstep: the comparison of every cycle.
#include <functional>
#include <optional>
#include <string>

#include "model/machine/links.hpp"
#include "sim/run/frame/frame.hpp"

namespace rayclock {

/// The first cycle in which model and RTL differ.
struct Divergence {
    std::uint64_t cycle = 0;
    /// The driver of the differing value (driver.hpp). If only the acceptance differs, the link's receiver;
    /// "host" for the frame's beginning and end; "rtl" for a failed assertion.
    std::string unit;
    /// The link's name. Without a link: "running" or "done" (signals), "cycles" (a register), "counters", or
    /// "none" (an assertion).
    std::string link;
    std::uint32_t ray = 0;
    std::uint32_t x = 0, y = 0;
    std::string expected;   ///< the model's value: differing fields, or whether it moved anything
    std::string got;        ///< the RTL's value
    std::string later;   ///< if only one of them made a transfer: when the other one made it; empty otherwise
    int pipeline = 0;
    std::optional<Link> on{};   ///< the link, if there is one
    /// The field of the link's payload that identifies the unit. Empty if the payload is equal.
    std::string field{};
    std::size_t frame = 0;            ///< number of the frame
    std::uint64_t frame_begins = 0;   ///< machine cycle
    std::string wave{};               ///< file of the waveform, or empty
};

/// The first counter, in the order of the units, that differs at the end of a frame.
struct CounterDifference {
    std::string unit, cause;
    std::uint64_t model = 0, rtl = 0;   ///< in cycles
    std::uint64_t others = 0;           ///< number of other counters that differ
};

/// The result of a comparison.
struct LockstepResult {
    std::vector<FrameResult> runs;       ///< the model's for all frames, without hits and answers
    FrameResult model, rtl;              ///< `seconds` is the wall time of both machines together
    std::uint64_t events_compared = 0;   ///< transfers (cycle, link, payload) that both sides made
    /// Transfers whose payload differs, and pixels that differ in the end.
    std::uint64_t value_mismatches = 0;
    std::uint64_t account_mismatches = 0;   ///< frames whose counters differ
    /// Difference of the frame's cycles, or of the first cycle with other moves.
    std::uint64_t cycle_gap = 0;
    std::optional<CounterDifference> counter;   ///< the first one, of the first frame whose counters differ
    bool counters_compared = false;             ///< for every frame; false if the machines diverged in time
    std::optional<Divergence> first;
    bool agrees() const {
        return value_mismatches == 0 && account_mismatches == 0 && cycle_gap == 0 && !first;
    }
};

/// Runs frames on model and RTL in lockstep. In every cycle it compares valid, ready and the packed payload
/// of every transfer on every link. At the end of a frame it compares the RTL's counters with the model's
/// accounts. After the first difference in time each machine runs on alone, and only pixels are compared. An
/// impossible value of the RTL and a failed assertion count as differences too. `model` and `rtl` of the
/// result are those of the last frame.
///
/// Calls `on_first` once with the first divergence, as soon as it is found; only `later` is unknown then.
/// Throws std::runtime_error if the model hangs.
LockstepResult run_lockstep(const Job& job, const std::vector<RecordedFrame>& frames,
                            Disturbance disturbance = {}, const Progress& progress = {}, int seed = 1,
                            const std::function<void(const Divergence&)>& on_first = {});
LockstepResult run_lockstep(const Job& job, Disturbance disturbance = {}, const Progress& progress = {},
                            int seed = 1);

}   // namespace rayclock

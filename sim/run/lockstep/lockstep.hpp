#pragma once
#include <functional>
#include <optional>
#include <string>

#include "model/core/links.hpp"
#include "sim/run/engine/engine.hpp"

namespace rayclock {

/// The first cycle in which model and RTL did not do the same.
struct Divergence {
    std::uint64_t cycle = 0;
    std::string unit;   ///< that drives what differs (driver.hpp); or that accepts what comes on the link, if
                        ///< the difference is that it does; "host" for the frame's beginning and end, "rtl"
                        ///< for an assertion that fails
    std::string link;   ///< of the host "running" or "done", the chip's own signals
    std::uint32_t ray = 0;
    std::uint32_t x = 0, y = 0;
    std::string expected;   ///< what the model did: differing fields, or whether it moved anything
    std::string got;        ///< what the RTL did
    std::string later;      ///< of a transfer that only one of them made: when the other did; empty otherwise
    int pipeline = 0;
    std::optional<Link> on{};   ///< the link, if it is one
    std::string field{};   ///< of its payload: the one that names the unit; empty if the payload is the same
    std::size_t frame = 0;            ///< its number
    std::uint64_t frame_begins = 0;   ///< cycle of the machine
    std::string wave{};               ///< file of the waveform, if there is one
};

/// The first counter, in the order of the units, that differs at the end of a frame.
struct CounterDifference {
    std::string unit, cause;
    std::uint64_t model = 0, rtl = 0;   ///< cycles
    std::uint64_t others = 0;           ///< so many more counters differ
};

struct LockstepResult {
    std::vector<FrameRun> runs;           ///< the model's of all frames; hits and answers are left out
    FrameRun model, rtl;                  ///< seconds: the time of each machine's own share
    std::uint64_t events_compared = 0;    ///< transfers (cycle, link, payload) seen on both sides
    std::uint64_t value_mismatches = 0;   ///< transfers whose payload differs, and pixels that differ in the
                                          ///< end
    std::uint64_t account_mismatches = 0;   ///< frames whose counters differ
    std::uint64_t cycle_gap = 0;   ///< difference of the frame's cycles, or of the first cycle with other
                                   ///< moves
    std::optional<CounterDifference> counter;   ///< the first, of the first frame whose counters differ
    bool counters_compared = false;             ///< of every frame; not if the machines parted
    std::optional<Divergence> first;
    bool agrees() const {
        return value_mismatches == 0 && account_mismatches == 0 && cycle_gap == 0 && !first;
    }
};

/// Runs frames on model and RTL side by side and compares, in every cycle and on every link, valid, ready
/// and the packed payload of what moves; at the end of a frame the RTL's counters with the model's accounts.
/// After the first difference in time each machine runs on alone, and pixels are compared. What no machine
/// can mean, and an assertion of the RTL that fails, is a difference like any other. The result's runs are
/// those of the last frame.
/// `on_first` is told of the first divergence as soon as it is found; only `later` is not known then.
LockstepResult run_lockstep(const Job& job, const std::vector<FrameTrace>& frames, Traffic traffic = {},
                            const Progress& progress = {}, int seed = 1,
                            const std::function<void(const Divergence&)>& on_first = {});
LockstepResult run_lockstep(const Job& job, Traffic traffic = {}, const Progress& progress = {},
                            int seed = 1);

}   // namespace rayclock

#pragma once
// The links of both machines, or of the RTL alone, around a divergence.
#include <optional>
#include <string>
#include <vector>

#include "sim/run/lockstep/lockstep.hpp"

namespace rayclock {

/// A link in a cycle, on both machines. The model's payload is known when the transfer happens, the RTL's
/// when it is offered.
struct LinkCycle {
    bool model_valid = false, model_fires = false, rtl_valid = false, rtl_fires = false;
    Words model, rtl;
    bool differs() const;
};

/// The last cycles before a divergence, and a few after it.
struct Capture {
    struct CapturedLink {
        int pipeline;   ///< 0 for links that all pipelines share
        Link link;
    };
    bool has_model = true;   ///< false: the model did not run, and its part of each LinkCycle is empty
    std::vector<CapturedLink> links;
    std::uint64_t first = 0;                      ///< machine cycle
    std::vector<std::vector<LinkCycle>> cycles;   ///< [cycle - first][link]
    std::optional<std::uint64_t> differs_at;      ///< the first of these cycles in which a link differs
};

constexpr std::uint64_t cycles_before = 1000, cycles_after = 20;

/// Runs both machines again from reset until shortly after the divergence. The RTL is a library that writes
/// its signals to `wave_path`, beginning `cycles_before` cycles before the divergence. A cycle takes 10 units
/// of time, and its signals are settled from the 5th on. Without the model, the RTL continues after its last
/// frame. The result is partial if interrupted().
Capture capture(const Job& job, const std::vector<RecordedFrame>& frames, Disturbance disturbance, int seed,
                std::uint64_t divergence, const std::string& wave_path, bool with_model,
                const Progress& progress);

}   // namespace rayclock

#pragma once
// Follows a differing value back through the RTL to the statement that computes it. If a statement only
// passes the value on, one of the signals that it reads holds the value: in the same cycle, or before a
// register in the previous cycle. So the waveform shows the path of the value. The path ends at a statement
// that reads no signal with this value.
#include <string>
#include <vector>

#include "sim/run/rtl/sources.hpp"
#include "sim/view/divergence/capture.hpp"
#include "sim/view/divergence/source.hpp"

namespace rayclock {

struct ConeStep {
    SourceLine source;   ///< the statement that drives the signal
    /// Lines that drive the same signal in other branches of `if`. One of them may be the branch that was
    /// built.
    std::vector<SourceLine> others;
    std::string signal;        ///< path from the unit's instance: "u_hitdiv.u_o"
    std::uint64_t cycle = 0;   ///< machine cycle in which it holds the value
    bool is_register = false;
};

/// Returns the path from the unit's output on. It is empty if the divergence is not on a link, or if its
/// unit's output is not among the signals. `sources`: the sources of the RTL that wrote the waveform.
std::vector<ConeStep> cone_of(const Divergence& divergence, const Config& config, const Capture& capture,
                              const std::string& rtl_wave, const std::vector<RtlText>& sources = rtl_texts());

}   // namespace rayclock

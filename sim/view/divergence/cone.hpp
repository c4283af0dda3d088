#pragma once
// From the value that differs back through the RTL, to where it is made. A value that is only passed on is in
// one of the signals that a statement reads, in the same cycle, or before a register in the cycle before: so
// the waveform says which way it came. The way ends at a statement that none of whose signals holds the
// value.
#include <string>
#include <vector>

#include "sim/view/divergence/capture.hpp"
#include "sim/view/divergence/source.hpp"
#include "sim/run/rtl/sources.hpp"

namespace rayclock {

struct ConeStep {
    SourceLine source;                ///< that gives the signal its value
    std::vector<SourceLine> others;   ///< of other branches of `if`, which may be the one that was built
    std::string signal;               ///< from the unit's instance: "u_hitdiv.u_o"
    std::uint64_t cycle = 0;          ///< of the machine, in which it holds the value
    bool is_register = false;
};

/// From the unit's output on; empty if the divergence is on no link, or its unit's output is not among the
/// signals. `sources`: of the RTL that wrote the waveform.
std::vector<ConeStep> cone_of(const Divergence& divergence, const Config& config, const Capture& capture,
                              const std::string& rtl_wave, const std::vector<RtlText>& sources = rtl_texts());

}   // namespace rayclock

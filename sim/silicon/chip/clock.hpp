#pragma once
// The clock that a chip was routed for, where other commands find it.
#include <optional>
#include <string>

#include "sim/silicon/chip/run.hpp"

namespace rayclock::chip {

struct RoutedClock {
    double mhz = 0;
    std::string device;
    int seed = 0;

    int khz() const { return int(mhz * 1000); }   ///< not above what was shown
};

/// The fastest that was kept for this configuration and these sources; nothing if it was not routed. Needs no
/// tool.
std::optional<RoutedClock> routed_clock(const Config& config);

/// Keeps it, if it is the fastest so far.
void keep_clock(const Config& config, const RoutedClock& clock, jobs::Cache& cache);

}   // namespace rayclock::chip

#pragma once
// The routed clock of a chip, kept for other commands.
#include <optional>
#include <string>

#include "sim/silicon/chip/place_and_route.hpp"

namespace rayclock::chip {

/// The clock of one routed chip.
struct RoutedClock {
    double mhz = 0;
    std::string device;
    int seed = 0;

    int khz() const { return int(mhz * 1000); }   ///< rounds down to a clock that routing has shown
};

/// Returns the fastest clock kept for this configuration and these sources, or nothing. Needs no tool.
std::optional<RoutedClock> routed_clock(const Config& config);

/// Keeps the clock if it is the fastest so far.
void keep_clock(const Config& config, const RoutedClock& clock, results::Cache& cache);

}   // namespace rayclock::chip

#pragma once
// Measures wall time.
#include <chrono>

namespace rayclock {

/// Measures seconds since its construction, on a clock that is never adjusted.
class Stopwatch {
public:
    double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point start_ = Clock::now();
};

}   // namespace rayclock

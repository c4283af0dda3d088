#pragma once
// Stopping work at Ctrl-C by an exception.
#include "model/base/interrupted.hpp"
#include "model/base/progress.hpp"
#include "sim/files/process/interrupt.hpp"

namespace rayclock {

/// Throws Interrupted after Ctrl-C.
inline void stop_if_interrupted() {
    if (interrupted()) throw Interrupted("interrupted: nothing is written");
}

/// Wraps a progress callback so that it throws Interrupted after Ctrl-C. Use it only for work whose partial
/// results are discarded.
inline Progress stopping(const Progress& progress) {
    return [progress](std::string_view what, std::uint64_t done, std::uint64_t total) {
        stop_if_interrupted();
        if (progress) progress(what, done, total);
    };
}

}   // namespace rayclock

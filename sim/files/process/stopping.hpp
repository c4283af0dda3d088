#pragma once
#include "model/base/interrupted.hpp"
#include "model/base/progress.hpp"
#include "sim/files/process/interrupt.hpp"

namespace rayclock {

/// Throws Interrupted after Ctrl-C.
inline void stop_if_interrupted() {
    if (interrupted()) throw Interrupted("interrupted: nothing is written");
}

/// The same, and Ctrl-C ends the work that reports to it: for work of which nothing is kept.
inline Progress stopping(const Progress& progress) {
    return [progress](std::string_view what, std::uint64_t done, std::uint64_t total) {
        stop_if_interrupted();
        if (progress) progress(what, done, total);
    };
}

}   // namespace rayclock

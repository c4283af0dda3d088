#pragma once
// How fast a machine with and without units is simulated.
#include <vector>

#include "model/base/progress.hpp"
#include "model/scene/scene.hpp"
#include "model/scene/camera.hpp"
#include "model/scene/whitted.hpp"
#include "sim/silicon/area/variants.hpp"

namespace rayclock::area {

struct Speed {
    std::string name;           ///< of the variant
    std::uint64_t cycles = 0;   ///< of the frame
    double rays = 0;
    double model_seconds = 0;   ///< recording and replay, one thread
    double rtl_seconds = 0;
    std::uintmax_t library = 0;   ///< bytes of the RTL, compiled by Verilator and the C++ compiler
};

/// One frame on each machine, first the model and then the RTL: the best of `rounds`, which take turns, since
/// others share the host. Throws UserError if interrupted, or if model and RTL do not take the same cycles.
std::vector<Speed> measure(const std::vector<Variant>& variants, const Scene& scene, FrameSize size,
                           const Whitted& settings, int rounds, const Progress& progress);

}   // namespace rayclock::area

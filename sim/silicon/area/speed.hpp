#pragma once
// Measures how fast machines with and without optional units are simulated.
#include <vector>

#include "model/base/progress.hpp"
#include "model/scene/camera.hpp"
#include "model/scene/scene.hpp"
#include "model/scene/whitted.hpp"
#include "sim/silicon/area/variants.hpp"

namespace rayclock::area {

/// The simulation speed of one variant.
struct Speed {
    std::string name;           ///< name of the variant
    std::uint64_t cycles = 0;   ///< cycles of the frame
    double rays = 0;
    double model_seconds = 0;   ///< recording and replay, one thread
    double rtl_seconds = 0;
    std::uintmax_t library = 0;   ///< bytes of the compiled RTL library (Verilator and the C++ compiler)
};

/// Renders one frame on each machine, first on the model and then on the RTL. Keeps the best of `rounds`. The
/// variants take turns because other jobs share the host. Throws Interrupted after Ctrl-C, and
/// std::runtime_error if the cycles of model and RTL differ.
std::vector<Speed> measure(const std::vector<Variant>& variants, const Scene& scene, FrameSize size,
                           const Whitted& settings, int rounds, const Progress& progress);

}   // namespace rayclock::area

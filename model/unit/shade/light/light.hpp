#pragma once
// Lights and shadow rays of a pass.
#include "model/unit/shade/state.hpp"

namespace rayclock {

/// The outcome of a pass for a light: the shadow ray's direction. light() also sets the light's contribution
/// in state.share. Mirror of rtl/unit/shade/light/rc_light.sv.
struct LightOut {
    bool counts = false;   ///< the light lies on the side seen, and its cosine is positive
    LightParts parts;
    /// Near light: from the light to o, times 2^B, or of M bits if o is far. Otherwise from o to the light,
    /// of M bits.
    Vec3i d{};
    Home home;   ///< with two levels: at, or from, the instance that was hit
};
LightOut light(const Frame& frame, const Config& config, ShadeState& state, const Placement& placement = {});

}   // namespace rayclock

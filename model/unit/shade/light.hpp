#pragma once
#include "model/unit/shade/state.hpp"

namespace rayclock {

/// The part of a pass that a light takes: what it would add, into state.share, and the shadow ray's
/// direction. Mirror of rtl/unit/shade/rc_light.sv.
struct LightOut {
    bool counts = false;   ///< the light lies on the side seen, and its cosine is positive
    LightParts parts;
    Vec3i d{};   ///< near: from the light to o, times 2^B, or of M bits if o is far; else from o to the
                 ///< light, of M bits
    Home home;   ///< with two levels: at, or from, the instance that was hit
};
LightOut light(const Frame& frame, const Config& config, ShadeState& state, const Placement& placement = {});

}   // namespace rayclock

#pragma once
#include "model/shade/state.hpp"

namespace rayclock {

/// The part of a pass that a reflected or refracted ray takes. Mirror of rtl/shade/rc_bounce.sv.
struct BounceOut {
    bool goes = false;    ///< it leaves on the side on which it should; a refracted one: without total
                          ///< reflection
    bool total = false;   ///< total reflection
    std::uint32_t weight = 0;
    Vec3i d{};   ///< M bits
};
BounceOut reflect(const Config& config, const ShadeState& state);
BounceOut refract(const Config& config, const ShadeState& state);

}   // namespace rayclock

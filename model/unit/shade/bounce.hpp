#pragma once
#include "model/unit/shade/state.hpp"

namespace rayclock {

/// The part of a pass that a reflected or refracted ray takes. Mirror of rtl/unit/shade/rc_bounce.sv.
struct BounceOut {
    bool goes = false;    ///< it leaves on the side on which it should; a refracted one: without total
                          ///< reflection, and with two levels if a component is as long as shortest_held()
    bool total = false;   ///< total reflection
    std::uint32_t weight = 0;
    Vec3i d{};   ///< M bits
    Home home;   ///< with two levels: from the instance that was hit
};
/// With two levels: what the longest component of a refracted direction must be at least, a quarter of a unit
/// vector.
inline std::int32_t shortest_held(const Config& config) { return 1 << (config.dir_bits - 4); }
BounceOut reflect(const Config& config, const ShadeState& state, const Placement& placement = {});
BounceOut refract(const Config& config, const ShadeState& state, const Placement& placement = {});

/// With two levels: the ray from a point of an instance's triangle, in its mesh's space.
Home home_of(const ShadeState& state, const Vec3i& d, const Placement& placement, const Config& config);

}   // namespace rayclock

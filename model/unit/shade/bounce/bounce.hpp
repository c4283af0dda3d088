#pragma once
// Reflected and refracted rays of a pass.
#include "model/unit/shade/state.hpp"

namespace rayclock {

/// The outcome of a pass for a reflected or refracted ray. Mirror of rtl/unit/shade/bounce/rc_bounce.sv.
struct BounceOut {
    /// The ray leaves on the right side. A refracted ray also needs no total reflection and, with two levels,
    /// a component of at least shortest_held().
    bool goes = false;
    bool total = false;   ///< total reflection
    std::uint32_t weight = 0;
    Vec3i d{};   ///< M bits
    Home home;   ///< with two levels: from the instance that was hit
};
/// Returns, for two levels, the least size of a refracted direction's longest component: a quarter of a unit
/// vector.
inline std::int32_t shortest_held(const Config& config) { return 1 << (config.dir_bits - 4); }
BounceOut reflect(const Config& config, const ShadeState& state, const Placement& placement = {});
BounceOut refract(const Config& config, const ShadeState& state, const Placement& placement = {});

/// Returns, for two levels, the ray from a point of an instance's triangle in its mesh's space.
Home home_of(const ShadeState& state, const Vec3i& d, const Placement& placement, const Config& config);

}   // namespace rayclock

#pragma once
// Planes in any direction.
#include "model/engine/kd/treelet.hpp"

namespace rayclock {

/// A slant (a treelet whose planes lie in any direction, core/lines.hpp) unpacked for the model.
struct WideSlant : WideExits {
    using WideExits::WideExits;
    std::array<Vec3i, max_width - 1> normal{};
    std::array<std::int32_t, max_width - 1> at{};
};
WideSlant widen(const Slant& slant, int node_width);

/// A ray's direction as slants want it: moved up by ray_dir_bits - dir_bits, so that what it is worth does
/// not depend on what the ray is for; a shadow ray's has ray_dir_bits as it is.
Vec3i aligned(const Ray& ray, const Config& config);

/// What the plane n . x = at says of a ray, conservative (docs/bsp.md).
///
/// Both `num` = at - n . o, with the origin's fraction bits, and `den` = n . d are whole numbers, so on which
/// side the origin lies, and whether the ray goes towards the upper side, is decided exactly. If it moves and
/// comes from the near side, it is on the plane at T = 2^S num / den, S = F + M - 1 - B. Both are cut off to
/// crossing_bits, and q = floor(2^17 num / den) of these: T lies strictly between (q - 2) 2^x and (q + 2)
/// 2^x, x = S - 17 + the difference of their lengths. The far side is entered at floor((q - 2) 2^x) at the
/// earliest, the near side left at floor((q + 2) 2^x) + 1 at the latest. Mirror of
/// rtl/engine/bsp/rc_crossing.sv.
PlaneSides crossing(const Vec3i& o, const Vec3i& along, const Vec3i& normal, std::int32_t at,
                    const Config& config);

/// Which exits of a slant a ray meets, as treelet_exits() of a treelet. Mirror of rtl/engine/bsp/rc_slant.sv,
/// latency Config::slant_latency() + 1, one slant per cycle.
std::uint32_t slant_exits(const BoxRay& ray, const Vec3i& along, const WideSlant& slant, const Config& config,
                          std::uint32_t* t_near);
/// The unit's answer.
BoxRsp slant(const SlantReq& req, const Config& config);

}   // namespace rayclock

#pragma once
// The unit slant: nodes with planes in any direction.
#include "model/engine/bsp/node.hpp"
#include "model/engine/space_cells/decide.hpp"

namespace rayclock {

/// A slant (a treelet whose planes lie in any direction, node.hpp) unpacked for the model.
struct WideSlant : WideExits {
    using WideExits::WideExits;
    std::array<Vec3i, max_width - 1> normal{};
    std::array<std::int32_t, max_width - 1> at{};
};
WideSlant widen(const Slant& slant, int node_width);

/// A ray in the form of slants.
struct SlantRay {
    BoxRay box;
    Vec3i along{};   ///< slant_direction()
};
/// Returns a ray's direction in the form that slants use. It is shifted up by ray_dir_bits - dir_bits, so
/// that its scale does not depend on the ray's kind. A shadow ray's direction already has ray_dir_bits.
Vec3i slant_direction(const Ray& ray, const Config& config);

/// Returns the position of a ray relative to the plane n . x = at, conservatively (docs/proofs/bsp.md).
///
/// `num` = at - n . o, with the origin's fraction bits, and `den` = n . d are both whole numbers. So the
/// origin's side, and the side towards which the ray goes, are exact. A ray that moves and starts on the near
/// side is on the plane at T = 2^S num / den, S = F + M - 1 - B. Both numbers are cut to crossing_bits, and
/// q = floor(2^17 num / den) of these. Then T lies strictly between (q - 2) 2^x and (q + 2) 2^x, where x = S
/// - 17 + the difference of their lengths. The ray enters the far side at floor((q - 2) 2^x) at the earliest,
/// and leaves the near side at floor((q + 2) 2^x) + 1 at the latest. Mirror of rtl/engine/bsp/rc_crossing.sv.
PlaneSides crossing(const Vec3i& o, const Vec3i& along, const Vec3i& normal, std::int32_t at,
                    const Config& config);

/// Returns the exits of a slant that a ray meets, as treelet_exits() (kd/treelet.hpp) does for a treelet.
/// Mirror of rtl/engine/bsp/rc_slant.sv, latency bsp::Engine::latency() + 1, one slant per cycle.
std::uint32_t slant_exits(const BoxRay& ray, const Vec3i& along, const WideSlant& slant, const Config& config,
                          std::uint32_t* t_near);
/// Returns the unit's answer.
NodeAnswer slant(const SlantReq& req, const Config& config);

}   // namespace rayclock

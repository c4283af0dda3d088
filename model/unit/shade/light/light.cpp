// The contribution of a light, and its shadow ray.
#include "model/unit/shade/light/light.hpp"

#include <algorithm>

#include "model/unit/shade/bounce/bounce.hpp"
#include "model/fixed/rounding.hpp"
#include "model/fixed/power.hpp"
#include "model/fixed/unit_vector.hpp"
#include "model/unit/xform/xform.hpp"

namespace rayclock {

namespace {

/// Returns, for two levels, the shadow ray in the mesh's space. The light is mapped like any ray's origin,
/// and the ray from it ends exactly at the point.
Home home_from(const Vec3i& light, const ShadeState& state, const Placement& placement, const Config& c) {
    Vec3i o = light;
    for (auto& x : o) x *= 1 << c.origin_bits;
    Home home{placement.home(), moved_point(placement, o, RayKind::shadow, c), {}};
    for (std::size_t k = 0; k < 3; ++k) home.d[k] = std::int32_t(state.inner[k] - home.o[k]);
    return home;
}

}   // namespace

LightOut light(const Frame& frame, const Config& c, ShadeState& state, const Placement& placement) {
    const std::int32_t* place = &frame.shade.place[3 * state.light];
    LightOut out;
    Vec3l to{};
    Int128 side = 0;
    for (std::size_t k = 0; k < 3; ++k) to[k] = (std::int64_t(place[k]) << c.origin_bits) - state.o[k];
    const std::array<std::int32_t, 3> unit = unit_vector(to);
    const bool near = frame.shade.near[state.light] != 0;
    out.d = direction_of(unit, c);
    if (near)   // from the light; for a point beyond the lattice only the direction is representable
        for (std::size_t k = 0; k < 3; ++k) out.d[k] = state.is_far ? -out.d[k] : std::int32_t(-to[k]);
    // The side seen, exactly: the ray's own direction decides.
    if (c.has_homes())
        out.home = near && !state.is_far ? home_from({place[0], place[1], place[2]}, state, placement, c)
                                         : home_of(state, out.d, placement, c);
    const Vec3i& way = c.has_homes() ? out.home.d : out.d;
    for (std::size_t k = 0; k < 3; ++k) side += Int128(state.n[k]) * way[k];
    if (near) side = -side;
    const std::uint32_t cosine = clamped_dot(state.normal, unit);   // N . L
    out.counts = side > 0 && cosine > 0;
    // R . V with R = 2 (N . L) N - L.
    const std::int64_t mirrored =
        rounded(2 * std::int64_t(cosine) * state.cosine, unit_bits) - unit_dot(unit, state.view);
    const std::uint32_t phong =
        power(std::uint32_t(std::clamp<std::int64_t>(mirrored, 0, 1 << unit_bits)), state.shine);
    out.parts = {unit, cosine, phong};
    for (std::size_t k = 0; k < 3; ++k) {
        const std::uint64_t matte =
            rounded(std::uint64_t(state.diffuse) * cosine * state.albedo[k], 2 * share_bits);
        const std::uint64_t gloss = rounded(std::uint64_t(state.highlight) * phong, share_bits);
        const std::uint64_t share = rounded(
            (matte + gloss) * frame.shade.colour[3 * state.light + k] * state.weight, share_bits + unit_bits);
        state.share[k] = std::uint32_t(std::min<std::uint64_t>(share, 1 << unit_bits));
    }
    return out;
}

}   // namespace rayclock

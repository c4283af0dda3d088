// Directions and weights of reflected and refracted rays.
#include "model/unit/shade/bounce/bounce.hpp"

#include <algorithm>

#include "model/fixed/rounding.hpp"
#include "model/fixed/square_root.hpp"
#include "model/unit/xform/xform.hpp"

namespace rayclock {

namespace {

constexpr std::int64_t unit_one = 1 << unit_bits;

/// Returns a vector of about unit length with components clamped to 1.
std::array<std::int32_t, 3> within(const Vec3l& v) {
    std::array<std::int32_t, 3> unit{};
    for (std::size_t k = 0; k < 3; ++k) unit[k] = std::int32_t(std::clamp(v[k], -unit_one, unit_one));
    return unit;
}

/// Returns the sign of n . d, exactly.
int side_of(const Vec3l& n, const Vec3i& d) {
    const Int128 dot = Int128(n[0]) * d[0] + Int128(n[1]) * d[1] + Int128(n[2]) * d[2];
    return dot > 0 ? 1 : dot < 0 ? -1 : 0;
}

/// Schlick 1994: R0 + (1 - R0) (1 - cosine)^5.
std::int64_t schlick(const ShadeState& state) {
    const std::int64_t q = unit_one - state.cosine, q2 = rounded(q * q, unit_bits),
                       q4 = rounded(q2 * q2, unit_bits), q5 = rounded(q4 * q, unit_bits);
    return state.r0 + rounded((unit_one - std::int64_t(state.r0)) * q5, unit_bits);
}

std::uint32_t times(std::uint32_t weight, std::int64_t share) {
    return std::uint32_t(rounded(weight * std::min(share, unit_one), unit_bits));
}

/// Returns 2^32 times the squared cosine of the refracted ray; negative for total reflection. The product of
/// the squared ratio and the squared sine is rounded down.
std::int64_t refracted_cosine(const ShadeState& state) {
    const std::uint64_t sine2 =
        (std::uint64_t(1) << 2 * unit_bits) - std::uint64_t(state.cosine) * state.cosine;
    const auto bent =
        std::uint64_t(Int128(std::uint64_t(state.ratio) * state.ratio) * sine2 >> 2 * index_frac);
    return (std::int64_t(1) << 2 * unit_bits) - std::int64_t(bent);
}

/// True if, with two levels, the direction is long enough for the instances' boxes to hold the ray
/// (docs/machine/motion.md, Secondary rays). A refracted direction is shorter than others if a corner normal
/// faces away from the viewer.
bool is_held(const Config& c, const Vec3i& d) {
    const std::int32_t least = shortest_held(c);
    return !c.has_homes() ||
           std::any_of(d.begin(), d.end(), [&](std::int32_t k) { return std::abs(k) >= least; });
}

/// Returns the side on which a ray along d leaves the surface: 1 is the side seen. With two levels its d'
/// decides, exactly.
int leaves(const Config& c, const ShadeState& state, const Placement& placement, BounceOut& out) {
    if (!c.has_homes()) return side_of(state.n, out.d);
    out.home = home_of(state, out.d, placement, c);
    return side_of(state.n, out.home.d);
}

}   // namespace

Home home_of(const ShadeState& state, const Vec3i& d, const Placement& placement, const Config& c) {
    Home home{placement.home(), {}, moved_direction(placement, d, c)};
    for (std::size_t k = 0; k < 3; ++k) home.o[k] = std::int32_t(state.inner[k]);
    return home;
}

BounceOut reflect(const Config& c, const ShadeState& state, const Placement& placement) {
    BounceOut out;
    Vec3l mirrored{};
    for (std::size_t k = 0; k < 3; ++k)
        mirrored[k] = rounded(2 * std::int64_t(state.cosine) * state.normal[k], unit_bits) - state.view[k];
    out.d = direction_of(within(mirrored), c);
    out.goes = leaves(c, state, placement, out) > 0;
    std::int64_t share = state.mirror;
    if (c.refraction) {
        if (state.total)
            share += state.transmit;
        else if (state.schlick)
            share += rounded(state.transmit * schlick(state), unit_bits);
    }
    out.weight = times(state.weight, share);
    return out;
}

BounceOut refract(const Config& c, const ShadeState& state, const Placement& placement) {
    BounceOut out;
    const std::int64_t cosine2 = refracted_cosine(state);
    out.total = cosine2 < 0;
    const std::int64_t root = out.total ? 0 : std::int64_t(square_root(std::uint64_t(cosine2)));
    const std::int64_t along = rounded(std::int64_t(state.ratio) * state.cosine, index_frac) - root;
    Vec3l bent{};
    for (std::size_t k = 0; k < 3; ++k)
        bent[k] = rounded(
            along * state.normal[k] - (std::int64_t(state.ratio) * state.view[k] << (unit_bits - index_frac)),
            unit_bits);
    out.d = direction_of(within(bent), c);
    out.goes = leaves(c, state, placement, out) < 0 && !out.total && is_held(c, out.d);
    const std::int64_t share =
        state.schlick ? rounded(state.transmit * (unit_one - schlick(state)), unit_bits) : state.transmit;
    out.weight = times(state.weight, share);
    return out;
}

}   // namespace rayclock

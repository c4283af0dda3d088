// The surface that a ray has hit: its point, normal and colour.
#include "model/unit/shade/surface/surf.hpp"

#include <algorithm>
#include <cstdlib>

#include "model/unit/tri/origin.hpp"
#include "model/unit/shade/light/approach.hpp"
#include "model/fixed/rounding.hpp"
#include "model/fixed/unit_vector.hpp"

namespace rayclock {

namespace {

std::int64_t signed_uv(std::uint32_t x, const Config& c) {
    const int spare = 32 - c.uv_bits();
    return std::int32_t(x << spare) >> spare;
}

Vec3l edges_cross(const Surface& s) {
    Vec3l e1{}, e2{};
    for (std::size_t k = 0; k < 3; ++k)
        e1[k] = std::int64_t(s.b[k]) - s.a[k], e2[k] = std::int64_t(s.c[k]) - s.a[k];
    return {e1[1] * e2[2] - e1[2] * e2[1], e1[2] * e2[0] - e1[0] * e2[2], e1[0] * e2[1] - e1[1] * e2[0]};
}

/// Clamps a coordinate to this many bits. Returns true if it did not fit.
bool saturate(std::int64_t at, int bits, std::int64_t& o) {
    const std::int64_t most = (std::int64_t(1) << (bits - 1)) - 1;
    o = std::clamp(at, -most, most);
    return o != at;
}

/// Weights u and v in units of 2^-(B + fine). `ends`: a plane's u or v is saturated.
struct FineWeights {
    std::int64_t u = 0, v = 0;
    bool ends = false;
};
FineWeights fine_weights(const Closest& hit, bool is_plane, int frac_bits, const Config& c) {
    if (!is_plane) {
        const Weights w = inner_weights(hit.u, hit.v, c.bary_bits, frac_bits);
        return {w.u, w.v, false};
    }
    const std::int64_t u = signed_uv(hit.u, c), v = signed_uv(hit.v, c),
                       most = (std::int64_t(1) << (c.uv_bits() - 1)) - 1;
    const bool ends = u == most || v == most || u == -most - 1 || v == -most - 1;
    return {rounded(u, c.bary_bits - c.origin_bits), rounded(v, c.bary_bits - c.origin_bits), ends};
}

/// Returns the surface's colour. For a checkered plane it is that of the square (Surface::normal). Where u or
/// v is saturated it is the average of both colours.
std::array<std::uint32_t, 3> albedo_of(const Surface& s, bool is_plane, const Closest& hit, bool ends,
                                       const Config& c) {
    if (!s.checkered || !is_plane) return s.colour;
    if (!ends) {
        const auto second = [&](std::uint64_t x, std::size_t side) {
            const std::uint64_t at = x + (std::uint64_t(std::uint32_t(s.normal[side])) << c.bary_bits);
            return (at & ((std::uint64_t(1) << c.uv_bits()) - 1)) >> (s.normal[2 + side] & 63) & 1;
        };
        return second(hit.u, 0) != second(hit.v, 1) ? s.other : s.colour;
    }
    std::array<std::uint32_t, 3> between{};
    for (std::size_t k = 0; k < 3; ++k) between[k] = (s.colour[k] + s.other[k]) >> 1;
    return between;
}

/// Computes the ray's point at t.
void ray_at(const PassIn& in, const Config& c, Vec3l& o) {
    for (std::size_t k = 0; k < 3; ++k)
        saturate(in.o[k] + rounded(std::int64_t(in.d[k]) * in.hit.t,
                                   c.dir_bits - 1 + c.t_frac_bits - c.origin_bits),
                 c.origin_width(), o[k]);
}

/// Sets the view against the ray, and its cosine with the unit normal, which must be set.
void set_view(const PassIn& in, ShadeState& state) {
    state.view = unit_vector({-std::int64_t(in.d[0]), -std::int64_t(in.d[1]), -std::int64_t(in.d[2])});
    state.cosine = clamped_dot(state.normal, state.view);
}

}   // namespace

void transform_surface(const PassIn& in, const Config& c, ShadeState& state) {
    state.inner = state.o;
    if (in.placement.is_same) return;
    ray_at(in, c, state.o);
    Vec3l toward{};
    for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t i = 0; i < 3; ++i)
            toward[k] += std::int64_t(in.placement.a[3 * i + k]) * state.normal[i];
    state.normal = unit_vector(toward);
    set_view(in, state);
}

std::array<std::uint32_t, 3> surf(const PassIn& in, const Config& c, ShadeState& state) {
    const Surface& s = in.surface;
    const bool is_sphere = c.spheres && s.kind == PrimKind::sphere,
               is_plane = c.planes && s.kind == PrimKind::plane;
    const int b = c.origin_bits;
    Vec3l toward{};   // the normal before normalisation
    state.is_far = state.is_lost = 0;
    bool ends = false;
    if (is_sphere) {
        ray_at(in, c, state.o);
        for (std::size_t k = 0; k < 3; ++k) state.n[k] = state.o[k] - (std::int64_t(s.a[k]) << b);
        toward = state.n;
    } else {
        const int fine = is_plane ? 0 : int(s.fine);
        const FineWeights p = fine_weights(in.hit, is_plane, b + fine, c);
        state.n = edges_cross(s);
        state.is_lost = ends = p.ends;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::int64_t e1 = std::int64_t(s.b[k]) - s.a[k], e2 = std::int64_t(s.c[k]) - s.a[k];
            state.is_lost |= saturate((std::int64_t(s.a[k]) << b) + ((p.u * e1 + p.v * e2) >> fine),
                                      c.point_width(), state.o[k]);
            state.is_far |= c.planes && std::abs(state.o[k]) > lattice_end(c);
            toward[k] = c.smooth && s.smooth ? ((std::int64_t(1) << (b + fine)) - p.u - p.v) * s.normal[k] +
                                                   p.u * s.normal[3 + k] + p.v * s.normal[6 + k]
                                             : state.n[k];
        }
    }
    state.is_far |= state.is_lost;
    for (std::size_t k = 0; k < 3; ++k) {
        if (in.hit.back) state.n[k] = -state.n[k], toward[k] = -toward[k];
    }
    state.normal = unit_vector(toward);
    set_view(in, state);
    state.albedo = albedo_of(s, is_plane, in.hit, ends, c);
    state.self = in.hit.prim;
    state.is_inside = in.hit.back;
    state.diffuse = s.diffuse, state.highlight = s.highlight, state.mirror = s.mirror,
    state.transmit = s.transmit;
    state.shine = s.shine, state.schlick = s.schlick, state.r0 = s.r0;
    state.ratio = in.hit.back ? s.leave : s.enter;

    if (c.has_textures()) {
        state.ambient = s.ambient, state.record = s.record;
        state.is_round = c.spheres && s.kind == PrimKind::sphere;
        state.path = path_to(in, state, c);
        if (s.record != 0) return {};   // the texture event adds it
    }
    return ambient_light(state, s.ambient);
}

std::array<std::uint32_t, 3> ambient_light(const ShadeState& state, std::uint32_t share) {
    std::array<std::uint32_t, 3> ambient{};
    for (std::size_t k = 0; k < 3; ++k)
        ambient[k] =
            std::uint32_t(rounded(std::uint64_t(state.weight) * share * state.albedo[k], 2 * share_bits));
    return ambient;
}

std::array<std::uint32_t, 2> octahedral(const ShadeState& state, const Config& c) {
    std::array<std::int64_t, 3> n{};
    std::int64_t sum = 1;
    for (std::size_t k = 0; k < 3; ++k) {
        n[k] = state.is_inside ? -state.normal[k] : state.normal[k];
        sum += std::abs(n[k]);
    }
    const std::int64_t half = std::int64_t(1) << (c.bary_bits - 1);
    std::int64_t p = half * std::abs(n[0]) / sum, q = half * std::abs(n[2]) / sum;
    if (n[1] < 0) {
        p = half - p, q = half - q;
        std::swap(p, q);
    }
    return {std::uint32_t(n[0] < 0 ? half - p : half + p), std::uint32_t(n[2] < 0 ? half - q : half + q)};
}

std::array<std::uint32_t, 3> apply_texture(const std::array<std::uint32_t, 3>& texel, ShadeState& state) {
    for (std::size_t k = 0; k < 3; ++k) state.albedo[k] = rounded(state.albedo[k] * texel[k], share_bits);
    return ambient_light(state, state.ambient);
}

namespace {

/// Returns the approximate length of a vector.
std::uint64_t length_of(Vec3l v) {
    for (auto& x : v) x = std::abs(x);
    std::ranges::sort(v);
    return std::uint64_t(v[2] + (v[1] >> 2) + (v[1] >> 3) + (v[0] >> 2) + (v[0] >> 4));
}

}   // namespace

std::uint32_t path_to(const PassIn& in, const ShadeState& state, const Config& c) {
    const bool is_far = c.planes && in.surface.kind == PrimKind::plane && in.hit.t == (1u << c.t_bits()) - 1;
    std::uint64_t length = 0;
    if (is_far) {
        Vec3l way{};
        for (std::size_t k = 0; k < 3; ++k) way[k] = state.o[k] - in.o[k];
        length = length_of(way) << c.t_frac_bits >> c.origin_bits;
    } else {
        const std::uint64_t size = length_of({in.d[0], in.d[1], in.d[2]}) >> (c.dir_bits - 1 - length_bits);
        length = size * in.hit.t >> length_bits;
    }
    return std::uint32_t(
        std::min<std::uint64_t>(in.state.path + length, (std::uint64_t(1) << c.path_bits()) - 1));
}

}   // namespace rayclock

// With two levels: a surface's point and normal are transformed to the scene's space, and rays begin in the
// instance that they leave.
#include "model/base/axes.hpp"
#include "model/scene/placed.hpp"
#include "sim/judge/paths/path.hpp"

namespace rayclock {

/// Judges the transformation of a surface from the mesh's space to the scene's. The exact point becomes
/// `inner`, and the point of the ray at t replaces it. The transpose of the stored map transforms the normal.
/// Nothing else changes.
///
/// The unit normal has an error of vector_error before, so the transformed one has this error times the map's
/// size. The directions of x and x + e differ by at most |e| / (|x| - |e| / 2). Normalising adds
/// vector_error.
void PathJudge::transform(const PassIn& in, const PassOut& out) {
    const ShadeState& before = in.state;
    const ShadeState& s = out.state;
    demand(out.leave == (place_.texture ? PassOut::Leave::texture : PassOut::Leave::again),
           "a surface that is turned sends a ray, or does not request its texture");
    const auto demand_next = [&] { place_.texture ? demand_texture(s, out) : demand_lights(s); };
    if (visit_.place == oracle::PlacedRay::nowhere) return fail("nothing was hit that could be turned");
    demand(rules_.placed->is_map_of(visit_.place, in.placement),
           "memory does not hold the instance that was hit");
    demand(in.o == bounce_ray_.o && in.d == bounce_ray_.d,
           "a pass was given another ray than the one that arrived");
    ShadeState same = before;
    same.o = s.o, same.inner = s.inner, same.normal = s.normal, same.view = s.view, same.cosine = s.cosine;
    same.next_event = s.next_event, same.light = s.light, same.pending = s.pending, same.colour = s.colour;
    demand(same == s, "what was found on the surface is not kept when it is turned");
    demand(s.inner == before.o, "the point in the mesh is not kept");
    if (!is_turned()) {
        demand(s.o == before.o && s.normal == before.normal && s.view == before.view &&
                   s.cosine == before.cosine,
               "a surface is turned where nothing is");
        return demand_next();
    }
    const Vec3i point = point_at(in);
    for (std::size_t k = 0; k < 3; ++k)
        demand(s.o[k] == point[k], "a secondary ray's origin is not the point that was hit");

    const std::array<std::int64_t, 9>& a = rules_.placed->solids().places()[visit_.place].a;
    glm::dvec3 exact(0);
    Vec3l turned{};
    double size = 0;
    for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t i = 0; i < 3; ++i) {
            turned[k] += a[3 * i + k] * before.normal[i];
            exact[int(k)] += double(a[3 * i + k]) * place_.normal[int(i)];
            size += double(a[3 * i + k]) * double(a[3 * i + k]);
        }
    const double off = std::sqrt(size) * vector_error, length = glm::length(exact);
    place_.normal_error = std::min(2.0, off < length ? off / (length - off / 2) + vector_error : 2.0);
    judge_vectors(in, s, turned);
    place_.normal = unit_or_zero(exact);
    demand_next();
}

/// Returns a ray from the point along d in the space of the point's instance. It begins exactly at the point.
Home PathJudge::home_of(const ShadeState& s, const Vec3i& d) const {
    Home home;
    if (visit_.place == oracle::PlacedRay::nowhere) return home;
    // Line 0: the ray is the same in the instance.
    home.line = is_turned() ? rules_.placed->line(visit_.place) : 0;
    home.o = by_axis([&](std::size_t k) { return std::int32_t(s.inner[k]); });
    home.d = oracle::placed_direction(rules_.placed->solids().places()[visit_.place], d, config_.map_frac());
    return home;
}

/// Returns a shadow ray in the instance's space: from the lattice point nearest to the light, exactly to the
/// point.
Home PathJudge::home_from(const ShadeState& s, const Vec3i& light) const {
    Home home;
    if (visit_.place == oracle::PlacedRay::nowhere) return home;
    const int frac = config_.origin_bits;
    const Vec3i whole = by_axis([&](std::size_t k) { return light[k] >> frac; });
    const Vec3i moved =
        oracle::placed_point(rules_.placed->solids().places()[visit_.place], whole, 0, config_.map_frac());
    home.line = is_turned() ? rules_.placed->line(visit_.place) : 0;
    home.o = by_axis([&](std::size_t k) { return moved[k] * (1 << frac); });
    home.d = by_axis([&](std::size_t k) { return std::int32_t(s.inner[k] - home.o[k]); });
    return home;
}

}   // namespace rayclock

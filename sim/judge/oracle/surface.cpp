// Exact hits of single triangles, and the searches through the tree.
#include "sim/judge/oracle/surface.hpp"

namespace rayclock::oracle {

namespace {

std::vector<Extent> extents(const std::vector<Corners>& triangles) {
    std::vector<Extent> boxes;
    boxes.reserve(triangles.size());
    for (const Corners& t : triangles) boxes.push_back(extent(t));
    return boxes;
}

}   // namespace

std::vector<Corners> snapped(const Scene& scene, const Lattice& lattice) {
    std::vector<Corners> triangles;
    triangles.reserve(scene.triangles.size());
    const auto corner = [&](const Triangle& t, std::size_t k) {
        return lattice.snap(scene.vertices[t.vertex[k]]);
    };
    for (const Triangle& t : scene.triangles) triangles.push_back({corner(t, 0), corner(t, 1), corner(t, 2)});
    return triangles;
}

ExactHit exact_hit(const Vec3i& o, const Vec3i& d, const Corners& triangle, std::uint32_t primitive) {
    const auto at = cross<Int128, std::int64_t>(o, d, triangle);
    return at ? ExactHit{primitive, at->num, at->den, at->sense} : ExactHit{};
}

Surface::Surface(std::vector<Corners> triangles, int margin)
    : triangles_(std::move(triangles)), tree_(extents(triangles_), margin) {
    ordered_.reserve(triangles_.size());
    for (const std::uint32_t i : tree_.order()) ordered_.push_back(triangles_[i]);
}

Extent Surface::bounds() const {
    Extent all = triangles_.empty() ? Extent{} : extent(triangles_[0]);
    for (const Corners& t : triangles_)
        for (const Vec3i& p : {t.a, t.b, t.c}) all.add(p);
    return all;
}

ExactHit Surface::closest(const Vec3i& o, const Vec3i& d) const {
    ExactHit best;
    const tree::Ray ray(o, d);
    const auto main_size = std::int64_t(ray.main_size());
    const auto after = [&](double near) {
        return best.primitive != no_primitive &&
               Int128(std::int64_t(near)) * best.den > 2 * best.num * main_size;
    };
    tree_.nearest_first(ray, after, [&](std::uint32_t place) {
        const ExactHit hit = exact_hit(o, d, ordered_[place], tree_.order()[place]);
        if (hit.primitive != no_primitive && hit.before(best)) best = hit;
    });
    return best;
}

void Surface::candidates(const Vec3i& o, const Vec3i& d, std::vector<std::uint32_t>& found) const {
    found.clear();
    tree_.all(tree::Ray(o, d), [&](std::uint32_t place) { found.push_back(tree_.order()[place]); });
}

}   // namespace rayclock::oracle

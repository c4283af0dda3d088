// The smallest enclosing globe by pivoting.
#include "model/engine/spheres/enclose.hpp"

#include <cmath>

#include <glm/geometric.hpp>

namespace rayclock::spheres {

namespace {

/// Bounds the error of all doubles below, since coordinates are below 2^21.
constexpr double rounding = 1.0 / (1 << 20);
constexpr double sheared_step = 1.7321;   ///< a lattice step on each axis
constexpr double most_of_least = 1.0 / 1024;
constexpr int max_pivots = 100;

using Points = std::vector<glm::dvec3>;

/// Finds the least globe with 1 to 4 points on it: the circumcentre in their affine hull. Returns false if
/// they are dependent, or if the centre is not in their convex hull; then a subset suffices.
bool on_all(const glm::dvec3* p, int n, Globe& out) {
    glm::dvec3 q[3];
    for (int i = 1; i < n; ++i) q[i - 1] = p[i] - p[0];
    // Solve sum of l[j] (2 q[i] . q[j]) = q[i] . q[i] by Gauss, with pivots on the diagonal.
    double a[3][4], l[3] = {0, 0, 0};
    const int m = n - 1;
    for (int i = 0; i < m; ++i) {
        for (int j = 0; j < m; ++j) a[i][j] = 2 * glm::dot(q[i], q[j]);
        a[i][m] = glm::dot(q[i], q[i]);
    }
    for (int i = 0; i < m; ++i) {
        if (!(std::abs(a[i][i]) > 1e-9 * 2 * glm::dot(q[i], q[i]))) return false;
        for (int r = i + 1; r < m; ++r) {
            const double f = a[r][i] / a[i][i];
            for (int j = i; j <= m; ++j) a[r][j] -= f * a[i][j];
        }
    }
    double first = 1;
    for (int i = m; i-- > 0;) {
        l[i] = a[i][m];
        for (int j = i + 1; j < m; ++j) l[i] -= a[i][j] * l[j];
        l[i] /= a[i][i];
        if (!(l[i] >= 0)) return false;
        first -= l[i];
    }
    if (!(first >= 0)) return false;
    out.centre = p[0];
    for (int i = 0; i < m; ++i) out.centre += l[i] * q[i];
    out.radius = glm::length(out.centre - p[0]);
    return true;
}

/// Returns the least globe around at most 5 points, and reduces `points` to those on it.
Globe of_few(Points& points) {
    Globe best;
    best.radius = HUGE_VAL;
    Points support;
    for (unsigned set = 1; set < 1u << points.size(); ++set) {
        glm::dvec3 chosen[4];
        int n = 0;
        bool few = true;
        for (std::size_t i = 0; i < points.size() && few; ++i) {
            if (!(set >> i & 1)) continue;
            few = n < 4;
            if (few) chosen[n++] = points[i];
        }
        Globe globe;
        if (!few || !on_all(chosen, n, globe) || globe.radius >= best.radius) continue;
        bool all = true;
        for (const glm::dvec3& p : points)
            all = all && glm::length(p - globe.centre) <= globe.radius * (1 + 1e-12) + 1e-9;
        if (!all) continue;
        best = globe;
        support.assign(chosen, chosen + n);
    }
    points = std::move(support);
    return best;
}

struct Farthest {
    double distance = -1;
    glm::dvec3 point{};
};
Farthest farthest_bead(std::span<const Bead> beads, const glm::dvec3& from) {
    Farthest most;
    double square = -1;
    for (const Bead& bead : beads) {
        const glm::dvec3 way = bead.centre - from;
        const double far = glm::dot(way, way);
        if (bead.radius == 0 && far <= square) continue;
        const double length = std::sqrt(far), distance = length + bead.radius;
        if (distance <= most.distance) continue;
        const glm::dvec3 on = length > 0 ? way / length : glm::dvec3(1, 0, 0);
        most = {distance, from + on * distance};
        square = distance * distance;
    }
    return most;
}

}   // namespace

void add_beads(const PrimData& prim, const Config& config, std::vector<Bead>& out) {
    const auto point = [](const Vec3i& p) { return glm::dvec3(p[0], p[1], p[2]); };
    switch (prim.kind) {
        case PrimKind::sphere:
            out.push_back({point(prim.a), std::sqrt(double(radius_squared(prim, config.coord_bits)))});
            return;
        case PrimKind::plane:
            for (int i = 0; i < 8; ++i) {
                const double far = double(1 << (config.coord_bits - 1));
                out.push_back({{i & 1 ? far : -far, i & 2 ? far : -far, i & 4 ? far : -far}, 0});
            }
            return;
        default:
            for (const Vec3i& corner : {prim.a, prim.b, prim.c})
                out.push_back({point(corner), config.is_sheared() ? sheared_step : 0});
    }
}

Globe enclose(std::span<const Bead> beads) {
    Points support{farthest_bead(beads, beads[0].centre).point};
    Globe globe{support[0], 0};
    if (beads.size() == 1) globe.centre = beads[0].centre;
    Globe least{globe.centre, HUGE_VAL};
    for (int i = 0; i < max_pivots; ++i) {
        const Farthest most = farthest_bead(beads, globe.centre);
        if (most.distance < least.radius) least = {globe.centre, most.distance};
        if (beads.size() == 1 || most.distance <= globe.radius * (1 + 1e-9)) break;
        const Points before = support;
        support.push_back(most.point);
        globe = of_few(support);
        // Stop on rounding, or on a sphere whose points converge.
        if (std::isinf(globe.radius) || support == before ||
            least.radius <= globe.radius * (1 + 0.1 * most_of_least))
            break;
    }
    least.radius += rounding;
    return least;
}

}   // namespace rayclock::spheres

// Computes instance maps, their boxes, and the bounds on a hit's error.
#include "model/compile/levels/fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "model/unit/shade/bounce/bounce.hpp"

namespace rayclock {
namespace {

// If a mesh has more corners than this, the box of a moving instance is not exact.
constexpr std::size_t max_exact = 64;

/// Extents of the class's corners along a row of the stored map's inverse: of all corners, or of solids
/// around them.
struct Extent {
    double lo = 0, hi = 0;
};
Extent extent_of(const MeshClass& made, const glm::dvec3& row, const glm::dvec3& moved) {
    const glm::dvec3 scaled = row / made.lattice.pitch;
    const double middle = glm::dot(scaled, made.reach.middle) - glm::dot(row, moved),
                 reach = made.reach.along(scaled);
    return {middle - reach, middle + reach};
}
Extent exact_extent(const MeshClass& made, const glm::dvec3& row, const glm::dvec3& moved) {
    constexpr double far = std::numeric_limits<double>::infinity();
    Extent extent{far, -far};
    for (const Vec3i& point : made.points) {
        const glm::dvec3 from = glm::dvec3(point[0], point[1], point[2]) - moved;
        const double along = row[0] * from[0] + row[1] * from[1] + row[2] * from[2];
        extent = {std::min(extent.lo, along), std::max(extent.hi, along)};
    }
    return extent;
}

/// Returns the largest distance of a hit from its own triangles, over all rays of a chip that shades, bounce
/// after bounce (docs/machine/motion.md, Secondary rays). A ray that leaves the instance again starts
/// slightly farther off its triangle than the ray that met it.
double off_of_secondary(const MeshClass& made, bool is_whole, double stretch, const Config& config) {
    const double frac = std::ldexp(1, -config.origin_bits), slope = is_whole ? 0 : 0.5,
                 camera = std::ldexp(1, config.dir_bits - 2),
                 bounce = config.refraction ? shortest_held(config) : 0.57 * camera;
    const auto reach = [&](double begin, double shortest) {   // S, for a ray that begins this far off
        return (2 * largest_of(config) + 2 + stretch * (1.25 + begin)) / (shortest - slope * stretch);
    };
    const double anew = std::ldexp(1, -config.t_frac_bits) + frac + 1.25 + 2.5 * frac * made.longest;
    double off = frac + slope * reach(frac, camera);
    for (int bounces = 0; bounces <= config.bounces; ++bounces) {
        const double begin = off + anew;
        off = begin + slope * reach(begin, bounce);
    }
    return off;
}

/// Sets the box of the mesh's corners as the stored map places them, enlarged by the error of a hit around
/// each. A triangle lies within its corners' box, and so do its points, each with that error around it.
void place_box(const MeshClass& made, const glm::dmat3& linear, const glm::dvec3& moved, const Config& config,
               bool by_reach, FittedMap& fitted) {
    const double largest = largest_of(config);
    InstanceMap& map = fitted.map;
    const glm::dmat3 back = glm::inverse(linear);
    glm::dvec3 reach(0);   // of a step in the mesh
    for (int i = 0; i < 3; ++i) reach[i] = std::abs(back[0][i]) + std::abs(back[1][i]) + std::abs(back[2][i]);
    const double stretch = std::max({reach.x, reach.y, reach.z});   // alpha
    // The smallest value of a direction's largest component.
    const double shortest = std::ldexp(1, config.dir_bits - 2);
    fitted.stretched = !(stretch <= max_stretch);
    if (fitted.stretched) return;
    const double last = (2 * largest + 1.25 * stretch + 1) / (shortest - stretch / 2);
    map.off = map.is_whole ? 0 : 0.5 + 0.5 * last;
    if (config.shading && !map.is_same) map.off = off_of_secondary(made, map.is_whole, stretch, config);
    const double slack = map.is_whole && !by_reach ? 0 : 1.0 / 64;   // covers the double arithmetic here
    for (int i = 0; i < 3; ++i) {
        const glm::dvec3 row(back[0][i], back[1][i], back[2][i]);
        const Extent extent = by_reach ? extent_of(made, row, moved) : exact_extent(made, row, moved);
        const double least = std::floor(extent.lo - reach[i] * map.off - slack),
                     most = std::ceil(extent.hi + reach[i] * map.off + slack);
        fitted.beyond = std::max({fitted.beyond, -largest - least, most - largest});
        map.box.lo[std::size_t(i)] = std::int32_t(least);
        map.box.hi[std::size_t(i)] = std::int32_t(most);
    }
}

}   // namespace

LatticeInMesh lattice_in_mesh(const glm::dmat4& place, const Lattice& lattice) {
    const glm::dmat3 back = glm::inverse(glm::dmat3(place));
    LatticeInMesh seen;
    seen.middle = back * (lattice.centre - glm::dvec3(place[3]));
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) {
            seen.row[std::size_t(i)][k] = back[k][i] * lattice.pitch[k];
            seen.step[i] += std::abs(seen.row[std::size_t(i)][k]);
        }
    return seen;
}

double CornerReach::along(const glm::dvec3& d) const {
    const glm::dvec3 size = glm::abs(d);
    double least = std::min(glm::dot(size, half), ball * std::sqrt(glm::dot(d, d)));
    for (int k = 0; k < 3; ++k) {
        const double y = d[(k + 1) % 3], z = d[(k + 2) % 3];
        least = std::min(least, size[k] * half[k] + disc[k] * std::sqrt(y * y + z * z));
    }
    return least;
}

CornerReach reach_of(const MeshClass& made) {
    CornerReach reach;
    if (made.points.empty()) return reach;
    const auto at = [&](const Vec3i& p) { return glm::dvec3(p[0], p[1], p[2]) * made.lattice.pitch; };
    glm::dvec3 lo = at(made.points[0]), hi = lo;
    for (const Vec3i& point : made.points) lo = glm::min(lo, at(point)), hi = glm::max(hi, at(point));
    reach.middle = 0.5 * (lo + hi);
    reach.half = glm::max(hi - reach.middle, reach.middle - lo);
    for (const Vec3i& point : made.points) {
        const glm::dvec3 from = at(point) - reach.middle;
        reach.ball = std::max(reach.ball, std::sqrt(glm::dot(from, from)));
        for (int k = 0; k < 3; ++k) {
            const double y = from[(k + 1) % 3], z = from[(k + 2) % 3];
            reach.disc[k] = std::max(reach.disc[k], std::sqrt(y * y + z * z));
        }
    }
    return reach;
}

FittedMap fit(const LatticeInMesh& seen, const MeshClass& made, const Config& config, bool by_reach) {
    const int frac = config.map_frac();
    const std::int64_t one = std::int64_t(1) << frac;
    FittedMap fitted;
    InstanceMap& map = fitted.map;
    map.is_whole = map.is_same = true;
    glm::dmat3 linear;   // as stored
    glm::dvec3 moved;
    for (std::size_t i = 0; i < 3; ++i) {
        const double unit = std::ldexp(1, frac) / made.lattice.pitch[int(i)];
        std::array<double, 3> exact;
        std::int64_t sum = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            exact[k] = seen.row[i][int(k)] * unit;
            sum += std::abs(std::llround(exact[k]));
        }
        for (std::size_t k = 0; k < 3; ++k) {
            const double entry = sum > one ? std::trunc(exact[k]) : std::round(exact[k]);
            map.a[3 * i + k] = std::int32_t(entry);
            linear[int(k)][int(i)] = std::ldexp(entry, -frac);
            map.is_whole = map.is_whole && map.a[3 * i + k] % one == 0;
            map.is_same = map.is_same && map.a[3 * i + k] == (i == k) * one;
        }
        map.b[i] = std::llround((seen.middle[int(i)] - made.lattice.centre[int(i)]) * unit);
        moved[int(i)] = std::ldexp(double(map.b[i]), -frac);
        map.is_whole = map.is_whole && map.b[i] % one == 0;
        map.is_same = map.is_same && map.b[i] == 0;
    }
    place_box(made, linear, moved, config, by_reach && (made.deforms || made.points.size() > max_exact),
              fitted);
    return fitted;
}

}   // namespace rayclock

#pragma once
// Ties: decisions that doubles leave open, because a slightly moved ray gives another result.
#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "sim/judge/reference/ray.hpp"

namespace rayclock {

/// The relative size of such a move. It is larger than the 2^-36 by which the tracer moves a ray off its
/// surface, and larger than all rounding of doubles. It is far smaller than a step of any lattice.
constexpr double tie_size = 0x1p-34;
/// Twice the relative size of the tracer's move off a surface, which also covers the rounding of doubles.
constexpr double off_surface_size = 0x1p-35;

inline glm::dvec3 across(const glm::dvec3& d) {
    const glm::dvec3 size = glm::abs(d);
    const glm::dvec3 axis = size.x <= size.y && size.x <= size.z ? glm::dvec3(1, 0, 0)
                            : size.y <= size.z                   ? glm::dvec3(0, 1, 0)
                                                                 : glm::dvec3(0, 0, 1);
    return glm::normalize(glm::cross(d, axis));
}

/// Returns how far the point where a ray meets a sphere moves along the ray, if the ray moves sideways by up
/// to `off`. `to_centre`: from the ray's origin to the centre. `direction`: a unit vector. The half chord h
/// satisfies h^2 = r^2 - a^2, where a is the distance of the ray from the centre, so |a'^2 - a^2| <= (2 r +
/// off) off. A ray that grazes the sphere has a small h, and its point moves much farther than the ray.
inline double graze_error(const glm::dvec3& to_centre, const glm::dvec3& direction, double radius,
                          double off) {
    const glm::dvec3 aside = to_centre - glm::dot(to_centre, direction) * direction;
    const double square = std::max(0.0, radius * radius - glm::dot(aside, aside)),
                 change = (2 * radius + off) * off;
    return std::sqrt(square + change) - std::sqrt(std::max(0.0, square - change)) + off;
}

/// Turns and moves the path slightly in sixteen ways, and calls try_path(path) until one call returns true.
template <class Try> bool any_moved(const RefPath& path, const Try& try_path) {
    const glm::dvec3 right = across(path.direction), up = glm::cross(path.direction, right);
    const double size =
        tie_size * (1 + std::max({std::abs(path.from.x), std::abs(path.from.y), std::abs(path.from.z)}));
    for (int i = 0; i < 16; ++i) {
        const double angle = (0.5 + i) * 0.39269908169872414;   // an eighth of a turn, for two turns
        const glm::dvec3 off = std::cos(angle) * right + std::sin(angle) * up;
        RefPath moved = path;
        if (i < 8)
            moved.direction = glm::normalize(path.direction + tie_size * off);
        else
            moved.from += size * off + (i % 2 ? size : -size) * path.direction;
        if (try_path(moved)) return true;
    }
    return false;
}

}   // namespace rayclock

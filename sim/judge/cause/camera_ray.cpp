#include "sim/judge/cause/camera_ray.hpp"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

#include "sim/judge/paths/steps.hpp"

namespace rayclock {

namespace {

double largest(const glm::dvec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

}   // namespace

bool goes_through(const Asked& asked, const PixelRays& rays, const glm::dvec3& given, const Vec3i& d) {
    const Frame& frame = asked.frame;
    const int bits = asked.config.dir_bits;
    const glm::dvec3 pitch = asked.lattice.pitch;
    const PixelRays steps{rays.eye, rays.corner / pitch, rays.right / pitch, rays.down / pitch};
    double most = std::max(largest(steps.right), largest(steps.down));
    for (const double x : {-0.5, frame.width - 0.5})
        for (const double y : {-0.5, frame.height - 0.5})
            most = std::max(most, largest(steps.direction(x, y)));
    // All directions of the map end in one plane.
    const glm::dvec3 plane = glm::cross(steps.right, steps.down);
    glm::dvec3 v = given / pitch;
    v *= glm::dot(plane, steps.corner) / glm::dot(plane, v);

    const double sides = double(frame.width) + frame.height, end = std::exp2(bits - 1),
                 scale = (std::ldexp(end - 1, guard_bits) - 0.5 * sides - 1.5) / most,
                 sum = scale * largest(v) - 0.5 * sides;
    const glm::dvec3 machine = vector_of(d);
    if (!(sum > 0) || largest(machine) < std::exp2(bits - 2) - 1) return false;
    const double once = largest(machine) >= end - 1 ? 1 : 0.5,
                 error = once + 0.5 * sides * std::min(end / sum, std::exp2(most_shift - guard_bits));
    const double sine = glm::length(glm::cross(unit_of(machine), unit_of(v)));
    return glm::dot(machine, v) > 0 &&
           sine <= std::sqrt(3.0) * error / glm::length(machine) * (1 + Range::slack) + Range::slack;
}

}   // namespace rayclock

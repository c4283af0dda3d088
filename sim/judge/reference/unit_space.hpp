#pragma once
// The scaled space in which the reference tracer works.
#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include "model/scene/scene.hpp"

namespace rayclock {

/// The reference tracer's own space, in which everything that bounds() covers lies within -1..1. The factor
/// is a power of two, so scaling is exact. So float boxes are as tight for a tiny scene, or one far from the
/// origin, as for any other.
struct RefUnitSpace {
    glm::dvec3 centre{0};
    double scale = 1;

    explicit RefUnitSpace(const Scene& scene) {
        if (primitive_count(scene) == 0) return;
        const Bounds box = bounds(scene);
        centre = box.lo + 0.5 * (box.hi - box.lo);
        const glm::dvec3 half = glm::max(box.hi - centre, centre - box.lo);
        const double side = std::max(half.x, std::max(half.y, half.z));
        if (side > 0) scale = std::ldexp(1.0, -std::ilogb(side) - 1);
    }

    glm::dvec3 operator()(const glm::dvec3& p) const { return (p - centre) * scale; }
};

}   // namespace rayclock

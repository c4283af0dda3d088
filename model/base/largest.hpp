#pragma once
// The size of a vector by its largest component.
#include <algorithm>
#include <cmath>

#include <glm/vec3.hpp>

namespace rayclock {

inline double largest(const glm::dvec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

}   // namespace rayclock

#pragma once
#include <cstdint>
#include <vector>

#include "model/scene/scene.hpp"

namespace rayclock {

// Of primitives that are the same set of points the machine holds the one with the lowest number, since equal
// distances go to the lower number. In rounded reals their distances need not be equal. So the tracer keeps
// the first of them only: triangles with the same three corners, in whatever order, spheres with the same
// centre and radius (and an inside that is seen, or not), planes with the same point and sides. Each function
// gives the numbers of those that are kept, counted among the primitives of their kind, in rising order.

std::vector<std::uint32_t> distinct_triangles(const Scene& scene);
std::vector<std::uint32_t> distinct_spheres(const Scene& scene);
std::vector<std::uint32_t> distinct_planes(const Scene& scene);

}   // namespace rayclock

#pragma once
// Primitives that are the same set of points. The machine reports the one with the lowest number, since equal
// distances go to the lower number. In rounded reals their distances need not be equal, so the reference
// tracer keeps only the first of them.
//
// Triangles are equal if they have the same three corners in any order. Spheres are equal if they have the
// same centre and radius and an inside that is either visible or not. Planes are equal if they have the same
// point and sides. Each function returns the numbers that are kept, counted among the primitives of their
// kind, in rising order.
#include <cstdint>
#include <vector>

#include "model/scene/scene.hpp"

namespace rayclock {

std::vector<std::uint32_t> distinct_triangles(const Scene& scene);
std::vector<std::uint32_t> distinct_spheres(const Scene& scene);
std::vector<std::uint32_t> distinct_planes(const Scene& scene);

}   // namespace rayclock

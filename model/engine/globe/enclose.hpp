#pragma once
// The least globe (bounding sphere) around primitives on the lattice.
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "model/core/payloads.hpp"

namespace rayclock {

struct Globe {
    glm::dvec3 centre{};
    double radius = 0;   ///< no point of what it encloses is farther from the centre, whatever was rounded
};

/// Corners of triangles, and spheres as their centres and radii.
struct Bead {
    glm::dvec3 centre{};
    double radius = 0;
};
/// Adds those of a primitive. A plane, which is everywhere, counts as the lattice's corners. Where the test
/// may take a ray that passes a triangle within a step (sheared), its corners have that radius.
void add_beads(const PrimData& prim, const Config& config, std::vector<Bead>& out);

/// Pivoting as in Gaertner 1999, "Fast and robust smallest enclosing balls": the globe of a few beads, to
/// which the one that lies farthest outside is added until none is. Of corners it is the least globe but for
/// rounding. The points of a sphere that matter are found one by one, so that with spheres it is larger by at
/// most 2^-10.
Globe enclose(std::span<const Bead> beads);

}   // namespace rayclock

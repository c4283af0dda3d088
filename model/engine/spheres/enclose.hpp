#pragma once
// The smallest globe (bounding sphere) around primitives on the lattice.
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "model/core/payloads.hpp"

namespace rayclock::spheres {

struct Globe {
    glm::dvec3 centre{};
    double radius = 0;   ///< rounded up, so that no enclosed point is farther from the centre
};

/// A corner of a triangle, or a sphere as its centre and radius.
struct Bead {
    glm::dvec3 centre{};
    double radius = 0;
};
/// Appends the beads of a primitive. An infinite plane counts as the lattice's corners. The sheared test may
/// hit a triangle within a step of a ray, so its corners have that radius.
void add_beads(const PrimData& prim, const Config& config, std::vector<Bead>& out);

/// Returns the smallest globe around the beads, by pivoting as in Gaertner 1999, "Fast and robust smallest
/// enclosing balls". It starts with the globe of a few beads and adds the bead farthest outside until no bead
/// is outside. Around corners the globe is minimal except for rounding. The relevant points of a sphere are
/// found one by one, so with spheres the globe is larger by at most 2^-10.
Globe enclose(std::span<const Bead> beads);

}   // namespace rayclock::spheres

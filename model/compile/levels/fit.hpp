#pragma once
// One instance on the lattice of its class: its map, and the box of what it places.
#include <glm/vec3.hpp>

#include "model/compile/levels/maps.hpp"

namespace rayclock {

/// The scene's lattice seen from a mesh: its middle, and for each axis of the mesh what a step along each of
/// the scene's axes is there.
struct Seen {
    glm::dvec3 middle{0};
    std::array<glm::dvec3, 3> row{};
    glm::dvec3 step{0};   ///< of each row, the sum of sizes: how far one step along all axes reaches
};

Seen seen_from(const glm::dmat4& place, const Lattice& lattice);

/// L, the largest coordinate.
inline double largest_of(const Config& config) { return double((1 << (config.coord_bits - 1)) - 1); }

/// A map, by how many steps its box reaches beyond what a node can say, and whether it would be too coarse.
struct Fitted {
    InstanceMap map;
    double beyond = 0;
    bool stretched = false;
};

/// `by_reach`: the box is that of the solids around the corners, because the instance moves or there are
/// many.
Fitted fit(const Seen& seen, const MeshClass& made, const Config& config, bool by_reach);

/// Of the class's corners.
CornerReach reach_of(const MeshClass& made);

}   // namespace rayclock

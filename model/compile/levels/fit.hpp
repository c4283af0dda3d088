#pragma once
// Fits one instance to the lattice of its class: its map, and the box of its contents.
#include <glm/vec3.hpp>

#include "model/compile/levels/maps.hpp"

namespace rayclock {

/// The scene's lattice seen from a mesh: its middle, and for each axis of the mesh the components of a step
/// along each of the scene's axes.
struct LatticeInMesh {
    glm::dvec3 middle{0};
    std::array<glm::dvec3, 3> row{};
    glm::dvec3 step{0};   ///< for each row the sum of absolute values: the reach of one step along all axes
};

LatticeInMesh lattice_in_mesh(const glm::dmat4& place, const Lattice& lattice);

/// Returns L, the largest coordinate.
inline double largest_of(const Config& config) { return double((1 << (config.coord_bits - 1)) - 1); }

/// A map, the number of steps by which its box reaches beyond the range of a node, and whether the map is too
/// coarse.
struct FittedMap {
    InstanceMap map;
    double beyond = 0;
    bool stretched = false;
};

/// Returns the map of an instance. With `by_reach` its box bounds the solids around the corners, because the
/// instance moves or has many corners.
FittedMap fit(const LatticeInMesh& seen, const MeshClass& made, const Config& config, bool by_reach);

/// Returns the solids around the class's corners.
CornerReach reach_of(const MeshClass& made);

}   // namespace rayclock

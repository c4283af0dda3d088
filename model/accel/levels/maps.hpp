#pragma once
// The lattices of a scene of instances, and their maps: docs/motion.md has the rules and the proofs.
#include <vector>

#include "model/accel/memory_image.hpp"
#include "model/accel/tree.hpp"
#include "model/scene/placed.hpp"

namespace rayclock {

/// Meshes that are placed; the first is the scene's own triangles, if it has any.
struct LevelParts {
    std::vector<const SharedMesh*> meshes;
    std::vector<Instance> instances;   ///< in the order of their primitives' numbers; `mesh` is of `meshes`
};

/// Instances of one mesh that share a lattice, and so a lower structure: none sees the scene's lattice more
/// than twice as large as another on any axis. Or one that no map could place well: it is written out, its
/// mesh moved to its place beforehand, and its map is the identity.
struct MeshClass {
    std::uint32_t mesh = 0;
    glm::dmat4 before{1};   ///< the identity, or the place of what is written out
    Lattice lattice;
    std::vector<glm::dvec3> corners;   ///< of a chip that shades: the mesh's, as aligned() moves them
    std::vector<Vec3i> points;         ///< its corners on the lattice, each once
    std::int32_t longest = 0;          ///< component of an edge, in steps
};

struct InstanceMap {
    std::uint32_t mesh_class = 0;
    std::array<std::int32_t, 9> a{};   ///< as in Placement
    Vec3l b{};
    bool is_whole = false;   ///< nothing is rounded by it: axes swapped, mirrored and moved by whole steps
    double off = 0;          ///< rho: how far, in the mesh's steps, a hit's point may lie off its triangle
    LatticeBox box;          ///< on the scene's lattice: holds every point of a ray that hits the instance
};

struct LevelMaps {
    Lattice lattice;
    std::vector<MeshClass> classes;
    std::vector<InstanceMap> instances;
};

/// Of the mesh's corner `index`, in the class.
Vec3i snapped_corner(const MeshClass& made, const SharedMesh& mesh, std::uint32_t index);

/// More than this many of the scene's steps for one of the mesh's, and an instance is written out: a map that
/// turns, moves and scales alike has 24 at most.
constexpr double most_stretch = 32;

LevelMaps map_instances(const LevelParts& parts, const glm::dvec3& eye, const Config& config);

}   // namespace rayclock

#pragma once
// The lattices of a scene of instances, and their maps. docs/machine/motion.md has the rules and the proofs.
#include <optional>
#include <span>
#include <vector>

#include "model/layout/memory_image.hpp"
#include "model/layout/tree.hpp"
#include "model/scene/placed.hpp"

namespace rayclock {

/// Meshes and their instances. The first mesh is the scene's own triangles, if it has any. The scene's
/// spheres and planes, if any, are the last mesh, which has no triangles.
struct LevelParts {
    std::vector<const SharedMesh*> meshes;
    /// In the order of their primitives' numbers. `mesh` is an index of `meshes`.
    std::vector<Instance> instances;
    /// By mesh: its bounds at all times, if it deforms. Empty if none does.
    std::vector<std::optional<Bounds>> deforming{};
    const Scene* round = nullptr;   ///< the scene, if it has spheres or planes
    std::vector<Texture> textures{};

    const Bounds* deforms(std::uint32_t mesh) const {
        return mesh < deforming.size() && deforming[mesh] ? &*deforming[mesh] : nullptr;
    }
    bool is_round(std::uint32_t mesh) const { return round && mesh + 1 == meshes.size(); }
    std::size_t count(std::uint32_t mesh) const {
        return is_round(mesh) ? round->spheres.size() + round->planes.size() : meshes[mesh]->triangles.size();
    }
};

/// Solids that hold all corners of a class and have a cheap extent along any direction: a box, a ball, and
/// three discs as thick as the box. Units are lattice steps times the pitches, about `middle`.
struct CornerReach {
    glm::dvec3 middle{0}, half{0}, disc{0};   ///< disc: the radius about each axis
    double ball = 0;

    /// Returns a bound on a corner's distance from the middle along a direction, times the direction's
    /// length.
    double along(const glm::dvec3& direction) const;
};

/// Instances of one mesh that share a lattice, and therefore a lower structure. No member sees the scene's
/// lattice more than twice as large as another on any axis. If corner normals count, all members stretch them
/// by the same amount, to 2^-12 of a length. A class may instead be one instance that no map could place
/// well. That instance is written out: its mesh is moved to its place beforehand, and its map is the
/// identity.
struct MeshClass {
    std::uint32_t mesh = 0;
    glm::dmat4 before{1};   ///< the identity, or the place of a written-out instance
    Lattice lattice;
    /// The mesh's corners after align_large_triangles(), for a chip that shades.
    std::vector<glm::dvec3> corners;
    std::vector<Vec3i> points;   ///< its corners on the lattice, each once
    std::int32_t longest = 0;    ///< longest component of an edge, in steps
    CornerReach reach;           ///< of `points`
    bool deforms = false;        ///< fields that depend on the mesh's corners belong to one frame
    /// The members' stretch of normals, up to a rotation and a factor: the cofactors of the first member's
    /// place.
    glm::dmat3 normal_map{1};
};

struct InstanceMap {
    std::uint32_t mesh_class = 0;
    std::array<std::int32_t, 9> a{};   ///< as in Placement
    Vec3l b{};
    bool is_whole = false;   ///< nothing is rounded: axes are swapped, mirrored and moved by whole steps
    bool is_same = false;    ///< the identity
    double off = 0;   ///< rho: largest distance of a hit's point from its triangle, in the mesh's steps
    LatticeBox box;   ///< on the scene's lattice; holds every point of a ray that hits the instance
};

struct LevelMaps {
    Lattice lattice;
    std::vector<MeshClass> classes;
    std::vector<InstanceMap> instances;
};

/// Sets the fields of a class that depend on its mesh's current corners.
void take_shape(MeshClass& made, const SharedMesh& mesh, const Config& config);

/// Returns the primitives of a mesh that count on a class's lattice, numbered within the mesh.
std::vector<PrimData> snapped(const LevelParts& parts, const MeshClass& made, const Config& config);

/// Returns the mesh's corner `index` on the class's lattice.
Vec3i snapped_corner(const MeshClass& made, const SharedMesh& mesh, std::uint32_t index);

/// The most steps of the scene per step of the mesh; beyond that, an instance is written out. A map that
/// rotates, moves and scales uniformly has at most 24.
constexpr double max_stretch = 32;

/// Returns the lattices and maps of a scene that does not move.
LevelMaps map_instances(const LevelParts& parts, const glm::dvec3& eye, const Config& config);

/// The places of all instances of LevelParts at one time.
using InstancePlaces = std::vector<glm::dmat4>;

/// Returns lattices and classes that serve all times of an animation, given the places and the eye at each.
/// Boxes are those of the first time. The first eye is a lattice point. The result is empty if a moving
/// instance would have to be written out.
std::optional<LevelMaps> map_moving(const LevelParts& parts, std::span<const InstancePlaces> times,
                                    std::span<const glm::dvec3> eyes, const Config& config);

/// Returns the map of an instance of a class at its place at one of these times.
InstanceMap map_at(const glm::dmat4& place, std::uint32_t mesh_class, const LevelMaps& maps,
                   const Config& config);

}   // namespace rayclock

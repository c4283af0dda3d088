#pragma once
// The lattices of a scene of instances, and their maps: docs/motion.md has the rules and the proofs.
#include <optional>
#include <span>
#include <vector>

#include "model/layout/memory_image.hpp"
#include "model/layout/tree.hpp"
#include "model/scene/placed.hpp"

namespace rayclock {

/// Meshes that are placed; the first is the scene's own triangles, if it has any. If it has spheres or
/// planes, these are the last, a mesh without triangles.
struct LevelParts {
    std::vector<const SharedMesh*> meshes;
    std::vector<Instance> instances;   ///< in the order of their primitives' numbers; `mesh` is of `meshes`
    /// By mesh: its bounds at all times, if it deforms. Empty if none does.
    std::vector<std::optional<Bounds>> deforming{};
    const Scene* round = nullptr;   ///< the scene, if it has spheres or planes

    const Bounds* deforms(std::uint32_t mesh) const {
        return mesh < deforming.size() && deforming[mesh] ? &*deforming[mesh] : nullptr;
    }
    bool is_round(std::uint32_t mesh) const { return round && mesh + 1 == meshes.size(); }
    std::size_t count(std::uint32_t mesh) const {
        return is_round(mesh) ? round->spheres.size() + round->planes.size() : meshes[mesh]->triangles.size();
    }
};

/// Solids that hold all corners of a class, whose extent along any direction is soon told: a box, a ball, and
/// three discs as thick as the box. In steps of the lattice times its pitches, about `middle`.
struct CornerReach {
    glm::dvec3 middle{0}, half{0}, disc{0};   ///< disc: the radius about each axis
    double ball = 0;

    /// The most that a corner lies from the middle along a direction, times its length.
    double along(const glm::dvec3& direction) const;
};

/// Instances of one mesh that share a lattice, and so a lower structure: none sees the scene's lattice more
/// than twice as large as another on any axis. If corner normals count, all members stretch them alike, to
/// 2^-12 of a length. Or one that no map could place well: it is written out, its
/// mesh moved to its place beforehand, and its map is the identity.
struct MeshClass {
    std::uint32_t mesh = 0;
    glm::dmat4 before{1};   ///< the identity, or the place of what is written out
    Lattice lattice;
    std::vector<glm::dvec3> corners;   ///< of a chip that shades: the mesh's, as aligned() moves them
    std::vector<Vec3i> points;         ///< its corners on the lattice, each once
    std::int32_t longest = 0;          ///< component of an edge, in steps
    CornerReach reach;                 ///< of points
    bool deforms = false;              ///< what depends on the mesh's corners is of one frame
    /// How its members stretch normals, up to a rotation and a factor: the cofactors of the first one's
    /// place.
    glm::dmat3 normal_map{1};
};

struct InstanceMap {
    std::uint32_t mesh_class = 0;
    std::array<std::int32_t, 9> a{};   ///< as in Placement
    Vec3l b{};
    bool is_whole = false;   ///< nothing is rounded by it: axes swapped, mirrored and moved by whole steps
    bool is_same = false;    ///< the identity
    double off = 0;          ///< rho: how far, in the mesh's steps, a hit's point may lie off its triangle
    LatticeBox box;          ///< on the scene's lattice: holds every point of a ray that hits the instance
};

struct LevelMaps {
    Lattice lattice;
    std::vector<MeshClass> classes;
    std::vector<InstanceMap> instances;
};

/// Gives a class what depends on its mesh's corners, as they are now.
void take_shape(MeshClass& made, const SharedMesh& mesh, const Config& config);

/// Primitives of a mesh on a class's lattice, numbered within the mesh, as far as they count.
std::vector<PrimData> snapped(const LevelParts& parts, const MeshClass& made, const Config& config);

/// Of the mesh's corner `index`, in the class.
Vec3i snapped_corner(const MeshClass& made, const SharedMesh& mesh, std::uint32_t index);

/// More than this many of the scene's steps for one of the mesh's, and an instance is written out: a map that
/// turns, moves and scales alike has 24 at most.
constexpr double most_stretch = 32;

LevelMaps map_instances(const LevelParts& parts, const glm::dvec3& eye, const Config& config);

/// Where all instances of LevelParts stand at one time.
using Places = std::vector<glm::dmat4>;

/// Lattices and classes that serve all of an animation's times: places and eyes of each. Boxes are those of
/// the first time. Nothing if an instance that moves would have to be written out. The first eye is a lattice
/// point.
std::optional<LevelMaps> map_moving(const LevelParts& parts, std::span<const Places> times,
                                    std::span<const glm::dvec3> eyes, const Config& config);

/// The map of an instance of a class where it stands at one of these times.
InstanceMap map_at(const glm::dmat4& place, std::uint32_t mesh_class, const LevelMaps& maps,
                   const Config& config);

}   // namespace rayclock

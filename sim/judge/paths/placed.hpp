#pragma once
// What a machine of two levels must have been given: every mesh on the lattice that the host has chosen for
// it, every instance in its place.
//
// Shared with the host are those lattices, and the maps as memory holds them. A map is judged: each of its
// numbers must be the one that docs/motion.md states for the instance's place, which is in the scene.
// Corners, normals and materials are made from the scene. Memory must contain each
// instance that is not empty exactly once.
#include <string>
#include <unordered_map>
#include <vector>

#include "sim/judge/oracle/placed.hpp"
#include "model/scene/placed.hpp"
#include "sim/judge/paths/world.hpp"

namespace rayclock {

class PlacedWorld {
public:
    /// `asked.scene` is flat, with `placed`, or folded. A scene without `placed` is one mesh of its own.
    PlacedWorld(const Asked& asked, const MemoryImage& image);

    const oracle::PlacedSolids& solids() const { return *solids_; }
    /// What is wrong with the maps in memory, a sentence each.
    const std::vector<std::string>& faults() const { return faults_; }

    std::uint32_t place_of(std::uint32_t primitive) const { return solids_->place_of(primitive); }
    /// Line of an instance in memory.
    std::uint32_t line(std::uint32_t place) const { return instances_[place].line; }
    /// The instance in a line; `nowhere` if there is none.
    std::uint32_t place_at(std::uint32_t line) const;
    bool is_mirrored(std::uint32_t place) const { return instances_[place].is_mirrored; }
    /// A ray is there what it is in the scene: the map is the identity.
    bool is_same(std::uint32_t place) const { return instances_[place].is_same; }
    /// The ray, as the instances see it.
    oracle::PlacedRay ray(const Ray& ray) const;
    const Material& material(std::uint32_t primitive) const;
    Surface surface(std::uint32_t primitive) const;
    bool holds_normals(std::uint32_t primitive, const Surface& seen) const;
    const Plane& plane(std::uint32_t primitive) const;
    bool is_map_of(std::uint32_t place, const Placement& placement) const;
    /// Shared meshes on their lattices, in steps, where the maps in memory put them, in steps of the scene's
    /// lattice: what is left of the reference's world when only corners and maps are rounded.
    PlacedScene snapped() const;

private:
    /// A mesh on the lattice of a class: its unit is a step. Spheres and planes are as they are in the scene.
    struct Made {
        Scene scene;
        std::vector<oracle::Solid> solids;
        bool is_within = true;   ///< the lattice, with all corners
        bool is_near = true;     ///< each corner to the scene's: corner_bounds()
    };
    struct Placed {
        std::string name;
        std::uint32_t mesh = 0, mesh_class = 0, first = 0, line = 0;
        glm::dmat4 place{1};
        std::optional<std::uint32_t> material;
        bool is_mirrored = false;   ///< its map mirrors: b and c of the mesh stand the other way round
        bool is_same = false;
        std::vector<Placement> found;
    };

    void list_instances(const PlacedScene& scene, const LevelLattices& lattices);
    /// `first`: the place of the first instance of the class.
    Made make(const PlacedScene& scene, const SharedMesh& mesh, const LevelLattices::Class& of,
              const glm::dmat4& first) const;
    Made make_round(const PlacedScene& scene) const;
    void read_maps(const MemoryImage& image);
    void judge_map(const Placed& placed, const LevelLattices::Class& of, const Placement& map);

    const Asked& asked_;
    const Config& config_;
    std::vector<Made> classes_;
    std::vector<Placed> instances_;
    std::unordered_map<std::uint32_t, std::uint32_t> of_line_;   ///< instances
    std::optional<oracle::PlacedSolids> solids_;
    std::vector<std::string> faults_;
};

}   // namespace rayclock

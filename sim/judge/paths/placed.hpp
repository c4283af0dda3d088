#pragma once
// The correct inputs of a machine of two levels: every mesh on the lattice that the host chose for it, and
// every instance in its place.
//
// The judge takes these lattices, and the maps in memory, from the host. It judges the maps: each number must
// be the one that docs/machine/motion.md states for the instance's place in the scene. It computes corners,
// normals and materials from the scene. Memory must contain each instance that is not empty exactly once.
#include <string>
#include <unordered_map>
#include <vector>

#include "model/scene/placed.hpp"
#include "sim/judge/oracle/placed.hpp"
#include "sim/judge/paths/texture.hpp"
#include "sim/judge/paths/world.hpp"

namespace rayclock {

class PlacedWorld {
public:
    /// `asked.scene` is flat, has `placed`, or is folded. A scene without `placed` is a single mesh.
    PlacedWorld(const FrameInputs& inputs, const MemoryImage& image);

    const oracle::PlacedSolids& solids() const { return *solids_; }
    /// Returns the faults of the maps in memory, a sentence each.
    const std::vector<std::string>& faults() const { return faults_; }

    std::uint32_t place_of(std::uint32_t primitive) const { return solids_->place_of(primitive); }
    /// Returns the line of an instance in memory.
    std::uint32_t line(std::uint32_t place) const { return instances_[place].line; }
    /// Returns the instance in a line; `nowhere` if there is none.
    std::uint32_t place_at(std::uint32_t line) const;
    bool is_mirrored(std::uint32_t place) const { return instances_[place].is_mirrored; }
    /// True if the instance's map is the identity.
    bool is_same(std::uint32_t place) const { return instances_[place].is_same; }
    /// Returns the ray in the space of each instance.
    oracle::PlacedRay ray(const Ray& ray) const;
    const Material& material(std::uint32_t primitive) const;
    Surface surface(std::uint32_t primitive) const;
    bool holds_normals(std::uint32_t primitive, const Surface& seen) const;
    /// Returns the primitive in its mesh, if it shows a texture. An instance's own material has none.
    std::optional<TexturedSurface> textured(std::uint32_t primitive) const;
    /// True if the primitive is a triangle whose texture may have holes.
    bool may_have_holes(std::uint32_t primitive) const;
    const Plane& plane(std::uint32_t primitive) const;
    bool is_map_of(std::uint32_t place, const Placement& placement) const;
    /// Returns the scene with rounded corners and maps, and no other error. The meshes are in steps of their
    /// lattices, and the maps in memory place them in steps of the scene's lattice.
    PlacedScene snapped() const;

private:
    /// A mesh on the lattice of a class, in lattice steps. Spheres and planes are those of the scene.
    struct Made {
        Scene scene;
        std::vector<oracle::Solid> solids;
        bool is_within = true;   ///< all corners lie within the lattice
        bool is_near = true;     ///< no corner is farther off than corner_bounds()
    };
    struct Placed {
        std::string name;
        std::uint32_t mesh = 0, mesh_class = 0, first = 0, line = 0;
        glm::dmat4 place{1};
        std::optional<std::uint32_t> material;
        bool is_mirrored = false;   ///< its map mirrors, so b and c of each triangle are exchanged
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

    const FrameInputs& inputs_;
    const Config& config_;
    std::vector<Made> classes_;
    std::vector<Placed> instances_;
    std::unordered_map<std::uint32_t, std::uint32_t> of_line_;   ///< instance by line
    std::optional<oracle::PlacedSolids> solids_;
    std::vector<std::string> faults_;
};

}   // namespace rayclock

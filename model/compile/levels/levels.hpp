#pragma once
// Scene compilation in two levels: a tree over instances, and below it one for each mesh and class.
#include <functional>

#include "model/compile/levels/upper.hpp"

namespace rayclock {

struct LevelsImage {
    MemoryImage image;   ///< line 0 is the root of the scene's tree; the lattice is the scene's
    LevelMaps maps;
    std::vector<std::uint32_t> roots;      ///< by class: line of its root, 0 if nothing is left of it
    std::vector<UpperEntry> entries;       ///< of the scene's tree: their maps are of `maps`
    std::vector<std::uint32_t> of_entry;   ///< by entry: its instance, in the order of `maps`
    std::uint32_t upper_lines = 0;   ///< of a scene that moves: how many lines each of its trees may take
    /// By class, of a mesh that deforms: how many lines each of its trees may take, one tree for each buffer;
    /// of others 0.
    std::vector<std::uint32_t> rooms;
    std::vector<std::uint32_t> surfaces;   ///< by class: line of its first surface, if the chip shades
};

/// The configuration with levels=2. Throws UserError if no machine can be both.
Config with_two_levels(Config config, const std::string& where);

/// For that configuration. Throws UserError as it does, for a scene with true spheres or planes, and as
/// compile_scene() does.
/// The image is not copied: entries point into it.
LevelsImage compile_levels(const PlacedScene& scene, const glm::dvec3& eye, const Config& config);

// ---- The parts of it, which scenes that move use as well.

/// The scene's own triangles as a mesh.
SharedMesh own_mesh(const PlacedScene& scene);
/// What is placed; `own` must stay, and so must the scene. Instances of empty meshes are left out.
LevelParts parts_of(const PlacedScene& scene, const SharedMesh& own);
/// Where these stand now.
Places places_of(const PlacedScene& scene);
/// Throws UserError for what two levels cannot hold.
void check_levels(const PlacedScene& scene, const Config& config, const std::string& name);
/// Throws UserError if the machine cannot keep so many groups of siblings.
void check_need(int need, const Config& config, const std::string& name);
/// The triangles of a mesh on a class's lattice, numbered within the mesh: those that count, or all of a mesh
/// that deforms, because one that has no area now may have some in another frame.
std::vector<PrimData> snapped_triangles(const SharedMesh& mesh, const MeshClass& made, const Config& config);
/// Their surfaces, as a scene whose unit is a step of the lattice.
Scene class_surfaces(const SharedMesh& mesh, const MeshClass& made, const std::vector<Material>& materials);
/// The most lines that the scene's tree over these entries will take.
using UpperRoom = std::function<std::uint32_t(const std::vector<UpperEntry>&)>;
/// The image of `out.maps`: `buffers` trees of the scene's level, of which the first is written, then the
/// lower structures. 0 buffers: one tree, and no line too many; otherwise each has `room`.
void compile_parts(const LevelParts& parts, const std::vector<Material>& materials, const Config& config,
                   const std::string& name, int buffers, const UpperRoom& room, LevelsImage& out);

}   // namespace rayclock

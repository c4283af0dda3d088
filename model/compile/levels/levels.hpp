#pragma once
// Scene compilation in two levels: a tree over instances, and below it one tree for each mesh and class.
#include <functional>

#include "model/compile/levels/upper.hpp"
#include "model/compile/textures.hpp"

namespace rayclock {

/// The result of a compilation. It is not copied, because entries point into it.
struct LevelsImage {
    MemoryImage image;   ///< line 0 is the root of the scene's tree; the lattice is the scene's
    LevelMaps maps;
    std::vector<std::uint32_t> roots;      ///< by class: line of its root, 0 if nothing of it is left
    std::vector<UpperEntry> entries;       ///< of the scene's tree; their maps point into `maps`
    std::vector<std::uint32_t> of_entry;   ///< by entry: number of its instance, in the order of `maps`
    std::uint32_t upper_lines = 0;         ///< of a scene that moves: most lines of each of its trees
    /// By class: most lines of each tree of a mesh that deforms, with one tree per buffer. 0 for other
    /// meshes.
    std::vector<std::uint32_t> rooms;
    /// One copy of a class's surfaces and texture records, if the chip shades. A mesh that deforms has a copy
    /// for each buffer. Other meshes have one copy.
    struct Surfaces {
        std::uint32_t first = 0;              ///< line of the first surface
        std::vector<std::uint32_t> records;   ///< the result of write_records()
    };
    std::vector<std::vector<Surfaces>> surfaces;   ///< by class and buffer
    TextureLines textures;
};

/// Returns the configuration with levels=2. Throws UserError if that combination is not allowed.
Config with_two_levels(Config config, const std::string& where);

/// Compiles the scene for with_two_levels(config). Throws UserError as with_two_levels(), check_levels() and
/// compile_scene() do.
LevelsImage compile_levels(const PlacedScene& scene, const glm::dvec3& eye, const Config& config);

// ---- Its parts, which scenes that move also use.

/// Returns the scene's own triangles as a mesh.
SharedMesh own_mesh(const PlacedScene& scene);
/// Returns the placed meshes. It refers to `own` and the scene, which must outlive it. Instances of empty
/// meshes are left out.
LevelParts parts_of(const PlacedScene& scene, const SharedMesh& own);
/// Returns the current places of its instances.
InstancePlaces places_of(const PlacedScene& scene);
/// Throws UserError if the scene needs a unit that the configuration lacks, is empty, or needs longer
/// primitive numbers.
void check_levels(const PlacedScene& scene, const Config& config, const std::string& name);
/// Throws UserError if the machine cannot keep `need` groups of siblings.
void check_need(int need, const Config& config, const std::string& name);
/// Returns the triangles of a mesh on a class's lattice, numbered within the mesh. These are the ones that
/// count. For a mesh that deforms they are all, because one without area now may have area in another frame.
std::vector<PrimData> snapped_triangles(const SharedMesh& mesh, const MeshClass& made, const Config& config);
/// Returns their surfaces, as a scene whose unit is a lattice step.
Scene class_surfaces(const SharedMesh& mesh, const MeshClass& made, const std::vector<Material>& materials);
/// Returns the most lines of the scene's tree over these entries.
using UpperRoom = std::function<std::uint32_t(const std::vector<UpperEntry>&)>;
/// Writes the image of `out.maps`: `buffers` trees of the scene's level, with only the first one filled, then
/// the lower structures. 0 buffers give one tree without spare lines; otherwise each tree has `room`.
void compile_parts(const LevelParts& parts, const std::vector<Material>& materials, const Config& config,
                   const std::string& name, int buffers, const UpperRoom& room, LevelsImage& out);

}   // namespace rayclock

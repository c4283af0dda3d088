#pragma once
// A scene of instances that move, in two levels: lower structures that stay where they are, or follow meshes
// that deform, and the scene's tree, made anew for every frame.
#include <memory>
#include <span>

#include "model/compile/levels/levels.hpp"
#include "model/compile/refit/refit.hpp"
#include "model/compile/upload.hpp"

namespace rayclock {

/// By mesh of a PlacedScene: its bounds at all times, if it deforms.
using ShapeBounds = std::vector<std::optional<Bounds>>;

class MovingLevels {
public:
    /// For frames at these times, in this order: where instances stand (places_of()) and the eye. With two
    /// buffers the scene's tree of a frame lies elsewhere than that of the frame before, which can be drawn
    /// while it is written. Null if an instance that moves is sheared or flattened so much that its mesh
    /// would have to be written out, and if meshes deform that are not held by boxes, which alone are
    /// refitted, or that planes cut above, since it is not known what lines their scene's trees will take.
    /// Throws UserError as compile_levels() does. `shapes`: by mesh of the scene, the bounds at these times
    /// if it deforms.
    static std::unique_ptr<MovingLevels> make(const PlacedScene& scene, std::span<const Places> times,
                                              std::span<const glm::dvec3> eyes, int buffers,
                                              const Config& config, const ShapeBounds& shapes = {});

    /// The memory as the frame that was made last finds it. What no frame writes is there from the beginning:
    /// all but the scene's trees and what follows meshes that deform.
    const MemoryImage& image() const { return levels_.image; }
    std::uint32_t root() const { return root_; }   ///< of that frame
    const LevelsImage& levels() const { return levels_; }

    /// The next frame: what the host writes for it.
    Upload next(const Places& places);
    /// The same where meshes deform: the scene is the one that this was made of, as it is now. A lower
    /// structure is refitted, and built anew above `rebuild` times its cost (Refit).
    Upload next(const PlacedScene& scene, double rebuild = usual_rebuild);

private:
    /// A lower structure that follows its mesh. All of it is there once for each buffer.
    struct Follower {
        std::uint32_t mesh_class = 0, mesh = 0, triangles = 0;   ///< mesh: of the scene
        Refit tree;
        std::array<std::uint32_t, 2> written{};   ///< by buffer: lines from its root on that the memory has
    };
    /// Lines that a frame may write.
    struct Region {
        std::uint32_t first = 0, lines = 0;
        bool is_new = false;                 ///< the memory may hold anything there
        Follower* follower = nullptr;        ///< whose tree lies there, if it follows a mesh
        std::vector<std::uint32_t> held{};   ///< the words before
    };

    MovingLevels(const PlacedScene& scene, LevelMaps maps, std::span<const Places> times, int buffers,
                 const Config& config, const ShapeBounds& shapes);
    std::uint32_t room(const std::vector<UpperEntry>& entries, std::span<const Places> times);
    void follow(const PlacedScene& scene, double rebuild, std::size_t buffer, Upload& upload);
    void draw(Follower& follower, const SharedMesh& mesh, const std::vector<Material>& materials,
              std::size_t buffer);
    void hold(std::size_t buffer);
    void take_region(const Region& region, std::size_t buffer, Upload& upload) const;
    Upload next(const Places& places, const PlacedScene* scene, double rebuild);

    Config config_;
    std::string name_;
    LevelsImage levels_;
    Places last_;   // of the maps as they are
    std::size_t frame_ = 0;
    int buffers_;
    std::uint32_t root_ = 0;
    std::vector<Follower> followers_;
    std::vector<Region> regions_;   // of the frame, rising
    std::vector<PlacedEntry> placed_;
    std::array<bool, 2> is_read_{};   // since the last reset, by buffer
};

}   // namespace rayclock

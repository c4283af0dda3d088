#pragma once
// A scene of moving instances in two levels. Lower structures stay where they are, or follow meshes that
// deform. The scene's tree is rebuilt for every frame.
#include <memory>
#include <span>

#include "model/compile/levels/levels.hpp"
#include "model/compile/refit/refit.hpp"
#include "model/compile/upload.hpp"

namespace rayclock {

/// By mesh of a PlacedScene: its bounds at all times, if it deforms.
using ShapeBounds = std::vector<std::optional<Bounds>>;

/// Keeps the memory of such a scene, frame by frame.
class MovingLevels {
public:
    /// Prepares frames at these times, in this order: the places of the instances (places_of()) and the eye.
    /// `shapes` gives, by mesh of the scene, the bounds at these times if it deforms. With two buffers
    /// consecutive frames keep the scene's tree in different lines, so the host can write one while the chip
    /// draws the other.
    ///
    /// Returns null if a moving instance is sheared or flattened so much that its mesh would have to be
    /// written out. With deforming meshes it also returns null if their lower structure is not boxes without
    /// splits: only these are refitted. The same holds if planes cut the upper level, since the lines of its
    /// trees are then unknown. Throws UserError as compile_levels() does.
    static std::unique_ptr<MovingLevels> make(const PlacedScene& scene, std::span<const InstancePlaces> times,
                                              std::span<const glm::dvec3> eyes, int buffers,
                                              const Config& config, const ShapeBounds& shapes = {});

    /// Returns the memory as the last frame finds it. Lines that no frame writes are there from the
    /// beginning: everything except the scene's trees, and the trees, surfaces and texture records of
    /// deforming meshes.
    const MemoryImage& image() const { return levels_.image; }
    std::uint32_t root() const { return root_; }   ///< of that frame
    const LevelsImage& levels() const { return levels_; }

    /// Makes the next frame, and returns what the host writes for it.
    Upload next(const InstancePlaces& places);
    /// Does the same with deforming meshes. `scene` is the scene of make() in its current shape. A lower
    /// structure is refitted, and rebuilt if its cost exceeds `rebuild` times the cost when it was built
    /// (Refit).
    Upload next(const PlacedScene& scene, double rebuild = usual_rebuild);

private:
    /// A lower structure that follows its mesh. Each buffer has a full copy.
    struct Follower {
        std::uint32_t mesh_class = 0, mesh = 0, triangles = 0;   ///< mesh: index in the scene
        Refit tree;
        std::array<std::uint32_t, 2> written{};   ///< by buffer: lines from its root on that the memory holds
    };
    /// Lines that a frame may write.
    struct Region {
        std::uint32_t first = 0, lines = 0;
        bool is_new = false;                 ///< the memory may hold anything there
        Follower* follower = nullptr;        ///< owner of the tree there, if it follows a mesh
        std::vector<std::uint32_t> held{};   ///< the words before this frame
    };

    MovingLevels(const PlacedScene& scene, LevelMaps maps, std::span<const InstancePlaces> times, int buffers,
                 const Config& config, const ShapeBounds& shapes);
    std::uint32_t room(const std::vector<UpperEntry>& entries, std::span<const InstancePlaces> times);
    void follow(const PlacedScene& scene, double rebuild, std::size_t buffer, Upload& upload);
    void draw(Follower& follower, const SharedMesh& mesh, const Scene& own, std::size_t buffer);
    void hold(std::size_t buffer);
    void take_region(const Region& region, std::size_t buffer, Upload& upload) const;
    Upload next(const InstancePlaces& places, const PlacedScene* scene, double rebuild);

    Config config_;
    std::string name_;
    LevelsImage levels_;
    InstancePlaces last_;   // places of the current maps
    std::size_t frame_ = 0;
    int buffers_;
    std::uint32_t root_ = 0;
    std::vector<Follower> followers_;
    std::vector<Region> regions_;   // of the frame, rising
    std::vector<PlacedEntry> placed_;
    std::array<bool, 2> is_read_{};   // by buffer, since the last reset
};

}   // namespace rayclock

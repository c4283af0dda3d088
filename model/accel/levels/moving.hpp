#pragma once
// A scene of instances that move, in two levels: lower structures that stay where they are, and the scene's
// tree, made anew for every frame.
#include <memory>
#include <span>

#include "model/accel/levels/levels.hpp"
#include "model/upload.hpp"

namespace rayclock {

class MovingLevels {
public:
    /// For frames at these times, in this order: where instances stand (places_of()) and the eye. With two
    /// buffers the scene's tree of a frame lies elsewhere than that of the frame before, which can be drawn
    /// while it is written. Null if an instance that moves is sheared or flattened so much that its mesh
    /// would have to be written out, and if planes cut the scene: then no bound of the tree's lines is known.
    /// Throws UserError as compile_levels() does.
    static std::unique_ptr<MovingLevels> make(const PlacedScene& scene, std::span<const Places> times,
                                              std::span<const glm::dvec3> eyes, int buffers,
                                              const Config& config);

    /// The memory as the frame that was made last finds it. Of the first frame, all but the scene's trees is
    /// there from the beginning.
    const MemoryImage& image() const { return levels_.image; }
    std::uint32_t root() const { return root_; }   ///< of that frame
    const LevelsImage& levels() const { return levels_; }

    /// The next frame: what the host writes for it.
    Upload next(const Places& places);

private:
    MovingLevels(const PlacedScene& scene, LevelMaps maps, int buffers, const Config& config);
    void take_changes(std::uint32_t first, Upload& upload);

    Config config_;
    std::string name_;
    LevelsImage levels_;
    Places last_;   // of the maps as they are
    std::size_t frame_ = 0;
    int buffers_;
    std::uint32_t root_ = 0;
    std::vector<std::uint32_t> held_;   // the tree's lines before
    std::vector<PlacedEntry> placed_;
    std::array<bool, 2> is_read_{};   // since the last reset, by buffer
};

}   // namespace rayclock

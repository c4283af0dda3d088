#pragma once
// A film of one level with meshes that deform: one lattice for all frames, and a tree that is refitted.
#include <span>
#include <string>

#include "model/compile/refit/refit.hpp"
#include "model/compile/upload.hpp"

namespace rayclock {

class RefittedScene {
public:
    /// `scene` as it is in any frame; `bounds` of its triangles in all frames, and the eye of each. The first
    /// eye is a lattice point. Throws UserError as compile_scene() does.
    RefittedScene(const Scene& scene, Bounds bounds, std::span<const glm::dvec3> eyes, double rebuild,
                  const Config& config);

    /// The next frame: what the host writes for it. The scene has the same primitives in every frame. Throws
    /// UserError as compile_scene() does.
    Upload next(const Scene& scene);

    /// The memory as the frame that was made last finds it.
    const MemoryImage& image() const { return image_; }

private:
    std::vector<PrimData> snapped(const Scene& scene) const;
    void take_changes(const std::vector<std::uint32_t>& held, Upload& upload);

    Config config_;
    std::string name_;
    double rebuild_;
    Refit tree_;
    std::uint32_t tree_lines_ = 0;   ///< room for any tree, so that surfaces stay where they are
    std::uint32_t written_ = 0;      ///< lines from the first on that the memory has of trees
    MemoryImage image_;
    std::size_t frame_ = 0;
};

}   // namespace rayclock

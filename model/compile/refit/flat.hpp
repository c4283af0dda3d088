#pragma once
// A film in one level with deforming meshes: one lattice for all frames, and a tree that is refitted.
#include <span>
#include <string>

#include "model/compile/refit/refit.hpp"
#include "model/compile/upload.hpp"
#include "model/scene/scene.hpp"

namespace rayclock {

class RefittedScene {
public:
    /// `scene`: in the shape of any frame. `bounds`: of its triangles over all frames. `eyes`: one for each
    /// frame; the first is a lattice point. Throws UserError as compile_scene() does.
    RefittedScene(const Scene& scene, Bounds bounds, std::span<const glm::dvec3> eyes, double rebuild,
                  const Config& config);

    /// Makes the next frame, and returns what the host writes for it. The scene must have the same primitives
    /// in every frame. Throws UserError as compile_scene() does.
    Upload next(const Scene& scene);

    /// Returns the memory as the last frame finds it.
    const MemoryImage& image() const { return image_; }

private:
    std::vector<PrimData> snapped(const Scene& scene) const;
    void take_changes(const std::vector<std::uint32_t>& held, Upload& upload);

    Config config_;
    std::string name_;
    double rebuild_;
    Refit tree_;
    std::uint32_t tree_lines_ = 0;   ///< room for any tree, so that the surfaces stay in place
    std::uint32_t written_ = 0;      ///< lines of trees, from the first on, that the memory holds
    MemoryImage image_;
    std::size_t frame_ = 0;
};

}   // namespace rayclock

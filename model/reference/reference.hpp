#pragma once
#include <memory>

#include "model/core/progress.hpp"
#include "model/scene/hit.hpp"
#include "model/scene/scene.hpp"

namespace rayclock {

/// The double-precision software tracer: the scene as given, its own BVH, a watertight triangle test.
/// It shares nothing with the fixed-point model but the scene and the camera's definition.
class Reference {
public:
    explicit Reference(const Scene& scene);
    ~Reference();
    Reference(Reference&&) noexcept;

    /// Closest hit with depth > 0 along eye + depth * unit(direction).
    Hit trace(const glm::dvec3& origin, const glm::dvec3& direction) const;

    /// Every primary ray of a frame; `threads` 0 means all cores. The result does not depend on it.
    HitFrame frame(const Camera& camera, FrameSize size, int threads = 0, const Progress& progress = {}) const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace rayclock

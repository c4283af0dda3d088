#pragma once
#include <functional>
#include <memory>

#include "model/base/progress.hpp"
#include "model/scene/hit.hpp"
#include "model/scene/scene.hpp"
#include "model/scene/whitted.hpp"

namespace rayclock {

/// A finished picture.
struct WhittedFrame {
    std::vector<glm::dvec3> pixels;   ///< linear RGB within 0..1, row by row from the top
    RayCounts rays;
    HitFrame hits;                           ///< of each pixel's first sample
    std::vector<std::uint64_t> signatures;   ///< of each pixel (PathSignature)
};

/// Sees every ray of a picture: where it begins, its unit direction, and how far it goes, in terms of the
/// scene. A ray that meets nothing has no end, HUGE_VAL; a shadow ray ends at the light, or at the nearest
/// thing before it. Several threads call it at once.
using RayWatch =
    std::function<void(const glm::dvec3& from, const glm::dvec3& direction, double reach, bool hits)>;

/// The double-precision software tracer: the scene as given, its own BVHs, a watertight triangle test.
/// It shares nothing with the fixed-point model but the scene and the camera's definition.
class Reference {
public:
    explicit Reference(const Scene& scene);
    ~Reference();
    Reference(Reference&&) noexcept;

    /// Closest hit with depth > 0 along eye + depth * unit(direction).
    Hit trace(const glm::dvec3& origin, const glm::dvec3& direction) const;

    /// Every primary ray of a frame; `threads` 0 means all cores. The result does not depend on it.
    HitFrame frame(const Camera& camera, FrameSize size, int threads = 0,
                   const Progress& progress = {}) const;

    /// The finished picture (model/scene/whitted.hpp). The scene that the tracer was made from must still be
    /// there, unchanged. Pixels and counts do not depend on `threads`.
    WhittedFrame whitted(const Camera& camera, FrameSize size, const Whitted& settings, int threads = 0,
                         const Progress& progress = {}, const RayWatch& watch = {}) const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}   // namespace rayclock

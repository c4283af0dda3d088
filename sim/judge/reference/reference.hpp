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

/// One pixel of a finished picture.
struct WhittedPixel {
    glm::dvec3 colour{0};
    Hit first;
    std::uint64_t signature = 0;
};

class RefGeometry;
class RefSteer;

/// A ray as a watcher sees it, in terms of the scene. `direction` is a unit vector. A ray that meets nothing
/// has no end, HUGE_VAL; a shadow ray ends at the light.
struct WatchedRay {
    glm::dvec3 from, direction;
    double reach = 0;
    bool hits = false;                     ///< a shadow ray: it is blocked
    std::vector<std::uint32_t> blockers;   ///< of a shadow ray: all primitives before the light, in no order
};

/// Sees every ray of a picture.
struct RayWatch {
    std::function<void(const WatchedRay&)> see;   ///< several threads call it at once; empty: nobody watches
    /// Other than in our pictures, what transmits is lit from its outside only, also where a ray meets it
    /// from the inside (Haines' rule 7 with the normal not turned to the side that the ray came from).
    bool lights_outside_of_glass = false;
};

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

    /// One pixel of the finished picture, by itself or led by `steer` (sim/judge/reference/steer.hpp).
    WhittedPixel pixel(const Camera& camera, FrameSize size, const Whitted& settings, std::uint32_t x,
                       std::uint32_t y, RefSteer* steer = nullptr) const;

    /// What the tracer has made of the scene; empty of a folded scene.
    const RefGeometry& geometry() const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}   // namespace rayclock

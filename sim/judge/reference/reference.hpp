#pragma once
// The reference tracer's interface: hits and finished pictures in double precision.
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

/// A ray in the scene's coordinates, as RayWatch reports it. `direction` is a unit vector. `reach` is the
/// distance to its end: HUGE_VAL if it hits nothing, and the distance to the light for a shadow ray.
struct WatchedRay {
    glm::dvec3 from, direction;
    double reach = 0;
    bool hits = false;   ///< a shadow ray: it is blocked
    /// Of a shadow ray: all primitives before the light, in arbitrary order.
    std::vector<std::uint32_t> blockers;
};

/// Observes every ray of a picture.
struct RayWatch {
    std::function<void(const WatchedRay&)> see;   ///< called from several threads at once; may be empty
    /// Lights transmitting surfaces only from outside, even where a ray hits them from inside. Rayclock's own
    /// pictures do not use this. It is Haines' rule 7 with a normal that is not turned to the side of the
    /// ray.
    bool lights_outside_of_glass = false;
};

/// The software tracer in double precision: it uses the scene as given, its own BVHs and a watertight
/// triangle test. It shares only the scene and the camera's definition with the fixed-point model.
class Reference {
public:
    explicit Reference(const Scene& scene);
    ~Reference();
    Reference(Reference&&) noexcept;

    /// Returns the closest hit with depth > 0 along origin + depth * unit(direction).
    Hit trace(const glm::dvec3& origin, const glm::dvec3& direction) const;

    /// Traces every primary ray of a frame. `threads` 0 means all cores; the result does not depend on it.
    /// Throws UserError if the size is wrong.
    HitFrame frame(const Camera& camera, FrameSize size, int threads = 0,
                   const Progress& progress = {}) const;

    /// Draws the finished picture (model/scene/whitted.hpp). The caller must keep the tracer's scene alive
    /// and unchanged. Pixels and counts do not depend on `threads`. Throws UserError for a folded scene.
    WhittedFrame whitted(const Camera& camera, FrameSize size, const Whitted& settings, int threads = 0,
                         const Progress& progress = {}, const RayWatch& watch = {}) const;

    /// Draws one pixel of the finished picture, either freely or guided by `steer`
    /// (sim/judge/reference/steer.hpp).
    WhittedPixel pixel(const Camera& camera, FrameSize size, const Whitted& settings, std::uint32_t x,
                       std::uint32_t y, RefSteer* steer = nullptr) const;

    /// Returns the tracer's form of the scene; empty for a folded scene.
    const RefGeometry& geometry() const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}   // namespace rayclock

#pragma once
// The finished picture of the reference tracer.
#include "sim/judge/reference/geometry.hpp"
#include "sim/judge/reference/reference.hpp"
#include "sim/judge/reference/steer.hpp"

namespace rayclock {

/// Converts a hit to the scene's units.
inline Hit ref_hit(const RefClosest& found, const RefUnitSpace& space) {
    if (found.primitive == no_primitive) return {};
    return {found.primitive, static_cast<float>(found.depth / space.scale), static_cast<float>(found.u),
            static_cast<float>(found.v)};
}

/// Implements Reference::whitted().
WhittedFrame ref_whitted(const RefGeometry& geometry, const Scene& scene, const Camera& camera,
                         FrameSize size, const Whitted& settings, int threads, const Progress& progress,
                         const RayWatch& watch = {});

/// Implements Reference::pixel().
WhittedPixel ref_pixel(const RefGeometry& geometry, const Scene& scene, const Camera& camera, FrameSize size,
                       const Whitted& settings, std::uint32_t x, std::uint32_t y, RefSteer* steer);

}   // namespace rayclock

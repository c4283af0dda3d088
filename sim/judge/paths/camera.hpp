#pragma once
// Exact directions of camera rays.
#include "model/core/payloads.hpp"
#include "model/scene/camera.hpp"
#include "model/scene/whitted.hpp"

namespace rayclock {

/// Returns the direction of a camera ray through a sample of the pixel, or through its middle. It follows
/// from the frame's registers by the rule in model/core/frame.hpp.
Vec3i exact_direction(const Frame& frame, const Config& config, const Whitted& settings, int x, int y,
                      int sample);

/// True if the answers are equal except for the side, which only a shading chip finds.
bool same_hit(const Closest& a, const Closest& b);

}   // namespace rayclock

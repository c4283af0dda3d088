#pragma once
#include "model/core/payloads.hpp"
#include "model/scene/camera.hpp"
#include "model/scene/whitted.hpp"

namespace rayclock {

/// Direction of a camera ray from the frame's registers, by the rule in model/core/frame.hpp. Of a sample of
/// the pixel, or of its middle.
Vec3i exact_direction(const Frame& frame, const Config& config, const Whitted& settings, int x, int y,
                      int sample);

/// Equal except for the context and the side.
bool same_answer(const Closest& a, const Closest& b);

}   // namespace rayclock

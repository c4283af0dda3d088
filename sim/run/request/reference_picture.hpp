#pragma once
// What the reference makes of a request.
#include "sim/judge/reference/reference.hpp"
#include "model/scene/hit_shading.hpp"
#include "sim/run/request/request.hpp"

namespace rayclock {

struct ReferencePicture {
    Picture picture;
    WhittedFrame frame;   ///< of camera rays alone: only its hits
    const HitFrame& hits() const { return frame.hits; }
};

/// The finished picture, or that of camera rays with their local light. The tracer sees the request's scene
/// and settings alone. Pixels do not depend on `threads`.
ReferencePicture reference_picture(const Request& request, const Camera& camera, FrameSize size, int threads,
                                   const Progress& progress = {});

}   // namespace rayclock

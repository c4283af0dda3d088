#pragma once
// The picture that the reference tracer draws for a request.
#include "model/scene/hit_shading.hpp"
#include "sim/judge/reference/reference.hpp"
#include "sim/run/request/request.hpp"

namespace rayclock {

struct ReferencePicture {
    Picture picture;
    WhittedFrame frame;   ///< for camera rays only its hits are set
    const HitFrame& hits() const { return frame.hits; }
};

/// Returns the finished picture, or a picture of camera rays with their local light. The tracer gets only the
/// scene and the settings of the request. Pixels do not depend on `threads`.
ReferencePicture reference_picture(const Request& request, const Camera& camera, FrameSize size, int threads,
                                   const Progress& progress = {});

}   // namespace rayclock

// The picture that the reference tracer draws for a request.
#include "sim/run/request/reference_picture.hpp"

#include "sim/run/frame/frame.hpp"

namespace rayclock {

ReferencePicture reference_picture(const Request& request, const Camera& camera, FrameSize size, int threads,
                                   const Progress& progress) {
    const Reference tracer(request.scene);
    ReferencePicture drawn;
    if (request.finished) {
        drawn.frame = tracer.whitted(camera, size, request.settings, threads, progress);
        drawn.picture = picture_from_reference(drawn.frame);
    } else {
        drawn.frame.hits = tracer.frame(camera, size, threads, progress);
        drawn.picture = shade(request.scene, drawn.frame.hits, progress);
    }
    return drawn;
}

}   // namespace rayclock

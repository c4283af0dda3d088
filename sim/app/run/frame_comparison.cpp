// Compares a machine's frame with the reference and judges it.
#include "sim/app/run/frame_comparison.hpp"

#include "sim/run/request/reference_picture.hpp"

namespace rayclock {

FrameComparison compare(const Request& request, const Job& job, const MachineFrame& made, bool judged,
                        int threads, const Progress& progress, std::optional<std::size_t> pixel) {
    const Scene& scene = request.scene;
    const FrameInputs inputs{scene, made.camera, made.frame, job.image.lattice, request.config};
    FrameComparison c;
    c.hits = scaled(job, made.frame, made.answers);
    ReferencePicture reference = reference_picture(request, made.camera, job.size, threads, progress);
    c.reference = std::move(reference.picture);
    c.picture = request.finished ? picture_from_colours(job.size, made.colours) : shade(scene, c.hits);
    c.error = frame_error(c.hits, c.picture, reference.hits(), c.reference);
    if (request.finished) {
        const MachineOutput given{made.answers, made.colours, made.signatures};
        if (judged)
            c.judgement = judge_finished(inputs, job.image, request.settings,
                                         {reference.frame, c.picture, given}, c.hits, threads, progress);
    } else {
        const FrameAnswers answered{reference.hits(), made.answers, c.picture};
        if (judged) c.judgement = judge(inputs, job.image, answered, threads, progress);
        if (pixel) c.stages = stages_of(inputs, job.image, answered, *pixel);
    }
    c.reference_hits = std::move(reference.frame.hits);
    return c;
}

}   // namespace rayclock

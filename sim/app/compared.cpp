// Compares a machine's frame with the reference and judges it.
#include "sim/app/compared.hpp"

namespace rayclock {

Compared compare(const Request& request, const Job& job, const MachineFrame& made, bool judged, int threads,
                 const Progress& progress, std::optional<std::size_t> pixel) {
    const Scene& scene = request.scene;
    const Reference tracer(scene);
    const Asked asked{scene, made.camera, made.frame, job.image.lattice, request.config};
    Compared c;
    c.hits = scaled(job, made.frame, made.answers);
    if (request.finished) {
        WhittedFrame reference = tracer.whitted(made.camera, job.size, request.settings, threads, progress);
        c.picture = picture_of(job.size, made.colours);
        c.reference = picture_of(reference);
        c.error = frame_error(c.hits, c.picture, reference.hits, c.reference);
        const Given given{made.answers, made.colours, made.signatures};
        if (judged)
            c.judgement = judge_finished(asked, job.image, request.settings, {reference, c.picture, given},
                                         c.hits, threads, progress);
        c.reference_hits = std::move(reference.hits);
    } else {
        c.reference_hits = tracer.frame(made.camera, job.size, threads, progress);
        c.picture = shade(scene, c.hits);
        c.reference = shade(scene, c.reference_hits);
        c.error = frame_error(c.hits, c.picture, c.reference_hits, c.reference);
        const Answered answered{c.reference_hits, made.answers, c.picture};
        if (judged) c.judgement = judge(asked, job.image, answered, threads, progress);
        if (pixel) c.stages = stages_of(asked, job.image, answered, *pixel);
    }
    return c;
}

}   // namespace rayclock

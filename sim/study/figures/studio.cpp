// Renders one scene with each tracer.
#include "sim/study/figures/studio.hpp"

#include <algorithm>

#include "model/compile/surfaces.hpp"
#include "model/scene/builtin.hpp"

namespace rayclock::figures {

namespace {

Job job_of(const Studio& studio, const Scene& scene, FrameSize size, const Whitted& most) {
    return make_job(scene, *scene.camera, size, fitted_config(scene, most, named_config("default")),
                    studio.progress, most);
}

}   // namespace

bool Studio::has(Tracer tracer) const {
    return std::find(tracers.begin(), tracers.end(), tracer) != tracers.end();
}

Stage::Stage(const Studio& studio, const std::string& scene, const Whitted& most, FrameSize size)
    : studio_(studio),
      scene_(make_builtin(scene, Primitives::native)),
      job_(job_of(studio, scene_, size, most)),
      reference_(scene_) {}

Shot Stage::take(Tracer tracer, const Whitted& settings) {
    stop_if_interrupted();
    if (tracer == Tracer::reference) {
        const WhittedFrame frame =
            reference_.whitted(*scene_.camera, job_.size, settings, studio_.threads, studio_.progress);
        return {picture_from_reference(frame), frame.rays, {}};
    }
    job_.frame.shade =
        make_shade_frame(scene_, settings, job_.image, std::uint32_t(job_.size.height), job_.config);
    Shot shot;
    if (tracer == Tracer::rtl) {
        shot.run = run_rtl(job_, {}, studio_.progress);
    } else {
        std::vector<RecordedFrame> frames;
        const std::vector<FrameTiming> timings =
            record_and_replay(job_, job_.khz, frames, {}, studio_.threads, studio_.progress);
        shot.run = frame_result(frames[0], timings[0]);
        shot.run->colours = std::move(frames[0].trace.colours);
    }
    stop_if_interrupted();
    shot.picture = picture_from_colours(job_.size, shot.run->colours);
    shot.rays = shot.run->rays;
    return shot;
}

}   // namespace rayclock::figures

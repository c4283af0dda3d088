// Explains a pixel and makes the report.
#include "sim/app/run/explain_run.hpp"

#include "model/base/interrupted.hpp"
#include "sim/app/run/clock.hpp"
#include "sim/app/run/stream_run.hpp"
#include "sim/files/process/stopping.hpp"
#include "sim/view/explain/explain_page.hpp"
#include "sim/view/observe/replay.hpp"

namespace rayclock {

namespace {

/// Observes the last recorded frame. Sets its costs, and returns the story of a pixel.
PixelStory observed_story(const Job& job, const std::vector<RecordedFrame>& traces, std::size_t pixel,
                          int khz, Disturbance disturbance, FrameCosts& costs, const Progress& progress) {
    PixelEvents in_frame{std::uint32_t(pixel)}, alone{0};
    costs = observe(job.config, khz, traces, disturbance, 0, &in_frame, progress);
    if (costs.partial) throw Interrupted("interrupted: nothing is written");
    observe_alone(job.config, khz, traces.back(), std::uint32_t(pixel), &alone);
    return make_story(job, traces.back(), costs, in_frame, alone);
}

}   // namespace

void explain_pixel(Film& film, std::size_t pixel, const ExplainSettings& how, const Progress& progress,
                   const std::function<void(const Explanation&, const std::vector<FrameError>&)>& use) {
    std::vector<RecordedFrame> traces;
    while (traces.size() < film.frames()) {
        film.next();
        traces.push_back(film.record(how.threads, stopping(progress)));
    }
    const Request& request = film.request();
    const Job& job = film.job();
    const int khz = one_clock_of(how.clock, request.config);

    FrameCosts costs;
    PixelStory story = observed_story(job, traces, pixel, khz, how.disturbance, costs, progress);
    Explanation e{request.config, costs, khz, std::move(story), {}};
    std::vector<FrameError> error;
    if (how.is_compared) {
        const Trace& trace = traces.back().trace;
        const FrameComparison compared = compare(
            request, job, {traces.back().frame, film.camera(), trace.hits, trace.colours, trace.signatures},
            how.is_judged, how.threads, progress, pixel);
        e.colour = colour_finding(compared, pixel);
        error = {compared.error};
    }
    use(e, error);
}

void explain_ray(const StreamInput& input, const Config& config, std::size_t ray, const ExplainSettings& how,
                 const Progress& progress,
                 const std::function<void(const Explanation&, const StreamJob&)>& use) {
    const int khz = one_clock_of(how.clock, config);
    const Progress stop = stopping(progress);
    const StreamJob stream = input.job(config, stop);
    std::vector<RecordedFrame> traces;
    traces.push_back(record_frame(stream.job, stream.job.frame, how.threads, stop));
    FrameCosts costs;
    PixelStory story = observed_story(stream.job, traces, ray, khz, how.disturbance, costs, progress);
    use({stream.job.config, costs, khz, std::move(story), {}}, stream);
}

nlohmann::ordered_json explained_ray_json(const StreamJob& stream, const Explanation& e) {
    return {{"scene", scene_json(stream.scene)},
            {"stream", stream_json(stream)},
            {"config", config_json_object(stream.job.config)},
            {"mhz", e.khz / 1e3},
            {"cycles", e.costs.cycles},
            {"ray", e.number()},
            {"pipeline", e.story.pipeline},
            {"context", e.story.context},
            {"cost", pixel_cost_json(e.costs, e)},
            {"rays", rays_json(e)}};
}

nlohmann::ordered_json explanation_json(const Request& request, const FrameSize& size, const Explanation& e,
                                        const nlohmann::ordered_json& limits) {
    return {{"scene", scene_json(request.scene)},
            {"config", config_json_object(request.config)},
            {"frame", {{"width", size.width}, {"height", size.height}}},
            {"mhz", e.khz / 1e3},
            {"cycles", e.costs.cycles},
            {"pixel", {e.story.x, e.story.y}},
            {"pipeline", e.story.pipeline},
            {"context", e.story.context},
            {"cost", pixel_cost_json(e.costs, e)},
            {"rays", rays_json(e)},
            {"colour", colour_json(e.colour)},
            {"limits", limits}};
}

}   // namespace rayclock

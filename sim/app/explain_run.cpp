// Explains a pixel and makes the report.
#include "sim/app/explain_run.hpp"

#include "model/base/interrupted.hpp"
#include "sim/app/clock.hpp"
#include "sim/files/process/stopping.hpp"
#include "sim/view/explain/page.hpp"
#include "sim/view/observe/replay.hpp"

namespace rayclock {

void explain_pixel(Film& film, std::size_t pixel, const ExplainHow& how, const Progress& progress,
                   const std::function<void(const Explanation&, const std::vector<FrameError>&)>& use) {
    std::vector<RecordedFrame> traces;
    while (traces.size() < film.frames()) {
        film.next();
        traces.push_back(film.record(how.threads, stopping(progress)));
    }
    const Request& request = film.request();
    const Job& job = film.job();
    const int khz = one_clock_of(how.clock, request.config);

    PixelEvents in_frame{std::uint32_t(pixel)}, alone{0};
    const FrameCosts costs = observe(request.config, khz, traces, how.traffic, 0, &in_frame, progress);
    if (costs.partial) throw Interrupted("interrupted: nothing is written");
    observe_alone(request.config, khz, traces.back(), std::uint32_t(pixel), &alone);
    Explanation e{request.config, costs, khz, tell(job, traces.back(), costs, in_frame, alone), {}};
    std::vector<FrameError> error;
    if (how.is_compared) {
        const Trace& trace = traces.back().trace;
        const Compared compared = compare(
            request, job, {traces.back().frame, film.camera(), trace.hits, trace.colours, trace.signatures},
            how.is_judged, how.threads, progress, pixel);
        e.colour = colour_finding(compared, pixel);
        error = {compared.error};
    }
    use(e, error);
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

// rayclock explain: shows one pixel's history, ray by ray and cycle by cycle, and why it differs.
#include <fmt/format.h>

#include "model/base/error.hpp"
#include "sim/app/clock.hpp"
#include "sim/app/options/command_line.hpp"
#include "sim/app/options/commands.hpp"
#include "sim/app/explained.hpp"
#include "sim/app/options/options.hpp"
#include "sim/view/explain/page.hpp"
#include "sim/files/output.hpp"
#include "sim/files/streams.hpp"
#include "sim/view/report/tables.hpp"
#include "sim/view/report/text.hpp"
#include "sim/view/page/frame.hpp"
#include "sim/files/process/stopping.hpp"

namespace rayclock {

namespace {

struct ExplainOptions {
    std::string scene, pixel, size = default_size, clock = "66";
    ConfigChoice config;
    Finish finish;
    ViewChoice view;
    FramesOptions frames;
    TrafficOptions traffic;
    bool steps = false, no_reference = false, no_judge = false;
    LimitsChoice limits;
    int threads = 0;
    std::string report;
    JsonOutput json;
};

void declare_explain(Parser& parser, ExplainOptions& o) {
    scene_option(parser, o.scene).required();
    parser.option("PIXEL", o.pixel, "column and row of the pixel from the top left corner: 255,190")
        .required();
    parser.flag("--steps", o.steps, "print every visit, test and pass; JSON has them always");
    finished_options(parser, o.finish);
    view_options(parser, o.view);
    size_option(parser, o.size);
    parser.option("--clock", o.clock, "the clock in MHz; fmax: what chip has routed").with_default();
    config_options(parser, o.config);
    frames_options(parser, o.frames);
    parser.flag("--no-reference", o.no_reference, "leave out the comparison with the reference");
    judge_option(parser, o.no_judge);
    limits_options(parser, o.limits);
    threads_option(parser, o.threads);
    traffic_options(parser, o.traffic);
    parser.option("--report", o.report, "one HTML file: the rays' paths through the tree, and every step");
    json_option(parser, o.json);
}

nlohmann::ordered_json json_of(const Request& request, const FrameSize& size, const Explanation& e,
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

int run_explain(const ExplainOptions& o) {
    const FrameSize size = parse_size(o.size);
    const std::size_t pixel = parse_pixel(o.pixel, size);
    const Traffic traffic = traffic_of(o.traffic);
    const Limits limits = limits_of(o.limits);
    o.json.check();
    if (!o.report.empty()) {
        check_writable(o.report);
        check_page_library();
    }
    const Progress progress = terminal_progress();
    Film film(request_of(o.scene, o.config, o.finish, o.traffic.seed, size, stopping(progress), o.view),
              o.frames, o.view.is_asked(), size, stopping(progress));
    std::vector<RecordedFrame> traces;
    while (traces.size() < film.frames()) {
        film.next();
        traces.push_back(film.record(o.threads, stopping(progress)));
    }
    const Request& request = film.request();
    const Job& job = film.job();
    const int khz = one_clock_of(o.clock, request.config);

    PixelEvents in_frame{std::uint32_t(pixel)}, alone{0};
    const FrameCosts costs = observe(request.config, khz, traces, traffic, 0, &in_frame, progress);
    if (costs.partial) throw Interrupted("interrupted: nothing is written");
    observe_alone(request.config, khz, traces.back(), std::uint32_t(pixel), &alone);
    Explanation e{request.config, costs, khz, tell(job, traces.back(), costs, in_frame, alone), {}};
    std::vector<FrameError> error;   // errors of the explained frame
    if (!o.no_reference) {
        const Trace& trace = traces.back().trace;
        const Compared compared = compare(
            request, job, {traces.back().frame, film.camera(), trace.hits, trace.colours, trace.signatures},
            !o.no_judge, o.threads, progress, pixel);
        e.colour = colour_finding(compared, pixel);
        error = {compared.error};
    }
    const std::string far = far_frames(limits, error);
    if (!o.json.is_alone())
        write_output((far.empty() ? "" : far + "\n") + heading(request.scene, size, job) + "\n" +
                     explanation_text(e, o.steps));
    const nlohmann::ordered_json json = json_of(request, size, e, limits_json(limits, error));
    if (!o.report.empty())
        write_bytes(o.report, explanation_page(
                                  json, heading(request.scene, size, job) + "\n" + explanation_text(e, true),
                                  e, {{"command", command_line()}}));
    o.json.write(json);
    return 0;
}

}   // namespace

Command explain_command() {
    return command("explain", "follow one pixel ray by ray, cycle by cycle, and say why it differs",
                   "rayclock explain gears:8 255,190 --steps", declare_explain, run_explain);
}

}   // namespace rayclock

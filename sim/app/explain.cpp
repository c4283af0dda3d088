// rayclock explain: shows one pixel's history, ray by ray and cycle by cycle, and why it differs.
#include <fmt/format.h>

#include "model/base/error.hpp"
#include "sim/app/options/command_line.hpp"
#include "sim/app/options/commands.hpp"
#include "sim/app/explain_run.hpp"
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
    const ExplainHow how{traffic, o.clock, !o.no_reference, !o.no_judge, o.threads};
    explain_pixel(
        film, pixel, how, progress, [&](const Explanation& e, const std::vector<FrameError>& error) {
            const std::string far = far_frames(limits, error);
            if (!o.json.is_alone())
                write_output((far.empty() ? "" : far + "\n") +
                             heading(film.request().scene, size, film.job()) + "\n" +
                             explanation_text(e, o.steps));
            const nlohmann::ordered_json json =
                explanation_json(film.request(), size, e, limits_json(limits, error));
            if (!o.report.empty())
                write_bytes(o.report, explanation_page(json,
                                                       heading(film.request().scene, size, film.job()) +
                                                           "\n" + explanation_text(e, true),
                                                       e, {{"command", command_line()}}));
            o.json.write(json);
        });
    return 0;
}

}   // namespace

Command explain_command() {
    return command("explain", "follow one pixel ray by ray, cycle by cycle, and say why it differs",
                   "rayclock explain gears:8 255,190 --steps", declare_explain, run_explain);
}

}   // namespace rayclock

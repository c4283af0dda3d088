// rayclock explain: shows the history of one pixel, or of one ray of a stream, cycle by cycle, and why a
// pixel differs.
#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"
#include "sim/app/options/command_line.hpp"
#include "sim/app/options/commands.hpp"
#include "sim/app/options/options.hpp"
#include "sim/app/parts/stream_commands.hpp"
#include "sim/app/run/clock.hpp"
#include "sim/app/run/explain_run.hpp"
#include "sim/files/output.hpp"
#include "sim/files/process/stopping.hpp"
#include "sim/files/streams.hpp"
#include "sim/view/explain/explain_page.hpp"
#include "sim/view/page/frame.hpp"
#include "sim/view/report/tables.hpp"
#include "sim/view/report/text.hpp"

namespace rayclock {

namespace {

struct ExplainOptions {
    std::string scene, pixel, size = default_size, clock = "66";
    ConfigChoice config;
    Finish finish;
    ViewChoice view;
    FramesOptions frames;
    DisturbanceOptions disturbance;
    bool steps = false, no_reference = false, no_judge = false;
    LimitsChoice limits;
    StreamChoice stream;
    std::optional<int> ray;
    int threads = 0;
    std::string report;
    JsonOutput json;
};

void declare_explain(Parser& parser, ExplainOptions& o) {
    scene_option(parser, o.scene).required();
    parser.option(
        "PIXEL", o.pixel,
        "column and row of the pixel from the top left corner: 255,190; without it, --rays and --ray");
    parser.flag("--steps", o.steps, "print every visit, test and pass; JSON has them always");
    finished_options(parser, o.finish);
    view_options(parser, o.view);
    size_option(parser, o.size);
    one_clock_option(parser, o.clock);
    config_options(parser, o.config);
    frames_options(parser, o.frames);
    parser.flag("--no-reference", o.no_reference, "leave out the comparison with the reference");
    judge_option(parser, o.no_judge);
    limits_options(parser, o.limits);
    threads_option(parser, o.threads);
    disturbance_options(parser, o.disturbance);
    stream_options(parser, o.stream, false);
    parser.option("--ray", o.ray, "with --rays: the number of the ray to follow, from 0");
    parser.option("--report", o.report, "one HTML file: the rays' paths through the tree, and every step");
    json_option(parser, o.json);
}

/// Throws UserError if the page could not be written later.
void check_report(const ExplainOptions& o) {
    if (o.report.empty()) return;
    check_writable(o.report);
    check_page_library();
}

/// Writes the explanation as text, JSON and page.
void write_explanation(const ExplainOptions& o, const std::string& head, const Explanation& e,
                       const nlohmann::ordered_json& json, const std::string& far) {
    if (!o.json.is_alone())
        write_output((far.empty() ? "" : far + "\n") + head + explanation_text(e, o.steps));
    if (!o.report.empty())
        write_bytes(o.report, explanation_page(json, head + explanation_text(e, true), e,
                                               {{"command", command_line()}}));
    o.json.write(json);
}

int run_explain_ray(const ExplainOptions& o) {
    if (!o.ray) throw UserError("--rays needs --ray N, the number of the ray to follow");
    check_clocks(o.clock);
    const Disturbance disturbance = disturbance_of(o.disturbance);
    o.json.check();
    check_report(o);
    const Progress progress = terminal_progress();
    const StreamRequest request = stream_request(o.scene, o.config, o.stream, stopping(progress));
    const std::size_t rays = request.input->rays().size();
    if (*o.ray < 0 || std::size_t(*o.ray) >= rays)
        throw UserError(fmt::format("--ray: {} is not a ray of {}, whose rays are 0 to {}", *o.ray,
                                    printable(request.input->rays().name()), rays - 1));
    explain_ray(*request.input, request.config, std::size_t(*o.ray),
                {disturbance, o.clock, false, false, o.threads}, progress,
                [&](const Explanation& e, const StreamJob& stream) {
                    write_explanation(o, stream_heading(stream) + "\n", e, explained_ray_json(stream, e), "");
                });
    return 0;
}

int run_explain(const ExplainOptions& o) {
    if (traces_stream(o.stream, {.size = o.size,
                                 .finish = o.finish,
                                 .view = o.view,
                                 .frames = o.frames,
                                 .limits = o.limits,
                                 .own = {{!o.pixel.empty(), "PIXEL"},
                                         {o.no_reference, "--no-reference"},
                                         {o.no_judge, "--no-judge"}}}))
        return run_explain_ray(o);
    if (o.ray) throw UserError("--ray needs --rays, a stream of rays");
    if (o.pixel.empty()) throw UserError("PIXEL is required ('rayclock explain --help' tells more)");
    const FrameSize size = parse_size(o.size);
    const std::size_t pixel = parse_pixel(o.pixel, size);
    const Disturbance disturbance = disturbance_of(o.disturbance);
    const Limits limits = limits_of(o.limits);
    o.json.check();
    check_report(o);
    const Progress progress = terminal_progress();
    Film film(request_of(o.scene, o.config, o.finish, o.disturbance.seed, size, stopping(progress), o.view),
              o.frames, o.view.is_given(), size, stopping(progress));
    const ExplainSettings how{disturbance, o.clock, !o.no_reference, !o.no_judge, o.threads};
    explain_pixel(film, pixel, how, progress,
                  [&](const Explanation& e, const std::vector<FrameError>& error) {
                      write_explanation(o, heading(film.request().scene, size, film.job()) + "\n", e,
                                        explanation_json(film.request(), size, e, limits_json(limits, error)),
                                        far_frames(limits, error));
                  });
    return 0;
}

}   // namespace

Command explain_command() {
    return command("explain", "follow one pixel or ray cycle by cycle, and say why a pixel differs",
                   "rayclock explain gears:8 255,190 --steps", declare_explain, run_explain);
}

}   // namespace rayclock

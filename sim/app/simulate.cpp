// rayclock simulate: reports cycles, frames per second, work and accounts of frames at each clock.
#include <algorithm>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"
#include "model/base/stopwatch.hpp"
#include "sim/app/options/command_line.hpp"
#include "sim/app/options/commands.hpp"
#include "sim/app/options/options.hpp"
#include "sim/app/parts/stream_commands.hpp"
#include "sim/app/run/clock.hpp"
#include "sim/app/run/film_strip.hpp"
#include "sim/app/run/picture_folder.hpp"
#include "sim/app/run/pixel_findings.hpp"
#include "sim/app/run/sample_run.hpp"
#include "sim/app/run/simulate_run.hpp"
#include "sim/files/output.hpp"
#include "sim/files/process/stopping.hpp"
#include "sim/judge/cause/finished.hpp"
#include "sim/run/request/tracer.hpp"
#include "sim/view/observe/replay.hpp"
#include "sim/view/page/frame.hpp"
#include "sim/view/page/run_page.hpp"
#include "sim/view/report/sampled.hpp"
#include "sim/view/report/tables.hpp"
#include "sim/view/report/text.hpp"

namespace rayclock {

namespace {

const std::string default_tracer = name_of(Tracer::model);

struct SimulateOptions {
    std::string scene, size = default_size, clock = default_clocks, tracer = default_tracer;
    ConfigChoice config;
    Finish finish;
    ViewChoice view;
    std::optional<std::string> pixels;   // a part of the picture
    FramesOptions frames;
    DisturbanceOptions disturbance;
    StreamChoice stream;
    SampleChoice sample;
    bool no_reference = false, no_judge = false;
    LimitsChoice limits;
    int threads = 0;
    std::string report, output;
    JsonOutput json;
};

void sample_options(Parser& parser, SampleChoice& choice) {
    parser.option(
        "--sample", choice.share,
        "simulate only this share of each frame, for example 2%, and estimate all figures with 95 % "
        "intervals; draws no picture");
    parser.option("--error", choice.error,
                  "the same, with the share that estimates the cycles within +- this percentage, such as 1%");
    parser.option("--within", choice.within,
                  "the same, with the share that fits into this time, for example 10s");
}

void declare_simulate(Parser& parser, SimulateOptions& o) {
    scene_option(parser, o.scene).required();
    finished_options(parser, o.finish);
    view_options(parser, o.view);
    size_option(parser, o.size);
    pixels_option(parser, o.pixels);
    clock_option(parser, o.clock);
    config_options(parser, o.config);
    parser.option("--engine", o.tracer, "model or rtl").with_default();
    frames_options(parser, o.frames);
    parser.flag("--no-reference", o.no_reference, "leave out the comparison with the reference");
    judge_option(parser, o.no_judge);
    limits_options(parser, o.limits);
    threads_option(parser, o.threads);
    disturbance_options(parser, o.disturbance);
    stream_options(parser, o.stream, true);
    sample_options(parser, o.sample);
    parser.option("--report", o.report,
                  "the run as one HTML file: pictures, heat maps, charts, tables, all figures as data");
    parser.option("-o,--output", o.output,
                  "folder for the picture, the reference's picture, and where and why they differ");
    json_option(parser, o.json);
}

void print(const SimulateInput& work, const SimulateResult& s, const Limits& limits, const Totals& t,
           double seconds) {
    const Config& config = work.request().config;
    const std::string far = far_frames(limits, s.errors());
    if (!far.empty()) fmt::print("{}\n", far);
    fmt::print("{}\n{}{}\n{}\n{}", heading(work.request().scene, work.size, work.job()),
               clock_table(config, s.runs), clock_line(config, work.clocks), work_table(config, s.runs[0]),
               unit_table(config, s.runs));
    fmt::print("{}", film_table(config, s.runs, s.strip, s.traces));
    if (s.compared)
        fmt::print("\n{}{}", error_line("against the reference", s.compared->error),
                   s.judgement() ? cause_lines(*s.judgement()) : "");
    fmt::print("  host: {:.2f} s; rays recorded in {:.2f} s, {} cycles in {:.2f} s: {:.2f} M cycles/s\n",
               seconds, t.record_seconds, grouped(t.cycles), t.machine_seconds,
               double(t.cycles) / t.machine_seconds / 1e6);
    if (s.partial) fmt::print("  PARTIAL: interrupted; the figures cover the cycles until then\n");
}

/// Repeats the last frame at the first clock under observation.
FrameCosts watch_frame(const SimulateInput& work, const SimulateResult& s, Disturbance disturbance,
                       EventSink* sink, const Progress& progress) {
    constexpr std::uint64_t windows = 100;
    const FramesAtClock& run = s.runs[0];
    const std::uint64_t window = (run.last().cycles + windows - 1) / windows;
    FrameCosts costs = observe(work.request().config, run.khz, s.traces, disturbance,
                               std::max<std::uint64_t>(1, window), sink, progress);
    if (!costs.partial && (costs.cycles != run.last().cycles || costs.accounts != run.last().accounts))
        throw std::runtime_error("the watched frame is not the frame that was simulated");
    return costs;
}

/// Writes the pictures of the comparison. Returns the names of the files.
std::string write_frame_pictures(const SimulateOptions& o, const SimulateInput& work,
                                 const SimulateResult& s) {
    const Picture picture = last_frame_picture(work, s);
    const HitFrame hits =
        s.compared ? s.compared->hits : scaled(work.job(), s.traces.back().frame, s.answers());
    std::vector<NamedPicture> all{{"picture.png", picture, hits}};
    Picture difference;
    if (s.compared) all.push_back({"reference.png", s.compared->reference, hits});
    if (s.judgement()) {
        difference = cause_picture(s.compared->reference, *s.judgement());
        all.push_back({"difference.png", difference, hits});
    }
    write_pictures(o.output, all);
    return picture_paths(o.output, all);
}

using Texts = std::vector<std::pair<std::uint32_t, std::string>>;

/// Returns the explanations of the slowest pixels. A second run of the frame records only their events.
Texts explain_slowest(const SimulateInput& work, const SimulateResult& s, const FrameCosts& costs,
                      Disturbance disturbance, const Progress& progress) {
    // One pixel of a finished picture may have thousands of rays.
    constexpr std::size_t max_bytes = 4 << 20;
    const Config& config = work.request().config;
    const int khz = s.runs[0].khz;
    const std::vector<std::uint32_t> pixels = slowest_pixels(costs, 100);
    PixelEventRecorder events(pixels);
    watch_frame(work, s, disturbance, &events, progress);
    Texts texts;
    std::size_t bytes = 0;
    for (const std::uint32_t pixel : pixels) {
        if (interrupted() || bytes > max_bytes) break;
        if (progress) progress("explaining", texts.size(), pixels.size());
        PixelEvents alone{0};
        observe_alone(config, khz, s.traces.back(), pixel, &alone);
        Explanation e{
            config, costs, khz, make_story(work.job(), s.traces.back(), costs, events.of(pixel), alone), {}};
        if (s.compared) e.colour = colour_finding(*s.compared, pixel);
        texts.emplace_back(pixel, explanation_text(e, false));
        bytes += texts.back().second.size();
    }
    if (progress) progress("explaining", pixels.size(), pixels.size());
    return texts;
}

void write_report(const SimulateOptions& o, const SimulateInput& work, const SimulateResult& s,
                  const FrameCosts& costs, const Texts& texts, const nlohmann::ordered_json& json,
                  const Progress& progress) {
    if (progress) progress("writing the page", 0, 1);
    const Request& request = work.request();
    const Picture picture = last_frame_picture(work, s);
    const Picture* reference = s.compared ? &s.compared->reference : nullptr;
    const Judgement* judgement = s.judgement() ? &*s.judgement() : nullptr;
    std::vector<std::pair<std::string, std::string>> origin{{"command", command_line()}};
    for (auto& version : versions()) origin.push_back(std::move(version));
    origin.emplace_back("digest of pixels and cycles", json.at("digest").get<std::string>());
    write_bytes(o.report, report_page({json, request.config, s.runs[0].khz, s.runs[0].last(), costs, picture,
                                       reference, judgement, explain_line(s.runs[0].khz), texts, origin}));
    if (progress) progress("writing the page", 1, 1);
}

/// Throws UserError if an option was given that has no meaning for a sample.
void check_sample_options(const SimulateOptions& o) {
    check_sample(o.sample);
    const auto refuse = [](bool is_given, const char* option, const char* why) {
        if (is_given) throw UserError(fmt::format("--sample: {}; leave out {}", why, option));
    };
    refuse(o.stream.rays.has_value(), "--rays", "a stream of rays is simulated as a whole");
    refuse(o.tracer != default_tracer, "--engine", "the RTL draws whole frames only");
    refuse(o.frames.uploads == "double", "--uploads double",
           "the host writes between sampled frames, and not during them");
    refuse(!o.report.empty(), "--report", "a sample draws no picture for the page");
    refuse(!o.output.empty(), "--output", "a sample draws no picture");
    refuse(o.limits.max_other || o.limits.max_depth_error || o.limits.min_psnr,
           "--max-other, --max-depth-error and --min-psnr", "a sample has no picture to compare");
    traces_stream(o.stream, no_picture_options({}));   // refuses what needs --rays
}

int run_simulate_sample(const SimulateOptions& o) {
    const Stopwatch watch;
    check_sample_options(o);
    ViewChoice view = o.view;
    const FrameSize size = parse_part(o.size, o.pixels, view);
    check_clocks(o.clock);
    const Disturbance disturbance = disturbance_of(o.disturbance);
    o.json.check();
    const Progress progress = stopping(terminal_progress());
    Request request = request_of(o.scene, o.config, o.finish, o.disturbance.seed, size, progress, view);
    const std::vector<int> clocks = clocks_of(o.clock, request.config);
    Film film(std::move(request), o.frames, o.view.is_given(), size, progress);
    const SampledFilm sampled =
        run_sample(film, clocks, o.sample, o.disturbance.seed, disturbance, o.threads, watch, progress);
    const Config& config = film.job().config;
    if (!o.json.is_alone()) {
        fmt::print(
            "{}\n{}{}{}\n{}", heading(film.request().scene, size, film.job()),
            sampled_table(config, clocks, sampled.frames), sampled_film_table(config, clocks, sampled.frames),
            film_table(config, sampled.runs, sampled.strip, sampled.uploads), sampled_lines(sampled.frames));
        fmt::print("  host: {:.2f} s, of which {:.2f} s for the sample\n", watch.seconds(), sampled.seconds);
    }
    if (!sampled.shortfall.empty()) print_ineffective({sampled.shortfall});
    o.json.write(sample_json(film, size, o.frames.pan, clocks, sampled));
    return 0;
}

int run_simulate(const SimulateOptions& o) {
    if (o.sample.is_given()) return run_simulate_sample(o);
    if (traces_stream(o.stream, {.size = o.size,
                                 .finish = o.finish,
                                 .view = o.view,
                                 .frames = o.frames,
                                 .limits = o.limits,
                                 .own = {{!o.output.empty(), "--output"},
                                         {o.pixels.has_value(), "--pixels"},
                                         {o.tracer != default_tracer, "--engine"},
                                         {!o.report.empty(), "--report"},
                                         {o.no_reference, "--no-reference"}}}))
        return simulate_stream({.scene = o.scene,
                                .clock = o.clock,
                                .config = o.config,
                                .stream = o.stream,
                                .disturbance = o.disturbance,
                                .no_judge = o.no_judge,
                                .threads = o.threads,
                                .json = o.json});
    const Stopwatch watch;
    ViewChoice view = o.view;
    const FrameSize size = parse_part(o.size, o.pixels, view);
    check_clocks(o.clock);
    const Tracer tracer = parse_machine(o.tracer);
    const Disturbance disturbance = disturbance_of(o.disturbance);
    const Limits limits = limits_of(o.limits);
    o.json.check();
    if (!o.output.empty()) check_picture_folder(o.output, {"picture.png", "reference.png", "difference.png"});
    if (!o.report.empty()) {
        check_writable(o.report);
        check_page_library();
    }
    const Progress progress = terminal_progress();
    const Progress stop = stopping(progress);
    Request request = request_of(o.scene, o.config, o.finish, o.disturbance.seed, size, stop, view);
    const Config config = request.config;
    if (tracer == Tracer::rtl) check_rtl(config);
    const std::vector<int> clocks = clocks_of(o.clock, config);
    Film film(std::move(request), o.frames, o.view.is_given(), size, stop);
    if (!o.output.empty() && film.frames() > 1 && film.moves()) check_film_folder(o.output, film.frames());
    const SimulateInput work{film, size, clocks};
    const SimulateSettings how{.tracer = tracer,
                               .disturbance = disturbance,
                               .seed = o.disturbance.seed,
                               .is_compared = !o.no_reference,
                               .is_judged = !o.no_judge,
                               .threads = o.threads,
                               .pan = o.frames.pan,
                               .folder = o.output};
    SimulateResult simulated = run_simulation(how, work, progress);
    if (how.is_compared && !simulated.partial) compare_frames(simulated, how, work, stop);
    const double seconds = watch.seconds();

    const Totals totals = totals_of(simulated);
    if (!o.json.is_alone()) print(work, simulated, limits, totals, seconds);
    nlohmann::ordered_json json = simulation_json(how, work, simulated, limits, totals);
    if (!o.report.empty() && !simulated.partial) {
        const FrameCosts costs = watch_frame(work, simulated, disturbance, nullptr, progress);
        json["work_by_kind"] = work_by_kind_json(costs);
        if (!costs.partial)
            write_report(o, work, simulated, costs,
                         explain_slowest(work, simulated, costs, disturbance, progress), json, progress);
        if (!o.json.is_alone()) fmt::print("  report: {}\n", printable(o.report));
    }
    if (!o.output.empty() && !simulated.partial) {
        finish_film(simulated.strip, o.json.is_alone());   // on failure all earlier files stay
        const std::string paths = write_frame_pictures(o, work, simulated);
        if (!o.json.is_alone()) fmt::print("  pictures: {}\n", paths);
    }
    o.json.write(json);
    return simulated.partial || (simulated.judgement() && simulated.judgement()->wrong_for(config) > 0) ? 1
                                                                                                        : 0;
}

}   // namespace

Command simulate_command() {
    return command("simulate", "count the cycles, frames per second, work and stalls of a frame",
                   "rayclock simulate balls:3 --clock 66,90 --set contexts=32", declare_simulate,
                   run_simulate);
}

}   // namespace rayclock

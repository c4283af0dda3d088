// rayclock simulate: reports cycles, frames per second, work and accounts of frames at each clock.
#include <algorithm>
#include <chrono>
#include <mutex>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"
#include "model/base/stopwatch.hpp"
#include "model/trace/hits.hpp"
#include "sim/judge/reference/reference.hpp"
#include "sim/app/clock.hpp"
#include "sim/app/options/command_line.hpp"
#include "sim/app/options/commands.hpp"
#include "sim/app/explained.hpp"
#include "sim/app/film_strip.hpp"
#include "sim/app/options/options.hpp"
#include "sim/app/picture_folder.hpp"
#include "sim/app/streamed.hpp"
#include "sim/judge/cause/finished.hpp"
#include "sim/files/output.hpp"
#include "sim/files/process/threads.hpp"
#include "sim/view/observe/replay.hpp"
#include "sim/view/report/accounts.hpp"
#include "sim/view/report/tables.hpp"
#include "sim/view/report/text.hpp"
#include "sim/view/page/frame.hpp"
#include "sim/view/page/page.hpp"
#include "sim/files/process/stopping.hpp"

namespace rayclock {

namespace {

struct SimulateOptions {
    std::string scene, size = default_size, clock = default_clocks, engine = "model";
    ConfigChoice config;
    Finish finish;
    ViewChoice view;
    FramesOptions frames;
    TrafficOptions traffic;
    StreamChoice stream;
    bool no_reference = false, no_judge = false;
    LimitsChoice limits;
    int threads = 0;
    std::string report, output;
    JsonOutput json;
};

void declare_simulate(Parser& parser, SimulateOptions& o) {
    scene_option(parser, o.scene).required();
    finished_options(parser, o.finish);
    view_options(parser, o.view);
    size_option(parser, o.size);
    clock_option(parser, o.clock);
    config_options(parser, o.config);
    parser.option("--engine", o.engine, "model or rtl").with_default();
    frames_options(parser, o.frames);
    parser.flag("--no-reference", o.no_reference, "leave out the comparison with the reference");
    judge_option(parser, o.no_judge);
    limits_options(parser, o.limits);
    threads_option(parser, o.threads);
    traffic_options(parser, o.traffic);
    stream_options(parser, o.stream);
    parser.option("--report", o.report,
                  "the run as one HTML file: pictures, heat maps, charts, tables, all figures as data");
    parser.option("-o,--output", o.output,
                  "folder for the picture, the reference's picture, and where and why they differ");
    json_option(parser, o.json);
}

/// Replays the same trace once per clock, in parallel.
std::vector<FramesAtClock> replay_clocks(const Job& job, const std::vector<int>& clocks,
                                         const std::vector<RecordedFrame>& traces, Traffic traffic,
                                         int threads, const Progress& progress) {
    std::vector<FramesAtClock> runs(clocks.size());
    std::mutex mutex;
    std::vector<std::uint64_t> done(clocks.size());
    const std::uint64_t pixels = traces[0].trace.rays.size() * traces.size();
    jobs::for_each(clocks.size(), threads, [&](std::size_t i) {
        const Progress tell =
            !progress ? Progress{} : [&, i](std::string_view what, std::uint64_t n, std::uint64_t) {
                const std::lock_guard lock(mutex);
                done[i] = std::max(done[i], n);
                std::uint64_t sum = 0;
                for (const std::uint64_t d : done) sum += d;
                progress(what, std::min(sum, pixels * clocks.size()), pixels * clocks.size());
            };
        runs[i].khz = clocks[i];
        const std::vector<FrameTiming> timings = replay(job.config, clocks[i], traces, traffic, tell);
        for (std::size_t f = 0; f < timings.size(); ++f)
            runs[i].frames.push_back(frame_result(traces[f], timings[f]));
    });
    return runs;
}

std::vector<FramesAtClock> run_rtl_clocks(const Job& job, const std::vector<int>& clocks,
                                          const std::vector<RecordedFrame>& traces, Traffic traffic, int seed,
                                          const Progress& progress) {
    std::vector<FramesAtClock> runs;
    for (const int khz : clocks) {
        runs.push_back({khz, run_rtl(job, khz, traces, traffic, progress, seed)});
        if (runs.back().partial()) break;
    }
    return runs;
}

/// The input of a simulation: the frames of a film, and the clocks.
struct SimulatePlan {
    Film& film;
    FrameSize size;
    std::vector<int> clocks;
    const Request& request() const {
        return film.request();
    }   ///< the last frame's request once all frames
        ///< are recorded
    const Job& job() const { return film.job(); }
};

/// The results of a simulation.
struct Simulated {
    bool is_model = true;
    std::vector<RecordedFrame> traces;
    std::vector<FramesAtClock> runs;    ///< [clock]
    FilmStrip strip;                    ///< of the frames, if they were recorded one by one
    std::optional<Compared> compared;   ///< the last frame compared with the reference
    bool partial = false;

    std::optional<FrameError> error() const {
        return compared ? std::optional(compared->error) : std::nullopt;
    }
    /// Returns the errors of all compared frames.
    std::vector<FrameError> errors() const {
        return compared ? all_errors(strip, compared->error) : std::vector<FrameError>{};
    }
    const std::optional<Judgement>& judgement() const {
        static const std::optional<Judgement> none;
        return compared ? compared->judgement : none;
    }
    const std::vector<Closest>& answers() const {
        return is_model ? traces.back().trace.hits : runs.back().last().answers;
    }
    const Colours& colours() const {
        return is_model ? traces.back().trace.colours : runs.back().last().colours;
    }
};

Simulated run_engine(const SimulateOptions& o, const SimulatePlan& work, Traffic traffic,
                     const Progress& progress) {
    Simulated s;
    Film& film = work.film;
    s.is_model = o.engine == "model";
    // A single frame at a single clock replays while it is recorded.
    if (s.is_model && work.clocks.size() == 1 && film.frames() == 1 && !film.moves()) {
        film.next();
        const std::vector<FrameTiming> timings =
            record_and_replay(work.job(), work.clocks[0], s.traces, traffic, o.threads, progress);
        s.runs.push_back({work.clocks[0], {frame_result(s.traces[0], timings[0])}});
    } else {
        s.strip = record_film(film, {o.threads, o.output, !o.no_reference}, stopping(progress), s.traces);
        s.runs = s.is_model ? replay_clocks(work.job(), work.clocks, s.traces, traffic, o.threads, progress)
                            : run_rtl_clocks(work.job(), work.clocks, s.traces, traffic, int(o.traffic.seed),
                                             progress);
    }
    s.partial = s.runs.size() < work.clocks.size() ||
                std::any_of(s.runs.begin(), s.runs.end(), [](const FramesAtClock& r) { return r.partial(); });
    return s;
}

/// Compares the last frame with the reference and judges it.
void compare_frames(Simulated& s, const SimulateOptions& o, const SimulatePlan& work,
                    const Progress& progress) {
    s.compared = rayclock::compare(work.request(), work.job(),
                                   {s.traces.back().frame, work.film.camera(), s.answers(), s.colours(),
                                    s.traces.back().trace.signatures},
                                   !o.no_judge, o.threads, progress);
}

/// Sums over all frames and clocks.
struct Totals {
    std::uint64_t cycles = 0;
    double machine_seconds = 0, record_seconds = 0, engine_seconds = 0;   ///< seconds on the host
    Digest digest;
};
Totals totals_of(const Simulated& s) {
    Totals t;
    for (const FramesAtClock& run : s.runs)
        for (const FrameResult& frame : run.frames) {
            t.cycles += frame.cycles;
            t.machine_seconds += frame.seconds;
            t.digest.add(frame.digest);
        }
    for (const RecordedFrame& trace : s.traces) t.record_seconds += trace.trace.seconds;
    // A single replay runs in parallel with the recording, so its time includes both.
    t.engine_seconds =
        t.machine_seconds + (s.is_model && s.traces.size() * s.runs.size() > 1 ? t.record_seconds : 0);
    return t;
}

void print(const SimulatePlan& work, const Simulated& s, const Limits& limits, const Totals& t,
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

nlohmann::ordered_json json_of(const SimulateOptions& o, const SimulatePlan& work, const Simulated& s,
                               const Limits& limits, const Totals& t) {
    const Config& config = work.request().config;
    const FrameResult& frame = s.runs[0].last();
    nlohmann::ordered_json clocks = nlohmann::ordered_json::array();
    for (const FramesAtClock& run : s.runs) {
        clocks.push_back(clock_json(config, run));
        mark_clock(clocks.back(), config, run.khz);
    }
    return {{"scene", scene_json(work.request().scene)},
            {"config", config_json_object(config)},
            {"frame", {{"width", work.size.width}, {"height", work.size.height}}},
            {"camera", camera_json(work.film.camera())},
            {"frames", work.film.frames()},
            {"pan", o.frames.pan},
            {"film", film_json(config, s.runs, s.strip, s.traces)},
            {"engine", o.engine},
            {"partial", s.partial},
            {"compile", compile_json(work.job().image.report)},
            {"rays", rays_json(frame.rays)},
            {"work", work_json(frame)},
            {"work_by_kind", nullptr},
            {"clocks", clocks},
            {"units", units_json(config, frame)},
            {"memory", memory_json(config, s.runs[0].khz, frame)},
            {"error", error_json(s.error(), s.judgement())},
            {"limits", limits_json(limits, s.errors())},
            {"judge", judge_json(s.judgement())},
            {"host",
             {{"seconds", t.engine_seconds},
              {"record_seconds", s.is_model ? t.record_seconds : 0},
              {"judge_seconds", s.judgement() ? s.judgement()->seconds : 0},
              {"cycles_per_second", double(t.cycles) / t.engine_seconds},
              {"rays_per_second",
               rays_of(frame) * double(s.runs.size() * s.runs[0].frames.size()) / t.engine_seconds}}},
            {"digest", digest_text(t.digest.value())}};
}

/// Repeats the last frame at the first clock under observation.
FrameCosts watch_frame(const SimulatePlan& work, const Simulated& s, Traffic traffic, EventSink* sink,
                       const Progress& progress) {
    constexpr std::uint64_t windows = 100;
    const FramesAtClock& run = s.runs[0];
    const std::uint64_t window = (run.last().cycles + windows - 1) / windows;
    FrameCosts costs = observe(work.request().config, run.khz, s.traces, traffic,
                               std::max<std::uint64_t>(1, window), sink, progress);
    if (!costs.partial && (costs.cycles != run.last().cycles || costs.accounts != run.last().accounts))
        throw std::runtime_error("the watched frame is not the frame that was simulated");
    return costs;
}

/// Returns the last frame's picture, from the comparison if there is one.
Picture last_frame_picture(const SimulatePlan& work, const Simulated& s) {
    if (s.compared) return s.compared->picture;
    return work.request().finished
               ? picture_from_colours(work.size, s.colours())
               : shade(work.request().scene, scaled(work.job(), s.traces.back().frame, s.answers()));
}

/// Writes the pictures of the comparison. Returns the names of the files.
std::string write_frame_pictures(const SimulateOptions& o, const SimulatePlan& work, const Simulated& s) {
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
Texts explain_slowest(const SimulatePlan& work, const Simulated& s, const FrameCosts& costs, Traffic traffic,
                      const Progress& progress) {
    constexpr std::size_t most_bytes = 4 << 20;   // one pixel of a finished picture may have thousands of
                                                  // rays
    const Config& config = work.request().config;
    const int khz = s.runs[0].khz;
    const std::vector<std::uint32_t> pixels = slowest_pixels(costs, 100);
    PixelsEvents events(pixels);
    watch_frame(work, s, traffic, &events, progress);
    Texts texts;
    std::size_t bytes = 0;
    for (const std::uint32_t pixel : pixels) {
        if (interrupted() || bytes > most_bytes) break;
        if (progress) progress("explaining", texts.size(), pixels.size());
        PixelEvents alone{0};
        observe_alone(config, khz, s.traces.back(), pixel, &alone);
        Explanation e{
            config, costs, khz, tell(work.job(), s.traces.back(), costs, events.of(pixel), alone), {}};
        if (s.compared) e.colour = colour_finding(*s.compared, pixel);
        texts.emplace_back(pixel, explanation_text(e, false));
        bytes += texts.back().second.size();
    }
    if (progress) progress("explaining", pixels.size(), pixels.size());
    return texts;
}

void write_report(const SimulateOptions& o, const SimulatePlan& work, const Simulated& s,
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

/// Runs the command with a stream of rays. It draws no picture.
int run_simulate_stream(const SimulateOptions& o) {
    refuse_picture_options(o.size, o.finish, o.view, o.frames, o.limits, o.output);
    refuse_with_rays(o.engine != "model" ? "--engine"
                     : !o.report.empty() ? "--report"
                     : o.no_reference    ? "--no-reference"
                                         : nullptr);
    return simulate_stream({o.scene, o.clock, o.config, o.stream, o.traffic, o.no_judge, o.threads, o.json});
}

int run_simulate(const SimulateOptions& o) {
    check_stream_options(o.stream);
    if (o.stream.is_asked()) return run_simulate_stream(o);
    const Stopwatch watch;
    const FrameSize size = parse_size(o.size);
    if (o.clock.find("fmax") == std::string::npos)
        parse_clocks(o.clock);   // refused before the scene is loaded
    if (o.engine != "model" && o.engine != "rtl")
        throw UserError("--engine: " + shown(o.engine) + " is not model or rtl");
    const Traffic traffic = traffic_of(o.traffic);
    const Limits limits = limits_of(o.limits);
    o.json.check();
    if (!o.output.empty()) check_picture_folder(o.output, {"picture.png", "reference.png", "difference.png"});
    if (!o.report.empty()) {
        check_writable(o.report);
        check_page_library();
    }
    const Progress progress = terminal_progress();
    const Progress stop = stopping(progress);
    Request request = request_of(o.scene, o.config, o.finish, o.traffic.seed, size, stop, o.view);
    const Config config = request.config;
    if (o.engine == "rtl") check_rtl(config);
    const std::vector<int> clocks = clocks_of(o.clock, config);
    Film film(std::move(request), o.frames, o.view.is_asked(), size, stop);
    if (!o.output.empty() && film.frames() > 1 && film.moves()) check_film_folder(o.output, film.frames());
    const SimulatePlan work{film, size, clocks};
    Simulated simulated = run_engine(o, work, traffic, progress);
    if (!o.no_reference && !simulated.partial) compare_frames(simulated, o, work, stop);
    const double seconds = watch.seconds();

    const Totals totals = totals_of(simulated);
    if (!o.json.is_alone()) print(work, simulated, limits, totals, seconds);
    nlohmann::ordered_json json = json_of(o, work, simulated, limits, totals);
    if (!o.report.empty() && !simulated.partial) {
        const FrameCosts costs = watch_frame(work, simulated, traffic, nullptr, progress);
        json["work_by_kind"] = work_by_kind_json(costs);
        if (!costs.partial)
            write_report(o, work, simulated, costs,
                         explain_slowest(work, simulated, costs, traffic, progress), json, progress);
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

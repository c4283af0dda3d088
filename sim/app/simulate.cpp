// rayclock simulate: cycles, frames per second, work and accounts of frames, at each clock.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <future>
#include <mutex>

#include <fmt/format.h>

#include "model/core/error.hpp"
#include "model/core/quote.hpp"
#include "model/hits.hpp"
#include "model/reference/reference.hpp"
#include "sim/app/commands.hpp"
#include "sim/app/picture.hpp"
#include "sim/app/tables.hpp"
#include "sim/cause/finished.hpp"
#include "sim/report/accounts.hpp"
#include "sim/report/text.hpp"

namespace rayclock {

namespace {

/// One replay per clock, on all cores, from the same trace.
std::vector<ClockRun> replay_clocks(const Job& job, const std::vector<int>& clocks, const std::vector<FrameTrace>& traces, Traffic traffic, int threads,
                                    const Progress& progress) {
    std::vector<ClockRun> runs(clocks.size());
    std::atomic<std::size_t> next = 0;
    std::mutex mutex;
    std::vector<std::uint64_t> done(clocks.size());
    const std::uint64_t pixels = traces[0].trace.rays.size() * traces.size();
    const auto work = [&] {
        for (std::size_t i = next++; i < clocks.size(); i = next++) {
            const Progress tell = !progress ? Progress{} : [&, i](std::string_view what, std::uint64_t n, std::uint64_t) {
                const std::lock_guard lock(mutex);
                done[i] = std::max(done[i], n);
                std::uint64_t sum = 0;
                for (const std::uint64_t d : done) sum += d;
                progress(what, std::min(sum, pixels * clocks.size()), pixels * clocks.size());
            };
            runs[i].khz = clocks[i];
            const std::vector<FrameTiming> timings = replay(job.config, clocks[i], traces, traffic, tell);
            for (std::size_t f = 0; f < timings.size(); ++f) runs[i].frames.push_back(frame_run(traces[f], timings[f]));
        }
    };
    const std::size_t cores = threads > 0 ? std::size_t(threads) : std::max(1u, std::thread::hardware_concurrency());
    std::vector<std::future<void>> helpers;
    for (std::size_t i = 1; i < std::min(cores, clocks.size()); ++i) helpers.push_back(std::async(std::launch::async, work));
    work();
    for (auto& helper : helpers) helper.get();
    return runs;
}

std::vector<ClockRun> run_rtl_clocks(const Job& job, const std::vector<int>& clocks, const std::vector<FrameTrace>& traces, Traffic traffic, int seed,
                                     const Progress& progress) {
    std::vector<Frame> frames;
    for (const FrameTrace& trace : traces) frames.push_back(trace.frame);
    std::vector<ClockRun> runs;
    for (const int khz : clocks) {
        runs.push_back({khz, run_rtl(job, khz, frames, traffic, progress, seed)});
        if (runs.back().partial()) break;
    }
    return runs;
}

} // namespace

int simulate_command(const Options& o) {
    const auto start = std::chrono::steady_clock::now();
    catch_interrupts();
    const FrameSize size = parse_size(o.size);
    const std::vector<int> clocks = parse_clocks(o.clock);
    if (o.engine != "model" && o.engine != "rtl") throw UserError("--engine: " + shown(o.engine) + " is not model or rtl");
    const Traffic traffic = traffic_of(o);
    check_outputs(o);
    const Progress progress = terminal_progress();
    const Request request = request_of(o, size, progress);
    const Config& config = request.config;
    const Scene& scene = request.scene;
    if (o.engine == "rtl") check_rtl(config);
    const std::vector<Camera> path = camera_path(o, *scene.camera);
    const Job job = make_job(scene, path[0], size, config, progress, request.settings);
    std::vector<FrameTrace> traces;
    std::vector<ClockRun> runs;
    if (o.engine == "model" && clocks.size() == 1 && path.size() == 1) {   // one replay, beside the recording
        const std::vector<FrameTiming> timings = record_and_replay(job, clocks[0], traces, traffic, o.threads, progress);
        runs.push_back({clocks[0], {frame_run(traces[0], timings[0])}});
    } else {
        for (const Camera& camera : path) traces.push_back(record_frame(job, job_frame(job, camera), o.threads, progress));
        runs = o.engine == "model" ? replay_clocks(job, clocks, traces, traffic, o.threads, progress)
                                   : run_rtl_clocks(job, clocks, traces, traffic, int(o.seed), progress);
    }
    const bool partial = runs.size() < clocks.size() || std::any_of(runs.begin(), runs.end(), [](const ClockRun& r) { return r.partial(); });
    std::uint64_t cycles = 0;
    double machine_seconds = 0, record_seconds = 0;
    Digest digest;
    for (const ClockRun& run : runs)
        for (const FrameRun& frame : run.frames) {
            cycles += frame.cycles;
            machine_seconds += frame.seconds;
            digest.add(frame.digest);
        }
    for (const FrameTrace& trace : traces) record_seconds += trace.trace.seconds;
    // A single replay runs beside the recording, and its time has both.
    const double engine_seconds = machine_seconds + (o.engine == "model" && traces.size() * clocks.size() > 1 ? record_seconds : 0);
    std::optional<FrameError> error;
    std::optional<Judgement> judgement;
    if (!o.no_reference && !partial) {
        const std::vector<Closest>& answers = o.engine == "model" ? traces.back().trace.hits : runs.back().last().answers;
        const Frame& shown = traces.back().frame;
        const HitFrame hits = scaled(job, shown, answers);
        const Reference tracer(scene);
        if (request.finished) {
            const Colours& colours = o.engine == "model" ? traces.back().trace.colours : runs.back().last().colours;
            const WhittedFrame reference = tracer.whitted(path.back(), size, request.settings, o.threads, progress);
            const Picture picture = picture_of(size, colours);
            error = frame_error(hits, picture, reference.hits, picture_of(reference));
            const Given given{answers, colours, traces.back().trace.signatures};
            if (!o.no_judge)
                judgement = judge_finished({scene, path.back(), shown, job.image.lattice, config}, job.image, request.settings,
                                           {reference, picture, given}, hits, o.threads, progress);
        } else {
            const HitFrame reference = tracer.frame(path.back(), size, o.threads, progress);
            error = frame_error(scene, hits, reference);
            if (!o.no_judge)
                judgement = judge({scene, path.back(), shown, job.image.lattice, config}, {reference, answers, shade(scene, hits)}, o.threads, progress);
        }
    }
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();

    const FrameRun& frame = runs[0].last();
    if (o.json != "-") {
        fmt::print("{}\n{}\n{}\n{}", heading(scene, size, job), clock_table(config, runs), work_table(config, runs[0]), unit_table(config, runs));
        if (error) fmt::print("\n{}{}", error_line("against the reference", *error), judgement ? cause_lines(*judgement) : "");
        fmt::print("  host: {:.2f} s; rays recorded in {:.2f} s, {} cycles in {:.2f} s: {:.2f} M cycles/s\n", seconds, record_seconds, grouped(cycles),
                   machine_seconds, double(cycles) / machine_seconds / 1e6);
        if (partial) fmt::print("  PARTIAL: interrupted; the figures are of what was done until then\n");
    }
    if (!o.json.empty()) {
        nlohmann::ordered_json clocks_json = nlohmann::ordered_json::array();
        for (const ClockRun& run : runs) clocks_json.push_back(clock_json(config, run));
        const nlohmann::ordered_json json{
            {"scene", scene_json(scene)}, {"config", config_json_object(config)}, {"frame", {{"width", size.width}, {"height", size.height}}},
            {"frames", o.frames}, {"pan", o.pan}, {"engine", o.engine}, {"partial", partial}, {"compile", compile_json(job.image.report)},
            {"rays", rays_json(frame)},
            {"work", work_json(frame)}, {"clocks", clocks_json}, {"units", units_json(config, frame)}, {"memory", memory_json(config, runs[0].khz, frame)},
            {"error", error_json(error, judgement)}, {"judge", judge_json(judgement)},
            {"host", {{"seconds", engine_seconds}, {"record_seconds", o.engine == "model" ? record_seconds : 0}, {"judge_seconds", judgement ? judgement->seconds : 0}, {"cycles_per_second", double(cycles) / engine_seconds},
                      {"rays_per_second", rays_of(frame) * double(runs.size() * runs[0].frames.size()) / engine_seconds}}},
            {"digest", digest_text(digest.value())}};
        write_file(o.json, json.dump(2) + "\n");
    }
    return partial || (judgement && judgement->wrong_for(config) > 0) ? 1 : 0;
}

} // namespace rayclock

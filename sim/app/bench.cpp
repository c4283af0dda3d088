// rayclock bench: measures the speed of the simulator itself, as ratios within one run.

#include <fmt/format.h>

#include "model/base/stopwatch.hpp"
#include "sim/app/options/commands.hpp"
#include "sim/app/options/options.hpp"
#include "sim/files/process/stopping.hpp"
#include "sim/judge/reference/reference.hpp"
#include "sim/run/rtl/builder.hpp"
#include "sim/view/report/json.hpp"
#include "sim/view/report/text.hpp"

namespace rayclock {

namespace {

/// Returns the seconds that `work` takes: the best of at least three runs and half a second, because other
/// jobs share the machine.
template <class Work> double best_seconds(Work work) {
    double best = 1e300, total = 0;
    for (int i = 0; i < 3 || total < 0.5; ++i) {
        const Stopwatch watch;
        work();
        stop_if_interrupted();
        const double seconds = watch.seconds();
        best = std::min(best, seconds);
        total += seconds;
        if (total > 20) break;
    }
    return best;
}

struct BenchOptions {
    std::string scene, size = default_size;
    ConfigChoice config;
    ViewChoice view;
    int threads = 0;
    JsonOutput json;
};

void declare_bench(Parser& parser, BenchOptions& o) {
    scene_option(parser, o.scene).required();
    view_options(parser, o.view);
    size_option(parser, o.size);
    config_options(parser, o.config);
    threads_option(parser, o.threads);
    json_option(parser, o.json);
}

/// Seconds for each kind of work on one frame.
struct Seconds {
    double compile = 0, record = 0, replay = 0, model = 0, rtl = 0, reference = 0;
};

Seconds measure(const Scene& scene, const Job& job, int threads) {
    Seconds s;
    s.compile = best_seconds([&] { make_job(scene, *scene.camera, job.size, job.config); });
    std::vector<RecordedFrame> traces;
    traces.push_back(record_frame(job, job.frame, threads, stopping({})));
    s.record = best_seconds([&] { record_frame(job, job.frame, threads, stopping({})); });
    s.replay = best_seconds([&] { replay(job.config, job.khz, traces); });
    s.model = best_seconds([&] {
        std::vector<RecordedFrame> fresh;
        record_and_replay(job, job.khz, fresh, {}, threads);
    });
    s.rtl = best_seconds([&] { run_rtl(job); });
    const Reference tracer(scene);
    s.reference = best_seconds([&] { tracer.frame(*scene.camera, job.size, 1, stopping({})); });
    return s;
}

std::string text_of(const Seconds& s, double cycles, double rays) {
    Table table({"engine", "seconds", "M cycles/s", "M rays/s", "times the RTL"});
    const auto row = [&](const char* name, double seconds, bool clocked) {
        table.add({name, fmt::format("{:.3f}", seconds),
                   clocked ? fmt::format("{:.2f}", cycles / seconds / 1e6) : "",
                   fmt::format("{:.3f}", rays / seconds / 1e6), fmt::format("{:.1f}", s.rtl / seconds)});
    };
    row("rtl", s.rtl, true);
    row("model", s.model, true);
    row("  rays recorded", s.record, false);
    row("  trace replayed", s.replay, true);
    row("reference, 1 thread", s.reference, false);
    return fmt::format("{}  scene compilation {:.2f} s\n", table.text(), s.compile);
}

nlohmann::ordered_json json_of(const Scene& scene, const Job& job, const FrameResult& frame,
                               const Seconds& s) {
    const double cycles = double(frame.cycles), rays = double(frame.hits.hits.size());
    return {
        {"scene", scene_json(scene)},
        {"config", config_json_object(job.config)},
        {"frame", {{"width", job.size.width}, {"height", job.size.height}}},
        {"cycles", frame.cycles},
        {"rtl", {{"seconds", s.rtl}, {"cycles_per_second", cycles / s.rtl}}},
        {"model",
         {{"seconds", s.model}, {"cycles_per_second", cycles / s.model}, {"times_rtl", s.rtl / s.model}}},
        {"record", {{"seconds", s.record}, {"rays_per_second", rays / s.record}}},
        {"replay",
         {{"seconds", s.replay}, {"cycles_per_second", cycles / s.replay}, {"times_rtl", s.rtl / s.replay}}},
        {"reference", {{"seconds", s.reference}, {"rays_per_second", rays / s.reference}}},
        {"compile", {{"seconds", s.compile}}}};
}

int run_bench(const BenchOptions& o) {
    const FrameSize size = parse_size(o.size);
    const Config config = load_config(o.config);
    check_rtl(config);
    o.json.check();
    const Progress progress = stopping(terminal_progress());
    const Scene scene = ready_scene(o.scene, size, progress, o.view);
    build_rtl(config);
    const Job job = make_job(scene, *scene.camera, size, config, progress);
    const FrameResult frame = run_model(job);
    stop_if_interrupted();
    const Seconds seconds = measure(scene, job, o.threads);
    if (!o.json.is_alone()) {
        fmt::print("{}, {}x{}, configuration {}: {} cycles\n\n", scene.name, size.width, size.height,
                   config.name, grouped(frame.cycles));
        fmt::print("{}", text_of(seconds, double(frame.cycles), double(frame.hits.hits.size())));
    }
    o.json.write(json_of(scene, job, frame, seconds));
    return 0;
}

}   // namespace

Command bench_command() {
    return command("bench", "measure the simulator itself: model, RTL and reference",
                   "rayclock bench gears:8", declare_bench, run_bench);
}

}   // namespace rayclock

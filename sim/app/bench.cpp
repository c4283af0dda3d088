// rayclock bench: speed of the simulator itself, as ratios measured in one run.
#include <chrono>

#include <fmt/format.h>

#include "model/reference/reference.hpp"
#include "sim/app/commands.hpp"
#include "sim/report/json.hpp"
#include "sim/report/text.hpp"
#include "sim/rtl/builder.hpp"

namespace rayclock {

namespace {

/// Seconds that `work` takes: the best of at least three runs and half a second, since others share the machine.
template <class Work> double best_seconds(Work work) {
    using Clock = std::chrono::steady_clock;
    double best = 1e300, total = 0;
    for (int i = 0; i < 3 || total < 0.5; ++i) {
        const auto start = Clock::now();
        work();
        const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
        best = std::min(best, seconds);
        total += seconds;
        if (total > 20) break;
    }
    return best;
}

} // namespace

int bench_command(const Options& o) {
    const FrameSize size = parse_size(o.size);
    const Config config = load_config(o.config, o.set);
    check_rtl(config);
    check_outputs(o);
    const Scene scene = ready_scene(o, size, terminal_progress());
    build_rtl(config);
    double compile = best_seconds([&] { make_job(scene, *scene.camera, size, config); });
    const Job job = make_job(scene, *scene.camera, size, config);
    const FrameRun frame = run_model(job);
    std::vector<FrameTrace> traces;
    traces.push_back(record_frame(job, job.frame, o.threads));
    const double record = best_seconds([&] { record_frame(job, job.frame, o.threads); });
    const double again = best_seconds([&] { replay(config, job.khz, traces); });
    const double model = best_seconds([&] {
        std::vector<FrameTrace> fresh;
        record_and_replay(job, job.khz, fresh, {}, o.threads);
    });
    const double rtl = best_seconds([&] { run_rtl(job); });
    const Reference tracer(scene);
    const double reference = best_seconds([&] { tracer.frame(*scene.camera, size, 1); });

    const double cycles = double(frame.cycles), rays = double(frame.hits.hits.size());
    if (o.json != "-") {
        fmt::print("{}, {}x{}, configuration {}: {} cycles\n\n", scene.name, size.width, size.height, config.name, grouped(frame.cycles));
        Table table({"engine", "seconds", "M cycles/s", "M rays/s", "times the RTL"});
        const auto row = [&](const char* name, double s, bool clocked) {
            table.add({name, fmt::format("{:.3f}", s), clocked ? fmt::format("{:.2f}", cycles / s / 1e6) : "", fmt::format("{:.3f}", rays / s / 1e6),
                       fmt::format("{:.1f}", rtl / s)});
        };
        row("rtl", rtl, true);
        row("model", model, true);
        row("  rays recorded", record, false);
        row("  trace replayed", again, true);
        row("reference, 1 thread", reference, false);
        fmt::print("{}  scene compilation {:.2f} s\n", table.text(), compile);
    }
    if (!o.json.empty()) {
        const nlohmann::ordered_json json{
            {"scene", scene_json(scene)}, {"config", config_json_object(config)}, {"frame", {{"width", size.width}, {"height", size.height}}},
            {"cycles", frame.cycles}, {"rtl", {{"seconds", rtl}, {"cycles_per_second", cycles / rtl}}},
            {"model", {{"seconds", model}, {"cycles_per_second", cycles / model}, {"times_rtl", rtl / model}}},
            {"record", {{"seconds", record}, {"rays_per_second", rays / record}}},
            {"replay", {{"seconds", again}, {"cycles_per_second", cycles / again}, {"times_rtl", rtl / again}}},
            {"reference", {{"seconds", reference}, {"rays_per_second", rays / reference}}}, {"compile", {{"seconds", compile}}}};
        write_file(o.json, json.dump(2) + "\n");
    }
    return 0;
}

} // namespace rayclock

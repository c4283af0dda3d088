// rayclock simulate: cycles, frames per second, work and accounts of a frame.
#include <fmt/format.h>

#include "model/core/error.hpp"
#include "model/reference/reference.hpp"
#include "sim/app/commands.hpp"
#include "sim/app/tables.hpp"
#include "sim/report/text.hpp"

namespace rayclock {

int simulate_command(const Options& o) {
    const FrameSize size = parse_size(o.size);
    const std::vector<double> clocks = parse_clocks(o.clock);
    if (o.engine != "model" && o.engine != "rtl") throw UserError("--engine: '" + o.engine + "' is not model or rtl");
    const Config config = load_config(o.config, o.set);
    const Traffic traffic = traffic_of(o);
    check_outputs(o);
    const Progress progress = terminal_progress();
    const Scene scene = ready_scene(o, size, progress);
    const Job job = make_job(scene, *scene.camera, size, config, progress);
    const FrameRun run = o.engine == "model" ? run_model(job, traffic, progress) : run_rtl(job, traffic, progress, int(o.seed));
    std::optional<FrameError> error;
    if (!o.no_reference) error = frame_error(scene, run.hits, Reference(scene).frame(*scene.camera, size, o.threads, progress));

    if (o.json != "-") {
        fmt::print("{}\n{}\n{}\n{}", heading(scene, size, job), clock_table(run, clocks), work_table(run), unit_table(run));
        if (error) fmt::print("\n{}", error_line("against the reference", *error));
        fmt::print("  host: {:.2f} s, {:.2f} M cycles/s\n", run.seconds, double(run.cycles) / run.seconds / 1e6);
    }
    if (!o.json.empty()) {
        const nlohmann::ordered_json json{
            {"scene", scene_json(scene)}, {"config", config_json_object(config)}, {"frame", {{"width", size.width}, {"height", size.height}}},
            {"engine", o.engine}, {"compile", compile_json(job.image.report)},
            {"rays", {{"primary", run.hits.hits.size()}, {"shadow", 0}, {"reflection", 0}, {"refraction", 0}}},
            {"work", work_json(run)}, {"clocks", clocks_json(run, clocks)}, {"units", units_json(run)}, {"memory", memory_json(run)},
            {"error", error_json(error)},
            {"host", {{"seconds", run.seconds}, {"cycles_per_second", double(run.cycles) / run.seconds}, {"rays_per_second", double(run.hits.hits.size()) / run.seconds}}},
            {"digest", digest_text(run.digest)}};
        write_file(o.json, json.dump(2) + "\n");
    }
    return 0;
}

} // namespace rayclock

// rayclock rays: writes a stream of rays that a renderer would send.
#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"
#include "sim/app/options/commands.hpp"
#include "sim/app/options/options.hpp"
#include "sim/app/run/stream_run.hpp"
#include "sim/files/output.hpp"
#include "sim/files/process/stopping.hpp"
#include "sim/run/stream/make_rays.hpp"
#include "sim/view/report/tables.hpp"
#include "sim/view/report/text.hpp"

namespace rayclock {

namespace {

struct RaysOptions {
    std::string scene, size = "256x192", kind = "camera", order = "recorded", output;
    ConfigChoice config;
    ViewChoice view;
    int bounce = 1, samples = 1, threads = 0;
    std::optional<double> radius;
    std::uint64_t seed = default_seed;
    JsonOutput json;
};

void declare_rays(Parser& parser, RaysOptions& o) {
    scene_option(parser, o.scene).required();
    parser
        .option(
            "--kind", o.kind,
            "camera; shadow: to every light; mirror; ao: ambient occlusion; diffuse: cosine-weighted bounces")
        .with_default();
    parser.option("--bounce", o.bounce, "for mirror and diffuse: number of the bounce, 1 to 16")
        .with_default();
    parser.option("--samples", o.samples, "for ao and diffuse: rays from each hit, 1 to 1024").with_default();
    parser.option("--radius", o.radius,
                  "for ao: longest distance, in scene units; a tenth of the scene's diagonal if not given");
    parser.option("--order", o.order, "recorded: pixel by pixel; morton: by origin and direction; random")
        .with_default();
    parser.option("--seed", o.seed, "seed of random directions and of the random order").with_default();
    view_options(parser, o.view);
    size_option(parser, o.size);
    config_options(parser, o.config);
    threads_option(parser, o.threads);
    parser.option("-o,--output", o.output, ".npy file to write").required();
    json_option(parser, o.json);
}

int run_rays(const RaysOptions& o) {
    const RayStreamPlan plan =
        ray_stream_plan({o.kind, o.order, parse_size(o.size), o.bounce, o.samples, o.radius, o.seed}, "--");
    o.json.check();
    if (o.output == "-") throw UserError("--output must name a file, not standard output");
    if (o.output == o.json.path) throw UserError("--output and --json name the same file");
    check_writable(o.output);
    const Progress stop = stopping(terminal_progress());
    const Scene scene =
        stream_primitives(o.config) == Primitives::native
            ? ready_scene(load_noted_scene(o.scene, stop, Primitives::native), plan.size, o.view)
            : ready_scene(o.scene, plan.size, stop, o.view);
    std::vector<std::string> notes;
    const Config config = rays_config(o.config, scene, notes);
    print_ineffective(notes);
    const std::vector<StreamRay> rays = make_rays(scene, plan, config, o.threads, stop);
    write_bytes(o.output, rays_npy(rays, scene.name));
    if (!o.json.is_alone())
        fmt::print("{}: {} {} rays in {} order: {}\n", scene.name, grouped(rays.size()), o.kind, o.order,
                   printable(o.output));
    o.json.write({{"scene", scene_json(scene)},
                  {"kind", o.kind},
                  {"order", o.order},
                  {"rays", rays.size()},
                  {"file", o.output}});
    return 0;
}

}   // namespace

Command rays_command() {
    return command("rays", "write a stream of rays: shadow, mirror, ambient occlusion, bounces",
                   "rayclock rays gears:4 --kind diffuse -o rays.npy", declare_rays, run_rays);
}

}   // namespace rayclock

// rayclock render: a picture with one engine.

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"
#include "model/base/stopwatch.hpp"
#include "model/hits.hpp"
#include "model/reference/reference.hpp"
#include "sim/app/commands.hpp"
#include "sim/app/options.hpp"
#include "sim/engine/engine.hpp"
#include "sim/image/image.hpp"
#include "sim/report/json.hpp"
#include "sim/report/tables.hpp"
#include "sim/report/text.hpp"
#include "sim/rtl/stopping.hpp"

namespace rayclock {

namespace {

std::uint64_t digest_of(const HitFrame& frame) {
    Digest digest;
    for (const Hit& hit : frame.hits) {
        digest.add(hit.primitive);
        digest.add(std::uint64_t(std::llround(double(hit.depth) * (1 << 20))));
    }
    return digest.value();
}

struct Options {
    std::string scene, size = default_size, engine = "model", output;
    ConfigChoice config;
    Finish finish;
    ViewChoice view;
    int threads = 0;
    JsonOutput json;
};

void declare(Parser& parser, Options& o) {
    scene_option(parser, o.scene).required();
    finished_options(parser, o.finish);
    view_options(parser, o.view);
    size_option(parser, o.size);
    config_options(parser, o.config);
    parser.option("--engine", o.engine, "reference, model or rtl").with_default();
    parser.option("-o,--output", o.output, "picture to write: .png, or .exr with depth and primitive number")
        .required();
    threads_option(parser, o.threads);
    json_option(parser, o.json);
}

/// A picture, what its pixels hit, and what the report says of it.
struct Drawn {
    HitFrame hits;
    Picture picture;
    nlohmann::ordered_json json = nlohmann::ordered_json::object();
    double seconds = 0;   ///< without loading
};

Drawn draw_reference(const Request& request, FrameSize size, int threads, const Progress& progress) {
    const Scene& scene = request.scene;
    Drawn drawn;
    if (request.finished) {
        WhittedFrame frame =
            Reference(scene).whitted(*scene.camera, size, request.settings, threads, progress);
        drawn.picture = picture_of(frame);
        drawn.hits = std::move(frame.hits);
    } else {
        drawn.hits = Reference(scene).frame(*scene.camera, size, threads, progress);
        drawn.picture = shade(scene, drawn.hits, progress);
    }
    drawn.json["digest"] = digest_text(digest_of(drawn.hits));
    return drawn;
}

Drawn draw_machine(const Request& request, FrameSize size, bool is_rtl, const Progress& progress) {
    const Scene& scene = request.scene;
    const Job job = make_job(scene, *scene.camera, size, request.config, progress, request.settings);
    FrameRun run = is_rtl ? run_rtl(job, {}, progress) : run_model(job, {}, progress);
    Drawn drawn;
    drawn.picture = request.finished ? picture_of(size, run.colours) : shade(scene, run.hits, progress);
    drawn.hits = std::move(run.hits);
    drawn.json["config"] = config_json_object(request.config);
    drawn.json["cycles"] = run.cycles;
    drawn.json["digest"] = digest_text(run.digest);
    return drawn;
}

Drawn draw(const Options& o, FrameSize size, Scene& scene, const Progress& progress) {
    Request request = request_of(o.scene, o.config, o.finish, default_seed, size, progress, o.view);
    if (o.engine == "rtl") check_rtl(request.config);
    const Stopwatch watch;
    Drawn drawn = o.engine == "reference" ? draw_reference(request, size, o.threads, progress)
                                          : draw_machine(request, size, o.engine == "rtl", progress);
    drawn.seconds = watch.seconds();
    scene = std::move(request.scene);
    return drawn;
}

int run(const Options& o) {
    const FrameSize size = parse_size(o.size);
    if (o.engine != "reference" && o.engine != "model" && o.engine != "rtl")
        throw UserError("--engine: " + shown(o.engine) + " is not reference, model or rtl");
    check_picture_path(o.output);
    o.json.check();
    catch_interrupts();
    Scene scene;
    const Progress progress = stopping(terminal_progress());   // also for who waits for the file
    const Drawn drawn = draw(o, size, scene, progress);
    stop_if_interrupted();
    write_picture(o.output, drawn.picture, drawn.hits, interrupted);
    if (!o.json.is_alone())
        fmt::print("{}: {}, {}x{}, {} -> {}\n", scene.name, primitives_text(scene), size.width, size.height,
                   o.engine, printable(o.output));
    nlohmann::ordered_json json{{"scene", scene_json(scene)},
                                {"frame", {{"width", size.width}, {"height", size.height}}},
                                {"engine", o.engine}};
    json.update(drawn.json);
    json["host"] = {{"seconds", drawn.seconds}};
    o.json.write(json);
    return 0;
}

}   // namespace

Command render_command() {
    return command("render", "make a picture with one engine",
                   "rayclock render gears:4 --engine rtl -o gears.png", declare, run);
}

}   // namespace rayclock

// rayclock render: a picture with one engine.

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"
#include "model/base/stopwatch.hpp"
#include "model/hits.hpp"
#include "model/reference/reference.hpp"
#include "model/xform/picture.hpp"
#include "sim/app/commands.hpp"
#include "sim/app/options.hpp"
#include "sim/engine/engine.hpp"
#include "sim/image/image.hpp"
#include "sim/report/json.hpp"
#include "sim/report/tables.hpp"
#include "sim/report/text.hpp"
#include "sim/request/placed.hpp"

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
    int threads = 0, levels = 1;
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
    parser
        .option(
            "--levels", o.levels,
            "1: instances are written out as triangles; 2: a tree over instances, each mesh once (what the "
            "camera rays hit, by the model; cycles are not known yet)")
        .within(1, 2)
        .with_default();
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
        drawn.picture = shade(scene, drawn.hits);
    }
    drawn.json["digest"] = digest_text(digest_of(drawn.hits));
    return drawn;
}

Drawn draw_machine(const Request& request, FrameSize size, bool is_rtl, const Progress& progress) {
    const Scene& scene = request.scene;
    const Job job = make_job(scene, *scene.camera, size, request.config, progress, request.settings);
    FrameRun run = is_rtl ? run_rtl(job, {}, progress) : run_model(job, {}, progress);
    Drawn drawn;
    drawn.picture = request.finished ? picture_of(size, run.colours) : shade(scene, run.hits);
    drawn.hits = std::move(run.hits);
    drawn.json["config"] = config_json_object(request.config);
    drawn.json["cycles"] = run.cycles;
    drawn.json["digest"] = digest_text(run.digest);
    return drawn;
}

/// Two levels: what every camera ray does is there, when it does it is not.
Drawn draw_levels(const Options& o, FrameSize size, const Config& config, Scene& scene,
                  const Progress& progress) {
    const PlacedScene placed = told_placed(o.scene, progress);
    scene = flattened(placed);
    look(scene, size, o.view);
    const Stopwatch watch;
    const LevelsImage levels = compile_levels(placed, scene.camera->eye, config);
    const LevelsPicture picture = trace_levels(levels, *scene.camera, size, config, o.threads, progress);
    Drawn drawn;
    drawn.picture = shade(scene, picture.hits);
    drawn.hits = picture.hits;
    drawn.json["config"] = config_json_object(config);
    drawn.json["levels"] = {
        {"instances", levels.maps.instances.size()},   {"meshes", levels.maps.classes.size()},
        {"bytes", levels.image.report.bytes},          {"node_steps", picture.counts.visits},
        {"instances_entered", picture.counts.changes}, {"triangle_tests", picture.counts.tests}};
    drawn.json["digest"] = digest_text(rayclock::digest_of(picture.answers, 0));
    drawn.seconds = watch.seconds();
    return drawn;
}

/// The machine that walks two levels, or a sentence why there is none.
Config config_of_levels(const Options& o) {
    if (o.engine != "model")
        throw UserError("--levels 2 is drawn by --engine model only; the others see instances as triangles");
    if (o.finish.is_asked())
        throw UserError("--levels 2 draws what camera rays hit; a finished picture needs --levels 1");
    if (o.view.ground) throw UserError("--levels 2 has no ground to lay; --ground needs --levels 1");
    return load_config(o.config);
}

Drawn draw(const Options& o, FrameSize size, Scene& scene, const Progress& progress) {
    if (o.levels == 2) return draw_levels(o, size, config_of_levels(o), scene, progress);
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
    const Progress progress = terminal_progress();
    Scene scene;
    const Drawn drawn = draw(o, size, scene, progress);
    write_picture(o.output, drawn.picture, drawn.hits);
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

// rayclock render: a picture with one engine.
#include <chrono>

#include <fmt/format.h>

#include "model/core/error.hpp"
#include "model/core/quote.hpp"
#include "model/hits.hpp"
#include "model/reference/reference.hpp"
#include "sim/app/commands.hpp"
#include "sim/app/picture.hpp"
#include "sim/app/tables.hpp"
#include "sim/engine/engine.hpp"
#include "sim/image/image.hpp"
#include "sim/report/json.hpp"
#include "sim/report/text.hpp"

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

} // namespace

int render_command(const Options& o) {
    const FrameSize size = parse_size(o.size);
    if (o.engine != "reference" && o.engine != "model" && o.engine != "rtl")
        throw UserError("--engine: " + shown(o.engine) + " is not reference, model or rtl");
    check_picture_path(o.output);
    check_outputs(o);
    const Progress progress = terminal_progress();
    const Request request = request_of(o, size, progress);
    const Config& config = request.config;
    const Scene& scene = request.scene;
    if (o.engine == "rtl") check_rtl(config);

    const auto start = std::chrono::steady_clock::now();
    nlohmann::ordered_json json{{"scene", scene_json(scene)}, {"frame", {{"width", size.width}, {"height", size.height}}}, {"engine", o.engine}};
    HitFrame hits;
    Picture picture;
    if (o.engine == "reference" && request.finished) {
        WhittedFrame frame = Reference(scene).whitted(*scene.camera, size, request.settings, o.threads, progress);
        picture = picture_of(frame);
        hits = std::move(frame.hits);
        json["digest"] = digest_text(digest_of(hits));
    } else if (o.engine == "reference") {
        hits = Reference(scene).frame(*scene.camera, size, o.threads, progress);
        json["digest"] = digest_text(digest_of(hits));
    } else {
        const Job job = make_job(scene, *scene.camera, size, config, progress, request.settings);
        FrameRun run = o.engine == "model" ? run_model(job, {}, progress) : run_rtl(job, {}, progress);
        hits = std::move(run.hits);
        if (request.finished) picture = picture_of(size, run.colours);
        json["config"] = config_json_object(config);
        json["cycles"] = run.cycles;
        json["digest"] = digest_text(run.digest);
    }
    json["host"] = {{"seconds", std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count()}};
    if (picture.pixels.empty()) picture = shade(scene, hits);
    write_picture(o.output, picture, hits);
    if (o.json != "-") fmt::print("{}: {}, {}x{}, {} -> {}\n", scene.name, primitives_text(scene), size.width, size.height, o.engine, printable(o.output));
    if (!o.json.empty()) write_file(o.json, json.dump(2) + "\n");
    return 0;
}

} // namespace rayclock

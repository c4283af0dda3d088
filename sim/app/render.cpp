// rayclock render: renders a picture, or answers a stream of rays, with the reference, the model or the RTL.
#include <algorithm>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"
#include "model/base/stopwatch.hpp"
#include "model/trace/hits.hpp"
#include "sim/app/options/commands.hpp"
#include "sim/app/options/options.hpp"
#include "sim/app/parts/stream_commands.hpp"
#include "sim/app/run/film_strip.hpp"
#include "sim/app/run/picture_folder.hpp"
#include "sim/files/image/image.hpp"
#include "sim/files/process/stopping.hpp"
#include "sim/run/film/make_film.hpp"
#include "sim/run/frame/frame.hpp"
#include "sim/run/request/reference_picture.hpp"
#include "sim/run/request/tracer.hpp"
#include "sim/view/report/json.hpp"
#include "sim/view/report/tables.hpp"
#include "sim/view/report/text.hpp"

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

struct RenderOptions {
    std::string scene, size = default_size, tracer = name_of(Tracer::model), output;
    ConfigChoice config;
    Finish finish;
    ViewChoice view;
    FramesOptions frames;
    bool compare = false;
    LimitsChoice limits;
    StreamChoice stream;
    int threads = 0;
    JsonOutput json;
};

void declare_render(Parser& parser, RenderOptions& o) {
    scene_option(parser, o.scene).required();
    finished_options(parser, o.finish);
    view_options(parser, o.view);
    size_option(parser, o.size);
    config_options(parser, o.config);
    parser.option("--engine", o.tracer, "reference, model or rtl").with_default();
    frames_options(parser, o.frames);
    parser.option(
        "-o,--output", o.output,
        "picture to write: .png, or .exr with depth and primitive number; for several frames, a folder");
    parser.flag("--compare", o.compare, "compare the picture of the model or the RTL with the reference's");
    limits_options(parser, o.limits);
    threads_option(parser, o.threads);
    stream_options(parser, o.stream, true);
    json_option(parser, o.json);
}

/// Returns true if there may be several frames, which need a folder. Their number is known only after the
/// scene is loaded.
bool may_be_film(const RenderOptions& o) {
    return o.frames.frames > 1 || o.frames.time.find(':') != std::string::npos;
}

/// A picture, the hits of its pixels, and its part of the report.
struct RenderResult {
    HitFrame hits;
    Picture picture;
    nlohmann::ordered_json json = nlohmann::ordered_json::object();
    double seconds = 0;   ///< excludes loading
};

RenderResult draw_reference(const Request& request, FrameSize size, int threads, const Progress& progress) {
    ReferencePicture reference = reference_picture(request, *request.scene.camera, size, threads, progress);
    RenderResult drawn{std::move(reference.frame.hits), std::move(reference.picture)};
    drawn.json["digest"] = digest_text(digest_of(drawn.hits));
    return drawn;
}

/// Renders the current frame.
RenderResult draw_machine(const Request& request, const Job& job, Tracer tracer, const Progress& progress) {
    FrameResult run = tracer == Tracer::rtl ? run_rtl(job, {}, progress) : run_model(job, {}, progress);
    RenderResult drawn;
    drawn.picture = request.finished ? picture_from_colours(job.size, run.colours)
                                     : shade(request.scene, run.hits, progress);
    drawn.hits = std::move(run.hits);
    drawn.json["config"] = config_json_object(request.config);
    drawn.json["cycles"] = run.cycles;
    drawn.json["digest"] = digest_text(run.digest);
    return drawn;
}

RenderResult draw_next(Tracer tracer, Film& film, FrameSize size, int threads, const Progress& progress) {
    film.next();
    const Request& request = film.request();
    return tracer == Tracer::reference ? draw_reference(request, size, threads, progress)
                                       : draw_machine(request, film.job(), tracer, progress);
}

/// Errors of the pictures against the reference.
struct PictureComparison {
    std::vector<FrameError> errors;

    /// Returns the error with the least PSNR of all frames.
    std::optional<FrameError> error() const {
        const auto least =
            std::min_element(errors.begin(), errors.end(),
                             [](const FrameError& a, const FrameError& b) { return a.psnr_db < b.psnr_db; });
        return least == errors.end() ? std::nullopt : std::make_optional(*least);
    }
    void add(const RenderResult& drawn, const Request& request, FrameSize size, int threads,
             const Progress& progress) {
        const ReferencePicture reference =
            reference_picture(request, *request.scene.camera, size, threads, progress);
        errors.push_back(frame_error(drawn.hits, drawn.picture, reference.hits(), reference.picture));
    }
};

/// Renders numbered pictures, each as if it were the only one, and joins them to a film.
std::string draw_all(const RenderOptions& o, Tracer tracer, Film& film, FrameSize size,
                     const Progress& progress, PictureComparison& comparison, nlohmann::ordered_json& json) {
    nlohmann::ordered_json digests = nlohmann::ordered_json::array();
    StagedFiles staged(o.output);
    for (std::size_t f = 0; f < film.frames(); ++f) {
        const RenderResult drawn = draw_next(tracer, film, size, o.threads, progress);
        stop_if_interrupted();
        write_pictures(staged, {{frame_name(f), drawn.picture, drawn.hits}});
        digests.push_back(drawn.json.at("digest"));
        if (o.compare) comparison.add(drawn, film.request(), size, o.threads, progress);
    }
    json["digests"] = digests;
    return make_film(staged, o.output, film.frames(), film.times().fps);
}

/// Answers a stream of rays with one tracer. The answers have no timing.
int render_stream(const RenderOptions& o) {
    const Tracer tracer = parse_tracer(o.tracer);
    if (!o.stream.hits) throw UserError("--rays needs --hits, the .npy file for each ray's hit");
    check_hits(o.stream, o.json);
    o.json.check();
    const Progress progress = stopping(terminal_progress());
    const StreamRequest request = stream_request(o.scene, o.config, o.stream, progress);
    if (tracer == Tracer::rtl) check_rtl(request.config);
    const StreamInput& input = *request.input;
    const Stopwatch watch;
    const StreamAnswers traced = trace_stream(input, tracer, request.config, o.threads, progress);
    const std::vector<StreamHit>& answers = traced.hits;
    const double seconds = watch.seconds();
    stop_if_interrupted();
    print_ineffective(traced.notes);
    write_bytes(*o.stream.hits, hits_npy(answers, {}));
    const auto hits =
        std::count_if(answers.begin(), answers.end(), [](const StreamHit& hit) { return hit.hit; });
    if (!o.json.is_alone())
        fmt::print("{}: {}; {}: {} rays, {} hits, {} -> {}\n", input.scene().name,
                   primitives_text(input.scene()), printable(input.rays().name()), grouped(answers.size()),
                   grouped(std::uint64_t(hits)), o.tracer, printable(*o.stream.hits));
    o.json.write({{"scene", scene_json(input.scene())},
                  {"stream", {{"file", input.rays().name()}, {"rays", answers.size()}, {"hits", hits}}},
                  {"engine", o.tracer},
                  {"host", {{"seconds", seconds}}}});
    return 0;
}

int run_render(const RenderOptions& o) {
    if (traces_stream(o.stream, {.size = o.size,
                                 .finish = o.finish,
                                 .view = o.view,
                                 .frames = o.frames,
                                 .limits = o.limits,
                                 .own = {{!o.output.empty(), "--output"}, {o.compare, "--compare"}}}))
        return render_stream(o);
    if (o.output.empty()) throw UserError("--output is required ('rayclock render --help' tells more)");
    const FrameSize size = parse_size(o.size);
    const Tracer tracer = parse_tracer(o.tracer);
    if (o.compare && tracer == Tracer::reference)
        throw UserError("--compare needs --engine model or rtl: it compares with the reference");
    const Limits limits = limits_of(o.limits);
    o.json.check();
    const Progress progress = stopping(terminal_progress());   // shows progress also while the scene loads
    if (!may_be_film(o)) check_picture_path(o.output);
    Request request = request_of(o.scene, o.config, o.finish, default_seed, size, progress, o.view);
    if (tracer == Tracer::rtl) check_rtl(request.config);
    const Stopwatch watch;
    Film film(std::move(request), o.frames, o.view.is_given(), size, progress, tracer != Tracer::reference);
    const bool is_film = film.frames() > 1;
    if (is_film)
        check_film_folder(o.output, film.frames());
    else
        check_picture_path(o.output);
    nlohmann::ordered_json json = nlohmann::ordered_json::object();
    std::string said;
    PictureComparison comparison;
    if (is_film) {
        said = draw_all(o, tracer, film, size, progress, comparison, json);
    } else {
        const RenderResult drawn = draw_next(tracer, film, size, o.threads, progress);
        stop_if_interrupted();
        write_picture(o.output, drawn.picture, drawn.hits, interrupted);
        json = drawn.json;
        if (o.compare) comparison.add(drawn, film.request(), size, o.threads, progress);
    }
    const double seconds = watch.seconds();
    const Scene& scene = film.request().scene;
    const std::optional<FrameError> error = comparison.error();
    if (!o.json.is_alone()) {
        const std::string far = far_frames(limits, comparison.errors);
        fmt::print("{}{}: {}, {}x{}, {} -> {}\n{}{}", far.empty() ? "" : far + "\n", scene.name,
                   primitives_text(scene), size.width, size.height, o.tracer, printable(o.output),
                   said.empty() ? "" : "  " + said + "\n",
                   error ? error_line("against the reference", *error) : "");
    }
    nlohmann::ordered_json report{{"scene", scene_json(scene)},
                                  {"frame", {{"width", size.width}, {"height", size.height}}},
                                  {"engine", o.tracer}};
    report.update(json);
    if (error) {
        report["error"] = error_json(error, std::nullopt);
        report["limits"] = limits_json(limits, comparison.errors);
    }
    report["host"] = {{"seconds", seconds}};
    o.json.write(report);
    return 0;
}

}   // namespace

Command render_command() {
    return command("render", "draw a picture with the reference, the model or the RTL",
                   "rayclock render gears:4 --engine rtl -o gears.png", declare_render, run_render);
}

}   // namespace rayclock

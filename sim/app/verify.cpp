// rayclock verify: runs model and RTL in lockstep, and compares both with the reference and with the golden
// picture if there is one.
#include <cmath>
#include <filesystem>
#include <future>
#include <memory>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/interrupted.hpp"
#include "model/base/quote.hpp"
#include "model/base/stopwatch.hpp"
#include "model/scene/builtin.hpp"
#include "sim/app/options/command_line.hpp"
#include "sim/app/options/commands.hpp"
#include "sim/app/options/options.hpp"
#include "sim/app/parts/elastic.hpp"
#include "sim/app/parts/stream_commands.hpp"
#include "sim/app/run/film_strip.hpp"
#include "sim/app/run/picture_folder.hpp"
#include "sim/files/image/golden.hpp"
#include "sim/files/process/stopping.hpp"
#include "sim/judge/cause/finished.hpp"
#include "sim/run/film/choice.hpp"
#include "sim/run/request/reference_picture.hpp"
#include "sim/run/rtl/builder.hpp"
#include "sim/view/divergence/divergence.hpp"
#include "sim/view/observe/replay.hpp"
#include "sim/view/report/elastic.hpp"
#include "sim/view/report/limits.hpp"
#include "sim/view/report/lockstep.hpp"
#include "sim/view/report/tables.hpp"
#include "sim/view/report/text.hpp"

namespace rayclock {

namespace {

namespace fs = std::filesystem;

struct VerifyOptions {
    std::string scene, size = default_size, clock = default_clocks, output;
    ConfigChoice config;
    Finish finish;
    ViewChoice view;
    std::optional<std::string> pixels, cycles;   // a part of the picture
    FramesOptions frames;
    DisturbanceOptions disturbance;
    StreamChoice stream;
    LimitsChoice limits;
    ElasticChoice elastic;
    bool torture = false, no_judge = false, no_wave = false, netlist = false;
    int threads = 0;
    JsonOutput json;
};

void declare_verify(Parser& parser, VerifyOptions& o) {
    const DeclaredOption scene = scene_option(parser, o.scene);
    parser
        .flag("--torture", o.torture,
              "instead of a scene, run the torture set: small frames on seven chips that reach the corners "
              "of the machine")
        .excludes(scene);
    elastic_options(parser, o.elastic);
    finished_options(parser, o.finish);
    view_options(parser, o.view);
    size_option(parser, o.size);
    pixels_option(parser, o.pixels);
    parser.option(
        "--cycles", o.cycles,
        "draw only the part of the picture whose pixels are in the chip in these cycles of the whole "
        "picture, FIRST:LAST, LAST excluded");
    parser.option("--clock", o.clock, "clock rate in MHz; of several, the first").with_default();
    config_options(parser, o.config);
    frames_options(parser, o.frames);
    judge_option(parser, o.no_judge);
    limits_options(parser, o.limits);
    parser.option("-o,--output", o.output,
                  "folder for the pictures of reference, model and RTL and their difference");
    parser.flag("--no-wave", o.no_wave,
                "make no waveform and page of the first divergence; without this they are written to the "
                "folder of -o, or to the current one");
    parser.flag("--netlist", o.netlist,
                "simulate the cells of an ECP5 that Yosys makes of the RTL, and not the RTL itself; a chip "
                "takes some minutes to build, and no waveform is made");
    threads_option(parser, o.threads);
    disturbance_options(parser, o.disturbance);
    stream_options(parser, o.stream, true);
    json_option(parser, o.json);
}

/// Compares with the golden picture, which has its own size. The model renders a frame of that size for it.
GoldenResult golden_result(const std::string& spec, const Scene& scene, const Config& config) {
    const std::string folder = std::string(RAYCLOCK_SOURCE_DIR) + "/tests/golden";
    const FrameSize size{128, 96};
    // A built-in scene's name includes its size, even if none was typed.
    if (!is_builtin(spec) || !fs::exists(golden_path(folder, scene.name, size))) return {};
    const Job job = make_job(scene, *scene.camera, size, config);
    return check_golden(folder, scene.name, shade(scene, run_model(job).hits), config.coord_bits);
}

/// Returns the smallest rectangle with all pixels that are in the chip in these cycles of the film's last
/// frame. The film draws the whole picture.
PixelRect pixels_of_cycles(const VerifyOptions& o, Film film, CycleRange range, int khz,
                           Disturbance disturbance, const Progress& progress) {
    std::vector<RecordedFrame> traces;
    record_film(film, {.threads = o.threads}, stopping(progress), traces);
    const FrameCosts costs = observe(film.request().config, khz, traces, disturbance, 0, nullptr, progress);
    if (costs.partial) throw Interrupted("interrupted: nothing was compared");
    if (range.first >= costs.cycles)
        throw UserError(fmt::format("--cycles: the frame ends after {} cycles, before {} begins",
                                    costs.cycles, shown(*o.cycles)));
    const PixelRect rect = costs.pixels_in(range.first, range.last);
    if (rect.size.width == 0)
        throw UserError(fmt::format("--cycles: no pixel is in the chip in the cycles {}", shown(*o.cycles)));
    return rect;
}

/// The pictures of reference, model and RTL.
struct Pictures {
    ReferencePicture reference;
    Picture model, rtl;
};

/// The input of a verification: the frames of a film; the last frame is judged.
struct VerifyPlan {
    Film& film;
    FrameSize size;
    int khz;
    const Request& request() const { return film.request(); }
    Job job() const {
        Job job = film.job();
        job.khz = khz;
        return job;
    }
};

/// The results of a verification.
struct VerifyResult {
    Job job;   ///< job of the last frame
    std::vector<RecordedFrame> traces;
    FilmStrip strip;
    LockstepResult result;   ///< in an elastic verification without counters and cycle gap
    std::optional<ElasticResult> elastic;
    Pictures pictures;
    FrameError model, rtl;   ///< errors against the reference
    std::optional<Judgement> judgement;
    Picture difference;   ///< picture of the judgement
    GoldenResult golden;
    /// Seconds on the host since the command started: when the first divergence was found, and when its
    /// waveform was written.
    std::optional<double> divergence_seconds, waveform_seconds;
    std::unique_ptr<DivergenceShow> show;   ///< of the first divergence
    std::string no_show;                    ///< the reason why there is none

    std::vector<NamedPicture> named_pictures() const {
        const HitFrame& hits = pictures.reference.hits();
        std::vector<NamedPicture> all{{"reference.png", pictures.reference.picture, hits},
                                      {"model.png", pictures.model, result.model.hits},
                                      {"rtl.png", pictures.rtl, result.rtl.hits}};
        if (judgement) all.push_back({"difference.png", difference, hits});
        return all;
    }
    bool partial() const { return result.model.partial; }
    /// If model and RTL agree, results of one hold for both.
    const FrameResult& judged() const { return result.agrees() ? result.model : result.rtl; }
    const FrameError& error() const { return result.agrees() ? model : rtl; }
    /// Returns the errors of all compared frames; those of earlier frames are the model's.
    std::vector<FrameError> errors() const { return all_errors(strip, error()); }
    bool is_good(const Config& config) const {
        return result.agrees() && !partial() && (!judgement || judgement->wrong_for(config) == 0) &&
               (!golden.found || golden.within);
    }
};

DivergedRun diverged(const VerifyOptions& o, const VerifyPlan& work, Disturbance disturbance,
                     const VerifyResult& v, const Divergence& first) {
    return {.job = v.job,
            .frames = v.traces,
            .disturbance = disturbance,
            .seed = int(o.disturbance.seed),
            .first = first,
            .scene = work.request().scene.name,
            .command = command_line(),
            .is_elastic = o.elastic.is_given()};
}

/// Repeats diverging machines to record a waveform, before they continue. An error here must not hide the
/// divergence.
void capture_first(const VerifyOptions& o, const DivergedRun& diverged, VerifyResult& v,
                   const Progress& progress) {
    if (o.no_wave || o.netlist || interrupted()) return;
    try {
        v.show = std::make_unique<DivergenceShow>(diverged, o.output.empty() ? "." : o.output, progress);
    } catch (const std::exception& error) {
        v.no_show = error.what();
    }
}

/// Runs the frames on both machines, and renders the reference's picture.
VerifyResult run_machines(const VerifyOptions& o, const VerifyPlan& work, Disturbance disturbance,
                          const Stopwatch& watch, const Progress& progress) {
    VerifyResult v;
    v.strip = record_film(work.film, {.threads = o.threads, .folder = o.output, .compares = true},
                          stopping(progress), v.traces);
    const Request& request = work.request();
    // The lockstep has one thread: the reference works at the same time, and Ctrl-C ends both.
    auto reference = std::async(std::launch::async, [&] {
        return reference_picture(request, work.film.camera(), work.size, o.threads, stopping({}));
    });
    v.job = work.job();
    if (o.elastic.is_given()) {
        v.elastic = run_elastic(v.job, v.traces, parse_free_units(*o.elastic.units, v.job.config),
                                disturbance, progress, int(o.disturbance.seed));
        v.result = as_lockstep(*v.elastic);
        if (v.result.first) {
            v.divergence_seconds = watch.seconds();
            capture_first(o, diverged(o, work, disturbance, v, *v.result.first), v, progress);
            if (v.show) v.waveform_seconds = watch.seconds();
        }
        v.pictures.reference = reference.get();
        return v;
    }
    v.result = run_lockstep(v.job, v.traces, disturbance, progress, int(o.disturbance.seed),
                            [&](const Divergence& first) {
                                v.divergence_seconds = watch.seconds();
                                capture_first(o, diverged(o, work, disturbance, v, first), v, progress);
                                if (v.show) v.waveform_seconds = watch.seconds();
                            });
    v.pictures.reference = reference.get();
    return v;
}

/// Writes the page of the first divergence. Returns the paths of its files as text.
std::string show_first_divergence(const VerifyOptions& o, const VerifyPlan& work, Disturbance disturbance,
                                  VerifyResult& v) {
    if (!v.result.first) return {};
    if (!v.no_show.empty()) return fmt::format("    no waveform: {}\n", printable(v.no_show));
    if (!v.show) return {};
    try {
        const DivergenceFiles files = v.show->page(diverged(o, work, disturbance, v, *v.result.first));
        v.result.first->wave = files.wave;
        return fmt::format("    waveform: gtkwave {}\n{}{}", printable(files.view),
                           files.page.empty() ? "" : fmt::format("    page: {}\n", printable(files.page)),
                           files.note.empty() ? "" : "    " + files.note + "\n");
    } catch (const std::exception& error) {
        return fmt::format("    no page: {}\n", printable(error.what()));
    }
}

Picture drawn(const VerifyPlan& work, const FrameResult& made) {
    return work.request().finished ? picture_from_colours(work.size, made.colours)
                                   : shade(work.request().scene, made.hits);
}

/// Compares the machines' pictures with the reference and the golden picture, and judges their answers.
void compare_machines(VerifyResult& v, const VerifyOptions& o, const VerifyPlan& work,
                      const Progress& progress) {
    const Scene& scene = work.request().scene;
    Pictures& p = v.pictures;
    p.model = drawn(work, v.result.model), p.rtl = drawn(work, v.result.rtl);
    const HitFrame& hits = p.reference.hits();
    v.model = frame_error(v.result.model.hits, p.model, hits, p.reference.picture);
    v.rtl = frame_error(v.result.rtl.hits, p.rtl, hits, p.reference.picture);
    const FrameResult& judged = v.judged();
    const FrameInputs inputs{scene, work.film.camera(), v.traces.back().frame, v.job.image.lattice,
                             work.request().config};
    const bool judges = !v.partial() && !o.no_judge;
    if (judges && !work.request().finished)
        v.judgement = judge(inputs, v.job.image, {hits, judged.answers, shade(scene, judged.hits)}, o.threads,
                            progress);
    const MachineOutput given{judged.answers, judged.colours, v.traces.back().trace.signatures};
    if (judges && work.request().finished)
        v.judgement =
            judge_finished(inputs, v.job.image, work.request().settings,
                           {p.reference.frame, drawn(work, judged), given}, judged.hits, o.threads, progress);
    if (v.judgement) v.difference = cause_picture(p.reference.picture, *v.judgement);
    if (!work.request().finished && !o.view.is_given() && !work.film.camera().window)
        v.golden = golden_result(o.scene, scene, work.request().config);
}

void print(const VerifyOptions& o, const VerifyPlan& work, const VerifyResult& v,
           const std::string& wave_lines) {
    const Config& config = work.request().config;
    const FramesAtClock run{work.khz, {v.result.model}};
    fmt::print("{}\n{}\n{}\n{}\n", heading(work.request().scene, work.size, v.job),
               clock_table(config, {run}), work_table(config, run), unit_table(config, {run}));
    fmt::print("{}", film_table(config, {{work.khz, v.result.runs}}, v.strip, v.traces));
    if (o.netlist) fmt::print("  below, RTL means the netlist of an ECP5 that Yosys makes of it\n");
    fmt::print("{}{}", v.elastic ? elastic_lines(config, work.khz, *v.elastic) : lockstep_lines(v.result),
               wave_lines);
    fmt::print("{}", error_line("model against reference", v.model));
    if (!v.result.agrees()) fmt::print("{}", error_line("RTL against reference", v.rtl));
    if (v.judgement) fmt::print("{}", cause_lines(*v.judgement));
    if (v.golden.found)
        fmt::print(
            "  golden picture: {}, {}\n",
            std::isfinite(v.golden.psnr_db) ? fmt::format("PSNR {:.1f} dB", v.golden.psnr_db) : "equal",
            v.golden.within ? "within bounds" : "OUT OF BOUNDS");
    if (!o.output.empty()) fmt::print("  pictures: {}\n", picture_paths(o.output, v.named_pictures()));
}

nlohmann::ordered_json seconds_or_null(const std::optional<double>& seconds) {
    return seconds ? nlohmann::ordered_json(*seconds) : nlohmann::ordered_json(nullptr);
}

nlohmann::ordered_json json_of(const VerifyOptions& o, const VerifyPlan& work, const VerifyResult& v,
                               const Limits& limits, double seconds) {
    const Config& config = work.request().config;
    const LockstepResult& result = v.result;
    const FrameResult& frame = result.model;
    nlohmann::ordered_json golden;
    if (v.golden.found) golden = {{"psnr_db", decibel(v.golden.psnr_db)}, {"within", v.golden.within}};
    return {{"scene", scene_json(work.request().scene)},
            {"config", config_json_object(config)},
            {"camera", camera_json(work.film.camera())},
            {"frame", {{"width", work.size.width}, {"height", work.size.height}}},
            {"compile", compile_json(v.job.image.report)},
            {"partial", v.partial()},
            {"netlist", o.netlist},
            {"pixels", v.model.pixels},
            {"events_compared", result.events_compared},
            {"value_mismatches", result.value_mismatches},
            {"account_mismatches", result.account_mismatches},
            {"cycle_gap", v.elastic ? cycle_gap_of(*v.elastic) : result.cycle_gap},
            {"elastic", v.elastic ? elastic_json(config, work.khz, *o.elastic.units, *v.elastic) : nullptr},
            {"first_divergence", divergence_json(result.first)},
            {"counters_compared", result.counters_compared},
            {"first_counter", counter_json(result.counter)},
            {"reference", error_json(v.model, v.judgement)},
            {"limits", v.partial() ? nullptr : limits_json(limits, v.errors())},
            {"judge", judge_json(v.judgement)},
            {"golden", golden},
            {"rays", rays_json(frame.rays)},
            {"work", work_json(frame)},
            {"film", film_json(config, {{work.khz, result.runs}}, v.strip, v.traces)},
            {"clocks", nlohmann::ordered_json::array({clock_json(config, {work.khz, {frame}})})},
            {"units", units_json(config, frame)},
            {"memory", memory_json(config, work.khz, frame)},
            {"host",
             {{"seconds", seconds},
              {"judge_seconds", v.judgement ? v.judgement->seconds : 0},
              {"divergence_seconds", seconds_or_null(v.divergence_seconds)},
              {"waveform_seconds", seconds_or_null(v.waveform_seconds)}}},
            {"digest", digest_text(frame.digest)}};
}

/// Throws UserError if an option was given that has no meaning for the torture set, or for one unit alone.
void check_options(const VerifyOptions& o) {
    if (o.torture && (o.pixels || o.cycles))
        throw UserError(fmt::format("--torture runs frames of its own, so {} has no meaning here",
                                    o.pixels ? "--pixels" : "--cycles"));
    if (o.torture && (o.elastic.is_given() || o.elastic.alone))
        throw UserError(fmt::format("--torture runs in lockstep, so {} has no meaning here",
                                    o.elastic.alone ? "--unit-only" : "--elastic"));
    if (o.elastic.alone)
        refuse_with_unit_only(o.elastic.is_given()       ? "--elastic"
                              : o.stream.rays            ? "--rays"
                              : o.netlist                ? "--netlist"
                              : !o.output.empty()        ? "--output"
                              : o.no_wave                ? "--no-wave"
                              : o.frames.is_given()      ? "an option for several frames"
                              : o.pixels                 ? "--pixels"
                              : o.cycles                 ? "--cycles"
                              : o.disturbance.jitter > 0 ? "--jitter"
                              : o.disturbance.stall > 0  ? "--stall"
                                                         : nullptr);
}

/// Returns true if a stream of rays takes the place of a camera. Throws UserError if an option was given that
/// has no meaning for it.
bool verifies_stream(const VerifyOptions& o) {
    return traces_stream(o.stream, {.size = o.size,
                                    .finish = o.finish,
                                    .view = o.view,
                                    .frames = o.frames,
                                    .limits = o.limits,
                                    .own = {{!o.output.empty(), "--output"},
                                            {o.torture, "--torture"},
                                            {bool(o.elastic.alone), "--unit-only"},
                                            {o.netlist, "--netlist"},
                                            {o.no_wave, "--no-wave"},
                                            {o.pixels.has_value(), "--pixels"},
                                            {o.cycles.has_value(), "--cycles"}}});
}

void require_scene(const VerifyOptions& o) {
    if (o.scene.empty()) throw UserError("SCENE is required ('rayclock verify --help' tells more)");
}

/// Throws UserError unless the folder of `-o` can take what the command will write.
void check_folder(const VerifyOptions& o) {
    if (o.output.empty()) return;
    check_picture_folder(o.output, {"reference.png", "model.png", "rtl.png", "difference.png"});
    if (!o.no_wave) check_divergence_folder(o.output);
}
void check_folder(const VerifyOptions& o, const Film& film) {
    if (!o.output.empty() && film.frames() > 1 && film.moves()) check_film_folder(o.output, film.frames());
}

/// Prints and writes the result. Returns the exit code.
int report(const VerifyOptions& o, const VerifyPlan& work, const VerifyResult& verified, const Limits& limits,
           const std::string& wave_lines, double seconds) {
    const std::string far = verified.partial() ? "" : far_frames(limits, verified.errors());
    const bool agrees = verified.is_good(work.request().config), good = agrees && far.empty();
    if (!o.json.is_alone()) {
        if (!far.empty()) fmt::print("{}\n", far);
        print(o, work, verified, wave_lines);
        fmt::print("  {} in {:.1f} s\n",
                   good                 ? "VERIFIED"
                   : verified.partial() ? "PARTIAL: interrupted"
                   : agrees             ? "FAILED: model and RTL agree, and are far from the reference"
                                        : "FAILED",
                   seconds);
    }
    o.json.write(json_of(o, work, verified, limits, seconds));
    return good ? 0 : 1;
}

/// Verifies the frames of a camera.
int verify_frames(VerifyOptions o) {
    require_scene(o);
    const Stopwatch watch;
    if (o.pixels && o.cycles)
        throw UserError("--pixels and --cycles both choose a part of the picture: give one");
    const CycleRange cycles = o.cycles ? parse_cycles(*o.cycles) : CycleRange{};
    ViewChoice view = o.view;
    FrameSize size = parse_part(o.size, o.pixels, view);
    const std::vector<int> clocks = parse_clocks(o.clock);
    const Disturbance disturbance = disturbance_of(o.disturbance);
    o.json.check();
    const Limits limits = limits_of(o.limits);
    const Progress progress = terminal_progress();
    const Progress stop = stopping(progress);
    Request request = request_of(o.scene, o.config, o.finish, o.disturbance.seed, size, stop, view);
    check_rtl(request.config);
    if (o.elastic.is_given())
        parse_free_units(*o.elastic.units, request.config);   // refuses a wrong list early
    check_folder(o);
    o.frames = settled_frames(o.frames, request.scene);
    if (o.cycles) {
        Film whole(request, o.frames, o.view.is_given(), size, stop);
        check_folder(o, whole);
        const PixelRect rect =
            pixels_of_cycles(o, std::move(whole), cycles, clocks[0], disturbance, progress);
        request.scene.camera->window = PictureWindow{rect.x, rect.y, size.width, size.height};
        size = rect.size;
    }
    Film film(std::move(request), o.frames, o.view.is_given(), size, stop);
    if (o.elastic.alone)
        return verify_unit_alone(o.elastic, film, o.threads, int(o.disturbance.seed), o.json);
    check_folder(o, film);
    const VerifyPlan work{film, size, clocks[0]};
    VerifyResult verified = run_machines(o, work, disturbance, watch, progress);
    const std::string wave_lines = show_first_divergence(o, work, disturbance, verified);
    compare_machines(verified, o, work, verified.partial() ? progress : stop);
    if (!o.output.empty()) {
        finish_film(verified.strip, o.json.is_alone());   // on failure all earlier files stay
        write_pictures(o.output, verified.named_pictures());
    }
    return report(o, work, verified, limits, wave_lines, watch.seconds());
}

int run_verify(const VerifyOptions& typed) {
    VerifyOptions o = typed;
    take_elastic(o.elastic, o.scene);
    check_options(o);
    if (verifies_stream(o)) {
        require_scene(o);
        return verify_stream({.scene = o.scene,
                              .clock = o.clock,
                              .config = o.config,
                              .stream = o.stream,
                              .disturbance = o.disturbance,
                              .no_judge = o.no_judge,
                              .threads = o.threads,
                              .json = o.json,
                              .elastic = o.elastic.units});
    }
    if (o.netlist) build_netlists();
    return o.torture ? run_torture_set(o.json) : verify_frames(std::move(o));
}

}   // namespace

Command verify_command() {
    return command("verify", "run model and RTL in lockstep, and compare both with the reference",
                   "rayclock verify teapot:12 -o out", declare_verify, run_verify);
}

}   // namespace rayclock

// rayclock verify: model and RTL in lockstep, both against the reference, and the golden picture if there is one.
#include <chrono>
#include <cmath>
#include <filesystem>
#include <future>

#include <fmt/format.h>

#include "model/core/error.hpp"
#include "model/core/quote.hpp"
#include "model/reference/reference.hpp"
#include "model/scene/builtin.hpp"
#include "sim/app/commands.hpp"
#include "sim/app/limits.hpp"
#include "sim/app/picture.hpp"
#include "sim/app/tables.hpp"
#include "sim/cause/finished.hpp"
#include "sim/image/golden.hpp"
#include "sim/report/lockstep.hpp"
#include "sim/report/text.hpp"

namespace rayclock {

namespace {

namespace fs = std::filesystem;

/// Fails early if the pictures could not be written later. Makes nothing: the work may still fail.
void check_folder(const std::string& folder) {
    std::error_code error;
    if (fs::exists(folder, error) && !fs::is_directory(folder, error)) throw UserError(folder + ": is a file, not a folder for pictures");
    fs::path there = fs::absolute(folder);
    while (!fs::exists(there, error) && there.has_relative_path()) there = there.parent_path();
    for (const char* name : {"reference.png", "model.png", "rtl.png", "difference.png"}) check_writable((there / name).string());
}

/// The golden picture of the scene is of one size of its own; the model makes that frame for it.
GoldenResult golden_result(const Options& o, const Scene& scene, const Config& config) {
    const std::string folder = std::string(RAYCLOCK_SOURCE_DIR) + "/tests/golden";
    const FrameSize size{128, 96};
    // A built-in scene's name has its size in it, also where none was typed.
    if (!is_builtin(o.scene) || !fs::exists(golden_path(folder, scene.name, size))) return {};
    const Job job = make_job(scene, *scene.camera, size, config);
    return check_golden(folder, scene.name, shade(scene, run_model(job).hits), config.coord_bits);
}

/// What the engines drew.
struct Pictures {
    HitFrame hits;                           ///< the reference's
    Picture reference, model, rtl;
    WhittedFrame finished;                   ///< the reference's, of a finished picture
};

/// The lockstep has one thread: the reference works beside it.
Pictures draw_reference(const Request& request, const Camera& camera, FrameSize size, int threads) {
    const Reference tracer(request.scene);
    if (!request.finished) {
        HitFrame hits = tracer.frame(camera, size, threads);
        Picture picture = shade(request.scene, hits);
        return {std::move(hits), std::move(picture), {}, {}, {}};
    }
    WhittedFrame frame = tracer.whitted(camera, size, request.settings, threads);
    Picture picture = picture_of(frame);
    HitFrame hits = frame.hits;
    return {std::move(hits), std::move(picture), {}, {}, std::move(frame)};
}

void write_pictures(const std::string& folder, const Pictures& p, const LockstepResult& result, const std::optional<Judgement>& judgement) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) throw UserError(folder + ": cannot be made (" + error.message() + ")");
    const auto path = [&](const char* name) { return (fs::path(folder) / name).string(); };
    write_picture(path("reference.png"), p.reference, p.hits);
    write_picture(path("model.png"), p.model, result.model.hits);
    write_picture(path("rtl.png"), p.rtl, result.rtl.hits);
    if (judgement) write_picture(path("difference.png"), cause_picture(p.reference, *judgement), p.hits);
}

} // namespace

int verify_command(const Options& o) {
    if (o.torture) return torture_command(o);
    if (o.scene.empty()) throw UserError("SCENE is required ('rayclock verify --help' tells more)");
    const auto start = std::chrono::steady_clock::now();
    catch_interrupts();
    const FrameSize size = parse_size(o.size);
    const std::vector<int> clocks = parse_clocks(o.clock);
    const Traffic traffic = traffic_of(o);
    check_outputs(o);
    const Limits limits = limits_of(o);
    const Progress progress = terminal_progress();
    const Request request = request_of(o, size, progress);
    const Config& config = request.config;
    const Scene& scene = request.scene;
    check_rtl(config);
    if (!o.output.empty()) check_folder(o.output);
    const std::vector<Camera> path = camera_path(o, *scene.camera);
    Job job = make_job(scene, path[0], size, config, progress, request.settings);
    job.khz = clocks[0];
    std::vector<FrameTrace> traces;
    for (const Camera& camera : path) traces.push_back(record_frame(job, job_frame(job, camera), o.threads, progress));

    auto reference_work = std::async(std::launch::async, [&] { return draw_reference(request, path.back(), size, o.threads); });
    const LockstepResult result = run_lockstep(job, traces, traffic, progress, int(o.seed));
    const ClockRun run{job.khz, {result.model}};
    Pictures pictures = reference_work.get();
    const HitFrame& reference = pictures.hits;
    const auto drawn = [&](const FrameRun& made) { return request.finished ? picture_of(size, made.colours) : shade(scene, made.hits); };
    pictures.model = drawn(result.model), pictures.rtl = drawn(result.rtl);
    const FrameError model = frame_error(result.model.hits, pictures.model, reference, pictures.reference),
                     rtl = frame_error(result.rtl.hits, pictures.rtl, reference, pictures.reference);
    // If the RTL is the model, what is said of one holds for both.
    const FrameRun& judged = result.agrees() ? result.model : result.rtl;
    const Asked asked{scene, path.back(), traces.back().frame, job.image.lattice, config};
    std::optional<Judgement> judgement;
    const bool judges = !result.model.partial && !o.no_judge;
    if (judges && !request.finished) judgement = judge(asked, {reference, judged.answers, shade(scene, judged.hits)}, o.threads, progress);
    const Given given{judged.answers, judged.colours, traces.back().trace.signatures};
    if (judges && request.finished)
        judgement = judge_finished(asked, job.image, request.settings, {pictures.finished, drawn(judged), given}, judged.hits, o.threads, progress);
    const GoldenResult golden = request.finished ? GoldenResult{} : golden_result(o, scene, config);
    if (!o.output.empty()) write_pictures(o.output, pictures, result, judgement);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const bool partial = result.model.partial;
    const FrameError& error = result.agrees() ? model : rtl;
    const std::string beyond = partial ? "" : beyond_limits(limits, error);
    const bool good = (beyond.empty() || !limits.fails) && result.agrees() && !partial && (!judgement || judgement->wrong_for(config) == 0) && (!golden.found || golden.within);

    if (o.json != "-") {
        fmt::print("{}\n{}\n{}\n{}\n", heading(scene, size, job), clock_table(config, {run}), work_table(config, run), unit_table(config, {run}));
        fmt::print("{}", lockstep_lines(result));
        fmt::print("{}", error_line("model against reference", model));
        if (!result.agrees()) fmt::print("{}", error_line("RTL against reference", rtl));
        if (judgement) fmt::print("{}", cause_lines(*judgement));
        if (golden.found) fmt::print("  golden picture: {}, {}\n", std::isfinite(golden.psnr_db) ? fmt::format("PSNR {:.1f} dB", golden.psnr_db) : "equal", golden.within ? "within bounds" : "OUT OF BOUNDS");
        if (!o.output.empty()) fmt::print("  pictures: {0}/reference.png {0}/model.png {0}/rtl.png {0}/difference.png\n", printable(o.output));
        fmt::print("{}  {} in {:.1f} s\n", beyond, good ? (beyond.empty() ? "VERIFIED" : "VERIFIED, but far from the reference") : partial ? "PARTIAL: interrupted" : "FAILED", seconds);
    }
    if (!o.json.empty()) {
        const nlohmann::ordered_json json{
            {"scene", scene_json(scene)}, {"config", config_json_object(config)}, {"frame", {{"width", size.width}, {"height", size.height}}},
            {"compile", compile_json(job.image.report)}, {"partial", partial}, {"pixels", model.pixels}, {"events_compared", result.events_compared},
            {"value_mismatches", result.value_mismatches}, {"account_mismatches", result.account_mismatches}, {"cycle_gap", result.cycle_gap}, {"first_divergence", divergence_json(result.first)},
            {"counters_compared", result.counters_compared}, {"first_counter", counter_json(result.counter)},
            {"reference", error_json(model, judgement)}, {"limits", limits_json(limits, error)}, {"judge", judge_json(judgement)},
            {"golden", golden.found ? nlohmann::ordered_json{{"psnr_db", decibel(golden.psnr_db)}, {"within", golden.within}} : nlohmann::ordered_json(nullptr)},
            {"rays", rays_json(result.model)}, {"work", work_json(result.model)}, {"clocks", nlohmann::ordered_json::array({clock_json(config, run)})}, {"units", units_json(config, result.model)},
            {"memory", memory_json(config, job.khz, result.model)},
            {"host", {{"seconds", seconds}, {"judge_seconds", judgement ? judgement->seconds : 0}}}, {"digest", digest_text(result.model.digest)}};
        write_file(o.json, json.dump(2) + "\n");
    }
    return good ? 0 : 1;
}

} // namespace rayclock

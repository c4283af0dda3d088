// simulate and verify with a stream of rays in place of a camera.
#include "sim/app/parts/stream_commands.hpp"

#include <memory>
#include <utility>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"
#include "model/base/stopwatch.hpp"
#include "sim/app/parts/elastic.hpp"
#include "sim/app/run/clock.hpp"
#include "sim/app/run/stream_run.hpp"
#include "sim/files/output.hpp"
#include "sim/files/process/stopping.hpp"
#include "sim/run/lockstep/lockstep.hpp"
#include "sim/run/request/request.hpp"
#include "sim/view/report/elastic.hpp"
#include "sim/view/report/lockstep.hpp"
#include "sim/view/report/tables.hpp"
#include "sim/view/report/text.hpp"

namespace rayclock {

void stream_options(Parser& parser, StreamChoice& choice, bool with_hits) {
    parser.option("--rays", choice.rays,
                  "trace the rays of a file in place of a camera's: .npy (n x 6 to 9) or AnyDSL's .rays");
    treatment_options(parser, choice);
    if (with_hits)
        parser.option("--hits", choice.hits, "with --rays: .npy file for each ray's hit and its cycle");
}

void treatment_options(Parser& parser, StreamChoice& choice) {
    parser.flag("--any-hit", choice.any_hit, "with --rays: every ray requests any hit, not the closest");
    parser
        .option("--outside", choice.outside,
                "with --rays: clip or refuse rays that begin outside the lattice")
        .with_default();
}

PictureOptions no_picture_options(std::vector<PictureOptions::Own> own) {
    static const std::string size = default_size;
    static const Finish finish;
    static const ViewChoice view;
    static const FramesOptions frames;
    static const LimitsChoice limits;
    return {.size = size,
            .finish = finish,
            .view = view,
            .frames = frames,
            .limits = limits,
            .own = std::move(own)};
}

bool traces_stream(const StreamChoice& choice, const PictureOptions& picture) {
    if (!choice.rays) {
        const char* option = choice.any_hit                             ? "--any-hit"
                             : choice.hits                              ? "--hits"
                             : choice.outside != StreamChoice{}.outside ? "--outside"
                                                                        : nullptr;
        if (option) throw UserError(fmt::format("{} needs --rays, a stream of rays", option));
        return false;
    }
    const auto& [size, finish, view, frames, limits, own] = picture;
    const char* odd = size != default_size ? "--size"
                      : finish.is_given()  ? "--depth, --aa or another option of finished pictures"
                      : view.is_given()    ? "an option of the camera"
                      : view.ground        ? "--ground"
                      : view.material      ? "--material"
                      : frames.is_given()  ? "an option for several frames"
                      : limits.max_other || limits.max_depth_error || limits.min_psnr ? "a limit of errors"
                                                                                      : nullptr;
    for (const PictureOptions::Own& option : own)
        if (!odd && option.is_given) odd = option.name;
    if (odd)
        throw UserError(fmt::format("--rays takes the place of a camera, so {} has no meaning here", odd));
    return true;
}

StreamRequest stream_request(const std::string& scene, const ConfigChoice& choice, const StreamChoice& stream,
                             const Progress& progress) {
    std::vector<std::string> notes;
    StreamRequest request;
    request.input = stream_input(scene, choice, stream, progress);
    request.config = stream_config(choice, request.input->scene(), notes);
    print_ineffective(notes);
    return request;
}

std::unique_ptr<const StreamInput> stream_input(const std::string& scene, const ConfigChoice& config,
                                                const StreamChoice& stream, const Progress& progress) {
    const Outside outside = parse_outside(stream.outside);
    const Primitives primitives = stream_primitives(config);
    auto rays = std::make_unique<const RayFile>(*stream.rays, stream.any_hit);
    return std::make_unique<const StreamInput>(load_noted_scene(scene, progress, primitives), std::move(rays),
                                               outside);
}

void check_hits(const StreamChoice& choice, const JsonOutput& json) {
    if (!choice.hits) return;
    if (*choice.hits == "-") throw UserError("--hits must name a file, not standard output");
    if (*choice.hits == json.path) throw UserError("--hits and --json name the same file");
    check_writable(*choice.hits);
}

std::string stream_heading(const StreamJob& s) {
    std::string text = fmt::format("{}: {}; {}: {} rays: {} for the closest hit and {} for any hit",
                                   s.scene.name, primitives_text(s.scene), printable(s.rays.name()),
                                   grouped(s.rays.size()), grouped(s.closest), grouped(s.any));
    if (s.clipped) text += fmt::format("; {} begin outside the lattice and are clipped", grouped(s.clipped));
    if (s.missing) text += fmt::format("; {} miss the lattice", grouped(s.missing));
    return text + fmt::format("\nconfiguration {}\n", s.job.config.name);
}

namespace {

std::string judge_line(const StreamJudgement& judged) {
    return fmt::format("  exact judge: {} rays, {} wrong{}\n", grouped(judged.rays), judged.wrong,
                       judged.wrong ? "; " + judged.first : "");
}

/// Checks the files that the command writes, before any work.
void check_outputs(const StreamCommand& c) {
    c.json.check();
    check_hits(c.stream, c.json);
}

/// Writes the answers as hits if they are requested. Returns false if it was interrupted; nothing is written
/// then.
bool write_hits(const StreamCommand& c, const StreamJob& s, const RecordedFrame& frame,
                const std::vector<Closest>& answers, const FramesAtClock& run, Disturbance disturbance,
                const Progress& progress) {
    if (!c.stream.hits) return true;
    const std::vector<std::uint64_t> retired =
        retirements(s.job.config, run.khz, frame, disturbance, run.last().cycles, progress);
    if (interrupted()) return false;
    write_bytes(*c.stream.hits, hits_npy(hits_of(s, answers), retired));
    if (!c.json.is_alone()) fmt::print("  hits: {}\n", printable(*c.stream.hits));
    return true;
}

}   // namespace

int simulate_stream(const StreamCommand& c) {
    const Stopwatch watch;
    const Disturbance disturbance = disturbance_of(c.disturbance);
    check_outputs(c);
    const Progress progress = terminal_progress(), stop = stopping(progress);
    check_clocks(c.clock);
    const StreamRequest request = stream_request(c.scene, c.config, c.stream, stop);
    const Config& config = request.config;
    const std::vector<int> clocks = clocks_of(c.clock, config);
    const StreamJob s = request.input->job(config, stop);
    const StreamResult run = run_stream(s, clocks, disturbance, !c.no_judge, c.threads, progress);
    const std::vector<FramesAtClock>& runs = run.runs;
    const std::optional<StreamJudgement>& judged = run.judged;
    if (!c.json.is_alone()) {
        fmt::print("{}{}{}\n{}\n{}", stream_heading(s), clock_table(config, runs), clock_line(config, clocks),
                   work_table(config, runs[0]), unit_table(config, runs));
        if (judged) fmt::print("\n{}", judge_line(*judged));
    }
    const bool partial =
        run.partial() || !write_hits(c, s, run.frame(), run.answers(), runs[0], disturbance, progress);
    if (partial && !c.json.is_alone())
        fmt::print("  PARTIAL: interrupted; the figures cover the cycles until then\n");
    c.json.write(simulated_stream_json(s, run, partial, watch.seconds()));
    return partial || (judged && judged->wrong > 0) ? 1 : 0;
}

int verify_stream(const StreamCommand& c) {
    const Stopwatch watch;
    const Disturbance disturbance = disturbance_of(c.disturbance);
    check_outputs(c);
    const int khz = parse_clocks(c.clock)[0];
    const Progress progress = terminal_progress(), stop = stopping(progress);
    const StreamRequest request = stream_request(c.scene, c.config, c.stream, stop);
    const Config& config = request.config;
    check_rtl(config);
    StreamJob s = request.input->job(config, stop);
    s.job.khz = khz;
    std::vector<RecordedFrame> frames;
    frames.push_back(record_frame(s.job, s.job.frame, c.threads, stop));
    std::optional<ElasticResult> elastic;
    if (c.elastic)
        elastic = run_elastic(s.job, frames, parse_free_units(*c.elastic, config), disturbance, progress,
                              int(c.disturbance.seed));
    const LockstepResult result =
        elastic ? as_lockstep(*elastic)
                : run_lockstep(s.job, frames, disturbance, progress, int(c.disturbance.seed));
    const std::vector<FramesAtClock> runs{{khz, {result.model}}};
    bool partial = result.model.partial;
    std::optional<StreamJudgement> judged;
    if (!c.no_judge && !partial) judged = judge_stream(s, result.rtl.answers, c.threads, stop);
    if (!c.json.is_alone()) {
        fmt::print("{}{}\n{}\n{}\n{}", stream_heading(s), clock_table(config, runs),
                   work_table(config, runs[0]), unit_table(config, runs),
                   elastic ? elastic_lines(config, khz, *elastic) : lockstep_lines(result));
        if (judged) fmt::print("{}", judge_line(*judged));
    }
    partial = partial || !write_hits(c, s, frames[0], result.rtl.answers, runs[0], disturbance, progress);
    const bool good = !partial && result.agrees() && (!judged || judged->wrong == 0);
    if (!c.json.is_alone())
        fmt::print("  {} in {:.1f} s\n",
                   good      ? "VERIFIED"
                   : partial ? "PARTIAL: interrupted"
                             : "FAILED",
                   watch.seconds());
    nlohmann::ordered_json json = stream_run_json(s, result.rtl.answers, runs, partial, judged);
    json["events_compared"] = result.events_compared;
    json["value_mismatches"] = result.value_mismatches;
    json["account_mismatches"] = result.account_mismatches;
    json["cycle_gap"] = elastic ? cycle_gap_of(*elastic) : result.cycle_gap;
    json["elastic"] = elastic ? elastic_json(config, khz, *c.elastic, *elastic) : nullptr;
    json["first_divergence"] = divergence_json(result.first);
    json["counters_compared"] = result.counters_compared;
    json["first_counter"] = counter_json(result.counter);
    json["host"] = {{"seconds", watch.seconds()}};
    json["digest"] = digest_text(result.model.digest);
    c.json.write(json);
    return good ? 0 : 1;
}

}   // namespace rayclock

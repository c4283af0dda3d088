// simulate and verify with a stream of rays in place of a camera.
#include "sim/app/streamed.hpp"

#include <memory>
#include <utility>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"
#include "model/base/stopwatch.hpp"
#include "model/core/settled.hpp"
#include "model/engine/check.hpp"
#include "model/trace/hits.hpp"
#include "sim/app/clock.hpp"
#include "sim/files/output.hpp"
#include "sim/files/process/stopping.hpp"
#include "sim/run/request/idle.hpp"
#include "sim/run/request/request.hpp"
#include "sim/run/lockstep/lockstep.hpp"
#include "sim/run/stream/stream.hpp"
#include "sim/view/report/accounts.hpp"
#include "sim/view/report/lockstep.hpp"
#include "sim/view/report/tables.hpp"
#include "sim/view/report/text.hpp"

namespace rayclock {

void stream_options(Parser& parser, StreamChoice& choice) {
    parser.option("--rays", choice.rays,
                  "trace the rays of a file in place of a camera's: .npy (n x 6 to 9) or AnyDSL's .rays");
    parser.flag("--any-hit", choice.any_hit, "with --rays: every ray requests any hit, not the closest");
    parser
        .option("--outside", choice.outside,
                "with --rays: clip or refuse rays that begin outside the lattice")
        .with_default();
    parser.option("--hits", choice.hits, "with --rays: .npy file for each ray's hit and its cycle");
}

void check_stream_options(const StreamChoice& choice) {
    if (choice.is_asked()) return;
    const char* option = choice.any_hit                             ? "--any-hit"
                         : choice.hits                              ? "--hits"
                         : choice.outside != StreamChoice{}.outside ? "--outside"
                                                                    : nullptr;
    if (option) throw UserError(fmt::format("{} needs --rays, a stream of rays", option));
}

void refuse_with_rays(const char* odd) {
    if (odd)
        throw UserError(fmt::format("--rays takes the place of a camera, so {} has no meaning here", odd));
}

void refuse_picture_options(const std::string& size, const Finish& finish, const ViewChoice& view,
                            const FramesOptions& frames, const LimitsChoice& limits,
                            const std::string& output) {
    const FramesOptions none;
    const char* odd = size != default_size ? "--size"
                      : finish.is_asked()  ? "--depth, --aa or another option of finished pictures"
                      : view.is_asked()    ? "an option of the camera"
                      : view.ground        ? "--ground"
                      : view.material      ? "--material"
                      : frames.frames != 1 || frames.pan != 0 || frames.fps || !frames.time.empty() ||
                              frames.uploads != none.uploads || frames.rebuild != none.rebuild
                          ? "an option of films"
                      : limits.max_other || limits.max_depth_error || limits.min_psnr ? "a limit of errors"
                      : !output.empty()                                               ? "--output"
                                                                                      : nullptr;
    refuse_with_rays(odd);
}

namespace {

/// A stream, ready to run.
struct Streamed {
    Scene scene;
    RayFile rays;
    std::unique_ptr<StreamJob> stream;   // refers to both
};

Config config_of(const StreamCommand& c) {
    const Config named = load_config({c.config.name, {}});
    const Config config =
        with_settings(settled(streaming(widened(named, c.config.set))), c.config.set, named.name);
    if (!config.is_stream()) throw UserError("--rays needs source=stream; leave out --set source=camera");
    tell_idle(idle_settings(config, c.config.set));
    return config;
}

Outside outside_of(const StreamChoice& choice) {
    if (choice.outside == "clip") return Outside::clip;
    if (choice.outside == "refuse") return Outside::refuse;
    throw UserError("--outside: " + shown(choice.outside) + " is not clip or refuse");
}

std::unique_ptr<Streamed> load(const StreamCommand& c, const Config& config, const Progress& progress) {
    const Outside outside = outside_of(c.stream);
    RayFile rays(*c.stream.rays, c.stream.any_hit);
    auto s =
        std::make_unique<Streamed>(Streamed{ready_scene(c.scene, {1, 1}, progress), std::move(rays), {}});
    if (!s->scene.spheres.empty() || !s->scene.planes.empty())
        throw UserError(s->scene.name +
                        ": a stream of rays meets triangles only, and the scene has spheres or planes");
    s->stream = std::make_unique<StreamJob>(make_stream_job(s->scene, s->rays, config, outside, progress));
    return s;
}

std::string heading_of(const StreamJob& s) {
    std::string text = fmt::format("{}: {}; {}: {} rays: {} for the closest hit and {} for any hit",
                                   s.scene.name, primitives_text(s.scene), printable(s.rays.name()),
                                   grouped(s.rays.size()), grouped(s.closest), grouped(s.any));
    if (s.clipped) text += fmt::format("; {} begin outside the lattice and are clipped", grouped(s.clipped));
    if (s.missing) text += fmt::format("; {} miss the lattice", grouped(s.missing));
    return text + fmt::format("\nconfiguration {}\n", s.job.config.name);
}

std::string judge_line(const StreamJudgement& judged) {
    return fmt::format("  exact judge: {} rays, {} wrong{}\n", grouped(judged.rays), judged.wrong,
                       judged.wrong ? "; " + judged.first : "");
}

nlohmann::ordered_json judgement_json(const std::optional<StreamJudgement>& judged) {
    if (!judged) return nullptr;
    return {{"rays", judged->rays},
            {"wrong", judged->wrong},
            {"first", judged->first},
            {"seconds", judged->seconds}};
}

nlohmann::ordered_json stream_json(const StreamJob& s, const std::vector<Closest>& answers) {
    std::size_t hits = 0;
    for (std::size_t i = 0; i < answers.size(); ++i) hits += hit_of(s, i, answers[i]).hit;
    return {{"file", s.rays.name()}, {"rays", s.rays.size()}, {"closest", s.closest}, {"any", s.any},
            {"clipped", s.clipped},  {"missing", s.missing},  {"hits", hits}};
}

nlohmann::ordered_json run_json(const StreamJob& s, const std::vector<Closest>& answers,
                                const std::vector<FramesAtClock>& runs, bool partial,
                                const std::optional<StreamJudgement>& judged) {
    const Config& config = s.job.config;
    const FrameResult& first = runs[0].last();
    nlohmann::ordered_json clocks = nlohmann::ordered_json::array();
    for (const FramesAtClock& run : runs) {
        clocks.push_back(clock_json(config, run));
        mark_clock(clocks.back(), config, run.khz);
    }
    return {{"scene", scene_json(s.scene)},
            {"stream", stream_json(s, answers)},
            {"config", config_json_object(config)},
            {"partial", partial},
            {"compile", compile_json(s.job.image.report)},
            {"rays", rays_json(first.rays)},
            {"work", work_json(first)},
            {"clocks", clocks},
            {"units", units_json(config, first)},
            {"memory", memory_json(config, runs[0].khz, first)},
            {"judge", judgement_json(judged)}};
}

/// Checks the files that the command writes, before any work.
void check_outputs(const StreamCommand& c) {
    c.json.check();
    if (!c.stream.hits) return;
    if (*c.stream.hits == "-") throw UserError("--hits must name a file, not standard output");
    if (*c.stream.hits == c.json.path) throw UserError("--hits and --json name the same file");
    check_writable(*c.stream.hits);
}

/// Writes the hits if they are asked for. Returns false if it was interrupted; nothing is written then.
bool write_hits(const StreamCommand& c, const StreamJob& s, const RecordedFrame& frame,
                const FramesAtClock& run, Traffic traffic, const Progress& progress) {
    if (!c.stream.hits) return true;
    const std::vector<std::uint64_t> retired =
        retirements(s.job.config, run.khz, frame, traffic, run.last().cycles, progress);
    if (interrupted()) return false;
    write_bytes(*c.stream.hits, hits_npy(s, frame.trace.hits, retired));
    if (!c.json.is_alone()) fmt::print("  hits: {}\n", printable(*c.stream.hits));
    return true;
}

}   // namespace

int simulate_stream(const StreamCommand& c) {
    const Stopwatch watch;
    const Traffic traffic = traffic_of(c.traffic);
    check_outputs(c);
    const Progress progress = terminal_progress(), stop = stopping(progress);
    const Config config = config_of(c);
    const std::vector<int> clocks = clocks_of(c.clock, config);
    const std::unique_ptr<Streamed> input = load(c, config, stop);
    const StreamJob& s = *input->stream;
    std::vector<RecordedFrame> frames;
    frames.push_back(record_frame(s.job, s.job.frame, c.threads, stop));
    const std::vector<Closest>& answers = frames[0].trace.hits;
    std::vector<FramesAtClock> runs;
    for (const int khz : clocks) {
        const std::vector<FrameTiming> timings = replay(config, khz, frames, traffic, progress);
        runs.push_back({khz, {frame_result(frames[0], timings[0])}});
        if (runs.back().partial()) break;
    }
    bool partial = runs.back().partial();
    std::optional<StreamJudgement> judged;
    if (!c.no_judge && !partial) judged = judge_stream(s, answers, c.threads, stop);
    if (!c.json.is_alone()) {
        fmt::print("{}{}{}\n{}\n{}", heading_of(s), clock_table(config, runs), clock_line(config, clocks),
                   work_table(config, runs[0]), unit_table(config, runs));
        if (judged) fmt::print("\n{}", judge_line(*judged));
    }
    partial = partial || !write_hits(c, s, frames[0], runs[0], traffic, progress);
    if (partial && !c.json.is_alone())
        fmt::print("  PARTIAL: interrupted; the figures cover the cycles until then\n");
    nlohmann::ordered_json json = run_json(s, answers, runs, partial, judged);
    Digest digest;
    std::uint64_t cycles = 0;
    for (const FramesAtClock& run : runs) digest.add(run.last().digest), cycles += run.last().cycles;
    json["host"] = {{"seconds", watch.seconds()}, {"cycles_per_second", double(cycles) / watch.seconds()}};
    json["digest"] = digest_text(digest.value());
    c.json.write(json);
    return partial || (judged && judged->wrong > 0) ? 1 : 0;
}

int verify_stream(const StreamCommand& c) {
    const Stopwatch watch;
    const Traffic traffic = traffic_of(c.traffic);
    check_outputs(c);
    const int khz = parse_clocks(c.clock)[0];
    const Progress progress = terminal_progress(), stop = stopping(progress);
    const Config config = config_of(c);
    check_rtl(config);
    const std::unique_ptr<Streamed> input = load(c, config, stop);
    StreamJob& s = *input->stream;
    s.job.khz = khz;
    std::vector<RecordedFrame> frames;
    frames.push_back(record_frame(s.job, s.job.frame, c.threads, stop));
    const LockstepResult result = run_lockstep(s.job, frames, traffic, progress, int(c.traffic.seed));
    const std::vector<FramesAtClock> runs{{khz, {result.model}}};
    bool partial = result.model.partial;
    std::optional<StreamJudgement> judged;
    if (!c.no_judge && !partial) judged = judge_stream(s, result.rtl.answers, c.threads, stop);
    if (!c.json.is_alone()) {
        fmt::print("{}{}\n{}\n{}\n{}", heading_of(s), clock_table(config, runs), work_table(config, runs[0]),
                   unit_table(config, runs), lockstep_lines(result));
        if (judged) fmt::print("{}", judge_line(*judged));
    }
    partial = partial || !write_hits(c, s, frames[0], runs[0], traffic, progress);
    const bool good = !partial && result.agrees() && (!judged || judged->wrong == 0);
    if (!c.json.is_alone())
        fmt::print("  {} in {:.1f} s\n",
                   good      ? "VERIFIED"
                   : partial ? "PARTIAL: interrupted"
                             : "FAILED",
                   watch.seconds());
    nlohmann::ordered_json json = run_json(s, result.rtl.answers, runs, partial, judged);
    json["events_compared"] = result.events_compared;
    json["value_mismatches"] = result.value_mismatches;
    json["account_mismatches"] = result.account_mismatches;
    json["cycle_gap"] = result.cycle_gap;
    json["first_divergence"] = divergence_json(result.first);
    json["counters_compared"] = result.counters_compared;
    json["first_counter"] = counter_json(result.counter);
    json["host"] = {{"seconds", watch.seconds()}};
    json["digest"] = digest_text(result.model.digest);
    c.json.write(json);
    return good ? 0 : 1;
}

}   // namespace rayclock

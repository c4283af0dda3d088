// simulate and verify with a stream of rays in place of a camera.
#include "sim/app/streamed.hpp"

#include <memory>
#include <utility>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"
#include "model/base/stopwatch.hpp"
#include "sim/app/clock.hpp"
#include "sim/app/elastic.hpp"
#include "sim/app/stream_run.hpp"
#include "sim/files/output.hpp"
#include "sim/files/process/stopping.hpp"
#include "sim/run/request/idle.hpp"
#include "sim/run/request/request.hpp"
#include "sim/run/lockstep/lockstep.hpp"
#include "sim/run/stream/stream.hpp"
#include "sim/view/report/elastic.hpp"
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
    const char* odd = size != default_size ? "--size"
                      : finish.is_asked()  ? "--depth, --aa or another option of finished pictures"
                      : view.is_asked()    ? "an option of the camera"
                      : view.ground        ? "--ground"
                      : view.material      ? "--material"
                      : frames.is_asked()  ? "an option of films"
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

std::unique_ptr<Streamed> load(const StreamCommand& c, const Config& config, const Progress& progress) {
    const Outside outside = parse_outside(c.stream.outside);
    RayFile rays(*c.stream.rays, c.stream.any_hit);
    auto s = std::make_unique<Streamed>(Streamed{told_scene(c.scene, progress), std::move(rays), {}});
    prepare_for_stream(s->scene);
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
    const Config config = stream_config(c.config);
    tell_idle(idle_settings(config, c.config.set));
    const std::vector<int> clocks = clocks_of(c.clock, config);
    const std::unique_ptr<Streamed> input = load(c, config, stop);
    const StreamJob& s = *input->stream;
    const StreamRun run = run_stream(s, clocks, traffic, !c.no_judge, c.threads, progress);
    const std::vector<FramesAtClock>& runs = run.runs;
    const std::optional<StreamJudgement>& judged = run.judged;
    if (!c.json.is_alone()) {
        fmt::print("{}{}{}\n{}\n{}", heading_of(s), clock_table(config, runs), clock_line(config, clocks),
                   work_table(config, runs[0]), unit_table(config, runs));
        if (judged) fmt::print("\n{}", judge_line(*judged));
    }
    const bool partial = run.partial() || !write_hits(c, s, run.frame(), runs[0], traffic, progress);
    if (partial && !c.json.is_alone())
        fmt::print("  PARTIAL: interrupted; the figures cover the cycles until then\n");
    c.json.write(simulated_stream_json(s, run, partial, watch.seconds()));
    return partial || (judged && judged->wrong > 0) ? 1 : 0;
}

int verify_stream(const StreamCommand& c) {
    const Stopwatch watch;
    const Traffic traffic = traffic_of(c.traffic);
    check_outputs(c);
    const int khz = parse_clocks(c.clock)[0];
    const Progress progress = terminal_progress(), stop = stopping(progress);
    const Config config = stream_config(c.config);
    tell_idle(idle_settings(config, c.config.set));
    check_rtl(config);
    const std::unique_ptr<Streamed> input = load(c, config, stop);
    StreamJob& s = *input->stream;
    s.job.khz = khz;
    std::vector<RecordedFrame> frames;
    frames.push_back(record_frame(s.job, s.job.frame, c.threads, stop));
    std::optional<ElasticResult> elastic;
    if (c.elastic)
        elastic = run_elastic(s.job, frames, parse_free_units(*c.elastic, config), traffic, progress,
                              int(c.traffic.seed));
    const LockstepResult result =
        elastic ? as_lockstep(*elastic) : run_lockstep(s.job, frames, traffic, progress, int(c.traffic.seed));
    const std::vector<FramesAtClock> runs{{khz, {result.model}}};
    bool partial = result.model.partial;
    std::optional<StreamJudgement> judged;
    if (!c.no_judge && !partial) judged = judge_stream(s, result.rtl.answers, c.threads, stop);
    if (!c.json.is_alone()) {
        fmt::print("{}{}\n{}\n{}\n{}", heading_of(s), clock_table(config, runs), work_table(config, runs[0]),
                   unit_table(config, runs),
                   elastic ? elastic_lines(config, khz, *elastic) : lockstep_lines(result));
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

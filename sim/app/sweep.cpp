// rayclock sweep: runs one scene on many configurations and clocks. Configurations that differ only in timing
// share one trace.
#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"
#include "sim/app/options/commands.hpp"
#include "sim/app/parts/stream_commands.hpp"
#include "sim/app/parts/sweep_outputs.hpp"
#include "sim/app/run/sample_run.hpp"
#include "sim/app/run/sweep_run.hpp"
#include "sim/explore/sweep/cost.hpp"
#include "sim/explore/sweep/shard.hpp"
#include "sim/files/image/image.hpp"
#include "sim/files/process/stopping.hpp"
#include "sim/view/report/text.hpp"

namespace rayclock {

namespace {

struct SweepOptions {
    std::string scene, size = default_size, clock = default_clocks, cost = "auto";
    std::vector<std::string> axes;
    ConfigChoice config;
    Finish finish;
    ViewChoice view;
    FramesOptions frames;
    std::uint64_t seed = 1;
    bool fresh = false, no_netlist = false;
    int threads = 0;
    std::optional<int> cache_bytes;
    std::optional<std::string> shard, sample;
    StreamChoice stream;
    SweepOutputs outputs;
};

void declare_sweep(Parser& parser, SweepOptions& o) {
    scene_option(parser, o.scene).required();
    finished_options(parser, o.finish);
    view_options(parser, o.view);
    frames_options(parser, o.frames);
    parser.option("--seed", o.seed, "seed of --jittered and --sample").within(1, 1 << 30);
    parser
        .option("--axis", o.axes,
                "key=1,2,4 or key=12:20:2: a parameter of the configuration, or clock; a/b=1/8,2/4 changes "
                "two together; may be repeated")
        .required();
    parser
        .option(
            "--cost", o.cost,
            "what the front weighs against speed and error: multipliers (of all pipelines), or of the "
            "chip lut, dsp, bram (Yosys maps every different unit, which takes minutes) or bits of memory; "
            "auto: the first of multipliers, bits and the memory image that differs between points")
        .with_default();
    parser.option("--cache-bytes", o.cache_bytes,
                  "only points whose caches hold so many bytes in each pipeline");
    size_option(parser, o.size);
    clock_option(parser, o.clock);
    config_options(parser, o.config);
    parser.option("--shard", o.shard,
                  "only a part of the points, 2/4 is the second of four; merge makes one sweep of all parts");
    fresh_option(parser, o.fresh);
    netlist_option(parser, o.no_netlist);
    threads_option(parser, o.threads);
    stream_options(parser, o.stream, false);
    parser.option("--sample", o.sample,
                  "estimate each point from this share of its frame, for example 2%; draws no pictures");
    sweep_outputs(parser, o.outputs);
}

/// Returns the sample that the options request. Throws UserError if an option has no meaning for a sample.
std::optional<sample::Ask> sample_of(const SweepOptions& o) {
    if (!o.sample) return std::nullopt;
    const auto refuse = [](bool is_given, const char* option, const char* why) {
        if (is_given) throw UserError(fmt::format("--sample: {}; leave out {}", why, option));
    };
    const LimitsChoice& limits = o.outputs.limits;
    refuse(o.stream.rays.has_value(), "--rays", "a stream of rays is simulated as a whole");
    refuse(o.frames.is_given(), "--frames and its group",
           "a sample covers one frame, at the scene's first moment");
    refuse(limits.max_other || limits.max_depth_error || limits.min_psnr,
           "--max-other, --max-depth-error and --min-psnr", "a sample has no picture to compare");
    return sample::Ask{parse_share(*o.sample), o.seed};
}

int run_sweep_command(const SweepOptions& o) {
    const std::optional<sample::Ask> sample = sample_of(o);
    const bool is_stream = traces_stream(o.stream, {.size = o.size,
                                                    .finish = o.finish,
                                                    .view = o.view,
                                                    .frames = o.frames,
                                                    .limits = o.outputs.limits,
                                                    .own = {}});
    sweep::parse_cost(o.cost);   // refused before the scene is loaded
    const sweep::Shard shard = o.shard ? sweep::parse_shard(*o.shard) : sweep::Shard{};
    if (!shard.is_whole() && !o.outputs.json.wanted())
        throw UserError("--shard needs --json FILE: that is what merge reads");
    if (o.cache_bytes && *o.cache_bytes < 1)
        throw UserError(fmt::format("--cache-bytes: {} is not above 0", *o.cache_bytes));
    const FrameSize size = parse_size(o.size);
    std::vector<sweep::Axis> axes;
    for (const std::string& text : o.axes) axes.push_back(sweep::parse_axis(text));
    check_outputs(o.outputs);
    check_plots(o.outputs, axes, is_stream ? Drawn::stream : sample ? Drawn::sample : Drawn::picture);
    const Progress progress = terminal_progress();
    StreamRequest stream;
    Request request;
    if (is_stream) {
        stream = stream_request(o.scene, o.config, o.stream, stopping(progress));
        request.config = stream.config;
        request.scene = stream.input->scene();
    } else {
        request = request_of(o.scene, o.config, o.finish, o.seed, size, stopping(progress), o.view);
        if (sample && moves(request.scene))
            throw UserError("--sample: " + printable(o.scene) + " moves, and a film is simulated as a whole");
    }
    const SweepResult run = run_sweep(
        {request, is_stream ? FrameSize{0, 0} : size, std::move(axes), o.clock, o.cost, o.cache_bytes, shard,
         !o.no_netlist, o.fresh, o.threads, o.frames, o.view, stream.input.get(), sample},
        progress);
    const sweep::Evaluation& outcome = run.swept.outcome;

    std::string how = fmt::format("{} points from {} traces, {} of them known before", outcome.results.size(),
                                  outcome.traces, outcome.known);
    if (!shard.is_whole()) how += ", part " + sweep::name_of(shard);
    if (!run.cache_trouble.empty())
        how += fmt::format("\n  nothing is kept for the next run: {}", run.cache_trouble);
    write_sweep(o.outputs, run.swept, how, run.shard);
    return outcome.partial ? 1 : 0;
}

}   // namespace

Command sweep_command() {
    return command("sweep", "run one scene on many configurations and clocks",
                   "rayclock sweep gears:8 --axis node_sets=16,32,64 --axis clock=66,200", declare_sweep,
                   run_sweep_command);
}

}   // namespace rayclock

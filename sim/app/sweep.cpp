// rayclock sweep: runs one scene on many configurations and clocks. Configurations that differ only in timing
// share one trace.
#include <fmt/format.h>

#include "model/base/error.hpp"
#include "sim/app/clock.hpp"
#include "sim/app/options/commands.hpp"
#include "sim/app/swept.hpp"
#include "sim/files/image/image.hpp"
#include "sim/view/report/text.hpp"
#include "sim/run/rtl/builder.hpp"
#include "sim/files/process/stopping.hpp"
#include "sim/explore/sweep/cost.hpp"
#include "sim/explore/sweep/shard.hpp"

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
    std::optional<std::string> shard;
    SweepOutputs outputs;
};

void declare_sweep(Parser& parser, SweepOptions& o) {
    scene_option(parser, o.scene).required();
    finished_options(parser, o.finish);
    view_options(parser, o.view);
    frames_options(parser, o.frames);
    parser.option("--seed", o.seed, "seed of --jittered").within(1, 1 << 30);
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
    sweep_outputs(parser, o.outputs);
}

/// Returns the requested points of the grid, each with its own clock.
std::vector<sweep::Point> points_of(const SweepOptions& o, const std::vector<sweep::Axis>& axes,
                                    const Config& config) {
    const bool at_fmax = o.clock == "fmax";
    std::vector<sweep::Point> points =
        sweep::make_points(axes, config, at_fmax ? 0 : parse_clocks(o.clock)[0], axis_clock);
    sweep::keep_size(points, o.cache_bytes);
    for (sweep::Point& point : points)   // an axis over clocks takes precedence
        if (at_fmax && point.khz == 0) point.khz = clocks_of(o.clock, point.config)[0];
    return points;
}

/// Removes all points outside this part. Returns the indices of the remaining points.
std::vector<std::size_t> keep_part(std::vector<sweep::Point>& points, const sweep::Shard& shard) {
    const std::vector<std::size_t> mine = sweep::points_of(shard, points);
    std::vector<sweep::Point> kept;
    for (const std::size_t i : mine) kept.push_back(std::move(points[i]));
    points = std::move(kept);
    return mine;
}

int run_sweep(const SweepOptions& o) {
    const sweep::Cost cost = sweep::parse_cost(o.cost);
    const sweep::Shard shard = o.shard ? sweep::parse_shard(*o.shard) : sweep::Shard{};
    if (!shard.is_whole() && !o.outputs.json.wanted())
        throw UserError("--shard needs --json FILE: that is what merge reads");
    if (o.cache_bytes && *o.cache_bytes < 1)
        throw UserError(fmt::format("--cache-bytes: {} is not above 0", *o.cache_bytes));
    const FrameSize size = parse_size(o.size);
    std::vector<sweep::Axis> axes;
    for (const std::string& text : o.axes) axes.push_back(sweep::parse_axis(text));
    check_outputs(o.outputs);
    check_plots(o.outputs, axes);
    const Progress progress = terminal_progress();
    const Request request = request_of(o.scene, o.config, o.finish, o.seed, size, stopping(progress), o.view);
    const Scene& scene = request.scene;
    const PictureChoice picture{request.finished, request.settings, settled_frames(o.frames, scene), o.view};
    std::vector<sweep::Point> points = points_of(o, axes, request.config);
    const std::vector<std::size_t> mine = keep_part(points, shard);
    jobs::Cache cache(rtl_cache() / "sweep", o.fresh);
    sweep::Merged swept{
        scene_json(scene),
        request.config,
        size,
        {std::move(axes), o.clock, o.cost, o.cache_bytes, !o.no_netlist, sweep::picture_json(picture)},
        {}};
    sweep::Outcome& outcome = swept.outcome;
    const bool netlists = !o.no_netlist && !sweep::needs_area(cost) && cost != sweep::Cost::bits;
    outcome = sweep::run({scene, size, std::move(points), o.threads, netlists, picture}, cache, progress);
    if (sweep::needs_area(cost) && !outcome.partial) {
        jobs::Cache areas(rtl_cache() / "area", o.fresh);
        sweep::count_areas(outcome, o.threads, areas, progress);
    }
    for (sweep::Result& result : outcome.results)
        if (!result.clock.is_null()) mark_clock(result.clock, result.point.config, result.point.khz);

    std::string how = fmt::format("{} points from {} traces, {} of them known before", outcome.results.size(),
                                  outcome.traces, outcome.known);
    if (!shard.is_whole()) how += ", part " + sweep::name_of(shard);
    if (!cache.trouble().empty())
        how += fmt::format("\n  nothing is kept for the next run: {}", cache.trouble());
    write_sweep(o.outputs, swept, how, sweep::shard_json(shard, mine, scene));
    return outcome.partial ? 1 : 0;
}

}   // namespace

Command sweep_command() {
    return command("sweep", "run one scene on many configurations and clocks",
                   "rayclock sweep gears:8 --axis node_sets=16,32,64 --axis clock=66,200", declare_sweep,
                   run_sweep);
}

}   // namespace rayclock

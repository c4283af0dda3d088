// rayclock sweep: one scene on many configurations and clocks. Those that differ in timing only share one
// trace.
#include <fmt/format.h>

#include "model/base/error.hpp"
#include "sim/app/clock.hpp"
#include "sim/app/commands.hpp"
#include "sim/app/options.hpp"
#include "sim/image/image.hpp"
#include "sim/report/text.hpp"
#include "sim/rtl/builder.hpp"
#include "sim/sweep/plot.hpp"
#include "sim/sweep/table.hpp"

namespace rayclock {

namespace {

struct Options {
    std::string scene, size = default_size, clock = default_clocks, output, plot, cost = "multipliers";
    std::vector<std::string> axes;
    ConfigChoice config;
    ViewChoice view;
    bool fresh = false, no_netlist = false;
    int threads = 0;
    std::optional<int> cache_bytes;
    JsonOutput json;
};

void declare(Parser& parser, Options& o) {
    scene_option(parser, o.scene).required();
    view_options(parser, o.view);
    parser
        .option("--axis", o.axes,
                "key=1,2,4 or key=12:20:2: a parameter of the configuration, or clock; a/b=1/8,2/4 changes "
                "two together; may be repeated")
        .required();
    parser
        .option(
            "--cost", o.cost,
            "what the front weighs against speed and error: multipliers (of all pipelines), or of the "
            "chip lut, dsp, bram (Yosys maps every different unit, which takes minutes) or bits of memory")
        .with_default();
    parser.option("--cache-bytes", o.cache_bytes,
                  "only points whose caches hold so many bytes in each pipeline");
    size_option(parser, o.size);
    clock_option(parser, o.clock);
    config_options(parser, o.config);
    parser.option("-o,--output", o.output, "table as CSV");
    parser.option("--plot", o.plot,
                  "writes NAME.svg: error against cost and against speed, with the fronts and the knee");
    fresh_option(parser, o.fresh);
    netlist_option(parser, o.no_netlist);
    threads_option(parser, o.threads);
    json_option(parser, o.json);
}

int one_clock(const std::string& value) { return parse_clocks(value).at(0); }

/// Points whose caches are as large as was asked for.
void keep_size(std::vector<sweep::Point>& points, std::uint64_t bytes) {
    std::uint64_t least = ~std::uint64_t(0), most = 0;
    for (const sweep::Point& point : points) {
        least = std::min(least, sweep::pipeline_cache_bytes(point.config));
        most = std::max(most, sweep::pipeline_cache_bytes(point.config));
    }
    std::erase_if(points,
                  [&](const auto& point) { return sweep::pipeline_cache_bytes(point.config) != bytes; });
    if (points.empty())
        throw UserError(
            fmt::format("--cache-bytes: no point's caches hold {} bytes in a pipeline; they hold {} to {}",
                        bytes, least, most));
}

int run(const Options& o) {
    catch_interrupts();
    const sweep::Cost cost = sweep::parse_cost(o.cost);
    if (o.cache_bytes && *o.cache_bytes < 1)
        throw UserError(fmt::format("--cache-bytes: {} is not above 0", *o.cache_bytes));
    const FrameSize size = parse_size(o.size);
    std::vector<sweep::Axis> axes;
    for (const std::string& text : o.axes) axes.push_back(sweep::parse_axis(text));
    const Config config = load_config(o.config);
    const bool at_fmax = o.clock == "fmax";
    std::vector<sweep::Point> points =
        sweep::make_points(axes, config, at_fmax ? 0 : parse_clocks(o.clock)[0], one_clock);
    if (o.cache_bytes) keep_size(points, std::uint64_t(*o.cache_bytes));
    for (sweep::Point& point : points)   // each at its own clock; an axis over clocks comes first
        if (at_fmax && point.khz == 0) point.khz = clocks_of(o.clock, point.config)[0];
    o.json.check();
    if (!o.output.empty()) check_writable(o.output);
    if (!o.plot.empty()) plot::check_plot_path(o.plot);
    const Progress progress = terminal_progress();
    const Scene scene = ready_scene(o.scene, size, progress, o.view);
    jobs::Cache cache(rtl_cache() / "sweep", o.fresh);
    sweep::Outcome outcome = sweep::run(
        {scene, size, std::move(points), o.threads, !o.no_netlist && cost == sweep::Cost::multipliers}, cache,
        progress);
    if (sweep::needs_area(cost) && !outcome.partial) {
        jobs::Cache areas(rtl_cache() / "area", o.fresh);
        sweep::count_areas(outcome, o.threads, areas, progress);
    }
    for (sweep::Result& result : outcome.results)
        if (!result.clock.is_null()) mark_clock(result.clock, result.point.config, result.point.khz);
    const sweep::Front front = sweep::front_of(outcome.results, cost);

    if (!o.json.is_alone()) {
        fmt::print("{}, {}x{}: {} points from {} traces, {} of them known before\n{}", scene.name, size.width,
                   size.height, outcome.results.size(), outcome.traces, outcome.known,
                   sweep::text(axes, outcome, front));
        if (!cache.trouble().empty()) fmt::print("  nothing is kept for the next run: {}\n", cache.trouble());
        if (outcome.partial) fmt::print("  PARTIAL: interrupted; the same command goes on where it was\n");
    }
    if (!o.output.empty()) write_file(o.output, sweep::csv(axes, outcome.results, front));
    if (!o.plot.empty())
        plot::write_plot(o.plot, sweep::front_plot(scene.name, size, axes, outcome.results, front));
    o.json.write({{"scene", scene_json(scene)},
                  {"config", config_json_object(config)},
                  {"frame", {{"width", size.width}, {"height", size.height}}},
                  {"partial", outcome.partial},
                  {"front",
                   {{"error", front.measures[0].key},
                    {"cost", front.measures[1].key},
                    {"speed", front.measures[2].key}}},
                  {"knee", sweep::knee_json(axes, outcome.results, front)},
                  {"points", sweep::points_json(axes, outcome.results, front)}});
    return outcome.partial ? 1 : 0;
}

}   // namespace

Command sweep_command() {
    return command(
        "sweep",
        "one scene on many configurations and clocks; those that differ only in timing share one trace",
        "rayclock sweep gears:8 --axis node_sets=16,32,64 --axis clock=66,200", declare, run);
}

}   // namespace rayclock

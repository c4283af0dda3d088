// rayclock sweep: one scene on many configurations and clocks. Those that differ in timing only share one trace.
#include <fmt/format.h>

#include "sim/app/commands.hpp"
#include "sim/image/image.hpp"
#include "sim/report/text.hpp"
#include "sim/rtl/builder.hpp"
#include "sim/sweep/plot.hpp"
#include "sim/sweep/table.hpp"

namespace rayclock {

namespace {

int one_clock(const std::string& value) { return parse_clocks(value).at(0); }

} // namespace

int sweep_command(const Options& o) {
    catch_interrupts();
    const FrameSize size = parse_size(o.size);
    std::vector<sweep::Axis> axes;
    for (const std::string& text : o.axes) axes.push_back(sweep::parse_axis(text));
    std::vector<sweep::Point> points = sweep::make_points(axes, load_config(o.config, o.set), parse_clocks(o.clock)[0], one_clock);
    check_outputs(o);
    if (!o.output.empty()) check_writable(o.output);
    if (!o.plot.empty()) plot::check_plot_path(o.plot);
    const Progress progress = terminal_progress();
    const Scene scene = ready_scene(o, size, progress);
    sweep::Cache cache(rtl_cache() / "sweep", o.fresh);
    const sweep::Outcome outcome = sweep::run({scene, size, std::move(points), o.threads, !o.no_netlist}, cache, progress);
    const sweep::Front front = sweep::front_of(outcome.results);

    if (o.json != "-") {
        fmt::print("{}, {}x{}: {} points from {} traces, {} of them known before\n{}", scene.name, size.width, size.height, outcome.results.size(),
                   outcome.traces, outcome.known, sweep::text(axes, outcome, front));
        if (!cache.trouble().empty()) fmt::print("  nothing is kept for the next run: {}\n", cache.trouble());
        if (outcome.partial) fmt::print("  PARTIAL: interrupted; the same command goes on where it was\n");
    }
    if (!o.output.empty()) write_file(o.output, sweep::csv(axes, outcome.results, front));
    if (!o.plot.empty()) plot::write_plot(o.plot, sweep::front_plot(scene.name, size, axes, outcome.results, front));
    if (!o.json.empty()) {
        const nlohmann::ordered_json json{
            {"scene", scene_json(scene)}, {"config", config_json_object(load_config(o.config, o.set))}, {"frame", {{"width", size.width}, {"height", size.height}}},
            {"partial", outcome.partial}, {"front", {{"error", front.measures[0].key}, {"cost", front.measures[1].key}, {"speed", front.measures[2].key}}},
            {"knee", sweep::knee_json(axes, outcome.results, front)}, {"points", sweep::points_json(axes, outcome.results, front)}};
        write_file(o.json, json.dump(2) + "\n");
    }
    return outcome.partial ? 1 : 0;
}

} // namespace rayclock

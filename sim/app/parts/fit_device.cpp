// Searches, routes and reports the machine for a device.
#include "sim/app/parts/fit_device.hpp"

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/interrupted.hpp"
#include "model/base/quote.hpp"
#include "sim/app/options/options.hpp"
#include "sim/explore/balance/balance_report.hpp"
#include "sim/explore/balance/scene_evaluator.hpp"
#include "sim/run/rtl/builder.hpp"
#include "sim/silicon/chip/chip_report.hpp"

namespace rayclock {

namespace {

// Leaves room for the host and for wiring between units, which are not counted before routing.
constexpr const char* default_fill = "90%";
constexpr const char* device_group = "Device (without --device only formats are fitted)";

/// Returns a sentence for a device that is too small for the least machine.
std::string no_machine(const DeviceFit& fit) {
    const balance::Machine& first = fit.found.first;
    if (!first.fps || !first.use)
        return fmt::format("{}: the smallest machine cannot draw the scene", fit.goal.device.name);
    return fmt::format("no machine with these formats fits {}: the smallest needs {}", fit.goal.device.name,
                       balance::excess(*first.use, fit.goal.room));
}

void route(DeviceFit& fit, const Scene& scene, FrameSize size, int threads, const Progress& progress,
           const PictureChoice& picture) {
    results::Cache cache(rtl_cache() / "chip", fit.goal.fresh);
    fit.routed = chip::run({fit.config, "chip", fit.goal.device, {1}, fit.goal.methods}, cache, progress);
    if (!fit.routed->fits()) return;
    balance::SceneEvaluator at_routed(scene, size, int(1000 * fit.routed->best().fmax_mhz), threads,
                                      fit.goal.fresh, progress, picture);
    std::vector<balance::Machine> one{{{}, fit.config, {}, {}}};
    if (at_routed.evaluator().fps(one)) fit.routed_fps = one[0].fps;
}

}   // namespace

void device_options(Parser& parser, DeviceOptions& o) {
    parser
        .option("--device", o.device,
                "then find the fastest machine that fits this FPGA: lfe5u-25, lfe5u-45 or lfe5u-85")
        .under(device_group);
    parser.option("--fill", o.fill, "share of the device that the machine may fill, 90% by default")
        .under(device_group);
    parser.option("--clock", o.clock, "clock at which machines are compared, in MHz; 66 by default")
        .under(device_group);
    method_options(parser, o.methods, device_group);
    parser.flag("--no-route", o.no_route, "do not place and route the result").under(device_group);
    parser.flag("--fresh", o.fresh, "compute everything again, without cached results").under(device_group);
}

std::optional<DeviceGoal> device_goal(const DeviceOptions& o) {
    if (o.device.empty()) {
        for (const auto& [name, given] : {std::pair{"--fill", o.fill.has_value()},
                                          {"--clock", o.clock.has_value()},
                                          {"--placer", o.methods.placer.has_value()},
                                          {"--router", o.methods.router.has_value()},
                                          {"--placements", o.methods.placements.has_value()},
                                          {"--no-route", o.no_route},
                                          {"--fresh", o.fresh}})
            if (given) throw UserError(fmt::format("{} has no effect without --device", name));
        return std::nullopt;
    }
    DeviceGoal goal{chip::device_of(o.device),    {}, default_khz, !o.no_route, o.fresh,
                    methods_of(o.methods, "chip")};
    if (o.no_route && !o.methods.first().empty())
        throw UserError(o.methods.first() + " has no effect with --no-route");
    const double fill = parse_percent("--fill", o.fill.value_or(default_fill), false) / 100;
    for (const chip::Resource& resource : chip::resources())
        goal.room.*resource.member = std::uint64_t(fill * double(goal.device.has.*resource.member));
    if (o.clock) {
        const std::vector<int> clocks = parse_clocks(*o.clock);
        if (clocks.size() != 1) throw UserError("--clock: fit takes one clock, not " + shown(*o.clock));
        goal.khz = clocks[0];
    }
    return goal;
}

DeviceFit fit_device(const DeviceGoal& goal, const Scene& scene, FrameSize size, const Config& formats,
                     int threads, const Progress& progress, const PictureChoice& picture) {
    DeviceFit fit{goal, {}, {}, {}, {}};
    balance::SceneEvaluator evaluator(scene, size, goal.khz, threads, goal.fresh, progress, picture);
    const std::optional<balance::SearchResult> found =
        balance::search(formats, goal.room, evaluator.evaluator());
    if (!found)
        throw Interrupted("interrupted: nothing is written; the same command continues where it stopped");
    fit.found = *found;
    const balance::Machine& best = fit.found.best();
    if (!best.fps || !best.use || !balance::fits(*best.use, goal.room))
        throw std::runtime_error(no_machine(fit));
    fit.config = best.config;
    if (goal.route) route(fit, scene, size, threads, progress, picture);
    return fit;
}

std::string text(const DeviceFit& fit) {
    std::string text = fmt::format("on {}, compared at {:g} MHz, an assumed clock; {} machines\n\n{}\n",
                                   fit.goal.device.name, fit.goal.khz / 1e3, fit.found.machines,
                                   balance::text(fit.found, fit.goal.room));
    if (!fit.routed) return text + "  not routed; rayclock chip routes it\n";
    text += chip::text(*fit.routed);
    if (fit.routed_fps)
        text += fmt::format("\n  {:.2f} frames per second at the routed {:.1f} MHz\n", *fit.routed_fps,
                            fit.routed->best().fmax_mhz);
    return text;
}

nlohmann::ordered_json json(const DeviceFit& fit) {
    nlohmann::ordered_json json = balance::json(fit.found, fit.goal.room);
    json["name"] = fit.goal.device.name;
    json["clock_mhz"] = fit.goal.khz / 1e3;
    json["chip"] = fit.routed ? chip::json(*fit.routed) : nlohmann::ordered_json(nullptr);
    json["fps_routed"] =
        fit.routed_fps ? nlohmann::ordered_json(*fit.routed_fps) : nlohmann::ordered_json(nullptr);
    return json;
}

}   // namespace rayclock

// rayclock chip: a configuration, or a unit of it alone, placed and routed on an ECP5.
#include <algorithm>
#include <filesystem>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "model/base/error.hpp"
#include "model/base/nearest.hpp"
#include "sim/app/commands.hpp"
#include "sim/app/options.hpp"
#include "sim/chip/picture.hpp"
#include "sim/chip/report.hpp"
#include "sim/engine/engine.hpp"
#include "sim/report/json.hpp"
#include "sim/report/text.hpp"
#include "sim/rtl/builder.hpp"

namespace rayclock {

namespace {

namespace fs = std::filesystem;

struct Options {
    ConfigChoice config;
    std::vector<std::string> units;
    std::string device = "lfe5u-85", seeds = "1", output;
    bool fresh = false;
    JsonOutput json;
};

void declare(Parser& parser, Options& o) {
    config_options(parser, o.config);
    parser.option("--unit", o.units, "route each of these units alone, separated by commas; all: every one")
        .by_commas();
    parser.option("--device", o.device, "lfe5u-25, lfe5u-45 or lfe5u-85").with_default();
    parser.option("--seeds", o.seeds, "seeds of the placer, as 1,2,3 or 1:8; the fastest counts")
        .with_default();
    parser.option("-o,--output", o.output, "folder for the report and pictures of the placement");
    fresh_option(parser, o.fresh);
    json_option(parser, o.json);
}

std::vector<std::string> tops_of(const Options& o, const Config& config) {
    if (o.units.empty()) return {"chip"};
    std::vector<std::string> names = chip::tops(config);
    names.erase(names.begin());   // the chip itself
    if (o.units == std::vector<std::string>{"all"}) return names;
    for (const std::string& unit : o.units)
        if (std::find(names.begin(), names.end(), unit) == names.end())
            throw UserError(fmt::format("--unit: no unit of '{}' is called {}{}; there are {}", config.name,
                                        shown(unit), did_you_mean(unit, names), fmt::join(names, ", ")));
    return o.units;
}

std::vector<int> seeds_of(const std::string& typed) {
    std::vector<int> seeds = parse_values("--seeds", typed);
    for (const int seed : seeds)
        if (seed < 1) throw UserError(fmt::format("--seeds: {} is not above 0, in {}", seed, shown(typed)));
    if (seeds.size() > 100) throw UserError(fmt::format("--seeds: {} seeds are more than 100", seeds.size()));
    return seeds;
}

/// A folder that is there or can be made.
void make_folder(const std::string& path) {
    std::error_code error;
    fs::create_directories(path, error);
    if (error) throw UserError(fmt::format("{}: {}", printable(path), error.message()));
    check_writable((fs::path(path) / "report.txt").string());
}

std::string text_of(const std::vector<chip::Result>& all) {
    std::string text;
    for (const chip::Result& result : all) text += chip::text(result) + "\n";
    return all.size() > 1 ? text + chip::table(all) : text;
}

nlohmann::ordered_json json_of(const Config& config, const std::vector<chip::Result>& all) {
    nlohmann::ordered_json json;
    if (all.size() == 1) {
        json = chip::json(all[0]);
    } else {
        json["alone"] = nlohmann::ordered_json::array();
        for (const chip::Result& result : all) json["alone"].push_back(chip::json(result));
    }
    json["config"] = config_json_object(config);
    return json;
}

void write_files(const Options& o, const std::vector<chip::Result>& all, const nlohmann::ordered_json& json) {
    const fs::path folder = o.output;
    write_file((folder / "report.txt").string(), text_of(all));
    write_file((folder / "report.json").string(), json.dump(2) + "\n");
    for (const chip::Result& r : all) {
        if (r.routes.empty()) continue;
        const std::string title =
            fmt::format("{} of '{}' on {}, {:.1f} MHz with seed {}", r.request.top, r.request.config.name,
                        r.request.device.name, r.best().fmax_mhz, r.best().seed);
        plot::write_plot((folder / (r.request.top + "-placement")).string(),
                         chip::placement(r.best(), r.request.device, title));
    }
}

int run(const Options& o) {
    catch_interrupts();
    const chip::Device& device = chip::device_of(o.device);
    const std::vector<int> seeds = seeds_of(o.seeds);
    const Config config = load_config(o.config);
    check_rtl(config);
    const std::vector<std::string> tops = tops_of(o, config);
    o.json.check();
    if (!o.output.empty()) make_folder(o.output);
    const Progress progress = terminal_progress();
    jobs::Cache cache(rtl_cache() / "chip", o.fresh);
    std::vector<chip::Result> all;
    for (const std::string& top : tops)
        all.push_back(chip::run({config, top, device, seeds}, cache, progress));
    if (!o.json.is_alone()) {
        fmt::print("{}", text_of(all));
        if (!cache.trouble().empty()) fmt::print("  nothing is kept for the next run: {}\n", cache.trouble());
    }
    const nlohmann::ordered_json json = json_of(config, all);
    if (!o.output.empty()) write_files(o, all, json);
    o.json.write(json);
    return std::all_of(all.begin(), all.end(), [](const chip::Result& r) { return r.fits(); }) ? 0 : 1;
}

}   // namespace

Command chip_command() {
    return command(
        "chip", "place and route a configuration, or its units alone, on an ECP5: area, clock, slowest paths",
        "rayclock chip --config small --device lfe5u-85 -o chip", declare, run);
}

}   // namespace rayclock

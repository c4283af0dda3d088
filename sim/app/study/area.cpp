// rayclock study area: makes docs/measured/area.md, the ECP5 resources of each unit with and without optional
// units.
#include <algorithm>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/interrupted.hpp"
#include "model/base/nearest.hpp"
#include "sim/app/options/commands.hpp"
#include "sim/app/options/options.hpp"
#include "sim/files/image/image.hpp"
#include "sim/run/frame/frame.hpp"
#include "sim/run/rtl/builder.hpp"
#include "sim/study/area.hpp"
#include "sim/study/typed.hpp"
#include "sim/view/report/text.hpp"

namespace rayclock {

namespace {

struct AreaOptions {
    ConfigChoice config;
    std::vector<std::string> units;
    std::string output;
    bool fresh = false;
    int threads = 0;
    JsonOutput json;
};

void declare_area(Parser& parser, AreaOptions& o) {
    config_options(parser, o.config);
    parser
        .option("--unit", o.units,
                "count only these units, separated by commas, without a page and without speeds")
        .by_commas();
    parser.option("-o,--output", o.output, "Markdown file to write; it also has the speed of simulation");
    fresh_option(parser, o.fresh);
    threads_option(parser, o.threads);
    json_option(parser, o.json);
}

void check_names(const std::vector<std::string>& only) {
    std::vector<std::string> names;
    for (const area::UnitRow& row : area::unit_rows()) names.push_back(row.name);
    for (const std::string& name : only)
        if (std::find(names.begin(), names.end(), name) == names.end())
            throw UserError(fmt::format("--unit: no unit is called {}{}; there are {}", shown(name),
                                        did_you_mean(name, names), fmt::join(names, ", ")));
}

std::string command_of(const AreaOptions& o) {
    std::string text = "rayclock study area -o " + page_path(o.output);
    if (o.config.name != ConfigChoice{}.name) text += " --config " + page_path(o.config.name);
    for (const std::string& item : o.config.set) text += " --set " + item;
    return text;
}

int run_area(const AreaOptions& o) {
    check_names(o.units);
    if (!o.units.empty() && !o.output.empty())
        throw UserError("--unit: a page has all units; leave out --unit, or --output");
    const Config base = load_config(o.config);
    std::vector<area::Variant> variants = area::variants_of(base);
    o.json.check();
    if (!o.output.empty()) check_writable(o.output);
    const Progress progress = terminal_progress();
    results::Cache cache(rtl_cache() / "area", o.fresh);
    const area::Areas areas = area::run(std::move(variants), o.units, o.threads, cache, progress);
    if (areas.partial)
        throw Interrupted("interrupted: no page was written; the same command continues where it stopped");
    const std::vector<area::Speed> speeds =
        o.output.empty() ? std::vector<area::Speed>{} : area::page_speeds(areas, progress);
    if (!o.json.is_alone()) {
        fmt::print("{} different units of {} machines, {} of them known before\n\n{}", areas.different,
                   areas.variants.size(), areas.known, area::table(areas));
        if (!cache.trouble().empty()) fmt::print("  nothing is kept for the next run: {}\n", cache.trouble());
    }
    if (!o.output.empty()) write_file(o.output, area::page(areas, speeds, base.name, command_of(o)));
    o.json.write(area::json(areas, speeds));
    return 0;
}

}   // namespace

Command area_command() {
    return command("area", "docs/measured/area.md: the ECP5 resources of each unit",
                   "rayclock study area -o docs/measured/area.md", declare_area, run_area);
}

}   // namespace rayclock

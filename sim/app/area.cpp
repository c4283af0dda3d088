// rayclock area: what each unit takes of an ECP5, with and without the units that a scene may need; the page docs/area.md.
#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "model/core/error.hpp"
#include "model/core/nearest.hpp"
#include "sim/app/commands.hpp"
#include "sim/area/page.hpp"
#include "sim/engine/engine.hpp"
#include "sim/image/image.hpp"
#include "sim/report/text.hpp"
#include "sim/rtl/builder.hpp"

namespace rayclock {

namespace {

// A scene that needs shading and no other unit, so that one machine has them idle and one has them not.
const area::SpeedFrame speed_frame{"mirrors", "96x72", 4};
constexpr int speed_rounds = 3;

void check_names(const std::vector<std::string>& only) {
    std::vector<std::string> names;
    for (const area::UnitRow& row : area::unit_rows()) names.push_back(row.name);
    for (const std::string& name : only)
        if (std::find(names.begin(), names.end(), name) == names.end())
            throw UserError(fmt::format("--unit: no unit is called {}{}; there are {}", shown(name), did_you_mean(name, names), fmt::join(names, ", ")));
}

std::vector<area::Speed> speeds_of(const area::Areas& areas, const Progress& progress) {
    Options o;
    o.scene = speed_frame.scene;
    const FrameSize size = parse_size(speed_frame.size);
    Whitted settings;
    settings.depth = speed_frame.depth;
    const std::vector<area::Variant> machines{areas.variants[0], areas.variants[1], areas.variants.back()};
    return area::measure(machines, ready_scene(o, size, progress), size, settings, speed_rounds, progress);
}

/// What to type for this page. Where this machine keeps its files is nobody's business.
std::string command_of(const Options& o) {
    const std::filesystem::path path(o.output), config(o.config);
    std::string text = "rayclock area -o " + (path.is_absolute() ? path.filename() : path).string();
    if (o.config != Options{}.config) text += " --config " + (config.is_absolute() ? config.filename() : config).string();
    for (const std::string& item : o.set) text += " --set " + item;
    return text;
}

} // namespace

int area_command(const Options& o) {
    catch_interrupts();
    check_names(o.units);
    if (!o.units.empty() && !o.output.empty()) throw UserError("--unit: a page has all units; leave out --unit, or --output");
    const Config base = load_config(o.config, o.set);
    std::vector<area::Variant> variants = area::variants_of(base);
    check_outputs(o);
    if (!o.output.empty()) check_writable(o.output);
    const Progress progress = terminal_progress();
    sweep::Cache cache(rtl_cache() / "area", o.fresh);
    const area::Areas areas = area::run(std::move(variants), o.units, o.threads, cache, progress);
    if (areas.partial) throw UserError("interrupted: no page was written; the same command goes on where it was");
    const std::vector<area::Speed> speeds = o.output.empty() ? std::vector<area::Speed>{} : speeds_of(areas, progress);
    if (o.json != "-") {
        fmt::print("{} different units of {} machines, {} of them known before\n\n{}", areas.different, areas.variants.size(), areas.known, area::table(areas));
        if (!cache.trouble().empty()) fmt::print("  nothing is kept for the next run: {}\n", cache.trouble());
    }
    if (!o.output.empty()) write_file(o.output, area::page(areas, speeds, speed_frame, base.name, command_of(o)));
    if (!o.json.empty()) write_file(o.json, area::json(areas, speeds).dump(2) + "\n");
    return 0;
}

} // namespace rayclock

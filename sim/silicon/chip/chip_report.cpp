// Formats results of chips as text and as JSON.
#include "sim/silicon/chip/chip_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "sim/files/table.hpp"
#include "sim/silicon/area/variants.hpp"
#include "sim/silicon/chip/cells.hpp"
#include "sim/silicon/chip/nextpnr.hpp"
#include "sim/silicon/synth/yosys.hpp"

namespace rayclock::chip {

using nlohmann::ordered_json;

namespace {

/// Returns the units in the order in which a ray meets them, followed by everything outside the pipeline.
std::vector<std::string> in_order(const std::map<std::string, Use>& units) {
    std::vector<std::string> names;
    for (const area::UnitRow& row : area::unit_rows())
        if (units.contains(row.name)) names.push_back(row.name);
    for (const auto& [unit, use] : units)
        if (std::find(names.begin(), names.end(), unit) == names.end() && unit != harness_unit)
            names.push_back(unit);
    return names;
}

/// Returns the counts after placement if there are any, else those after synthesis.
const std::map<std::string, Use>& units_of(const Result& r) {
    return r.routes.empty() ? r.units : r.best().units;
}

std::vector<std::string> row(const std::string& name, const Use& use) {
    return {name, grouped(use.lut), grouped(use.ff), grouped(use.dsp), grouped(use.bram)};
}

std::string percent(std::uint64_t part, std::uint64_t all) {
    return fmt::format("{:.1f} %", 100.0 * double(part) / double(all));
}

std::string area_table(const Result& r) {
    Table table({r.routes.empty() ? "synthesised" : "placed", "LUT", "FF", "MULT18X18D", "DP16KD"});
    const std::map<std::string, Use>& units = units_of(r);
    const Use all = total_of(units), &has = r.request.device.has;
    for (const std::string& unit : in_order(units)) table.add(row(unit, units.at(unit)));
    table.add(row("in all", all));
    table.add(row(r.request.device.name + " has", has));
    table.add({"", percent(all.lut, has.lut), percent(all.ff, has.ff), percent(all.dsp, has.dsp),
               percent(all.bram, has.bram)});
    if (units.contains(harness_unit))
        table.add(row(r.request.is_board() ? "pins and resets around it" : "harness around it",
                      units.at(harness_unit)));
    return table.text();
}

/// Returns the ends of a path: "box.s3_q -> box.s4_q".
std::string ends_of(const PathRow& p) {
    return fmt::format("{}.{} -> {}.{}", p.from_unit, p.from, p.to_unit, p.to);
}

std::string path_table(const Route& route) {
    Table table({"slowest paths", "ends at", "MHz", "ns", "in cells", "cells"}, 2);
    for (const PathRow& p : route.paths)
        table.add({ends_of(p), p.source, fmt::format("{:.1f}", p.mhz()), fmt::format("{:.2f}", p.ns),
                   fmt::format("{:.2f}", p.logic_ns), grouped(std::uint64_t(p.levels))});
    return table.text();
}

std::string clock_table(const Route& route) {
    Table table({"clock", "target, MHz", "routed, MHz", ""});
    for (const Clock& c : route.clocks)
        table.add({c.name, fmt::format("{:.1f}", c.target), fmt::format("{:.1f}", c.achieved),
                   c.is_met() ? "met" : "MISSED"});
    return table.text();
}

std::string seeds_text(const Result& r) {
    std::vector<std::string> all;
    for (const Route& route : r.routes) all.push_back(fmt::format("{}: {:.1f}", route.seed, route.fmax_mhz));
    return fmt::format("{}", fmt::join(all, ", "));
}

std::string name_of(const Request& r) {
    if (r.is_board()) return fmt::format("ULX3S with '{}' at {:g} MHz", r.config.name, r.khz / 1e3);
    return r.top == "chip" ? fmt::format("'{}'", r.config.name)
                           : fmt::format("{} of '{}', alone", r.top, r.config.name);
}

ordered_json use_json(const Use& use) {
    ordered_json json;
    for (const Resource& resource : resources()) json[resource.key] = use.*resource.member;
    return json;
}

ordered_json path_json(const PathRow& p) {
    return {{"mhz", p.mhz()},
            {"ns", p.ns},
            {"logic_ns", p.logic_ns},
            {"levels", p.levels},
            {"from_unit", p.from_unit},
            {"from", p.from},
            {"to_unit", p.to_unit},
            {"to", p.to},
            {"stage", p.from + " -> " + p.to},
            {"source", p.source}};
}

}   // namespace

std::string text(const Result& r) {
    std::string text = fmt::format("{} on {} ({}, speed grade {}); {}, nextpnr-ecp5 {}\n\n{}\n",
                                   name_of(r.request), r.request.device.name, package_name, speed_grade,
                                   synth::yosys_version().substr(0, synth::yosys_version().find(" (")),
                                   nextpnr().version, area_table(r));
    if (!r.fits()) return text + "  " + r.misfit + "\n";
    const Route& best = r.best();
    text += fmt::format("  routed: {:.1f} MHz with seed {}", best.fmax_mhz, best.seed);
    if (r.routes.size() > 1) text += fmt::format(" (by seed {})", seeds_text(r));
    const Methods &methods = r.request.methods, usual;
    if (methods.placer != usual.placer || methods.router != usual.router)
        text += fmt::format(", placer {}, {}", methods.placer, methods.router);
    if (methods.placements > 1) text += fmt::format(", placed {} times", methods.placements);
    if (!best.clocks.empty()) text += "\n\n" + clock_table(best);
    return text + (best.clocks.empty() ? "\n\n" : "\n") + path_table(best);
}

ordered_json json(const Result& r) {
    const std::map<std::string, Use>& units = units_of(r);
    ordered_json seeds = ordered_json::array(), paths = ordered_json::array(),
                 by_unit = ordered_json::object();
    for (const Route& route : r.routes) seeds.push_back({{"seed", route.seed}, {"fmax_mhz", route.fmax_mhz}});
    for (const std::string& unit : in_order(units)) by_unit[unit] = use_json(units.at(unit));
    if (!r.routes.empty())
        for (const PathRow& p : r.best().paths) paths.push_back(path_json(p));
    ordered_json json{{"top", r.request.top},
                      {"device", r.request.device.name},
                      {"fits", r.fits()},
                      {"routed", !r.routes.empty()},
                      {"placer", r.request.methods.placer},
                      {"router", r.request.methods.router},
                      {"placements", r.request.methods.placements}};
    json["fmax_mhz"] = r.routes.empty() ? ordered_json(nullptr) : ordered_json(r.best().fmax_mhz);
    if (r.request.is_board()) {
        ordered_json clocks = ordered_json::array();
        if (!r.routes.empty())
            for (const Clock& c : r.best().clocks)
                clocks.push_back({{"name", c.name}, {"target_mhz", c.target}, {"fmax_mhz", c.achieved}});
        json["clocks"] = clocks;
        json["bitstream_bytes"] = r.bitstream.size();
    }
    json["seeds"] = seeds;
    json["totals"] = use_json(total_of(units));
    json["has"] = use_json(r.request.device.has);
    json["harness"] = use_json(units.contains(harness_unit) ? units.at(harness_unit) : Use{});
    json["units"] = by_unit;
    json["paths"] = paths;
    json["misfit"] = r.fits() ? ordered_json(nullptr) : ordered_json(r.misfit);
    json["tools"] = {{"yosys", synth::yosys_version()}, {"nextpnr", nextpnr().version}};
    return json;
}

std::string table(const std::vector<Result>& alone) {
    Table table({"alone", "slowest path", "ends at", "LUT", "FF", "MULT18X18D", "DP16KD", "MHz"}, 3);
    for (const Result& r : alone) {
        const Use use = total_of(units_of(r));
        std::vector<std::string> cells{
            r.request.top, "", "", grouped(use.lut), grouped(use.ff), grouped(use.dsp), grouped(use.bram),
            "does not fit"};
        if (r.fits()) {
            const Route& best = r.best();
            cells.back() = fmt::format("{:.1f}", best.fmax_mhz);
            if (!best.paths.empty()) cells[1] = ends_of(best.paths[0]), cells[2] = best.paths[0].source;
        }
        table.add(cells);
    }
    return table.text();
}

}   // namespace rayclock::chip

// Sums the kept results of units, and compares the sum with the routed chip.
#include "sim/silicon/chip/estimate.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"
#include "sim/files/table.hpp"
#include "sim/silicon/area/variants.hpp"

namespace rayclock::chip {

using nlohmann::ordered_json;

namespace {

/// Formats the relative deviation: "+5.0 %" if the estimate is 5 % above the routed value.
std::string more_than(double estimated, double routed) {
    return fmt::format("{:+.1f} %", 100 * (estimated / routed - 1));
}

Use times(std::uint64_t n, const Use& use) { return {n * use.lut, n * use.ff, n * use.dsp, n * use.bram}; }

}   // namespace

Estimate estimate(const Request& request, results::Cache& cache, const Progress& progress) {
    Estimate made;
    std::vector<std::string> missing;
    std::uint64_t done = 0;
    for (const area::UnitRow& row : area::unit_rows()) {
        if (progress) progress(fmt::format("estimate, {}", row.name), done, area::unit_rows().size());
        ++done;
        if (!row.is_there(request.config)) continue;
        Request alone = request;
        alone.top = row.name;
        alone.methods = usual_methods(row.name);
        const std::optional<Result> found = kept(alone, cache);
        if (!found || !found->fits()) {
            missing.push_back(row.name);
            continue;
        }
        const std::uint64_t n = row.in_pipeline ? std::uint64_t(request.config.pipelines) : 1;
        made.units[row.name] = times(n, total_of(found->best().units));
        made.all += made.units[row.name];
        if (made.slowest.empty() || found->best().fmax_mhz < made.fmax_mhz)
            made.slowest = row.name, made.fmax_mhz = found->best().fmax_mhz;
    }
    if (!missing.empty())
        throw UserError(
            fmt::format("--fast: {} of '{}' {} not routed on {} with these seeds; the same command with "
                        "--unit {} instead of --fast routes them",
                        fmt::join(missing, ", "), printable(request.config.name),
                        missing.size() > 1 ? "were" : "was", request.device.name, fmt::join(missing, ",")));
    Request whole = request;
    made.routed = kept(whole, cache);
    if (made.routed && made.routed->routes.empty()) made.routed.reset();
    return made;
}

std::string text(const Estimate& e, const Request& request) {
    std::string text = fmt::format("'{}' on {}, estimated from its units, each routed alone\n\n",
                                   printable(request.config.name), request.device.name);
    Table table({"estimated", "LUT", "FF", "MULT18X18D", "DP16KD"});
    const auto add = [&](const std::string& name, const Use& u) {
        table.add({name, grouped(u.lut), grouped(u.ff), grouped(u.dsp), grouped(u.bram)});
    };
    for (const area::UnitRow& row : area::unit_rows())
        if (const auto at = e.units.find(row.name); at != e.units.end()) add(row.name, at->second);
    add("in all", e.all);
    add(request.device.name + " has", request.device.has);
    text += table.text() +
            fmt::format("\n  estimated: {:.1f} MHz, the clock of {} alone\n", e.fmax_mhz, e.slowest);
    if (!e.routed)
        return text + "  the chip itself was not routed; the same command without --fast routes it\n";
    const Use routed = total_of(e.routed->best().units);
    return text +
           fmt::format(
               "  the chip itself, routed: {:.1f} MHz, {} LUTs; in comparison the estimate is {} and {}\n",
               e.routed->best().fmax_mhz, grouped(routed.lut),
               more_than(e.fmax_mhz, e.routed->best().fmax_mhz),
               more_than(double(e.all.lut), double(routed.lut)));
}

ordered_json json(const Estimate& e, const Request& request) {
    const auto use_json = [](const Use& use) {
        ordered_json json;
        for (const Resource& resource : resources()) json[resource.key] = use.*resource.member;
        return json;
    };
    ordered_json units = ordered_json::object();
    for (const auto& [unit, use] : e.units) units[unit] = use_json(use);
    const Use has = request.device.has;
    const bool fits =
        e.all.lut <= has.lut && e.all.ff <= has.ff && e.all.dsp <= has.dsp && e.all.bram <= has.bram;
    ordered_json json{{"top", "chip"},
                      {"device", request.device.name},
                      {"fits", fits},
                      {"routed", false},
                      {"estimated", true},
                      {"fmax_mhz", e.fmax_mhz},
                      {"slowest_unit", e.slowest},
                      {"totals", use_json(e.all)},
                      {"has", use_json(has)},
                      {"units", units}};
    json["fmax_mhz_routed"] = e.routed ? ordered_json(e.routed->best().fmax_mhz) : ordered_json(nullptr);
    return json;
}

}   // namespace rayclock::chip

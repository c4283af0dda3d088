// Formats the result of fit as tables and as JSON.
#include "sim/explore/fit/fit_report.hpp"

#include <array>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "sim/view/report/json.hpp"
#include "sim/view/report/text.hpp"

namespace rayclock::fit {

using nlohmann::ordered_json;

namespace {

const char* verdict(const Signal& s) {
    if (s.fits()) return "fits";
    switch (s.excess) {
        case Excess::wraps: return "wraps, the sum fits";
        case Excess::saturates: return "saturates";
        case Excess::never: break;
    }
    return "OVERFLOWS";
}

/// Writes long numbers as a power of two. The JSON has their decimal digits.
std::string shorter(Int128 value) {
    const Int128 size = value < 0 ? -value : value;
    if (size < 10'000'000) return text(value);
    const double power = std::log2(double(size));
    return fmt::format("{}2^{:.2f}", value < 0 ? "-" : "", power);
}

/// A width that is a constant of the machine, and the width that the scene needs.
struct Constant {
    const char* name;
    int there, needed;
};
std::array<Constant, 3> constants(const Ranges& ranges) {
    const auto needed = [&](const char* unit, const char* name) {
        for (const Signal& s : ranges.signals)
            if (s.unit == unit && s.name == name) return s.needed();
        throw std::logic_error(std::string("no signal is called ") + unit + "." + name);
    };
    return {{{"exp_bits", exp_bits, std::max(needed("box", "exp"), needed("raygen", "len"))},
             {"offset_bits", offset_bits, needed("list", "offset")},
             {"count_bits", count_bits, needed("box", "kind")}}};
}

/// Formats the parts of a cost.
struct CostPart {
    const char *words, *key;
    std::uint64_t Cost::*of;
};
constexpr std::array cost_parts{
    CostPart{"multipliers, adders", "multiplier_adders", &Cost::multiplier_adders},
    CostPart{"dividers, adders", "divider_adders", &Cost::divider_adders},
    CostPart{"contexts, memory bits", "ray_bits", &Cost::ray_bits},
    CostPart{"of these stacks", "stack_bits", &Cost::stack_bits},
    CostPart{"caches, memory bits", "cache_bits", &Cost::cache_bits}};

int lines_of(const Fit& fit) { return int(fit.outcome.compile.bytes / line_bytes); }

}   // namespace

std::string parameter_table(const Fit& fit, const Config& base) {
    Table table({"parameter", "for", "one step below", base.name, "fitted"}, 3);
    for (const Fitted& f : fit.parameters)
        table.add({f.parameter->key, purpose_name(f.purpose), f.below, std::to_string(f.parameter->get(base)),
                   std::to_string(f.value)});
    return table.text();
}

std::string needs_text(const Fit& fit, const Config& base, const Ranges& ranges) {
    const Cost &now = fit.cost, &before = fit.base_cost;
    Table table({"", base.name, "fitted"});
    for (const CostPart& part : cost_parts)
        table.add({part.words, grouped(before.*part.of), grouped(now.*part.of)});
    table.add({"cost", grouped(before.total()), grouped(now.total())});
    std::string fixed;
    if (!ranges.signals.empty())
        for (const Constant& c : constants(ranges))
            fixed += fmt::format(
                "{} {} {} of {}",
                fixed.empty() ? "  constants of the machine, bits needed of the bits present:" : ",", c.name,
                c.needed, c.there);
    return fmt::format(
        "  memory image: {} bytes, {} lines of {} bytes, addresses of {} bits; a ray keeps up to {} groups "
        "of siblings\n{}{}\n{}",
        grouped(fit.outcome.compile.bytes), grouped(std::uint64_t(lines_of(fit))), line_bytes,
        fit.config.addr_bits, fit.outcome.compile.stack_need, fixed, fixed.empty() ? "" : "\n", table.text());
}

std::string units_text(const Config& config) {
    if (config.shading) return "  units: those that the finished picture of this scene needs\n";
    return fmt::format(
        "  units: triangles and camera rays need all units of the machine{}; those for spheres, planes and "
        "finished pictures are left out\n",
        config.l2_sets > 0 ? "" : " except the shared cache, which is left out");
}

ordered_json units_json(const Config& config) {
    ordered_json needed = ordered_json::array(), absent = ordered_json::array();
    for (const auto& [name, there] :
         {std::pair{"sphere", config.spheres}, {"plane", config.planes}, {"bounce", config.shading}})
        (there ? needed : absent).push_back(name);
    for (std::size_t u = 0; u < unit_count; ++u)
        (is_there(Unit(u), config) ? needed : absent).push_back(unit_infos[u].name);
    return {{"needed", needed}, {"absent", absent}};
}

std::string range_table(const Ranges& ranges) {
    Table table({"unit", "signal", "verdict", "from", "to", "needed", "there"}, 3);
    std::size_t wraps = 0, saturates = 0;
    for (const Signal& s : ranges.signals) {
        table.add({s.unit, s.name, verdict(s), shorter(s.range.lo), shorter(s.range.hi),
                   std::to_string(s.needed()), std::to_string(s.there)});
        wraps += !s.fits() && s.excess == Excess::wraps;
        saturates += !s.fits() && s.excess == Excess::saturates;
    }
    return fmt::format(
        "{}  {}: {} signals, {} of them terms that wrap in a sum that fits, {} that saturate\n", table.text(),
        ranges.proven() ? "no overflow possible" : "OVERFLOW POSSIBLE", ranges.signals.size(), wraps,
        saturates);
}

ordered_json parameters_json(const Fit& fit, const Config& base) {
    ordered_json list = ordered_json::array();
    for (const Fitted& f : fit.parameters)
        list.push_back({{"key", f.parameter->key},
                        {"value", f.value},
                        {"base", f.parameter->get(base)},
                        {"for", purpose_name(f.purpose)},
                        {"one_step_below", f.below}});
    return list;
}

ordered_json needs_json(const Fit& fit, const Ranges& ranges) {
    ordered_json fixed = ordered_json::array();
    if (!ranges.signals.empty())
        for (const Constant& c : constants(ranges))
            fixed.push_back({{"name", c.name}, {"bits_there", c.there}, {"bits_needed", c.needed}});
    return {{"bytes", fit.outcome.compile.bytes},
            {"lines", lines_of(fit)},
            {"addr_bits", fit.config.addr_bits},
            {"stack_need", fit.outcome.compile.stack_need},
            {"stack_depth", fit.config.stack_depth},
            {"stack_bits", fit.cost.stack_bits},
            {"constants", fixed}};
}

ordered_json cost_json(const Cost& cost) {
    ordered_json json;
    for (const CostPart& part : cost_parts) json[part.key] = cost.*part.of;
    json["total"] = cost.total();
    return json;
}

ordered_json ranges_json(const Ranges& ranges) {
    ordered_json signals = ordered_json::array();
    for (const Signal& s : ranges.signals)
        signals.push_back({{"unit", s.unit},
                           {"signal", s.name},
                           {"signed", s.is_signed},
                           {"from", text(s.range.lo)},
                           {"to", text(s.range.hi)},
                           {"bits_needed", s.needed()},
                           {"bits_there", s.there},
                           {"verdict", verdict(s)}});
    return {{"overflow_possible", !ranges.proven()}, {"signals", signals}};
}

ordered_json outcome_json(const Measurement& o) {
    return {{"pixels", o.pixels},
            {"pixels_other_primitive", o.other},
            {"psnr_db", decibel(o.psnr_db)},
            {"work", o.work}};
}

}   // namespace rayclock::fit

// Formats the results of a stress run.
#include "sim/explore/stress/stress_report.hpp"

#include <fmt/format.h>

#include "sim/view/report/text.hpp"

namespace rayclock::stress {

namespace {

using nlohmann::ordered_json;

std::vector<std::string> figures(const Counts& c) {
    return {grouped(c.rays),
            grouped(c.leaks),
            grouped(c.double_hits),
            grouped(c.oracle_mismatches),
            c.shadow_rays > 0 ? grouped(c.false_shadows) : "",
            c.shadow_rays > 0 ? grouped(c.light_leaks) : "",
            extra_boxes(c)};
}
std::vector<std::string> row(const std::string& name, const Counts& c) {
    std::vector<std::string> cells = figures(c);
    cells.insert(cells.begin(), name);
    return cells;
}

void add_figures(ordered_json& json, const Counts& c) {
    json["rays"] = c.rays;
    json["crossings"] = c.crossings;
    json["leaks"] = c.leaks;
    json["double_hits"] = c.double_hits;
    json["oracle_mismatches"] = c.oracle_mismatches;
    json["false_shadows"] = c.false_shadows;
    json["light_leaks"] = c.light_leaks;
    json["shadow_rays"] = c.shadow_rays;
    json["walked"] = c.walked;
    json["boxes"] = c.boxes;
    json["boxes_extra"] = c.boxes_extra;
    json["boxes_lost"] = c.boxes_lost;
}

}   // namespace

const char* verdict(const NamedTest& test, const std::vector<Cell>& cells) {
    const bool met = meets_demand(test, cells);
    if (has_too_few_rays(test, cells))
        return in_machine(test) ? "too few rays: the families that must leak do not show it yet (--rays)"
                                : "too few rays for this control to be noticed (--rays)";
    switch (test.demand) {
        case Demand::truth:
            return met ? "every decision is the exact one" : "WRONG: not every decision is the exact one";
        case Demand::watertight: return met ? "watertight" : "WRONG: not watertight";
        case Demand::nothing: return "a baseline: nothing is demanded";
        default: return met ? "a control: noticed" : "WRONG: this control was not noticed";
    }
}

std::string extra_boxes(const Counts& c) {
    return c.boxes > c.boxes_extra
               ? fmt::format("{:.2f} %", 100.0 * double(c.boxes_extra) / double(c.boxes - c.boxes_extra))
               : "";
}

std::string text(const Plan& plan, const StressResult& outcome) {
    std::string out;
    for (const std::string& name : plan.tests) {
        const NamedTest& test = named_test(name);
        const auto of_test = [&](const Cell& cell) { return cell.test == name; };
        Table table({"family", "rays", "leaks", "double hits", "oracle mismatches", "false shadows",
                     "light leaks", "extra boxes"});
        for (const std::string& family : plan.families)
            table.add(row(family, sum(outcome.cells, [&](const Cell& cell) {
                              return of_test(cell) && cell.family == family;
                          })));
        if (plan.bits.size() > 1)
            for (const int bits : plan.bits)
                table.add(
                    row(fmt::format("all sound, N = {}", bits), sum(outcome.cells, [&](const Cell& cell) {
                            return of_test(cell) && cell.bits == bits && !stress::family(cell.family).leaks;
                        })));
        const bool told = outcome.partial || sum(outcome.cells, of_test).rays == 0;
        out += fmt::format("{}: {}\n{}  {}\n\n", name, test.what, table.text(),
                           told ? "unfinished" : verdict(test, outcome.cells));
    }
    out += fmt::format(
        "{} rays in {:.1f} s, {:.2f} M rays/s a core{}{}\n", grouped(outcome.rays - outcome.rays_before),
        outcome.seconds,
        double(outcome.rays - outcome.rays_before) / 1e6 / std::max(1e-9, outcome.core_seconds),
        outcome.rays_before > 0 ? fmt::format("; {} were done before", grouped(outcome.rays_before)) : "",
        outcome.partial ? "; PARTIAL: interrupted" : "");
    return out;
}

ordered_json json(const Plan& plan, const StressResult& outcome) {
    ordered_json tests = ordered_json::array(), verdicts = ordered_json::object(),
                 few = ordered_json::object(), total;
    for (const Cell& cell : outcome.cells) {
        ordered_json one{{"test", cell.test}, {"bits", cell.bits}, {"family", cell.family}};
        add_figures(one, cell.counts);
        tests.push_back(std::move(one));
    }
    add_figures(total, sum(outcome.cells, [](const Cell&) { return true; }));
    for (const std::string& name : plan.tests) {
        const NamedTest& test = named_test(name);
        const auto unless_partial = [&](bool value) {
            return outcome.partial ? ordered_json(nullptr) : ordered_json(value);
        };
        verdicts[name] = unless_partial(meets_demand(test, outcome.cells));
        few[name] = unless_partial(has_too_few_rays(test, outcome.cells));
    }
    return {{"seed", plan.seed},
            {"tests", tests},
            {"total", total},
            {"good", verdicts},
            {"too_few_rays", few},
            {"partial", outcome.partial},
            {"host",
             {{"seconds", outcome.seconds},
              {"rays_per_core_second",
               double(outcome.rays - outcome.rays_before) / std::max(1e-9, outcome.core_seconds)}}}};
}

}   // namespace rayclock::stress

#include "sim/stress/state.hpp"

#include <fstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "model/core/error.hpp"
#include "sim/report/text.hpp"

namespace rayclock::stress {

namespace {

using nlohmann::ordered_json;

/// All that decides which rays are shot.
ordered_json plan_json(const Plan& plan) {
    return {{"tests", plan.tests}, {"bits", plan.bits}, {"families", plan.families}, {"rays", plan.rays}, {"seed", plan.seed}};
}

ordered_json counts_json(const Counts& c) {
    return {c.rays, c.leaks, c.double_hits, c.oracle_mismatches, c.crossings, c.walked, c.boxes, c.boxes_extra, c.boxes_lost, c.shadow_rays, c.false_shadows, c.light_leaks};
}

Counts counts_of(const ordered_json& json) {
    const auto at = [&](std::size_t i) { return json.at(i).get<std::uint64_t>(); };
    return {at(0), at(1), at(2), at(3), at(4), at(5), at(6), at(7), at(8), at(9), at(10), at(11)};
}

} // namespace

std::uint64_t read_state(const Plan& plan, std::vector<Cell>& cells) {
    std::ifstream file(plan.state);
    ordered_json json;
    try {
        json = ordered_json::parse(file);
        if (json.at("plan") != plan_json(plan))
            throw UserError(plan.state + ": is the state of another stress run; name another file, or the run's own options");
        const ordered_json& counts = json.at("counts");
        if (counts.size() != cells.size()) throw UserError(fmt::format("{}: has {} rows instead of {}", plan.state, counts.size(), cells.size()));
        for (std::size_t i = 0; i < cells.size(); ++i) cells[i].counts = counts_of(counts.at(i));
        return json.at("batches").get<std::uint64_t>();
    } catch (const ordered_json::exception& e) {
        throw UserError(fmt::format("{}: is no state of a stress run ({})", plan.state, e.what()));
    }
}

void write_state(const Plan& plan, const std::vector<Cell>& cells, std::uint64_t batches) {
    ordered_json counts = ordered_json::array();
    for (const Cell& cell : cells) counts.push_back(counts_json(cell.counts));
    write_file(plan.state, ordered_json{{"plan", plan_json(plan)}, {"batches", batches}, {"counts", counts}}.dump(1) + "\n");
}

} // namespace rayclock::stress

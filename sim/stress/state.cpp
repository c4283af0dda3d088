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

ordered_json counts_json(const Counts& c) { return {c.rays, c.leaks, c.double_hits, c.oracle_mismatches, c.crossings, c.walked}; }

Counts counts_of(const ordered_json& json) {
    return {json.at(0).get<std::uint64_t>(), json.at(1).get<std::uint64_t>(), json.at(2).get<std::uint64_t>(),
            json.at(3).get<std::uint64_t>(), json.at(4).get<std::uint64_t>(), json.at(5).get<std::uint64_t>()};
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

// Reads and writes the state of a stress run.
#include "sim/explore/stress/state.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "model/base/error.hpp"
#include "sim/files/cache/results.hpp"
#include "sim/files/input.hpp"
#include "sim/files/json_value.hpp"
#include "sim/files/text.hpp"
#include "sim/view/report/text.hpp"

namespace rayclock::stress {

namespace {

using nlohmann::ordered_json;

/// Returns everything that determines the rays.
ordered_json plan_json(const Plan& plan) {
    return {{"tests", plan.tests},
            {"bits", plan.bits},
            {"families", plan.families},
            {"rays", plan.rays},
            {"seed", plan.seed}};
}

ordered_json counts_json(const Counts& c) {
    ordered_json row = ordered_json::array();
    for (const auto field : count_fields) row.push_back(c.*field);
    return row;
}

/// Reads a row of counts. It must have exactly `rays` rays, and no count may exceed what these can give.
Counts counts_of(const JsonValue& in, std::uint64_t rays) {
    constexpr std::uint64_t most = std::uint64_t{1} << 53;   // sums of rows stay far below 2^64
    if (in.array().size() != count_fields.size())
        in.expected(fmt::format("{} whole numbers", count_fields.size()));
    Counts c;
    for (std::size_t i = 0; i < count_fields.size(); ++i) c.*count_fields[i] = in[i].whole(most);
    if (c.rays != rays) in.refuse(fmt::format("has {} rays; this number of batches has {}", c.rays, rays));
    const bool is_possible = c.leaks <= rays && c.double_hits <= rays && c.oracle_mismatches <= rays &&
                             c.walked <= rays && c.boxes_extra <= c.boxes &&
                             c.false_shadows <= c.shadow_rays && c.light_leaks <= c.shadow_rays;
    if (!is_possible) in.refuse("has counts that this number of rays cannot give");
    return c;
}

std::string check_of(const ordered_json& batches, const ordered_json& counts) {
    return results::hash_text(batches.dump() + counts.dump());   // protects against mistakes, not against
                                                                 // malice
}

}   // namespace

std::uint64_t read_state(const Plan& plan, std::vector<Cell>& cells, std::uint64_t batches_in_all,
                         const RaysOfCells& rays_after) {
    constexpr std::uint64_t max_bytes = std::uint64_t{1} << 24;
    return parse_state(plan, read_file(plan.state, {}, max_bytes, Owner::program), cells, batches_in_all,
                       rays_after);
}

std::uint64_t parse_state(const Plan& plan, std::string_view text, std::vector<Cell>& cells,
                          std::uint64_t batches_in_all, const RaysOfCells& rays_after) {
    const Json json = parse_json(plan.state, text);
    const JsonValue in(json, plan.state);
    in.only_keys({"plan", "batches", "counts", "check"});
    if (in.at("plan").object().raw() != Json(plan_json(plan)))
        SourcePosition{plan.state}.refuse(
            "is the state of another stress run; name another file, or the run's own options");
    const std::uint64_t batches = in.at("batches").whole(batches_in_all + 1);
    const JsonValue counts = in.at("counts").array();
    if (counts.size() != cells.size())
        counts.refuse(fmt::format("has {} rows instead of {}", counts.size(), cells.size()));
    const std::vector<std::uint64_t> rays = rays_after(batches);
    for (std::size_t i = 0; i < cells.size(); ++i) cells[i].counts = counts_of(counts[i], rays[i]);
    if (in.at("check").string() != check_of(in.at("batches").raw(), counts.raw()))
        in.refuse("was changed after it was written: its checksum is wrong");
    return batches;
}

void write_state(const Plan& plan, const std::vector<Cell>& cells, std::uint64_t batches) {
    ordered_json counts = ordered_json::array();
    for (const Cell& cell : cells) counts.push_back(counts_json(cell.counts));
    const ordered_json json{{"plan", plan_json(plan)},
                            {"batches", batches},
                            {"counts", counts},
                            {"check", check_of(batches, counts)}};
    write_file(plan.state, json.dump(1) + "\n");
}

}   // namespace rayclock::stress

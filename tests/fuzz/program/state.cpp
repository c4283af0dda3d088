// Fuzzes the state of a stress run.
#include <nlohmann/json.hpp>

#include "sim/files/json_value.hpp"
#include "sim/explore/stress/state.hpp"
#include "sim/files/cache/results.hpp"
#include "tests/fuzz/program/targets.hpp"

namespace rayclock::fuzz {
namespace {

constexpr std::uint64_t rays_of_a_batch = 1000, batches_in_all = 4;

std::vector<std::uint64_t> rays_after(std::uint64_t batches) {
    demand(batches <= batches_in_all, "nobody has done more than there is");
    return {rays_of_a_batch * (batches + 1) / 2, rays_of_a_batch * (batches / 2)};
}

void check_state(std::string_view text) {
    stress::Plan plan;
    plan.bits = {16};
    plan.families = {"edges", "shells"};
    plan.rays = rays_of_a_batch * batches_in_all;
    plan.state = file("fuzzed-state.json").string();
    std::vector<stress::Cell> cells{{"exact", 16, "edges", {}}, {"exact", 16, "shells", {}}};
    passes([&] {
        const std::uint64_t batches = stress::parse_state(plan, text, cells, batches_in_all, rays_after);
        for (std::size_t i = 0; i < cells.size(); ++i) {
            const stress::Counts& c = cells[i].counts;
            demand(c.rays == rays_after(batches)[i], "a state has the rays of its batches");
            demand(c.leaks <= c.rays && c.double_hits <= c.rays && c.oracle_mismatches <= c.rays &&
                       c.walked <= c.rays,
                   "no count is above that of rays");
            demand(c.boxes_extra <= c.boxes && c.false_shadows <= c.shadow_rays &&
                       c.light_leaks <= c.shadow_rays,
                   "no part is above its whole");
        }
    });
}

}   // namespace

void state(std::string_view bytes) {
    check_state(bytes);
    // Try again with a correct checksum, which mutation would never find.
    if (!passes([&] { parse_json("fuzzed.json", bytes); })) return;
    auto json = nlohmann::ordered_json::parse(bytes, nullptr, false);
    if (!json.is_object() || !json.contains("batches") || !json.contains("counts")) return;
    using Json = nlohmann::ordered_json;
    const auto text = [](const Json& part) {
        return nlohmann::json(part).dump(-1, ' ', false, Json::error_handler_t::replace);
    };
    json["check"] = results::hash_text(text(json["batches"]) + text(json["counts"]));
    check_state(json.dump(-1, ' ', false, Json::error_handler_t::replace));
}

}   // namespace rayclock::fuzz

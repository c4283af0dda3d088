// Makes the text and the JSON of an elastic verification.
#include "sim/view/report/elastic.hpp"

#include <fmt/format.h>

#include "sim/view/report/accounts.hpp"
#include "sim/view/report/json.hpp"
#include "sim/view/report/lockstep.hpp"
#include "sim/view/report/text.hpp"

namespace rayclock {

namespace {

double ratio_of(const ElasticResult& r) {
    return r.model.cycles ? double(r.rtl.cycles) / double(r.model.cycles) : 0;
}

std::string percent(std::uint64_t part, std::uint64_t all) {
    return fmt::format("{:.1f} %", all ? 100 * double(part) / double(all) : 0);
}

std::string account_text(const UnitAccount& unit) {
    const std::uint64_t all = unit.busy + unit.starved + unit.stalled;
    return fmt::format("{} / {} / {}", percent(unit.busy, all), percent(unit.starved, all),
                       percent(unit.stalled, all));
}

constexpr Unit caches[] = {Unit::node_cache, Unit::prim_cache, Unit::surf_cache,
                           Unit::tex_cache,  Unit::stream,     Unit::l2};

}   // namespace

std::string elastic_lines(const Config& config, int khz, const ElasticResult& r) {
    std::string text =
        fmt::format("  elastic: {} transfers of the RTL judged in {} cycles, {} values differ\n",
                    grouped(r.events_compared), grouped(r.rtl.cycles), grouped(r.value_mismatches));
    if (r.first) text += divergence_lines(*r.first);
    Table table({"", "model", "RTL"});
    table.add({"cycles", grouped(r.model.cycles),
               fmt::format("{} ({:.3f} times the model's)", grouped(r.rtl.cycles), ratio_of(r))});
    table.add({fmt::format("fps at {:g} MHz", khz / 1e3), fmt::format("{:.2f}", per_second(r.model, khz)),
               fmt::format("{:.2f}", per_second(r.rtl, khz))});
    for (const Unit cache : caches)
        if (is_there(cache, config))
            table.add({fmt::format("hit rate of {}", unit_infos[index(cache)].name),
                       fmt::format("{:.2f} %", 100 * cache_account(r.model, cache).hit_rate()),
                       fmt::format("{:.2f} %", 100 * cache_account(r.rtl, cache).hit_rate())});
    const std::vector<UnitAccount> model = unit_accounts(config, r.model), rtl = unit_accounts(config, r.rtl);
    for (std::size_t u = 0; u < model.size(); ++u)
        table.add({model[u].unit, account_text(model[u]), account_text(rtl[u])});
    return text + "  cost, with the shares busy / starved / stalled of each unit\n" + table.text(4);
}

nlohmann::ordered_json elastic_json(const Config& config, int khz, const std::string& units,
                                    const ElasticResult& r) {
    return {{"units", units},
            {"model_cycles", r.model.cycles},
            {"rtl_cycles", r.rtl.cycles},
            {"ratio", ratio_of(r)},
            {"model_fps", per_second(r.model, khz)},
            {"rtl_fps", per_second(r.rtl, khz)},
            {"model_units", units_json(config, r.model)},
            {"rtl_units", units_json(config, r.rtl)},
            {"rtl_memory", memory_json(config, khz, r.rtl)}};
}

}   // namespace rayclock

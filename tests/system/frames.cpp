#include "tests/system/frames.hpp"

#include <catch2/catch.hpp>

#include "model/core/error.hpp"
#include "sim/load/load.hpp"
#include "sim/report/accounts.hpp"

namespace rayclock::test {

Shot make_shot(const std::string& name, FrameSize size, const Config& config) {
    Scene scene = load_scene(name);
    if (!scene.camera) scene.camera = fit_camera(scene, double(size.width) / size.height);
    Job job = make_job(scene, *scene.camera, size, config);
    return {std::move(scene), std::move(job)};
}

Shot make_deep_shot(const std::string& name, FrameSize size, Config config) {
    for (;; config.stack_depth *= 2) {
        try {
            return make_shot(name, size, config);
        } catch (const UserError&) {
            if (config.stack_depth >= 64) throw;
        }
    }
}

Config with(Config config, const std::vector<std::pair<std::string, int>>& values) {
    for (const auto& [key, value] : values) {
        set_parameter(config, key, std::to_string(value), "test");
        config.name += " " + key + "=" + std::to_string(value);
    }
    check_config(config, config.name);
    return config;
}

const std::vector<std::string>& quick_configs() {
    static const std::vector<std::string> names{"default", "small", "narrow", "broad"};
    return names;
}

Config quick_config(const std::string& name) {
    if (name == "narrow")
        return with(named_config("small"), {{"coord_bits", 12}, {"dir_bits", 12}, {"t_frac_bits", 0}, {"recip_bits", 8}, {"box_bits", 4},
                                            {"bary_bits", 4}, {"node_width", 2}, {"leaf_size", 3}, {"stack_depth", 64}, {"raygen_queue", 2},
                                            {"box_queue", 2}, {"tri_queue", 2}});
    if (name == "broad")
        return with(named_config("default"), {{"coord_bits", 20}, {"dir_bits", 22}, {"recip_bits", 24}, {"bary_bits", 24}, {"leaf_size", 6},
                                              {"contexts", 2}, {"mem_latency", 1}});
    return named_config(name);
}

LockstepResult check_lockstep(const Job& job, Traffic traffic, int seed) {
    INFO("configuration " << job.config.name << ", jitter " << traffic.jitter << ", stall " << traffic.stall_percent << ", seed " << traffic.seed
                          << ", RTL seed " << seed);
    LockstepResult result = run_lockstep(job, traffic, {}, seed);
    if (result.first) {
        const Divergence& d = *result.first;
        UNSCOPED_INFO("first divergence: cycle " << d.cycle << " unit " << d.unit << " channel " << d.channel << " ray " << d.ray << " pixel "
                                                 << d.x << "," << d.y << " expected " << d.expected << " got " << d.got);
    }
    CHECK(result.agrees());
    CHECK(result.value_mismatches == 0);
    CHECK(result.cycle_gap == 0);
    CHECK(result.events_compared >= 4 * std::uint64_t(job.size.width) * std::uint64_t(job.size.height));
    CHECK(result.model.digest == result.rtl.digest);
    CHECK(result.model.hits.hits == result.rtl.hits.hits);
    CHECK(result.model.counts == result.rtl.counts);
    CHECK(result.model.box_tests == result.rtl.box_tests);
    for (const FrameRun* run : {&result.model, &result.rtl})
        for (const UnitAccount& a : unit_accounts(run->counts, run->cycles)) {
            INFO("unit " << a.unit);
            CHECK(a.busy + a.stalled <= run->cycles);
            CHECK(a.busy + a.starved + a.stalled == run->cycles);
            CHECK(a.count == a.busy);
        }
    return result;
}

} // namespace rayclock::test

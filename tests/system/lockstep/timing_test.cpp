// A frame's content does not depend on timing, and equal runs give equal results.
#include <catch2/catch.hpp>

#include <future>

#include "sim/run/frame/frame.hpp"
#include "sim/view/report/accounts.hpp"
#include "tests/support/machine/frames.hpp"

namespace rayclock::test::timing_test {

using namespace rayclock;
using namespace rayclock::test;

namespace {

/// Returns the same image and frame on a machine with another shape.
Job reshaped(Job job, const Values& values) {
    job.config = with(job.config, values);
    return job;
}

}   // namespace

TEST_CASE(
    "hits do not depend on memory, caches, order of answers, back-pressure, contexts, queues, tiles or "
    "pipelines: model",
    "[long]") {
    const std::string scene = GENERATE("teapot:6", "gears:2", "mount:4", "icosphere:3");
    const Shot shot = make_shot(scene, {48, 36}, named_config("default"));
    const HitFrame expected = run_model(shot.job).hits;
    const auto check = [&](const Job& job, Disturbance disturbance) {
        INFO(scene << ": " << job.config.name << ", jitter " << disturbance.jitter << ", stall "
                   << disturbance.stall_percent << ", seed " << disturbance.seed);
        CHECK(run_model(job, disturbance).hits.hits == expected.hits);
    };
    for (const int contexts : {1, 2, 4, 16, 128, 1024})
        check(reshaped(shot.job, {{"contexts", contexts}}), {});
    for (const int latency : {1, 2, 13, 100, 1000})
        check(reshaped(shot.job, {{"dram", 0}, {"mem_latency", latency}}), {});
    for (const int interval : {2, 7})
        check(reshaped(shot.job, {{"dram", 0}, {"mem_interval", interval}}), {});
    for (const int dram : {1, 2, 3}) check(reshaped(shot.job, {{"dram", dram}}), {});
    for (const int pipelines : {2, 4, 8})
        for (const int l2_sets : {0, 32})
            check(reshaped(shot.job, {{"pipelines", pipelines}, {"l2_sets", l2_sets}}), {});
    for (const int tile_bits : {0, 1, 6})
        check(reshaped(shot.job, {{"tile_bits", tile_bits}, {"pipelines", 2}}), {});
    for (const int sets : {1, 1024})
        for (const int ways : {1, 8})
            check(reshaped(shot.job, {{"node_sets", sets},
                                      {"node_ways", ways},
                                      {"prim_sets", sets},
                                      {"prim_ways", ways},
                                      {"node_mshrs", ways},
                                      {"prim_mshrs", ways},
                                      {"node_line", 64 * std::min(4, ways)},
                                      {"cache_queue", 2 * ways}}),
                  {});
    for (const int queue : {2, 4, 256})
        check(reshaped(shot.job, {{"raygen_queue", queue}, {"box_queue", queue}, {"tri_queue", queue}}), {});
    for (const int jitter : {1, 10, 300})
        for (const int stall : {0, 40, 95})
            for (std::uint64_t seed = 1; seed <= 3; ++seed) check(shot.job, {jitter, stall, seed});
    Rng rng(20);
    for (int i = 0; i < 20; ++i)
        check(
            reshaped(shot.job, {{"contexts", 1 << rng.below(9)},           {"dram", rng.below(4)},
                                {"mem_latency", 1 + rng.below(60)},        {"mem_interval", 1 + rng.below(4)},
                                {"tri_queue", 2 << rng.below(5)},          {"box_queue", 2 << rng.below(5)},
                                {"raygen_queue", 2 << rng.below(5)},       {"cache_queue", 2 << rng.below(5)},
                                {"node_sets", 1 << rng.below(7)},          {"node_ways", 1 << rng.below(4)},
                                {"prim_sets", 1 << rng.below(7)},          {"prim_ways", 1 << rng.below(4)},
                                {"node_line", 64 << rng.below(3)},         {"prim_line", 64 << rng.below(3)},
                                {"node_mshrs", 1 << rng.below(5)},         {"prim_mshrs", 1 << rng.below(5)},
                                {"l2_sets", rng.below(2) << rng.below(7)}, {"l2_line", 64 << rng.below(3)},
                                {"pipelines", 1 << rng.below(3)},          {"tile_bits", rng.below(7)}}),
            {rng.below(50), rng.below(80), rng.next()});
}

TEST_CASE("hits do not depend on latency, order of answers or back-pressure: RTL", "[long]") {
    const Shot shot =
        make_shot("gears:1", {32, 24}, quick_config(GENERATE("default", "small", "narrow", "broad")));
    const HitFrame expected = run_rtl(shot.job).hits;
    CHECK(expected.hits == run_model(shot.job).hits.hits);
    // The board's memory, the last one, does not allow these clocks: tests/board/chip_lockstep_test.cpp.
    for (int dram = 0; dram < int(DramName::board); ++dram)
        for (const int khz : {20000, 500000}) {
            Job job = reshaped(shot.job, {{"dram", dram}});
            job.khz = khz;
            INFO(job.config.name << " at " << khz << " kHz");
            CHECK(run_rtl(job).hits.hits == expected.hits);
        }
    for (const int latency : {1, 40})
        for (const int stall : {0, 60})
            for (std::uint64_t seed = 1; seed <= 2; ++seed) {
                INFO(shot.job.config.name << ", latency " << latency << ", stall " << stall << ", seed "
                                          << seed);
                CHECK(run_rtl(reshaped(shot.job, {{"dram", 0}, {"mem_latency", latency}}),
                              {3 * latency, stall, seed}, {}, int(seed))
                          .hits.hits == expected.hits);
            }
}

TEST_CASE("a run repeated has the same digest, on any thread and whatever else runs") {
    const Shot shot = make_shot("teapot:6", {48, 36}, quick_config("default"));
    const Disturbance disturbance{20, 30, 5};
    const std::uint64_t digest = run_model(shot.job, disturbance).digest;
    std::vector<std::future<std::uint64_t>> again;
    for (int i = 0; i < 3; ++i) {
        again.push_back(
            std::async(std::launch::async, [&] { return run_model(shot.job, disturbance).digest; }));
        again.push_back(std::async(std::launch::async,
                                   [&, i] { return run_rtl(shot.job, disturbance, {}, i + 1).digest; }));
        again.push_back(std::async(std::launch::async, [&] {
            return run_model(make_shot("teapot:6", {48, 36}, quick_config("default")).job, disturbance)
                .digest;
        }));
    }
    for (auto& run : again) CHECK(run.get() == digest);
    CHECK(run_model(shot.job, {20, 30, 6}).digest != digest);   // the digest includes cycles
    CHECK(run_model(make_shot("teapot:5", {48, 36}, quick_config("default")).job, disturbance).digest !=
          digest);
}

TEST_CASE("accounts close: work that enters a unit leaves it, and no frame is faster than its work allows") {
    const Shot shot = make_shot(GENERATE("teapot:6", "gears:1", "cornell"), {48, 36},
                                quick_config(GENERATE("default", "small", "narrow", "broad")));
    const Disturbance disturbance = GENERATE(Disturbance{}, Disturbance{5, 30, 3});
    const FrameResult run = run_model(shot.job, disturbance);
    INFO(shot.job.config.name);
    const Config& config = shot.job.config;
    for (const UnitAccount& a : unit_accounts(config, run)) {
        INFO("unit " << a.unit);
        CHECK(a.busy + a.starved + a.stalled == std::uint64_t(a.instances) * run.cycles);
        if (a.unit == "sched" || a.unit == "raygen" || a.unit == "box" || a.unit == "tri")
            CHECK(a.count == a.busy);
    }
    CHECK(bound_of(config, shot.job.khz, run).cycles <= double(run.cycles));
    for (const Unit cache : {Unit::node_cache, Unit::prim_cache}) {
        const CacheAccount c = cache_account(run, cache);
        CHECK(c.accesses == (cache == Unit::node_cache ? run.visits : run.triangle_tests));
        CHECK(c.hits + c.merged <= c.accesses);
    }
}

}   // namespace rayclock::test::timing_test

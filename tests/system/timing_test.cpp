// What a frame shows does not depend on when things happen; the same run is the same run.
#include <catch2/catch.hpp>

#include <future>

#include "sim/engine/engine.hpp"
#include "sim/report/accounts.hpp"
#include "tests/system/frames.hpp"

using namespace rayclock;
using namespace rayclock::test;

namespace {

/// The same image and frame on a machine that differs in shape only.
Job reshaped(Job job, const std::vector<std::pair<std::string, int>>& values) {
    job.config = with(job.config, values);
    return job;
}

} // namespace

TEST_CASE("hits do not depend on latency, order of answers, back-pressure, contexts or queues: model") {
    const std::string scene = GENERATE("teapot:6", "gears:2", "mount:4", "icosphere:3");
    const Shot shot = make_shot(scene, {48, 36}, named_config("default"));
    const HitFrame expected = run_model(shot.job).hits;
    const auto check = [&](const Job& job, Traffic traffic) {
        INFO(scene << ": " << job.config.name << ", jitter " << traffic.jitter << ", stall " << traffic.stall_percent << ", seed " << traffic.seed);
        CHECK(run_model(job, traffic).hits.hits == expected.hits);
    };
    for (const int contexts : {1, 2, 4, 16, 128, 1024}) check(reshaped(shot.job, {{"contexts", contexts}}), {});
    for (const int latency : {1, 2, 13, 100, 1000}) check(reshaped(shot.job, {{"mem_latency", latency}}), {});
    for (const int interval : {2, 7}) check(reshaped(shot.job, {{"mem_interval", interval}}), {});
    for (const int queue : {2, 4, 256}) check(reshaped(shot.job, {{"raygen_queue", queue}, {"box_queue", queue}, {"tri_queue", queue}}), {});
    for (const int jitter : {1, 10, 300})
        for (const int stall : {0, 40, 95})
            for (std::uint64_t seed = 1; seed <= 3; ++seed) check(shot.job, {jitter, stall, seed});
    Rng rng(20);
    for (int i = 0; i < 20; ++i)
        check(reshaped(shot.job, {{"contexts", 1 << rng.below(9)}, {"mem_latency", 1 + rng.below(60)}, {"mem_interval", 1 + rng.below(4)},
                                  {"tri_queue", 2 << rng.below(5)}, {"box_queue", 2 << rng.below(5)}, {"raygen_queue", 2 << rng.below(5)}}),
              {rng.below(50), rng.below(80), rng.next()});
}

TEST_CASE("hits do not depend on latency, order of answers or back-pressure: RTL") {
    const Shot shot = make_shot("gears:1", {32, 24}, quick_config(GENERATE("default", "small", "narrow", "broad")));
    const HitFrame expected = run_rtl(shot.job).hits;
    for (const int latency : {1, 40})
        for (const int stall : {0, 60})
            for (std::uint64_t seed = 1; seed <= 2; ++seed) {
                INFO(shot.job.config.name << ", latency " << latency << ", stall " << stall << ", seed " << seed);
                CHECK(run_rtl(reshaped(shot.job, {{"mem_latency", latency}}), {3 * latency, stall, seed}, {}, int(seed)).hits.hits == expected.hits);
            }
}

TEST_CASE("a run repeated has the same digest, on any thread and whatever else runs") {
    const Shot shot = make_shot("teapot:6", {48, 36}, quick_config("default"));
    const Traffic traffic{20, 30, 5};
    const std::uint64_t digest = run_model(shot.job, traffic).digest;
    std::vector<std::future<std::uint64_t>> again;
    for (int i = 0; i < 3; ++i) {
        again.push_back(std::async(std::launch::async, [&] { return run_model(shot.job, traffic).digest; }));
        again.push_back(std::async(std::launch::async, [&, i] { return run_rtl(shot.job, traffic, {}, i + 1).digest; }));
        again.push_back(std::async(std::launch::async, [&] { return run_model(make_shot("teapot:6", {48, 36}, quick_config("default")).job, traffic).digest; }));
    }
    for (auto& run : again) CHECK(run.get() == digest);
    CHECK(run_model(shot.job, {20, 30, 6}).digest != digest);   // it sees the cycles
    CHECK(run_model(make_shot("teapot:5", {48, 36}, quick_config("default")).job, traffic).digest != digest);
}

TEST_CASE("accounts close: work that enters a unit leaves it") {
    const Shot shot = make_shot(GENERATE("teapot:6", "gears:1", "cornell"), {48, 36}, quick_config(GENERATE("default", "small", "narrow", "broad")));
    const FrameRun run = run_model(shot.job, {5, 30, 3});
    const auto moved = [&](Channel c) { return run.counts[index(c)].moved; };
    const std::uint64_t pixels = 48 * 36;
    CHECK(moved(Channel::slot) == pixels);
    CHECK(moved(Channel::ray) == pixels);
    CHECK(moved(Channel::hit) == pixels);
    CHECK(moved(Channel::node_req) == moved(Channel::box_req));
    CHECK(moved(Channel::box_req) == moved(Channel::box_rsp));
    CHECK(moved(Channel::prim_req) == moved(Channel::tri_req));
    CHECK(moved(Channel::tri_req) == moved(Channel::tri_rsp));
    CHECK(moved(Channel::step) == moved(Channel::node_req));   // every node visited ends in one step
    CHECK(run.box_tests >= moved(Channel::box_req));
    CHECK(run.box_tests <= moved(Channel::box_req) * std::uint64_t(shot.job.config.node_width));
    CHECK(bound_of(run).cycles <= run.cycles);
    CHECK(run.counts[index(Channel::box_rsp)].refused == 0);
    CHECK(run.counts[index(Channel::tri_rsp)].refused == 0);
}

// Whole frames: the RTL does in every cycle what the model does.
#include <catch2/catch.hpp>

#include <filesystem>

#include "sim/rtl/builder.hpp"
#include "tests/system/frames.hpp"

using namespace rayclock;
using namespace rayclock::test;

namespace {

const std::vector<std::string> scenes{"tetra:4", "mount:4", "gears:1", "gears:2", "balls:1", "teapot:6", "cornell", "icosphere:3"};

} // namespace

// Not a test of its own: ctest runs it once before those that need the RTL, so that they do not build it side by side.
TEST_CASE("the RTL of the quick configurations builds", "[.build]") {
    for (const std::string& name : quick_configs()) {
        INFO(name);
        CHECK(std::filesystem::exists(build_rtl(quick_config(name)).library));
    }
}

TEST_CASE("model and RTL agree on every scene, default configuration") {
    const std::string scene = GENERATE(from_range(scenes));
    INFO(scene);
    const LockstepResult result = check_lockstep(make_shot(scene, {96, 72}, quick_config("default")).job);
    CHECK(result.events_compared > 50'000);
}

TEST_CASE("model and RTL agree on every scene, small configuration") {
    const std::string scene = GENERATE(from_range(scenes));
    INFO(scene);
    check_lockstep(make_shot(scene, {64, 48}, quick_config("small")).job);
}

TEST_CASE("model and RTL agree on every scene, the two extreme configurations") {
    const std::string scene = GENERATE(from_range(scenes));
    const std::string config = GENERATE("narrow", "broad");
    INFO(scene);
    check_lockstep(make_shot(scene, {48, 36}, quick_config(config)).job);
}

TEST_CASE("model and RTL agree on scenes from files") {
    std::size_t found = 0;
    for (const auto& entry : std::filesystem::directory_iterator("scenes")) {
        const std::string ending = entry.path().extension().string();
        if (ending != ".obj" && ending != ".json") continue;
        ++found;
        INFO(entry.path().string());
        for (const std::string& config : quick_configs()) check_lockstep(make_shot(entry.path().string(), {48, 36}, quick_config(config)).job);
    }
    CHECK(found > 0);
}

TEST_CASE("model and RTL agree for every leaf size") {
    const int leaf = GENERATE(1, 2, 3, 4, 5, 6);   // the image differs, the RTL does not
    for (const std::string& config : quick_configs())
        for (const char* scene : {"teapot:6", "gears:1"})
            check_lockstep(make_shot(scene, {48, 36}, with(quick_config(config), {{"leaf_size", leaf}})).job);
}

TEST_CASE("model and RTL agree for every memory and every back-pressure") {
    const std::string name = GENERATE("default", "small", "narrow", "broad");
    const Traffic traffic = GENERATE(Traffic{0, 0, 1}, Traffic{1, 0, 2}, Traffic{30, 0, 3}, Traffic{0, 50, 4}, Traffic{7, 20, 5},
                                     Traffic{100, 90, 6}, Traffic{3, 70, 7}, Traffic{200, 5, 8});
    const int latency = GENERATE(1, 8, 61);
    const Config config = with(quick_config(name), {{"mem_latency", latency}, {"mem_interval", latency == 8 ? 3 : 1}});
    check_lockstep(make_shot("gears:1", {32, 24}, config).job, traffic, int(traffic.seed));
}

TEST_CASE("model and RTL agree whatever the registers held before reset") {
    const Shot shot = make_shot("balls:1", {32, 24}, quick_config(GENERATE("default", "small", "narrow", "broad")));
    for (int seed = 1; seed <= 12; ++seed) check_lockstep(shot.job, {2, 10, std::uint64_t(seed)}, seed);
}

TEST_CASE("model and RTL agree on pictures of odd shapes") {
    const FrameSize size = GENERATE(FrameSize{1, 1}, FrameSize{1, 50}, FrameSize{50, 1}, FrameSize{2, 3}, FrameSize{65, 2}, FrameSize{33, 31});
    INFO(size.width << "x" << size.height);
    for (const std::string& config : quick_configs()) check_lockstep(make_shot("teapot:3", size, quick_config(config)).job, {4, 25, 9});
}

TEST_CASE("a ray that sees nothing and a picture that sees nothing") {
    for (const std::string& config : quick_configs()) {
        Shot shot = make_shot("tetra:3", {24, 18}, quick_config(config));
        shot.scene.camera->at = 2.0 * shot.scene.camera->eye - shot.scene.camera->at;   // about face
        const Job job = make_job(shot.scene, *shot.scene.camera, {24, 18}, quick_config(config));
        const LockstepResult result = check_lockstep(job);
        for (const Hit& hit : result.rtl.hits.hits) CHECK(hit == Hit{});
    }
}

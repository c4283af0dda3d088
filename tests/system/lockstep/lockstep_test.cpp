// Whole frames: the RTL equals the model in every cycle.
#include <catch2/catch.hpp>

#include <filesystem>

#include "model/compile/frame.hpp"
#include "sim/load/load.hpp"
#include "tests/support/machine/build_all.hpp"
#include "tests/support/machine/frames.hpp"

using namespace rayclock;
using namespace rayclock::test;

namespace {

const std::vector<std::string> scenes{"tetra:4", "mount:4",  "gears:1", "gears:2",
                                      "balls:1", "teapot:6", "cornell", "icosphere:3"};

}   // namespace

// Only builds. ctest runs it once before the tests that need the RTL, so that they do not build it at the
// same time.
TEST_CASE("the RTL of the quick configurations builds", "[.build]") {
    std::vector<RtlJob> jobs;
    for (const std::string& name : quick_configs()) jobs.push_back({"rc_chip", name, quick_config(name)});
    REQUIRE_NOTHROW(build_all(jobs));
}

TEST_CASE("model and RTL agree on eight scenes, default configuration") {
    const std::string scene = GENERATE(from_range(scenes));
    INFO(scene);
    const LockstepResult result = check_lockstep(make_shot(scene, {96, 72}, quick_config("default")).job);
    CHECK(result.events_compared > 50'000);
}

TEST_CASE("model and RTL agree on eight scenes, small configuration") {
    const std::string scene = GENERATE(from_range(scenes));
    INFO(scene);
    check_lockstep(make_shot(scene, {64, 48}, quick_config("small")).job);
}

TEST_CASE("model and RTL agree on eight scenes, the two extreme configurations") {
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
        const Scene scene = load_scene(entry.path().string(), {}, Primitives::native);
        if (!scene.spheres.empty() || !scene.planes.empty())
            continue;   // see finished_test.cpp for finished pictures
        ++found;
        INFO(entry.path().string());
        for (const std::string& config : quick_configs())
            check_lockstep(make_shot(entry.path().string(), {48, 36}, quick_config(config)).job);
    }
    CHECK(found > 0);
}

TEST_CASE("model and RTL agree for every leaf size", "[long]") {
    const int leaf = GENERATE(1, 2, 3, 4, 5, 6);   // the image differs, but not the RTL
    for (const std::string& config : quick_configs())
        for (const char* scene : {"teapot:6", "gears:1"})
            check_lockstep(make_shot(scene, {48, 36}, with(quick_config(config), {{"leaf_size", leaf}})).job);
}

TEST_CASE("model and RTL agree on an ideal memory of three latencies, under eight disturbances", "[long]") {
    const std::string name = GENERATE("default", "small", "narrow", "broad");
    const Disturbance disturbance = GENERATE(
        Disturbance{0, 0, 1}, Disturbance{1, 0, 2}, Disturbance{30, 0, 3}, Disturbance{0, 50, 4},
        Disturbance{7, 20, 5}, Disturbance{100, 90, 6}, Disturbance{3, 70, 7}, Disturbance{200, 5, 8});
    const int latency = GENERATE(1, 8, 61);
    Config config =
        with(quick_config(name), {{"mem_latency", latency}, {"mem_interval", latency == 8 ? 3 : 1}});
    config.dram = DramName::ideal;
    check_config(config, name);
    check_lockstep(make_shot("gears:1", {32, 24}, config).job, disturbance, int(disturbance.seed));
}

TEST_CASE("model and RTL agree on three DRAMs at three clocks, with and without back-pressure", "[long]") {
    const std::string name = GENERATE("default", "small", "narrow", "broad");
    const DramName dram = GENERATE(DramName::sdr, DramName::ddr3, DramName::rpu);
    const int khz = GENERATE(20000, 66000, 533333);
    Config config = quick_config(name);
    config.dram = dram;
    check_config(config, name);
    Job job = make_shot("gears:1", {32, 24}, config).job;
    job.khz = khz;
    INFO(khz << " kHz");
    for (const Disturbance& disturbance : {Disturbance{}, Disturbance{40, 0, 2}, Disturbance{25, 60, 3}})
        check_lockstep(job, disturbance, int(disturbance.seed));
}

TEST_CASE("model and RTL agree on memories side by side, and on one that a file describes") {
    struct Case {
        const char* dram;
        int channels, khz;
    };
    for (const Case& c : {Case{"ddr4", 1, 66000}, Case{"ddr4", 3, 4000000}, Case{"lpddr4", 2, 200000},
                          Case{"hbm2", 1, 1000000}, Case{"hbm2", 4, 533333}, Case{"sdr", 4, 20000}}) {
        for (const bool is_file : {false, true}) {
            Config config = quick_config(is_file ? "narrow" : "default");
            set_parameter(config, "dram", c.dram, "test");
            config.dram_channels = c.channels;
            if (is_file) {
                DramPart part = *config.dram_part();
                part.queue = 3;
                config.own_dram = std::make_shared<const DramPart>(part);
            }
            Job job = make_shot("gears:1", {32, 24}, config).job;
            job.khz = c.khz;
            INFO(c.dram << " x " << c.channels << ", " << c.khz << " kHz");
            check_lockstep(job);
            check_lockstep(job, Disturbance{25, 60, 3}, 3);
        }
    }
}

TEST_CASE("model and RTL agree while a screen is read from their memory and pixels are written to it") {
    for (const char* name : {"default", "narrow"}) {
        for (const char* dram : {"ideal", "sdr_half", "ddr3"}) {
            Config config = quick_config(name);
            set_parameter(config, "dram", dram, "test");
            config.scan_out = config.pixel_writes = 1;
            const Job job = make_shot("gears:1", {32, 24}, config).job;
            INFO(name << ", " << dram);
            check_lockstep(job);
            check_lockstep(job, Disturbance{25, 60, 3}, 3);
            Config quiet = config;
            quiet.scan_out = quiet.pixel_writes = 0;
            const FrameResult with = run_model(job),
                              without = run_model(make_shot("gears:1", {32, 24}, quiet).job);
            CHECK(with.memory.pixel_writes <= 32 * 24 / 16);
            CHECK(with.memory.pixel_writes + 4 >= 32 * 24 / 16);   // the last ones wait
            CHECK(with.memory.scanned > 0);
            CHECK(without.memory.scanned + without.memory.pixel_writes == 0);
            if (dram == std::string("sdr_half")) CHECK(with.cycles > without.cycles);
        }
    }
}

TEST_CASE("model and RTL agree over several frames on one machine, whose caches stay warm", "[long]") {
    const Shot shot =
        make_shot("gears:1", {32, 24}, quick_config(GENERATE("default", "small", "narrow", "broad")));
    const Job& job = shot.job;
    INFO(job.config.name);
    Camera turned = *shot.scene.camera;
    turned.fov_degrees *= 0.8;
    std::vector<RecordedFrame> one, two, four;
    for (auto* frames : {&one, &two, &four}) frames->push_back(record_frame(job, job.frame));
    for (auto* frames : {&two, &four})
        frames->push_back(record_frame(job, make_frame(turned, {32, 24}, job.image, job.config)));
    // Pixels outside one picture are inside the next.
    for (const FrameSize size : {FrameSize{19, 30}, FrameSize{50, 33}})
        four.push_back(record_frame(job, make_frame(*shot.scene.camera, size, job.image, job.config)));
    CHECK(two[1].trace.hits.size() == one[0].trace.hits.size());
    for (const Disturbance& disturbance : {Disturbance{}, Disturbance{10, 30, 5}}) {
        std::vector<RecordedFrame> cold;
        cold.push_back(record_frame(job, two[1].frame));
        const FrameResult first = check_lockstep(job, one, disturbance).rtl,
                          second = check_lockstep(job, two, disturbance).rtl;
        const FrameResult alone = check_lockstep(job, cold, disturbance).rtl;
        CHECK(first.hits.hits != second.hits.hits);   // another picture
        CHECK(second.hits.hits == alone.hits.hits);   // the content of the caches makes no difference
        if (job.config.node_sets <= 2) continue;
        CHECK(second.memory.reads <= alone.memory.reads);
        CHECK(second.memory.reads < first.memory.reads);
    }
    std::vector<RecordedFrame> same;
    for (int i = 0; i < 2; ++i) same.push_back(record_frame(job, job.frame));
    const LockstepResult again = check_lockstep(job, same);
    if (job.config.node_sets > 2) CHECK(again.rtl.memory.reads < run_model(job).memory.reads);
    // The RTL alone renders the model's frames.
    const std::vector<FrameResult> runs = run_rtl(job, job.khz, four);
    const std::vector<FrameTiming> timings = replay(job.config, job.khz, four);
    check_lockstep(job, four, {3, 20, 7});
    REQUIRE(runs.size() == 4);
    for (std::size_t i = 0; i < 4; ++i) {
        CHECK(runs[i].cycles == timings[i].cycles);
        CHECK(runs[i].accounts == timings[i].accounts);
        CHECK(runs[i].memory == timings[i].memory);
        CHECK(runs[i].digest == digest_of(four[i].trace.hits, timings[i].cycles));
    }
}

TEST_CASE("model and RTL agree for twelve random states of the registers before reset", "[long]") {
    const Shot shot =
        make_shot("balls:1", {32, 24}, quick_config(GENERATE("default", "small", "narrow", "broad")));
    for (int seed = 1; seed <= 12; ++seed) check_lockstep(shot.job, {2, 10, std::uint64_t(seed)}, seed);
}

TEST_CASE("model and RTL agree on pictures of odd shapes") {
    const FrameSize size = GENERATE(FrameSize{1, 1}, FrameSize{1, 50}, FrameSize{50, 1}, FrameSize{2, 3},
                                    FrameSize{65, 2}, FrameSize{33, 31});
    INFO(size.width << "x" << size.height);
    for (const std::string& config : quick_configs())
        check_lockstep(make_shot("teapot:3", size, quick_config(config)).job, {4, 25, 9});
}

TEST_CASE("model and RTL agree on a ray and a picture without hits") {
    for (const std::string& config : quick_configs()) {
        Shot shot = make_shot("tetra:3", {24, 18}, quick_config(config));
        shot.scene.camera->at = 2.0 * shot.scene.camera->eye - shot.scene.camera->at;   // turned around
        const Job job = make_job(shot.scene, *shot.scene.camera, {24, 18}, quick_config(config));
        const LockstepResult result = check_lockstep(job);
        for (const Hit& hit : result.rtl.hits.hits) CHECK(hit == Hit{});
    }
}

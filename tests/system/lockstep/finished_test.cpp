// Finished pictures: the RTL computes the model's colours in the same cycles.
#include <catch2/catch.hpp>

#include "model/compile/surfaces.hpp"
#include "model/engine/check.hpp"
#include "sim/judge/reference/reference.hpp"
#include "sim/files/image/image.hpp"
#include "sim/load/load.hpp"
#include "tests/support/machine/build_all.hpp"
#include "tests/support/machine/frames.hpp"

using namespace rayclock;
using namespace rayclock::test;

namespace {

const std::string scene_folder = "scenes/";

struct Finished {
    std::string scene;
    Whitted settings;
};

/// Returns a configuration with all units, so that all scenes need one build for each configuration.
Config with_all_units(Config config, const Whitted& settings) {
    Scene everything;
    everything.spheres.resize(1), everything.planes.resize(2), everything.normals.resize(1),
        everything.lights.resize(8);
    everything.materials.resize(1);
    everything.materials[0].transmit = 1;
    Whitted most = settings;
    most.aa = 2, most.depth = max_depth;
    Config all = fitted_config(everything, most, config);
    all.stack_depth = 64;
    check_config(all, "test");
    return all;
}

Job finished_job(const Finished& picture, FrameSize size, const Config& config) {
    Scene scene = load_scene(picture.scene, {}, Primitives::native);
    if (!scene.camera) scene.camera = fit_camera(scene, double(size.width) / size.height);
    return make_job(scene, *scene.camera, size, config, {}, picture.settings);
}

const std::vector<Finished> pictures{{"spheres", {4}},
                                     {"balls:1", {4}},
                                     {"gears:1", {4}},
                                     {"mount:2", {4}},
                                     {"rings:1", {2}},
                                     {"teapot:3", {4}},
                                     {"mirrors", {6}},
                                     {"tree:2", {1}},
                                     {"plane", {0}},
                                     {scene_folder + "pebble.json", {3}},
                                     {scene_folder + "pond.json", {3}},
                                     {"spheres", {15, 0.02}},
                                     {"mount:2", {0}},
                                     {"spheres", {3, 0, 2}},
                                     {"square", {1, 0, 3, true, 0, 7}},
                                     {"spheres", {2, 0, 3, true, 0.05, 3}}};

}   // namespace

// Only builds; see lockstep_test.cpp.
TEST_CASE("the RTL of the quick configurations that shade builds", "[.build]") {
    std::vector<RtlJob> jobs;
    for (const char* name : {"default", "narrow"}) {
        jobs.push_back(
            {"rc_chip", name + std::string(" with all units"), with_all_units(quick_config(name), {})});
    }
    REQUIRE_NOTHROW(build_all(jobs));
}

TEST_CASE("model and RTL make the same finished pictures in the same cycles", "[long]") {
    const Finished picture = GENERATE(from_range(pictures));
    const std::string config = GENERATE("default", "narrow");
    INFO(picture.scene << " depth " << picture.settings.depth << " aa " << picture.settings.aa
                       << " configuration " << config);
    check_lockstep(finished_job(picture, {24, 18}, with_all_units(quick_config(config), picture.settings)));
}

TEST_CASE("finished pictures do not depend on memory and sinks") {
    const int seed = GENERATE(range(1, 5));
    const Config config = with_all_units(quick_config("default"), {});
    const Job job = finished_job({"spheres", {3}}, {16, 12}, config);
    check_lockstep(job, {40, 30, std::uint64_t(seed)}, seed);
}

TEST_CASE("a finished picture is the reference's except for the cost of bits, and sends the same rays") {
    const auto [name, settings, least] =
        GENERATE(table<std::string, Whitted, double>({{"spheres", {4}, 46},
                                                      {"plane", {0}, 33},
                                                      {scene_folder + "pebble.json", {4}, 44},
                                                      {scene_folder + "pond.json", {4}, 44},
                                                      {"balls:2", {4}, 40},
                                                      {"gears:2", {4}, 44},
                                                      {"mount:4", {4}, 48},
                                                      {"rings:1", {4}, 40},
                                                      {"teapot:6", {4}, 48},
                                                      {"mirrors", {6}, 44},
                                                      {"tree:4", {4}, 42},
                                                      {"spheres", {3, 0.05, 2}, 44}}));
    INFO(name);
    Scene scene = load_scene(name, {}, Primitives::native);
    const FrameSize size{128, 96};
    Config config = fitted_config(scene, settings, named_config("default"));
    config.stack_depth = 64;
    const Job job = make_job(scene, *scene.camera, size, config, {}, settings);
    const RecordedFrame frame = record_frame(job, job.frame);
    const WhittedFrame reference = Reference(scene).whitted(*scene.camera, size, settings);
    CHECK(
        compare(picture_from_colours(size, frame.trace.colours), picture_from_reference(reference)).psnr_db >=
        least);
    // A ray from a plane's point beyond the lattice that misses the lattice is not sent
    // (docs/machine/shading.md).
    const double fewer = scene.planes.empty() ? 0.01 : 0.4;
    const auto near = [fewer](std::uint64_t mine, std::uint64_t theirs) {
        const double more = double(mine) - double(theirs);
        return more <= 0.01 * double(theirs) + 8 && -more <= fewer * double(theirs) + 8;
    };
    const RayCounts &mine = frame.trace.counts, &theirs = reference.rays;
    CAPTURE(mine.shadow, theirs.shadow, mine.reflection, theirs.reflection);
    CHECK(mine.primary == theirs.primary);
    CHECK(near(mine.primary_hits, theirs.primary_hits));
    CHECK(near(mine.shadow, theirs.shadow));
    CHECK(near(mine.reflection, theirs.reflection));
    CHECK(near(mine.refraction, theirs.refraction));
}

TEST_CASE(
    "a finished picture is the same for any number of threads, and its trace tells the same machine whatever "
    "the memory does") {
    const Job job = finished_job(
        {"balls:1", {3}}, {40, 30},
        fitted_config(make_builtin("balls:1", Primitives::native), {3}, named_config("default")));
    const RecordedFrame one = record_frame(job, job.frame, 1), many = record_frame(job, job.frame, 5);
    CHECK(one.trace.colours == many.trace.colours);
    CHECK(one.trace.counts == many.trace.counts);
    CHECK(one.trace.signatures == many.trace.signatures);
    std::vector<RecordedFrame> frames;
    frames.push_back(record_frame(job, job.frame));
    CHECK(frame_result(frames[0], replay(job.config, 66000, frames)[0]).pixels == 40 * 30);
}

// Samples of frames against the frames as a whole.
#include <cmath>

#include <catch2/catch.hpp>

#include "model/machine/machine.hpp"
#include "model/scene/builtin.hpp"
#include "model/trace/on_demand.hpp"
#include "sim/run/frame/frame.hpp"
#include "sim/run/sample/sample.hpp"
#include "sim/view/report/sampled.hpp"

using namespace rayclock;

namespace {

constexpr int khz = 66000;

Job job_of(const char* scene_name, FrameSize size, const Config& config = named_config("default")) {
    const Scene scene = make_builtin(scene_name);
    const Camera camera = scene.camera ? *scene.camera : fit_camera(scene, double(size.width) / size.height);
    return make_job(scene, camera, size, config);
}

/// The shares of samples whose interval, and whose interval of half the width, holds the cycles of the frame.
struct Coverage {
    double whole = 0, half = 0;
};
Coverage coverage(const Job& job, int seeds) {
    const double exact = double(run_model(job).cycles);
    Coverage covered;
    for (int seed = 1; seed <= seeds; ++seed) {
        const auto sampled = sample::run(job, {khz}, {0.05, std::uint64_t(seed)});
        const sample::Estimate e = sampled[0].total([](const FrameTiming& t) { return double(t.cycles); });
        const double error = std::fabs(e.value - exact);
        covered.whole += double(error <= e.half_width) / seeds;
        covered.half += double(error <= e.half_width / 2) / seeds;
    }
    return covered;
}

/// Returns the mean half-width of six samples' intervals of the cycles, relative to the cycles.
double width(const Job& job) {
    double sum = 0;
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        const auto sampled = sample::run(job, {khz}, {0, seed});
        sum += sampled[0].total([](const FrameTiming& t) { return double(t.cycles); }).relative();
    }
    return sum / 6;
}

}   // namespace

TEST_CASE("a machine that starts all tiles as stretches takes the cycles of the whole frame") {
    const Job job = job_of("gears:2", {70, 50});   // 5 x 4 tiles
    const FrameResult whole = run_model(job);
    const OnDemandJob shared(job.image, job.frame, job.config);
    OnDemandRecorder recorder(shared);
    Machine machine(job.config, khz);
    machine.start(job.frame, recorder.trace(), {{{0, 0}, 7}, {{2, 1}, 9}, {{1, 3}, 100}}, 70 * 50);
    machine.run(~std::uint64_t(0));
    REQUIRE(machine.done());
    REQUIRE(machine.cycle() == whole.cycles);
    REQUIRE(machine.accounts() == whole.accounts);
    PixelWork sum;
    for (std::uint32_t y = 0; y < 50; ++y)
        for (std::uint32_t x = 0; x < 70; ++x) sum.steps.visits += recorder.work(x, y).steps.visits;
    REQUIRE(sum.steps.visits == whole.visits);
}

TEST_CASE("a pixel that warms the caches reads what the machine reads") {
    // The caches hold the whole scene. After all pixels have warmed them, a replay of the frame reads nothing
    // from memory.
    Config config = named_config("default");
    config.node_sets = config.prim_sets = 4096;
    const Job job = job_of("gears:2", {64, 64}, config);
    const OnDemandJob shared(job.image, job.frame, job.config);
    OnDemandRecorder recorder(shared);
    Machine machine(job.config, khz);
    for (std::uint32_t y = 0; y < 64; ++y)
        for (std::uint32_t x = 0; x < 64; ++x) machine.warm(0, recorder.record(x, y));
    machine.start(job.frame, recorder.trace());
    machine.run(~std::uint64_t(0));
    REQUIRE(machine.memory().stats().reads == 0);
}

TEST_CASE("a sample does not depend on the number of threads, and depends on its seed") {
    const Job job = job_of("gears:2", {320, 256});
    const auto figures = [&](std::uint64_t seed, int threads) {
        return sample::run(job, {khz}, {0.05, seed}, {}, threads)[0].frame(job.config);
    };
    const FrameResult one = figures(5, 1), two = figures(5, 2), other = figures(6, 2);
    REQUIRE(one.cycles == two.cycles);
    REQUIRE(one.accounts == two.accounts);
    REQUIRE(one.memory == two.memory);
    REQUIRE(one.cycles != other.cycles);
}

TEST_CASE("in the accounts of a sample the causes of a unit sum to the cycles") {
    const Job job = job_of("gears:2", {320, 256});
    const FrameResult frame = sample::run(job, {khz}, {0.05, 1})[0].frame(job.config);
    for (std::size_t u = 0; u < unit_count; ++u) {
        if (!is_there(Unit(u), job.config)) continue;
        std::uint64_t sum = 0;
        for (const std::uint64_t cycles : frame.accounts.units[u]) sum += cycles;
        REQUIRE(sum == frame.cycles);
    }
}

TEST_CASE("samples of neighbouring parts read as many bytes as the frame") {
    // More than half of the parts are measured. A tile that ran twice would find its own lines in the caches.
    const Job job = job_of("gears:8", {320, 256});
    const double exact = double(run_model(job).memory.reads);
    constexpr int seeds = 12;
    double sum = 0;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        const auto sampled = sample::run(job, {khz}, {0, seed});
        sum += sampled[0].total([](const FrameTiming& t) { return double(t.memory.reads); }).value;
    }
    INFO("mean " << sum / seeds << ", exact " << exact);
    CHECK(std::fabs(sum / seeds / exact - 1) < 0.02);
}

TEST_CASE("the expected cycles of parts follow visits of instances") {
    Config two_levels = named_config("default");
    set_parameter(two_levels, "levels", "2", "");
    CHECK(width(job_of("gearbox:4", {320, 256}, two_levels)) < 0.008);
}

TEST_CASE("with few contexts the expected cycles of parts follow the latencies of all units") {
    // A ray waits for one unit after the other, and other rays do not hide these waits.
    Config few = named_config("default");
    set_parameter(few, "contexts", "4", "");
    CHECK(width(job_of("gears:4", {320, 256}, few)) < 0.008);
}

TEST_CASE("a sample counts visits of instances, so the work of xform has a narrow interval") {
    Config config = named_config("default");
    set_parameter(config, "levels", "2", "");
    const Job job = job_of("gearbox:4", {320, 256}, config);
    const double exact = double(run_model(job).accounts.units[index(Unit::xform)][0]);
    const sample::Estimate e = sample::run(job, {khz}, {0, 1})[0].account(config, Unit::xform, 0);
    CHECK(e.relative() < 0.02);
    CHECK(std::fabs(e.value / exact - 1) < 0.03);
}

TEST_CASE("a frame that is too small is refused") {
    REQUIRE_THROWS_WITH(sample::strata_of(job_of("tetra:1", {64, 48}).frame, named_config("default"), 0.05),
                        Catch::Contains("too few for a sample"));
}

TEST_CASE("intervals hold the cycles of a small frame in most of 40 samples, half intervals in fewer") {
    const Job job = job_of("gears:2", {320, 256});
    const Coverage covered = coverage(job, 40);
    CHECK(covered.whole >= 0.85);
    CHECK(covered.half < 0.85);   // so the first check notices intervals that are too narrow
}

TEST_CASE("intervals hold the cycles of three frames in 92 to 98 % of 200 samples each", "[slow]") {
    double mean = 0;
    for (const char* scene : {"gears:4", "teapot:12", "mount:6"})
        mean += coverage(job_of(scene, {320, 256}), 200).whole / 3;
    CHECK(mean > 0.92);
    CHECK(mean < 0.98);
}

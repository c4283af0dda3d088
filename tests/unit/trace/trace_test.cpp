// Traces: the number of threads does not change a recording, and it holds for every machine of the format.
#include <catch2/catch.hpp>

#include "model/layout/memory_image.hpp"
#include "tests/support/dut/dut.hpp"
#include "tests/support/machine/machines.hpp"

using namespace rayclock;
using namespace rayclock::test;

namespace {

/// A ray's words, read as the trace's description defines them.
struct RayTrace {
    std::vector<std::uint32_t> words;
    std::uint64_t visits = 0, tests = 0, dropped_groups = 0;
};
RayTrace read_ray(const std::uint32_t* at) {
    RayTrace ray;
    for (bool end = false; !end;) {
        const std::uint32_t head = *at++;
        ray.words.push_back(head);
        ++ray.visits;
        ray.dropped_groups += head >> VisitWord::dropped_shift;
        end = head & VisitWord::end_flag;
        for (bool more = head & VisitWord::tests_flag; more;) {
            ray.words.push_back(*at);
            ++ray.tests;
            more = !(*at++ & TestWord::last_flag);
        }
    }
    return ray;
}

void require_same(const Trace& a, const Trace& b, const Config& config) {
    REQUIRE(a.rays.size() == b.rays.size());
    for (std::size_t i = 0; i < a.rays.size(); ++i) {
        if (read_ray(a.rays[i]).words != read_ray(b.rays[i]).words)
            FAIL("pixel " << i << " does something else");
        if (!same(a.hits[i], b.hits[i], config)) FAIL("pixel " << i << " hits something else");
    }
    REQUIRE((a.visits == b.visits && a.box_tests == b.box_tests && a.triangle_tests == b.triangle_tests &&
             a.dropped_groups == b.dropped_groups));
}

void require_same(const FrameTiming& a, const FrameTiming& b) {
    REQUIRE(a.cycles == b.cycles);
    REQUIRE(a.pixels == b.pixels);
    REQUIRE(a.accounts == b.accounts);
    REQUIRE(a.memory == b.memory);
}

}   // namespace

TEST_CASE("a trace is the same whatever the number of threads", "[trace]") {
    const char* const scene = GENERATE("gears:2", "teapot:4");
    const FrameSize size = GENERATE(FrameSize{50, 35}, FrameSize{1, 1}, FrameSize{16, 16}, FrameSize{17, 33});
    const Job job = small_job(scene, size, format("default"));
    INFO(scene << " " << size.width << " x " << size.height);
    const Trace one = record_trace(job.image, job.frame, job.config, 1);
    for (const int threads : {2, 4, 0})
        require_same(one, record_trace(job.image, job.frame, job.config, threads), job.config);
}

TEST_CASE("a trace's sums are those of its rays, and every ray begins at the root", "[trace]") {
    const Job job = small_job(GENERATE("gears:2", "mount:3"), {50, 35}, format("small"));
    const Trace trace = record_trace(job.image, job.frame, job.config);
    std::uint64_t visits = 0, tests = 0, dropped_groups = 0;
    for (const std::uint32_t* at : trace.rays) {
        const RayTrace ray = read_ray(at);
        REQUIRE((ray.words[0] & trace_line_mask) == job.frame.root);
        visits += ray.visits;
        tests += ray.tests;
        dropped_groups += ray.dropped_groups;
    }
    REQUIRE(
        (trace.visits == visits && trace.triangle_tests == tests && trace.dropped_groups == dropped_groups));
    REQUIRE((trace.box_tests >= visits && trace.box_tests <= visits * std::uint64_t(job.config.node_width)));
    REQUIRE((dropped_groups > 0 && tests > 0));
    std::size_t words = 0;
    for (const auto& chunk : trace.chunks) words += chunk.size();
    REQUIRE(words == visits + tests);   // the trace has nothing else
}

TEST_CASE("a trace holds for machines of other shapes", "[trace]") {
    const char* const scene = GENERATE("gears:1", "teapot:4");
    const Job job = small_job(scene, {30, 20}, format("small"));
    std::vector<RecordedFrame> recorded;
    recorded.push_back(record_frame(job, job.frame));
    for (const Values& values : shapes()) {
        const Config config = shaped(job.config, values);
        INFO(scene << ", " << config.name);
        const Job own = small_job(scene, {30, 20}, config);
        std::vector<RecordedFrame> again;
        again.push_back(record_frame(own, own.frame));
        require_same(recorded[0].trace, again[0].trace, config);
        for (const Disturbance& disturbance : {Disturbance{}, Disturbance{7, 20, 5}})
            require_same(replay(config, 100000, recorded, disturbance)[0],
                         replay(config, 100000, again, disturbance)[0]);
        const FrameResult run = run_model(own);
        require_same(replay(config, own.khz, recorded)[0], run);
        REQUIRE(run.hits.hits == hits_of(job, recorded[0]).hits);
    }
}

TEST_CASE("frames in sequence find the caches as the last one left them", "[trace]") {
    const Job job =
        small_job("gears:1", {30, 20},
                  shaped(format("small"), {{"dram", GENERATE(0, 2)}, {"pipelines", GENERATE(1, 2)}}));
    std::vector<RecordedFrame> frames;
    for (int i = 0; i < 3; ++i) frames.push_back(record_frame(job, job.frame));
    const std::vector<FrameTiming> timings = replay(job.config, job.khz, frames);
    REQUIRE(timings.size() == 3);
    REQUIRE(timings[1].memory.reads < timings[0].memory.reads);
    REQUIRE(timings[1].cycles < timings[0].cycles);
    for (const FrameTiming& t : timings) {
        REQUIRE((t.pixels == 600 && !t.partial));
        std::uint64_t sum = 0;
        for (const std::uint64_t count : t.accounts.units[index(Unit::memory)]) sum += count;
        REQUIRE(sum == t.cycles);
    }
    std::vector<RecordedFrame> alone;
    alone.push_back(record_frame(job, job.frame));
    require_same(timings[0], replay(job.config, job.khz, alone)[0]);
}

TEST_CASE("a machine may replay a trace that is still being recorded", "[trace]") {
    for (const Values& values : shapes()) {
        const Job job = small_job("gears:2", {100, 70}, shaped(format("small"), values));
        INFO(job.config.name);
        std::vector<RecordedFrame> before, replayed;
        before.push_back(record_frame(job, job.frame));
        const std::vector<FrameTiming> expected = replay(job.config, job.khz, before);
        for (const int threads : {1, 2, 5}) {
            require_same(record_and_replay(job, job.khz, replayed, {}, threads)[0], expected[0]);
            require_same(replayed[0].trace, before[0].trace, job.config);
        }
    }
}

TEST_CASE("an abandoned recording stops and notifies those who wait for its rays", "[trace]") {
    const Job job = small_job("gears:2", {100, 70}, format("small"));
    Trace trace;
    { const Recording abandoned(job.image, job.frame, job.config, 2, trace); }
    REQUIRE(trace.failed.load());
    trace.rays.assign(trace.rays.size(), nullptr);
    REQUIRE_THROWS_AS(ray_at(trace, 3, 4), std::runtime_error);
}

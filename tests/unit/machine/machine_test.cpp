// The whole machine: neither the order in which units see the clock nor skipped idle cycles change it, and
// every unit's cycles add up.
#include <algorithm>
#include <numeric>

#include "model/compile/surfaces.hpp"
#include "model/core/settled.hpp"
#include "model/machine/machine.hpp"
#include "sim/run/rtl/rtl_machine.hpp"
#include "sim/run/stream/stream.hpp"
#include "tests/support/check/streams.hpp"
#include "tests/support/machine/machines.hpp"
#include "tests/support/world/traffic.hpp"

using namespace rayclock;
using namespace rayclock::test;

namespace {

rayclock::Disturbance disturbed(std::uint64_t seed) { return {5, 30, seed}; }

/// Compares everything that a machine shows of an observed cycle.
void require_same(const Machine& a, const Machine& b) {
    REQUIRE(a.cycle() == b.cycle());
    for (int p = 0; p < a.config().pipelines; ++p) {
        REQUIRE(a.valid_mask(p) == b.valid_mask(p));
        REQUIRE(a.fire_mask(p) == b.fire_mask(p));
    }
    REQUIRE(a.shared_valid() == b.shared_valid());
    REQUIRE(a.shared_fire() == b.shared_fire());
}

/// Returns a job of 300 random rays for a chip for streams.
Job stream_job_of(const Values& values) {
    const Scene scene = make_builtin("tetra:3", Primitives::triangles);
    const ListedRays rays("random rays", random_rays(scene, 300, 1));
    const Config config = shaped(format("default"), values);
    return make_stream_job(scene, rays, settled(streaming(config, scene)), Outside::clip).job;
}

/// Returns a job for a chip with or without shading; the scene "stream" is a stream of rays.
Job job_of(const char* scene, const Values& values, bool shading) {
    if (std::string(scene) == "stream") return stream_job_of(values);
    if (!shading) return small_job(scene, {20, 12}, shaped(format("small"), values));
    const Whitted settings{3};
    Scene made = make_builtin(scene, Primitives::native);
    if (!made.camera) made.camera = fit_camera(made, 20.0 / 12);
    return make_job(made, *made.camera, {20, 12},
                    shaped(fitted_config(made, settings, named_config("default")), values), {}, settings);
}

std::uint64_t sum(const CauseCounts& counts) {
    return std::accumulate(counts.begin(), counts.end(), std::uint64_t(0));
}

}   // namespace

TEST_CASE("the order in which units see the clock edge does not matter, nor whether a cycle is observed",
          "[machine]") {
    const Values values = GENERATE(Values{}, Values{{"pipelines", 2}, {"l2_sets", 4}, {"dram", 2}});
    const auto [scene, shading] =
        GENERATE(table<const char*, bool>({{"tetra:3", false}, {"balls:1", true}, {"stream", false}}));
    const Job job = job_of(scene, values, shading);
    const RecordedFrame frame = record_frame(job, job.frame);
    for (unsigned seed = 1; seed <= 4; ++seed) {
        const rayclock::Disturbance disturbance = seed % 2 ? rayclock::Disturbance{} : disturbed(seed);
        Machine plain{job.config, job.khz, disturbance}, shuffled{job.config, job.khz, disturbance},
            unseen{job.config, job.khz, disturbance};
        for (Machine* machine : {&plain, &shuffled, &unseen}) machine->start(frame.frame, frame.trace);
        Draw draw{seed};
        std::array<int, pipeline_units> order{};
        std::iota(order.begin(), order.end(), 0);
        while (!plain.done()) {
            for (int i = int(order.size()) - 1; i > 0; --i)
                std::swap(order[std::size_t(i)], order[std::size_t(draw.below(i + 1))]);
            INFO(job.config.name << ", seed " << seed << ", cycle " << plain.cycle());
            REQUIRE(plain.cycle() < 100000);
            plain.step([](const Move&) {});
            shuffled.step_in_order(order);
            require_same(plain, shuffled);
            unseen.step();
            REQUIRE(unseen.finished_pixels() == plain.finished_pixels());
            if (plain.cycle() % 64 == 0) REQUIRE(unseen.accounts() == plain.accounts());
        }
        for (const Machine* machine : {&shuffled, &unseen}) {
            REQUIRE(machine->done());
            REQUIRE(plain.accounts() == machine->accounts());
            REQUIRE(plain.memory().stats() == machine->memory().stats());
        }
    }
}

TEST_CASE("windows of cycles and single cycles are the same machine", "[machine]") {
    const Values values = GENERATE(
        Values{}, Values{{"dram", 2}}, Values{{"dram", 2}, {"pipelines", 2}, {"tile_bits", 1}},
        Values{{"mem_latency", 3}, {"contexts", 256}}, Values{{"tri_interval", 2}, {"raygen_interval", 4}},
        Values{{"tri_queue", 2}, {"box_queue", 2}, {"cache_queue", 2}},
        Values{{"timing", 1}, {"pipelines", 4}});
    const auto [scene, shading] =
        GENERATE(table<const char*, bool>({{"gears:1", false}, {"balls:1", true}, {"stream", false}}));
    const Job job = job_of(scene, values, shading);
    const RecordedFrame frame = record_frame(job, job.frame);
    Machine windows{job.config, job.khz}, single{job.config, job.khz};
    Draw draw{7};
    for (int frames = 0; frames < 2; ++frames) {
        for (Machine* machine : {&windows, &single}) machine->start(frame.frame, frame.trace);
        while (!windows.done()) {
            REQUIRE(windows.cycle() < 1000000);
            windows.run(windows.cycle() + 1 + std::uint64_t(draw.below(60)),
                        windows.finished_pixels() + 1 + std::uint64_t(draw.below(20)));
            while (single.cycle() < windows.cycle()) single.step();
            INFO(job.config.name << ", cycle " << windows.cycle());
            REQUIRE(single.cycle() == windows.cycle());
            REQUIRE(single.finished_pixels() == windows.finished_pixels());
            REQUIRE(single.accounts() == windows.accounts());
            REQUIRE(single.memory().stats() == windows.memory().stats());
        }
    }
}

TEST_CASE("a machine makes every pixel once, and every unit's cycles add up", "[machine]") {
    const Values values = GENERATE(from_range(shapes()));
    const rayclock::Disturbance disturbance = GENERATE(rayclock::Disturbance{}, disturbed(1), disturbed(2));
    const Job job = small_job("gears:1", {20, 12}, shaped(format("small"), values));
    INFO(job.config.name << ", seed " << disturbance.seed);
    const RecordedFrame frame = record_frame(job, job.frame);
    Machine machine{job.config, job.khz, disturbance};
    machine.start(frame.frame, frame.trace);
    std::vector<int> seen(20 * 12, 0);
    std::array<std::uint64_t, link_count> moved{};
    while (!machine.done()) {
        REQUIRE(machine.cycle() < 1000000);
        machine.step([&](const Move& move) {
            ++moved[index(move.link)];
            if (move.link == Link::hit) ++seen[move.y * 20 + move.x];
        });
        for (int p = 0; p < job.config.pipelines; ++p)
            if (machine.fire_mask(p) & ~machine.valid_mask(p))
                FAIL("a transfer without an offer in cycle " << machine.cycle());
    }
    REQUIRE(std::count(seen.begin(), seen.end(), 1) == 20 * 12);

    const Accounts accounts = machine.accounts();
    const std::uint64_t cycles = machine.cycle();
    for (std::size_t u = 0; u < unit_count; ++u) {
        INFO(unit_infos[u].name);
        const std::uint64_t all = u < pipeline_units ? cycles * std::uint64_t(job.config.pipelines) : cycles;
        REQUIRE(sum(accounts.units[u]) == (is_there(Unit(u), job.config) ? all : 0));
        for (std::size_t c = 0; c < cause_count; ++c)
            if (unit_infos[u].causes[c].kind == CauseKind::none) REQUIRE(accounts.units[u][c] == 0);
    }
    // Everything that enters a loop leaves it, and a unit works whenever its link moves.
    const auto count = [&](Link c) { return moved[index(c)]; };
    const auto code = [&](Unit u, std::size_t c) { return accounts.units[index(u)][c]; };
    for (const Link c : {Link::slot, Link::ray, Link::hit}) REQUIRE(count(c) == 20 * 12);
    for (const Link c : {Link::node_req, Link::box_req, Link::box_rsp})
        REQUIRE(count(c) == frame.trace.visits);
    REQUIRE(count(Link::leaves) == count(Link::tested));
    REQUIRE((count(Link::tested) > 0 && count(Link::tested) < frame.trace.visits));
    for (const Link c : {Link::prim_req, Link::tri_req, Link::tri_rsp})
        REQUIRE(count(c) == frame.trace.triangle_tests);
    REQUIRE((count(Link::node_miss) == count(Link::node_fill) &&
             count(Link::prim_miss) == count(Link::prim_fill)));
    REQUIRE(count(Link::mem_req) == count(Link::mem_rsp));
    REQUIRE(count(Link::mem_req) == machine.memory().stats().reads);
    const Link request_link = job.config.l2_sets > 0 ? Link::l2_req : Link::mem_req;
    REQUIRE(count(request_link) == count(Link::node_miss) + count(Link::prim_miss));
    REQUIRE(code(Unit::sched, 0) == count(Link::slot));
    REQUIRE(code(Unit::raygen, 0) == job.config.raygen_interval * count(Link::ray));
    // A turn is work, or holds a step up.
    REQUIRE(code(Unit::trav, 0) + code(Unit::trav, 2) == frame.trace.visits + frame.trace.dropped_groups);
    REQUIRE(frame.trace.dropped_groups > 0);
    REQUIRE(code(Unit::box, 0) == job.config.box_interval() * count(Link::box_req));
    REQUIRE(code(Unit::tri, 0) == job.config.tri_interval * count(Link::tri_req));
    REQUIRE(code(Unit::dispatch, 0) == count(Link::tile));
    REQUIRE(code(Unit::memport, 0) == count(request_link));
    for (const auto& [cache, request, miss, line] :
         {std::tuple{Unit::node_cache, Link::node_req, Link::node_miss, job.config.node_line},
          std::tuple{Unit::prim_cache, Link::prim_req, Link::prim_miss, job.config.prim_line}}) {
        INFO(unit_infos[index(cache)].name);
        // Every look-up is a hit, a miss or a merge.
        REQUIRE(code(cache, 0) + code(cache, 1) + code(cache, 2) == count(request));
        REQUIRE(code(cache, 1) * std::uint64_t(line / line_bytes) == count(miss));
        REQUIRE(code(cache, 3) == code(cache, 1) + code(cache, 2));   // every waiting request was answered
    }
}

TEST_CASE("idle cycles that are passed over are as if each had been stepped", "[machine]") {
    const Values values = GENERATE(from_range(shapes()));
    const auto [scene, shading] =
        GENERATE(table<const char*, bool>({{"tetra:3", false}, {"gears:1", false}, {"balls:1", true}}));
    const int khz = GENERATE(66000, 400000);
    const Job job = job_of(scene, values, shading);
    INFO(scene << ", " << job.config.name << ", " << khz << " kHz");
    std::vector<RecordedFrame> frames;
    for (int i = 0; i < 2; ++i)
        frames.push_back(record_frame(job, job.frame));   // the second with warm caches
    // A ray passes through these units without a look-up in node_cache or prim_cache. In shade it can make
    // several passes.
    const int latencies = int(Pipeline::max_window) + job.config.raygen_latency() +
                          job.config.shade_latency() + job.config.tri_latency() + node_latency(job.config);
    Machine stepped{job.config, khz}, ran{job.config, khz};
    Draw draw{3};
    for (const RecordedFrame& frame : frames) {
        stepped.start(frame.frame, frame.trace);
        ran.start(frame.frame, frame.trace);
        while (!ran.done()) {
            ran.run(ran.cycle() + std::uint64_t(draw.between(1, 500)));
            while (stepped.cycle() < ran.cycle()) stepped.step();
            INFO("cycle " << ran.cycle());
            REQUIRE(ran.cycle() < 2000000);
            REQUIRE(stepped.finished_pixels() == ran.finished_pixels());
            REQUIRE(ran.quiet() + Pipeline::max_window >= stepped.quiet());
            REQUIRE(ran.quiet() <= stepped.quiet() + 4 * std::uint64_t(latencies));
            REQUIRE(stepped.accounts() == ran.accounts());
            REQUIRE(stepped.memory().stats() == ran.memory().stats());
        }
        REQUIRE(stepped.done());
        REQUIRE(stepped.cycle() == ran.cycle());
    }
}

TEST_CASE("model and RTL of the machine count the same", "[machine][lockstep]") {
    const auto [scene, name] = GENERATE(table<const char*, const char*>(
        {{"tetra:3", "small"}, {"gears:1", "small"}, {"gears:1", "lanes1:rays4:small"}}));
    const Job job = small_job(scene, {16, 12}, format(name));
    const RecordedFrame frame = record_frame(job, job.frame);
    for (const rayclock::Disturbance& disturbance :
         // In the last case both caches wait.
         {rayclock::Disturbance{}, disturbed(3), rayclock::Disturbance{0, 75, 4}}) {
        Machine model{job.config, job.khz, disturbance};
        RtlMachine rtl{job.image, job.config, job.khz, disturbance};
        for (int i = 0; i < 2; ++i) {
            const Accounts before = model.accounts();
            model.start(frame.frame, frame.trace);
            rtl.start(frame.frame);
            while (!model.done()) {
                INFO("frame " << i << ", cycle " << model.cycle());
                REQUIRE(model.cycle() < 100000);
                model.step([](const Move&) {});
                rtl.step([](const HitOut&) {});
                REQUIRE(model.valid_mask(0) == rtl.valid_mask(0));
                REQUIRE(model.fire_mask(0) == rtl.fire_mask(0));
                REQUIRE(model.shared_valid() == rtl.shared_valid());
                REQUIRE(model.shared_fire() == rtl.shared_fire());
            }
            REQUIRE(rtl.done());
            REQUIRE(rtl.cycle() == model.cycle());
            REQUIRE(rtl.accounts() == model.accounts() - before);
            REQUIRE(rtl.box_tests() == frame.trace.box_tests);
            REQUIRE(rtl.memory().stats() == model.memory().stats());
        }
    }
}

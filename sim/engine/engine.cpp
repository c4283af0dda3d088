#include "sim/engine/engine.hpp"

#include <chrono>
#include <stdexcept>

#include <fmt/format.h>

#include "model/hits.hpp"
#include "model/machine.hpp"
#include "sim/rtl/rtl_machine.hpp"

namespace rayclock {

namespace {

constexpr std::uint64_t cycles_between_reports = 1 << 15;

/// Clocks a machine until its frame is done.
template <class AnyMachine> FrameRun run(AnyMachine& machine, const Job& job, const char* what, Traffic traffic, const Progress& progress) {
    const auto start = std::chrono::steady_clock::now();
    FrameCollector collector(job);
    const std::uint64_t limit = patience(job.config, traffic), pixels = job.frame.width * std::uint64_t(job.frame.height);
    std::uint64_t quiet = 0;
    while (!machine.done()) {
        machine.step();
        const std::uint32_t fire = machine.fire_mask();
        if (fire & bit(Channel::hit)) collector.add(machine.last_hit());
        quiet = fire ? 0 : quiet + 1;
        if (quiet > limit)
            throw std::runtime_error(fmt::format("{}: nothing has moved for {} cycles at cycle {}, with {} of {} pixels done", what, limit,
                                                 machine.cycle(), machine.hits(), pixels));
        if (progress && machine.cycle() % cycles_between_reports == 0) progress(what, machine.hits(), pixels);
    }
    if (progress) progress(what, pixels, pixels);
    FrameRun result;
    result.cycles = machine.cycle();
    result.counts = machine.counts();
    result.box_tests = machine.box_tests();
    collector.finish(result);
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
}

} // namespace

Job make_job(const Scene& scene, const Camera& camera, FrameSize size, const Config& config, const Progress& progress) {
    check_frame_size(size);
    Job job{config, {}, compile_scene(scene, camera.eye, config, progress), size};
    job.frame = make_frame(camera, size, job.image.lattice, config);
    return job;
}

FrameRun run_model(const Job& job, Traffic traffic, const Progress& progress) {
    Machine machine(job.image, job.frame, job.config, traffic);
    return run(machine, job, "model", traffic, progress);
}

FrameRun run_rtl(const Job& job, Traffic traffic, const Progress& progress, int seed) {
    RtlMachine machine(job.image, job.frame, job.config, traffic, seed);
    return run(machine, job, "rtl", traffic, progress);
}

FrameCollector::FrameCollector(const Job& job) : job_(job), outs_(std::size_t(job.size.width) * std::size_t(job.size.height)) {}

void FrameCollector::add(const HitOut& out) {
    if (out.x < job_.frame.width && out.y < job_.frame.height) outs_[std::size_t(out.y) * job_.frame.width + out.x] = out;
}

void FrameCollector::finish(FrameRun& run) {
    run.hits.size = job_.size;
    run.hits.hits.reserve(outs_.size());
    const HitScale scale(job_.frame, job_.image.lattice, job_.config);
    Digest digest;
    digest.add(run.cycles);
    for (const HitOut& out : outs_) {
        const Closest& c = out.closest;
        digest.add(c.found ? c.prim : no_primitive);
        digest.add(std::uint64_t(c.t) << 32 ^ std::uint64_t(c.u) << 16 ^ c.v);
        run.hits.hits.push_back(scale(out));
    }
    run.digest = digest.value();
}

std::uint64_t patience(const Config& config, const Traffic& traffic) {
    return 1000 + 10 * std::uint64_t(config.mem_latency + traffic.jitter + config.mem_interval);
}

} // namespace rayclock

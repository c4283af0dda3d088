// Replays recorded frames on a machine under observation.
#include "sim/view/observe/replay.hpp"

#include <stdexcept>

#include "model/machine/machine.hpp"
#include "model/machine/stuck_rays.hpp"
#include "sim/view/observe/observer.hpp"

namespace rayclock {

namespace {

constexpr std::uint64_t cycles_between_reports = 1 << 16;

void check_moving(const Machine& machine, std::uint64_t limit) {
    if (machine.quiet() > limit)
        throw std::runtime_error("model: nothing moves any more\n" + describe_stuck_rays(machine));
}

FrameCosts observe_frame(Machine& machine, const Frame& frame, const Trace& trace, std::uint64_t limit,
                         std::uint64_t window, EventSink* sink, const Progress& progress) {
    machine.start(frame, trace);
    Observer observer(machine, frame, sink, window);
    if (sink) sink->begins(machine);
    while (!machine.done() && !interrupted()) {
        observer.step(machine);
        if (sink && sink->done()) break;
        if (machine.cycle() % cycles_between_reports != 0) continue;
        check_moving(machine, limit);
        if (progress) progress("watching", machine.finished_pixels(), frame.pixels());
    }
    FrameCosts costs = observer.finish(machine);
    costs.partial = !machine.done();
    return costs;
}

}   // namespace

FrameCosts observe(const Config& config, int khz, std::span<const RecordedFrame> frames,
                   Disturbance disturbance, std::uint64_t window, EventSink* sink, const Progress& progress) {
    const std::uint64_t limit = patience(config, khz, disturbance);
    Machine machine(config, khz, disturbance);
    for (std::size_t f = 0; f + 1 < frames.size(); ++f) {
        prepare_frame(machine, f, frames);
        machine.start(frames[f].frame, frames[f].trace);
        while (!machine.done() && !interrupted()) {
            machine.run(machine.cycle() + cycles_between_reports);
            check_moving(machine, limit);
        }
    }
    prepare_frame(machine, frames.size() - 1, frames);
    return observe_frame(machine, frames.back().frame, frames.back().trace, limit, window, sink, progress);
}

FrameCosts observe_alone(const Config& config, int khz, const RecordedFrame& frame, std::uint32_t pixel,
                         EventSink* sink) {
    Trace trace;
    trace.width = trace.height = 1;
    trace.rays = {frame.trace.rays[pixel]};
    Frame one = frame.frame;
    one.width = one.height = 1;
    if (config.is_stream()) one.ray_count = 1;   // its record is the first one: the caches are warm anyway
    const std::uint64_t limit = patience(config, khz, {});
    Machine machine(config, khz);
    observe_frame(machine, one, trace, limit, 0, nullptr, {});
    return observe_frame(machine, one, trace, limit, 0, sink, {});
}

}   // namespace rayclock

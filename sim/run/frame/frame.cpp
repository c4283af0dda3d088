// The loops that run the model and the RTL, and the conversion of their results.
#include "sim/run/frame/frame.hpp"

#include <algorithm>
#include <stdexcept>
#include <thread>

#include <fmt/format.h>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "model/base/error.hpp"
#include "model/base/stopwatch.hpp"
#include "model/compile/compile.hpp"
#include "model/compile/frame.hpp"
#include "model/compile/surfaces.hpp"
#include "model/machine/machine.hpp"
#include "model/machine/stuck_rays.hpp"
#include "model/mem/frame_buffer.hpp"
#include "model/trace/hits.hpp"
#include "sim/run/rtl/rtl_machine.hpp"

namespace rayclock {

namespace {

constexpr std::uint64_t cycles_between_reports = 1 << 16;

std::string with_rate(const char* machine, std::uint64_t cycles, const Stopwatch& watch) {
    return fmt::format("{}, {:.1f} M cycles/s", machine,
                       double(cycles) / std::max(1e-9, watch.seconds()) / 1e6);
}

}   // namespace

void check_capacity(const MemoryImage& image, const Config& config) {
    std::uint64_t bytes = image.report.bytes;
    std::string content = "the scene's memory image";
    if (config.writes_hits()) {
        const std::uint64_t end = std::uint64_t(image.first_hit_line) + image.hit_lines,
                            most = std::uint64_t(1) << config.addr_bits;
        if (end > most)
            throw UserError(
                fmt::format("the scene, the rays and their hits need {} lines of memory, and addr_bits={} "
                            "allows {}; without pixel_writes=1 the chip writes no hits",
                            end, config.addr_bits, most));
        bytes = end * line_bytes;
        content += " with the rays and room for their hits";
    }
    const DramPart* part = config.dram_part();
    if (!part) return;
    if (config.is_board()) {
        const SdramPart& sdram = sdram_part(config.board_sdram);
        const std::uint64_t room = std::uint64_t(Screens::base(sdram, 0)) * 64;
        if (image.report.bytes > room)
            throw UserError(
                fmt::format("the scene's memory image of {} bytes does not fit below the two "
                            "pictures in the board's memory: {} has {} bytes for it",
                            image.report.bytes, sdram.name, room));
        return;
    }
    const std::int64_t capacity = capacity_bytes(*part) * config.dram_channels;
    const bool has_pictures = config.scan_out || (config.pixel_writes && !config.writes_hits());
    if (has_pictures && std::int64_t(bytes) + FrameBuffer::bytes > capacity)
        throw UserError(
            fmt::format("the scene's memory image of {} bytes and the {} bytes of two pictures (scan_out, "
                        "pixel_writes) are more "
                        "than the memory '{}' holds, {} bytes",
                        image.report.bytes, FrameBuffer::bytes, part->name, capacity));
    const double peak = double(peak_bytes_per_second(*part)) * config.dram_channels;
    if (config.scan_out && peak <= FrameBuffer::screen_bytes_per_second)
        throw UserError(fmt::format(
            "scan_out=1 reads {:.1f} MB/s for the screen, and the memory '{}' gives {:.1f} at most",
            FrameBuffer::screen_bytes_per_second / 1e6, part->name, peak / 1e6));
    if (std::int64_t(bytes) > capacity)
        throw UserError(
            fmt::format("{} of {} bytes is larger than the memory '{}' of {} bytes; --set dram={} holds it",
                        content, bytes, part->name, capacity,
                        std::int64_t(bytes) <= capacity_bytes(dram_part("ddr3")) ? "ddr3" : "ideal"));
}

std::vector<MirrorRange> mirrored_primitives(const PlacedScene& scene, const MemoryImage& image) {
    std::vector<MirrorRange> ranges;
    std::uint64_t first = scene.own.triangles.size();
    for (const Instance& instance : scene.instances) {
        const std::uint64_t end = first + scene.meshes[instance.mesh].triangles.size();
        const bool is_mirrored =
            glm::determinant(glm::dmat3(instance.place)) < 0 &&
            !std::binary_search(image.written_out.begin(), image.written_out.end(), std::uint32_t(first));
        if (is_mirrored && !ranges.empty() && ranges.back().end == first)
            ranges.back().end = std::uint32_t(end);
        else if (is_mirrored)
            ranges.push_back({std::uint32_t(first), std::uint32_t(end)});
        first = end;
    }
    return ranges;
}

namespace {

bool is_in(const std::vector<MirrorRange>& ranges, std::uint32_t prim) {
    const auto after = std::upper_bound(ranges.begin(), ranges.end(), prim,
                                        [](std::uint32_t p, const MirrorRange& r) { return p < r.first; });
    return after != ranges.begin() && prim < (after - 1)->end;
}

}   // namespace

Job make_job(const Scene& scene, const Camera& camera, FrameSize size, const Config& config,
             const Progress& progress, const Whitted& settings) {
    check_frame_size(size);
    if (config.is_board() && (size.width > int(Screens::width) || size.height > int(Screens::height)))
        throw UserError(fmt::format("a picture of {}x{} is larger than the board's frame buffer, {}x{}",
                                    size.width, size.height, Screens::width, Screens::height));
    if (config.is_stream())
        throw UserError("source=stream has no camera: use simulate or verify with --rays");
    Job job{config, {}, compile_scene(scene, camera.eye, config, progress), size};
    check_capacity(job.image, config);
    if (config.has_instances() && scene.placed) job.mirrored = mirrored_primitives(*scene.placed, job.image);
    if (config.has_shade())
        job.frame.shade = make_shade_frame(scene, settings, job.image, std::uint32_t(size.height), config);
    job.frame = job_frame(job, camera);
    return job;
}

Frame job_frame(const Job& job, const Camera& camera) {
    Frame frame = make_frame(camera, job.size, job.image, job.config);
    frame.shade = job.frame.shade;
    return frame;
}

RecordedFrame record_frame(const Job& job, const Frame& frame, int threads, const Progress& progress) {
    return {frame, record_trace(job.image, frame, job.config, threads, progress)};
}

std::vector<FrameTiming> replay(const Config& config, int khz, const std::vector<RecordedFrame>& frames,
                                Disturbance disturbance, const Progress& progress) {
    const std::uint64_t limit = patience(config, khz, disturbance);
    Machine machine(config, khz, disturbance);
    std::vector<FrameTiming> timings;
    for (std::size_t f = 0; f < frames.size(); ++f) {
        const RecordedFrame& frame = frames[f];
        const Stopwatch watch;
        const UploadTiming upload = prepare_frame(machine, f, std::span(frames));
        const std::uint64_t first = machine.cycle(), pixels = frame.trace.rays.size();
        const Accounts accounts = machine.accounts();
        const MemoryStats memory = machine.memory().stats();
        machine.start(frame.frame, frame.trace);
        do {
            machine.run(machine.cycle() + cycles_between_reports);
            if (machine.quiet() > limit)
                throw std::runtime_error(fmt::format(
                    "model: nothing has moved for {} cycles at cycle {}, with {} of {} pixels done\n{}",
                    machine.quiet(), machine.cycle(), machine.finished_pixels(), pixels,
                    describe_stuck_rays(machine)));
            if (progress)
                progress(with_rate("model", machine.cycle() - first, watch), machine.finished_pixels(),
                         pixels);
        } while (!machine.done() && !interrupted());
        FrameTiming timing{machine.cycle() - first,
                           machine.finished_pixels(),
                           machine.accounts() - accounts,
                           machine.memory().stats() - memory,
                           watch.seconds(),
                           !machine.done(),
                           upload};
        timings.push_back(timing);
        if (timing.partial) break;
    }
    return timings;
}

namespace {

/// Returns the rays of a frame with so many finished pixels: a share in proportion, which is exact if each
/// pixel has one ray.
RayCounts part_of(const RayCounts& all, std::uint64_t pixels, std::size_t of) {
    const auto part = [&](std::uint64_t rays) {
        return of == 0 ? 0 : std::uint64_t(double(rays) / double(of) * double(pixels));
    };
    return {part(all.primary), part(all.shadow), part(all.reflection), part(all.refraction),
            part(all.primary_hits)};
}

}   // namespace

RayWork work_of(const RecordedFrame& frame, const FrameTiming& timing) {
    const Trace& trace = frame.trace;
    return {timing.partial ? part_of(trace.counts, timing.pixels, trace.rays.size()) : trace.counts,
            trace.visits, trace.box_tests, trace.triangle_tests};
}

FrameResult frame_result(const RecordedFrame& frame, const FrameTiming& timing) {
    FrameResult run{timing, work_of(frame, timing), {}, {}, {}, !frame.trace.colours.empty()};
    run.digest = digest_of(frame.trace.hits, timing.cycles, frame.trace.colours);
    return run;
}

FrameResult frame_result(const Job& job, const Frame& frame, const FrameTiming& timing, const RayWork& work,
                         std::vector<Closest> answers, Colours colours) {
    FrameResult run{timing, work, scaled(job, frame, answers), {}, {}, job.config.has_shade()};
    run.digest = digest_of(answers, timing.cycles, colours);
    run.answers = std::move(answers);
    run.colours = std::move(colours);
    return run;
}

std::vector<FrameTiming> record_and_replay(const Job& job, int khz, std::vector<RecordedFrame>& frames,
                                           Disturbance disturbance, int threads, const Progress& progress) {
    frames = std::vector<RecordedFrame>(1);
    frames[0].frame = job.frame;
    const int cores = threads > 0 ? threads : int(std::max(1u, std::thread::hardware_concurrency()));
    Recording recording(job.image, job.frame, job.config, std::max(1, cores - 1), frames[0].trace);
    if (cores == 1) recording.finish();
    std::vector<FrameTiming> timings;
    try {
        timings = replay(job.config, khz, frames, disturbance, progress);
    } catch (...) {
        if (frames[0].trace.failed.load()) recording.finish();   // rethrows the cause
        throw;
    }
    if (timings.back().partial) frames[0].trace.failed.store(true);   // the remaining rays are not needed
    recording.finish();
    return timings;
}

FrameResult run_model(const Job& job, Disturbance disturbance, const Progress& progress) {
    std::vector<RecordedFrame> frames;
    const std::vector<FrameTiming> timings =
        record_and_replay(job, job.khz, frames, disturbance, 0, progress);
    return frame_result(job, job.frame, timings[0], work_of(frames[0], timings[0]),
                        std::move(frames[0].trace.hits), std::move(frames[0].trace.colours));
}

namespace {

FrameResult run_rtl_frame(RtlMachine& machine, const Job& job, const Frame& frame, std::uint64_t limit,
                          const UploadTiming& upload, const Progress& progress) {
    const Stopwatch watch;
    const std::uint64_t first = machine.cycle(), pixels = frame.pixels();
    const MemoryStats memory = machine.memory().stats();
    FrameCollector collector(frame, job.config.has_shade());
    machine.start(frame);
    std::uint64_t quiet = 0;
    while (!machine.done() && !interrupted()) {
        machine.step([&](const HitOut& hit) { collector.add(hit); });
        if (const auto& n = machine.invalid_value())
            throw std::runtime_error(fmt::format("rtl: cycle {}: the link {} carries {}", machine.cycle() - 1,
                                                 link_infos[index(n->link)].name, n->what));
        quiet = machine.moved() ? 0 : quiet + 1;
        if (quiet > limit)
            throw std::runtime_error(
                fmt::format("rtl: nothing has moved for {} cycles at cycle {}, with {} of {} pixels done",
                            limit, machine.cycle(), machine.finished_pixels(), pixels));
        if (progress && machine.cycle() % cycles_between_reports == 0)
            progress(with_rate("rtl", machine.cycle() - first, watch), machine.finished_pixels(), pixels);
    }
    if (progress) progress("rtl", pixels, pixels);
    const Accounts& accounts = machine.accounts();   // for an interrupted frame, these count two more cycles
    const FrameTiming timing{machine.done() ? machine.cycle() - first : machine.counted_cycles(),
                             machine.finished_pixels(),
                             accounts,
                             machine.memory().stats() - memory,
                             watch.seconds(),
                             !machine.done(),
                             upload};
    const auto lookups = [&](Unit cache) {
        const CauseCounts& c = timing.accounts.units[index(cache)];   // by CacheOutcome: hit, miss, merge
        return c[0] + c[1] + c[2];
    };
    return frame_result(
        job, frame, timing,
        {machine.rays(), lookups(Unit::node_cache), machine.box_tests(), lookups(Unit::prim_cache)},
        collector.hits(), collector.colours());
}

}   // namespace

std::vector<FrameResult> run_rtl(const Job& job, int khz, std::span<const RecordedFrame> frames,
                                 Disturbance disturbance, const Progress& progress, int seed) {
    RtlMachine machine(job.image, job.config, khz, disturbance, seed);
    std::vector<FrameResult> runs;
    for (std::size_t f = 0; f < frames.size(); ++f) {
        machine.change(frames[f].upload);
        const UploadTiming upload = prepare_frame(machine, f, frames);
        runs.push_back(run_rtl_frame(machine, job, frames[f].frame, patience(job.config, khz, disturbance),
                                     upload, progress));
        if (runs.back().partial) break;
    }
    return runs;
}

FrameResult run_rtl(const Job& job, Disturbance disturbance, const Progress& progress, int seed) {
    std::vector<RecordedFrame> one(1);
    one[0].frame = job.frame;
    return std::move(run_rtl(job, job.khz, one, disturbance, progress, seed)[0]);
}

HitFrame scaled(const Job& job, const Frame& frame, const std::vector<Closest>& hits) {
    HitFrame picture{job.size, {}};
    if (job.config.is_stream()) return picture;
    picture.hits.reserve(hits.size());
    const HitScale scale(frame, job.image.lattice, job.config);
    const std::uint32_t beyond = (1u << job.config.t_bits()) - 1;
    for (std::uint32_t i = 0; i < hits.size(); ++i) {
        picture.hits.push_back(scale({i % frame.width, i / frame.width, hits[i]}));
        if (is_in(job.mirrored, hits[i].found ? hits[i].prim : no_primitive))
            std::swap(picture.hits.back().u, picture.hits.back().v);
        const bool is_plane = job.config.planes && hits[i].found && hits[i].prim >= job.image.first_plane;
        if (!is_plane || hits[i].t != beyond) continue;
        const std::uint32_t line = job.image.first_plane_surface_line + hits[i].prim - job.image.first_plane;
        picture.hits.back().depth = depth_on_plane(hits[i], unpack<Surface>(job.image.line(line), job.config),
                                                   frame.eye, job.image.lattice, job.config);
    }
    return picture;
}

HitFrame hits_of(const Job& job, const RecordedFrame& frame) {
    return scaled(job, frame.frame, frame.trace.hits);
}

Picture picture_from_colours(FrameSize size, const Colours& colours) {
    Picture picture{size, {}};
    picture.pixels.reserve(colours.size());
    constexpr float one = 1 << unit_bits;
    for (const auto& c : colours)
        picture.pixels.emplace_back(float(c[0]) / one, float(c[1]) / one, float(c[2]) / one);
    return picture;
}

Picture picture_from_reference(const WhittedFrame& reference) {
    Picture picture{reference.hits.size, {}};
    picture.pixels.assign(reference.pixels.begin(), reference.pixels.end());
    return picture;
}

std::uint64_t digest_of(const std::vector<Closest>& hits, std::uint64_t cycles, const Colours& colours) {
    Digest digest;
    digest.add(cycles);
    for (const Closest& c : hits) {
        digest.add(c.found ? c.prim : no_primitive);
        digest.add(std::uint64_t(c.t) << 32 ^ std::uint64_t(c.u) << 16 ^ c.v);
    }
    for (const auto& c : colours) digest.add(std::uint64_t(c[0]) << 40 ^ std::uint64_t(c[1]) << 20 ^ c[2]);
    return digest.value();
}

std::uint64_t patience(const Config& config, int khz, const Disturbance& disturbance) {
    std::uint64_t cycles = std::uint64_t(config.mem_latency + config.mem_interval);
    if (const DramPart* part = config.dram_part())
        cycles += std::uint64_t(longest_pause_ps(*part)) * std::uint64_t(khz) / 1'000'000'000;
    return 20000 + 10 * (cycles + std::uint64_t(disturbance.jitter));
}

}   // namespace rayclock

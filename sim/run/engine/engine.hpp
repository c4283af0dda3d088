#pragma once
// Whole frames on the model or on the RTL, with what they cost.
#include <span>
#include <string>

#include "model/layout/memory_image.hpp"
#include "model/base/progress.hpp"
#include "model/core/units.hpp"
#include "model/mem/memory.hpp"
#include "sim/judge/reference/reference.hpp"
#include "model/scene/hit_shading.hpp"
#include "model/scene/hit.hpp"
#include "model/scene/placed.hpp"
#include "model/trace/trace.hpp"
#include "model/compile/upload.hpp"
#include "sim/files/process/interrupt.hpp"

namespace rayclock {

constexpr int default_khz = 66000;

/// Primitives of instances that are mirror images. The chip knows a mesh's triangles by the order of their
/// corners in the mesh; in the scene the second and the third have changed places, so that their outside
/// stays outside. What is written out is turned already.
struct MirrorRange {
    std::uint32_t first = 0, end = 0;   ///< rising
};
std::vector<MirrorRange> mirrored_primitives(const PlacedScene& scene, const MemoryImage& image);

/// A scene compiled for one configuration and one picture, and the chip's clock: all that a machine needs.
struct Job {
    Config config;
    Frame frame;
    MemoryImage image;
    FrameSize size;
    int khz = default_khz;
    std::vector<MirrorRange> mirrored{};   ///< if the chip walks instances
};
/// The image must fit into the memory that the configuration names; throws UserError if it does not.
/// make_job() asks this.
void check_capacity(const MemoryImage& image, const Config& config);
Job make_job(const Scene& scene, const Camera& camera, FrameSize size, const Config& config,
             const Progress& progress = {}, const Whitted& settings = {});
/// The job's frame, seen by another camera.
Frame job_frame(const Job& job, const Camera& camera);

using Colours = std::vector<std::array<std::uint32_t, 3>>;   ///< [y * width + x], unit_bits of fraction

/// What a frame took.
struct FrameTiming {
    std::uint64_t cycles = 0;
    std::uint64_t pixels = 0;   ///< finished
    Accounts accounts;
    MemoryStats memory;
    double seconds = 0;      ///< of the host
    bool partial = false;    ///< stopped before the end
    UploadTiming upload{};   ///< before it
    std::uint64_t all_cycles() const { return cycles + upload.cycles + upload.reset; }
};

/// What a frame's rays did.
struct FrameWork {
    RayCounts rays;   ///< of the RTL: only those that leave its raygen, by what they are for
    std::uint64_t visits = 0, box_tests = 0, triangle_tests = 0;
};

/// A frame that a machine made.
struct FrameRun : FrameTiming, FrameWork {
    HitFrame hits;
    std::vector<Closest> answers;    ///< the same, as the machine gave them
    Colours colours;                 ///< likewise, if the chip shades: unit_bits of fraction
    bool finished_picture = false;   ///< the chip shades
    std::uint64_t digest = 0;        ///< see digest_of()
};

/// A frame of a sequence, what its rays do, and what the host writes before it.
struct FrameTrace {
    Frame frame;
    Trace trace;
    Upload upload{};
};
/// bring() for one frame of a sequence.
template <class Machine>
UploadTiming bring(Machine& machine, std::size_t f, std::span<const FrameTrace> frames) {
    return bring(machine, f, [&](std::size_t k) { return k < frames.size() ? &frames[k].upload : nullptr; });
}
FrameTrace record_frame(const Job& job, const Frame& frame, int threads = 0, const Progress& progress = {});

/// Runs frames on one machine, one after the other: what lies in the caches stays. `khz` and `config`'s
/// timing may differ from the job's that was recorded. Stops early, with the last frame partial, when
/// interrupted().
std::vector<FrameTiming> replay(const Config& config, int khz, const std::vector<FrameTrace>& frames,
                                Traffic traffic = {}, const Progress& progress = {});

/// One frame, the job's, replayed while it is being recorded: `frames` gets its trace.
std::vector<FrameTiming> record_and_replay(const Job& job, int khz, std::vector<FrameTrace>& frames,
                                           Traffic traffic = {}, int threads = 0,
                                           const Progress& progress = {});

/// Frames on the RTL, which makes its frames by itself: of their traces it reads none.
std::vector<FrameRun> run_rtl(const Job& job, int khz, std::span<const FrameTrace> frames,
                              Traffic traffic = {}, const Progress& progress = {}, int seed = 1);

/// A frame's run, from what it took, what its rays did and what they answered.
FrameRun frame_run(const Job& job, const Frame& frame, const FrameTiming& timing, const FrameWork& work,
                   std::vector<Closest> answers, Colours colours);
/// A replayed frame with what its rays did; hits and answers are left out.
FrameRun frame_run(const FrameTrace& frame, const FrameTiming& timing);
/// What the rays of a recorded frame did, or those of the pixels that were done.
FrameWork work_of(const FrameTrace& frame, const FrameTiming& timing);

/// Rays of a frame: of a finished picture all, else one for each pixel that is done.
inline double rays_of(const FrameRun& run) {
    return run.finished_picture ? double(run.rays.all()) : double(run.pixels);
}

/// One frame, recorded and replayed; or made by the RTL.
FrameRun run_model(const Job& job, Traffic traffic = {}, const Progress& progress = {});
FrameRun run_rtl(const Job& job, Traffic traffic = {}, const Progress& progress = {}, int seed = 1);

/// A recorded frame as hits.
HitFrame hits_of(const Job& job, const FrameTrace& frame);
/// Over every pixel's primitive, t, u and v, its colour if the chip shades, and the cycles.
std::uint64_t digest_of(const std::vector<Closest>& hits, std::uint64_t cycles, const Colours& colours = {});
/// Colours that a chip made, as a picture.
Picture picture_of(FrameSize size, const Colours& colours);
/// The same of those that the reference made.
Picture picture_of(const WhittedFrame& reference);

/// Gathers an RTL's hits as they come out.
class FrameCollector {
public:
    FrameCollector(const Frame& frame, bool shading)
        : width_(frame.width),
          height_(frame.height),
          hits_(std::size_t(frame.width) * frame.height),
          colours_(shading ? hits_.size() : 0) {}
    void add(const HitOut& out) {
        if (out.x >= width_ || out.y >= height_) return;
        const std::size_t at = std::size_t(out.y) * width_ + out.x;
        hits_[at] = out.closest;
        if (!colours_.empty()) colours_[at] = out.colour;
    }
    const std::vector<Closest>& hits() const { return hits_; }
    const Colours& colours() const { return colours_; }

private:
    std::uint32_t width_, height_;
    std::vector<Closest> hits_;
    Colours colours_;
};
/// In terms of the scene.
HitFrame scaled(const Job& job, const Frame& frame, const std::vector<Closest>& hits);

/// Cycles of this clock without any transfer after which a run is given up: ten times as many as the memory
/// can take to answer.
std::uint64_t patience(const Config& config, int khz, const Traffic& traffic);

}   // namespace rayclock

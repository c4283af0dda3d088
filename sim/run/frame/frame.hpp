#pragma once
// Renders whole frames on the model or on the RTL, and reports their cost.
#include <span>
#include <string>

#include "model/base/progress.hpp"
#include "model/compile/upload.hpp"
#include "model/layout/memory_image.hpp"
#include "model/machine/units.hpp"
#include "model/mem/memory.hpp"
#include "model/scene/hit.hpp"
#include "model/scene/hit_shading.hpp"
#include "model/scene/placed.hpp"
#include "model/trace/trace.hpp"
#include "sim/files/process/interrupt.hpp"
#include "sim/judge/reference/reference.hpp"

namespace rayclock {

constexpr int default_khz = 66000;

/// A range of primitives of instances that are mirror images. The chip uses the order of a triangle's corners
/// in the mesh. In the scene the second and the third corner are swapped, so that the outside stays outside.
/// Triangles that are expanded into the scene are swapped already.
struct MirrorRange {
    std::uint32_t first = 0, end = 0;   ///< sorted and disjoint
};
/// Returns the ranges of the scene, in rising order.
std::vector<MirrorRange> mirrored_primitives(const PlacedScene& scene, const MemoryImage& image);

/// A scene compiled for one configuration and one picture, and the chip's clock: everything that a machine
/// needs.
struct Job {
    Config config;
    Frame frame;
    MemoryImage image;
    FrameSize size;
    int khz = default_khz;
    std::vector<MirrorRange> mirrored{};   ///< if the chip traverses instances
};
/// Throws UserError if the image does not fit into the memory of the configuration, or if that memory is too
/// slow for `scan_out`. Called by make_job().
void check_capacity(const MemoryImage& image, const Config& config);
/// Compiles a scene. Throws UserError if the size is wrong or the image does not fit.
Job make_job(const Scene& scene, const Camera& camera, FrameSize size, const Config& config,
             const Progress& progress = {}, const Whitted& settings = {});
/// Returns the job's frame, seen by another camera.
Frame job_frame(const Job& job, const Camera& camera);

using Colours = std::vector<std::array<std::uint32_t, 3>>;   ///< [y * width + x], unit_bits of fraction

/// The cost of a frame on a machine: cycles, the account of each unit's cycles, and memory traffic.
struct FrameTiming {
    std::uint64_t cycles = 0;
    std::uint64_t pixels = 0;   ///< finished ones
    Accounts accounts;
    MemoryStats memory;
    double seconds = 0;      ///< of the host
    bool partial = false;    ///< stopped before the end
    UploadTiming upload{};   ///< before the frame
    std::uint64_t all_cycles() const { return cycles + upload.cycles + upload.reset; }
};

/// The work of a frame's rays: rays by purpose, visits and tests. It does not depend on a machine's timing.
struct RayWork {
    RayCounts rays;   ///< of the RTL: only rays that leave its raygen, by purpose
    std::uint64_t visits = 0, box_tests = 0, triangle_tests = 0;
};

/// A frame that a machine has rendered: its cost, the work of its rays, and the hits and colours.
struct FrameResult : FrameTiming, RayWork {
    HitFrame hits;
    std::vector<Closest> answers;    ///< the same hits, as the machine returned them
    Colours colours;                 ///< [y * width + x], if the chip shades: unit_bits of fraction
    bool finished_picture = false;   ///< the chip shades
    std::uint64_t digest = 0;        ///< see digest_of()
};

/// A frame whose rays are traced but not yet timed: its registers, the trace of its rays, and the host's
/// writes before it. Machines replay a sequence of them.
struct RecordedFrame {
    Frame frame;
    Trace trace;
    Upload upload{};
};
/// Calls prepare_frame() for one frame of a sequence.
template <class Machine>
UploadTiming prepare_frame(Machine& machine, std::size_t f, std::span<const RecordedFrame> frames) {
    return prepare_frame(machine, f,
                         [&](std::size_t k) { return k < frames.size() ? &frames[k].upload : nullptr; });
}
/// Records the work of a frame's rays. `threads` 0 means all cores.
RecordedFrame record_frame(const Job& job, const Frame& frame, int threads = 0,
                           const Progress& progress = {});

/// Replays frames on one machine one after the other, so that the caches keep their contents. `khz` and
/// `config`'s timing may differ from those of the recorded job. Stops early, with the last frame partial,
/// once interrupted(). Throws std::runtime_error if the machine hangs.
std::vector<FrameTiming> replay(const Config& config, int khz, const std::vector<RecordedFrame>& frames,
                                Disturbance disturbance = {}, const Progress& progress = {});

/// Replays the job's frame while it is being recorded. `frames` receives the recorded frame.
std::vector<FrameTiming> record_and_replay(const Job& job, int khz, std::vector<RecordedFrame>& frames,
                                           Disturbance disturbance = {}, int threads = 0,
                                           const Progress& progress = {});

/// Renders frames on the RTL. The RTL computes them itself and reads none of their traces. Throws
/// std::runtime_error if it hangs or puts an impossible value on a link.
std::vector<FrameResult> run_rtl(const Job& job, int khz, std::span<const RecordedFrame> frames,
                                 Disturbance disturbance = {}, const Progress& progress = {}, int seed = 1);

/// Builds a frame's result from its cost, the work of its rays and their answers.
FrameResult frame_result(const Job& job, const Frame& frame, const FrameTiming& timing, const RayWork& work,
                         std::vector<Closest> answers, Colours colours);
/// Builds the result of a replayed frame, without hits and answers.
FrameResult frame_result(const RecordedFrame& frame, const FrameTiming& timing);
/// Returns the work of a recorded frame's rays. For a partial frame, the ray counts are in proportion to the
/// finished pixels; visits and tests are those of the whole frame.
RayWork work_of(const RecordedFrame& frame, const FrameTiming& timing);

/// Returns the number of rays of a frame: all rays of a finished picture, else one for each finished pixel.
inline double rays_of(const FrameResult& run) {
    return run.finished_picture ? double(run.rays.all()) : double(run.pixels);
}

/// Renders one frame: run_model() records and replays it, run_rtl() computes it on the RTL.
FrameResult run_model(const Job& job, Disturbance disturbance = {}, const Progress& progress = {});
FrameResult run_rtl(const Job& job, Disturbance disturbance = {}, const Progress& progress = {},
                    int seed = 1);

/// Returns the hits of a recorded frame.
HitFrame hits_of(const Job& job, const RecordedFrame& frame);
/// Hashes every pixel's primitive, t, u and v, its colour if the chip shades, and the cycles.
std::uint64_t digest_of(const std::vector<Closest>& hits, std::uint64_t cycles, const Colours& colours = {});
/// Converts colours that a chip computed, or their recorded trace, to a picture.
Picture picture_from_colours(FrameSize size, const Colours& colours);
/// Converts the frame of the reference tracer to a picture.
Picture picture_from_reference(const WhittedFrame& reference);

/// Collects an RTL's hits as they arrive.
class FrameCollector {
public:
    FrameCollector(const Frame& frame, bool shades)
        : width_(frame.width), hits_(std::size_t(frame.pixels())), colours_(shades ? hits_.size() : 0) {}
    void add(const HitOut& out) {
        const std::size_t at = std::size_t(out.y) * width_ + out.x;
        if (out.x >= width_ || at >= hits_.size()) return;
        hits_[at] = out.closest;
        if (!colours_.empty()) colours_[at] = out.colour;
    }
    const std::vector<Closest>& hits() const { return hits_; }
    const Colours& colours() const { return colours_; }

private:
    std::uint32_t width_;
    std::vector<Closest> hits_;
    Colours colours_;
};
/// Converts hits to the scene's units.
HitFrame scaled(const Job& job, const Frame& frame, const std::vector<Closest>& hits);

/// Returns the number of cycles of this clock without any transfer after which a run is given up. It is ten
/// times the longest time that the memory takes to answer.
std::uint64_t patience(const Config& config, int khz, const Disturbance& disturbance);

}   // namespace rayclock

#pragma once
// The recording of a frame's rays, which a machine replays.
#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <thread>
#include <vector>

#include "model/base/progress.hpp"
#include "model/layout/memory_image.hpp"
#include "model/scene/whitted.hpp"
#include "model/trace/trace_words.hpp"

namespace rayclock {

/// Records the rays of a pixel when a machine starts it.
class PixelRecorder {
public:
    virtual ~PixelRecorder() = default;
    /// Returns the pixel's first word. The words stay in place until the machine has finished the pixel.
    virtual const std::uint32_t* record(std::uint32_t x, std::uint32_t y) = 0;
};

/// A frame's rays as recorded: for every pixel the nodes visited, the triangles tested and the hit. It is
/// valid for every configuration of the same format, node width and leaf size, with any caches, memory,
/// clock, contexts and pipelines.
///
/// trace_words.hpp describes the words of a pixel.
struct Trace {
    std::uint32_t width = 0, height = 0;      ///< as in Frame, also for a stream
    std::uint32_t first_mesh_line = ~0u;      ///< of the lower engine's nodes, if there are two engines
    std::vector<const std::uint32_t*> rays;   ///< [y * width + x], or [ray]: into chunks
    std::vector<Closest> hits;                ///< [y * width + x]; `ray` is 0
    std::vector<std::array<std::uint32_t, 3>> colours;   ///< [y * width + x], if the chip shades: as in Pixel
    std::vector<std::uint64_t> signatures;   ///< [y * width + x], if the chip shades: PathSignature
    RayCounts counts;
    std::vector<std::vector<std::uint32_t>> chunks;
    std::uint64_t visits = 0, box_tests = 0, triangle_tests = 0, dropped_groups = 0;
    double seconds = 0;   ///< host time of the recording
    /// Records rays on demand, in the machine's thread; `rays` is then empty. Null: `rays` holds all rays.
    PixelRecorder* source = nullptr;

    /// Set if recording ended early. It moves with the trace as plain data, so do not move a trace during its
    /// recording.
    struct Flag : std::atomic<bool> {
        Flag() : std::atomic<bool>(false) {}
        Flag(Flag&& other) noexcept : std::atomic<bool>(other.load()) {}
        Flag& operator=(Flag&& other) noexcept {
            store(other.load());
            return *this;
        }
    } failed;

    Trace() = default;
    Trace(Trace&&) = default;
    Trace& operator=(Trace&&) = default;
};

/// Walks every pixel's ray with `threads` threads, 0 for all cores. The result does not depend on their
/// number.
Trace record_trace(const MemoryImage& image, const Frame& frame, const Config& config, int threads = 0,
                   const Progress& progress = {});

/// Records in the background. A machine may replay the trace during the recording, and waits for rays that
/// are not yet there. `image` and `trace` must stay in place until finish(), after which totals and hits are
/// valid.
class Recording {
public:
    Recording(const MemoryImage& image, const Frame& frame, const Config& config, int threads, Trace& trace,
              const Progress& progress = {});
    ~Recording();
    Recording(const Recording&) = delete;
    /// Waits for the end. Throws the exception of a thread, if any.
    void finish();

private:
    struct Work;
    std::unique_ptr<Work> work_;
};

/// Returns a ray's first word. If the trace has a source, that records the ray on demand. Otherwise this
/// waits for a ray that is not yet recorded. Throws if recording failed.
inline const std::uint32_t* ray_at(const Trace& trace, std::uint32_t x, std::uint32_t y) {
    if (trace.source) return trace.source->record(x, y);
    auto& place = const_cast<const std::uint32_t*&>(trace.rays[std::size_t(y) * trace.width + x]);
    const std::atomic_ref<const std::uint32_t*> word(place);
    const std::uint32_t* first = word.load(std::memory_order_acquire);
    while (first == nullptr) [[unlikely]] {
            if (trace.failed.load()) throw std::runtime_error("the rays could not be recorded");
            std::this_thread::yield();
            first = word.load(std::memory_order_acquire);
        }
    return first;
}

}   // namespace rayclock

#pragma once
// The recording of a frame's rays, which a machine replays.
#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <thread>
#include <vector>

#include "model/layout/memory_image.hpp"
#include "model/base/progress.hpp"
#include "model/scene/whitted.hpp"

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
/// A visit is a word: bits 0..23 the node's line, then the flags below, then the number of groups that trav
/// drops after it. A word for each triangle follows (bits 0..24 the half line, bit 31 set in the last). The
/// visit of an instance has its own flags: enters(), a value that no number of groups takes.
///
/// If the chip shades, a pixel has many rays in sequence. Two words follow each ray. The first holds the line
/// of the surface to read (if the flag is set). It also holds a flag for a finished pixel, or the purpose of
/// the next ray. The second is the number of passes through shade that follow. With instances, a word with
/// the line of the instance hit comes before these two. If all its primitives share a material, another word
/// holds the material's line. If the surface has a texture, two more words come next: the lines of its record
/// (marked) and of its texels. The surface's word then has a flag.
struct Trace {
    static constexpr std::uint32_t tests_flag = 1u << 24;   ///< triangle words follow
    static constexpr std::uint32_t end_flag = 1u << 25;     ///< the ray is done after this visit
    static constexpr int dropped_shift = 26;
    static constexpr std::uint32_t entry_flags = ~0u << dropped_shift;   ///< of an instance's visit
    static constexpr bool enters(std::uint32_t head) { return head >= entry_flags; }
    static constexpr std::uint32_t last_flag = 1u << 31;   ///< of a triangle's word
    /// Marks a word with the line of an instance or of its material.
    static constexpr std::uint32_t place_flag = 1u << 31;
    static constexpr std::uint32_t surface_flag = 1u << 24,
                                   pixel_flag = 1u << 25,    ///< of the word after a ray
        texture_flag = 1u << 28,                             ///< in the same word: a texture is read
        cutout_flag = 1u << 29;                              ///< in the same word: it belongs to a cut-out
    static constexpr std::uint32_t record_flag = 1u << 30;   ///< marks the word of a texture record
    static constexpr int purpose_shift = 26;                 ///< in the same word: RayPurpose of the next ray
    static constexpr std::uint32_t node_mask = (1u << max_addr_bits) - 1,
                                   prim_mask = (2u << max_addr_bits) - 1;

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

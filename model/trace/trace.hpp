#pragma once
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

/// A frame's rays as recorded: for every pixel the nodes it visits, the triangles it tests and what it hits.
/// Holds for every configuration of the same format, node width and leaf size, whatever its caches, memory,
/// clock, contexts and pipelines.
///
/// A visit is a word (bits 0..23 the node's line, then the flags below, then how many groups trav drops after
/// it) followed, if it has any, by a word for each triangle (bits 0..24 the half line, bit 31 set in the
/// last). The visit of an instance has its flags alone: enters(), which no number of groups is. If the chip
/// shades, a pixel has many rays, one after the other, and each is followed by two words: the line of the
/// surface that must be read (if the flag is set), whether the pixel then is finished and, if not, what the
/// next ray is for; and how many passes through shade follow. If there are instances, a word with the line of
/// that which was hit comes before them, and one with the line of its material if it has one for all.
struct Trace {
    static constexpr std::uint32_t tests_flag = 1u << 24;   ///< triangle words follow
    static constexpr std::uint32_t end_flag = 1u << 25;     ///< the ray is done after this visit
    static constexpr int turns_shift = 26;
    static constexpr std::uint32_t entry_flags = ~0u << turns_shift;   ///< of an instance's visit
    static constexpr bool enters(std::uint32_t head) { return head >= entry_flags; }
    static constexpr std::uint32_t last_flag = 1u << 31;    ///< of a triangle's word
    static constexpr std::uint32_t place_flag = 1u << 31;   ///< of the word before that word
    static constexpr std::uint32_t surface_flag = 1u << 24,
                                   pixel_flag = 1u << 25;   ///< of the word after a ray
    static constexpr int purpose_shift = 26;                ///< likewise: RayPurpose of the next ray
    static constexpr std::uint32_t node_mask = (1u << max_addr_bits) - 1,
                                   prim_mask = (2u << max_addr_bits) - 1;

    std::uint32_t width = 0, height = 0;
    std::uint32_t meshes = ~0u;   ///< line from which on nodes are the lower engine's, if there are two
    std::vector<const std::uint32_t*> rays;              ///< [y * width + x]: into chunks
    std::vector<Closest> hits;                           ///< likewise; `ray` is 0
    std::vector<std::array<std::uint32_t, 3>> colours;   ///< likewise, if the chip shades: as in Pixel
    std::vector<std::uint64_t> signatures;               ///< likewise: PathSignature
    RayCounts counts;
    std::vector<std::vector<std::uint32_t>> chunks;
    std::uint64_t visits = 0, box_tests = 0, triangle_tests = 0, turns = 0;
    double seconds = 0;   ///< host time of recording

    /// Set if recording ended early. Moves with the trace as plain data: nobody records while it is moved.
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

/// Walks every pixel's ray; `threads` 0 for all cores. The same for any number of them.
Trace record_trace(const MemoryImage& image, const Frame& frame, const Config& config, int threads = 0,
                   const Progress& progress = {});

/// The same beside other work: a machine may replay the trace while it is being recorded, and waits for rays
/// that are not there yet. `image` and `trace` must stay where they are until finish(), after which totals
/// and hits are good.
class Recording {
public:
    Recording(const MemoryImage& image, const Frame& frame, const Config& config, int threads, Trace& trace,
              const Progress& progress = {});
    ~Recording();
    Recording(const Recording&) = delete;
    /// Waits for the end; throws what a thread threw.
    void finish();

private:
    struct Work;
    std::unique_ptr<Work> work_;
};

/// A ray's first word, waiting for it if its trace is still being recorded.
inline const std::uint32_t* ray_at(const Trace& trace, std::uint32_t x, std::uint32_t y) {
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

#pragma once
#include <cstdint>
#include <vector>

#include "model/accel/memory_image.hpp"
#include "model/core/progress.hpp"

namespace rayclock {

/// A frame's rays as recorded: for every pixel the nodes it visits, the triangles it tests and what it hits. Holds for every
/// configuration of the same format, node width and leaf size, whatever its caches, memory, clock, contexts and pipelines.
///
/// A visit is a word (bits 0..23 the node's line, then the flags below, then how many groups trav drops after it) followed,
/// if it has any, by a word for each triangle (bits 0..24 the half line, bit 31 set in the last).
struct Trace {
    static constexpr std::uint32_t tests_flag = 1u << 24;   ///< triangle words follow
    static constexpr std::uint32_t end_flag = 1u << 25;     ///< the ray is done after this visit
    static constexpr int turns_shift = 26;
    static constexpr std::uint32_t last_flag = 1u << 31;    ///< of a triangle's word
    static constexpr std::uint32_t node_mask = (1u << addr_bits) - 1, prim_mask = (2u << addr_bits) - 1;

    std::uint32_t width = 0, height = 0;
    std::vector<const std::uint32_t*> rays;   ///< [y * width + x]: into chunks
    std::vector<Closest> hits;                ///< likewise; `ray` is 0
    std::vector<std::vector<std::uint32_t>> chunks;
    std::uint64_t visits = 0, box_tests = 0, triangle_tests = 0, turns = 0;
    double seconds = 0;                       ///< host time of recording

    Trace() = default;
    Trace(Trace&&) = default;
    Trace& operator=(Trace&&) = default;
};

/// Walks every pixel's ray; `threads` 0 for all cores. The same for any number of them.
Trace record_trace(const MemoryImage& image, const Frame& frame, const Config& config, int threads = 0, const Progress& progress = {});

} // namespace rayclock

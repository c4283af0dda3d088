#pragma once
// Costs of a frame on the model: by pixel, by purpose of rays, by unit and over time. The observer counts
// every transfer, so the sums equal the machine's own accounts.
#include <array>
#include <cstdint>
#include <vector>

#include "model/machine/links.hpp"
#include "model/mem/memory.hpp"
#include "model/scene/whitted.hpp"
#include "sim/run/request/view.hpp"

namespace rayclock {

/// The place of a context: a unit, or the memory, on whose data the context waits. The memory is a separate
/// place, distinct from the cache that requested the data.
constexpr std::size_t memory_place = pipeline_units;
constexpr std::size_t ray_places = pipeline_units + 1;
const char* place_name(std::size_t place);

/// The caches that serve rays: node_cache, prim_cache, surf_cache or, on a chip for streams, stream, and
/// tex_cache.
constexpr std::size_t ray_caches = 4;
constexpr std::array<Unit, ray_caches> cache_units{Unit::node_cache, Unit::prim_cache, Unit::surf_cache,
                                                   Unit::tex_cache};
/// Returns how many of them a chip has.
inline std::size_t ray_caches_of(const Config& c) { return c.has_textures() ? 4 : c.shading ? 3 : 2; }

/// The costs of one pixel, or of one ray of a stream. The counts of all pixels sum to those of the frame.
struct PixelCost {
    std::uint32_t rays = 0;
    std::uint32_t visits = 0;   ///< nodes fetched and tested
    std::uint32_t tests = 0;    ///< primitives fetched and tested
    std::uint32_t misses = 0;   ///< look-ups of all caches that found no line, including merged ones
    std::uint32_t bytes = 0;    ///< requested from memory on behalf of this pixel
    std::uint32_t first = 0;    ///< cycle of the frame in which the pixel entered the pipeline
    std::uint32_t cycles = 0;   ///< from `first` until the pixel left the pipeline
};

/// The costs of all rays with the same purpose.
struct PurposeCost {
    std::uint64_t rays = 0, visits = 0, tests = 0, bytes = 0;
    /// [cache]: look-ups that hit, that requested a line, and that joined a request in flight.
    std::array<std::uint64_t, ray_caches> hits{}, misses{}, merges{};
    /// Cycles of contexts by place. Shading after a ray counts as that ray's cycles.
    std::array<std::uint64_t, ray_places> places{};
    std::uint64_t cycles() const;
    std::uint64_t all_misses() const;
};

/// A window of time.
struct Window {
    std::uint64_t first = 0, cycles = 0;   ///< cycles of the frame
    Accounts accounts;
    MemoryStats memory;
    std::uint64_t contexts = 0;   ///< contexts in use, summed over the cycles
};

/// The time that a pipeline worked on a tile.
struct TileSpan {
    std::uint32_t x = 0, y = 0;   ///< coordinates in tiles
    int pipeline = 0;
    std::uint64_t first = 0, last = 0;   ///< cycles in which the first pixel started and the last pixel ended
};

/// All costs of one frame.
struct FrameCosts {
    std::uint32_t width = 0, height = 0;
    std::uint64_t cycles = 0;
    bool partial = false;                    ///< interrupted
    std::vector<PixelCost> pixels;           ///< [y * width + x]; of a stream, [ray]
    std::array<PurposeCost, 4> purposes{};   ///< by RayPurpose
    std::vector<Window> windows;
    std::vector<TileSpan> tiles;   ///< in the order of assignment
    /// [link]: cycles in which a valid request was refused, and transfers; summed over the pipelines.
    std::array<std::uint64_t, link_count> refused{}, moved{};
    Accounts accounts;
    MemoryStats memory;

    /// Sums over all pixels.
    struct Sums {
        std::uint64_t rays = 0, visits = 0, tests = 0, misses = 0, bytes = 0, cycles = 0;
    };
    Sums total() const;
    /// Returns the smallest rectangle with all pixels that were in a pipeline in one of these cycles, without
    /// `last`. Its size is 0x0 if there was none.
    PixelRect pixels_in(std::uint64_t first, std::uint64_t last) const;
};

}   // namespace rayclock

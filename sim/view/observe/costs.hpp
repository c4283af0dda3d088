#pragma once
// What a frame cost on the model, by pixel, by what rays are for, by unit and over time. All of it is counted
// transfer by transfer, so it closes with the accounts of the machine.
#include <array>
#include <cstdint>
#include <vector>

#include "model/core/links.hpp"
#include "model/mem/memory.hpp"
#include "model/scene/whitted.hpp"

namespace rayclock {

/// Where a context is: in a unit, or waiting for memory on behalf of a cache, which is apart from the cache.
constexpr std::size_t memory_place = pipeline_units;
constexpr std::size_t ray_places = pipeline_units + 1;
const char* place_name(std::size_t place);

constexpr std::size_t ray_caches = 3;   ///< node_cache, prim_cache, surf_cache
constexpr std::array<Unit, ray_caches> cache_units{Unit::node_cache, Unit::prim_cache, Unit::surf_cache};

/// One pixel. The counts of all pixels sum to those of the frame.
struct PixelCost {
    std::uint32_t rays = 0;
    std::uint32_t visits = 0;   ///< nodes fetched and tested
    std::uint32_t tests = 0;    ///< primitives, likewise
    std::uint32_t misses = 0;   ///< look-ups of all caches that found no line, merged ones included
    std::uint32_t bytes = 0;    ///< asked of the memory because of this pixel
    std::uint32_t first = 0;    ///< cycle of the frame in which the pixel entered the pipeline
    std::uint32_t cycles = 0;   ///< from there until it left
};

/// All rays that are for the same.
struct PurposeCost {
    std::uint64_t rays = 0, visits = 0, tests = 0, bytes = 0;
    /// [cache]: look-ups that were hits, that asked for a line, that joined a line on its way.
    std::array<std::uint64_t, ray_caches> hits{}, misses{}, merges{};
    /// Cycles of contexts by where they were. Those in shade after a ray count as that ray's.
    std::array<std::uint64_t, ray_places> places{};
    std::uint64_t cycles() const;
    std::uint64_t all_misses() const;
};

/// A stretch of time.
struct Window {
    std::uint64_t first = 0, cycles = 0;   ///< of the frame
    Accounts accounts;
    MemoryStats memory;
    std::uint64_t contexts = 0;   ///< in use, summed over the cycles
};

/// A tile as a pipeline worked on it.
struct TileSpan {
    std::uint32_t x = 0, y = 0;   ///< tile
    int pipeline = 0;
    std::uint64_t first = 0, last = 0;   ///< cycles of its first pixel's start and its last pixel's end
};

struct FrameCosts {
    std::uint32_t width = 0, height = 0;
    std::uint64_t cycles = 0;
    bool partial = false;                    ///< interrupted
    std::vector<PixelCost> pixels;           ///< [y * width + x]
    std::array<PurposeCost, 4> purposes{};   ///< by RayPurpose
    std::vector<Window> windows;
    std::vector<TileSpan> tiles;   ///< in the order in which they were given out
    /// [link]: cycles in which something was offered and not accepted, and transfers; of all pipelines.
    std::array<std::uint64_t, link_count> refused{}, moved{};
    Accounts accounts;
    MemoryStats memory;

    /// Over all pixels.
    struct Sums {
        std::uint64_t rays = 0, visits = 0, tests = 0, misses = 0, bytes = 0, cycles = 0;
    };
    Sums total() const;
};

}   // namespace rayclock

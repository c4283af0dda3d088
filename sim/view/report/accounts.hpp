#pragma once
#include <string>
#include <vector>

#include "sim/run/engine/engine.hpp"

namespace rayclock {

/// What a unit did in every cycle of a frame, summed over the pipelines: busy + starved + stalled = instances
/// * cycles.
struct UnitAccount {
    struct Part {
        std::string cause;
        std::uint64_t cycles = 0;
    };
    std::string unit;
    int instances = 1;
    std::uint64_t count = 0;   ///< pieces of work done
    std::uint64_t busy = 0, starved = 0, stalled = 0;
    std::vector<Part> busy_by, starved_by, stalled_by;
};
std::vector<UnitAccount> unit_accounts(const Config& config, const FrameRun& run);

/// Look-ups of a cache.
struct CacheAccount {
    std::uint64_t accesses = 0, hits = 0;
    std::uint64_t merged = 0;   ///< of the others: the line was on its way already
    double hit_rate() const { return accesses ? double(hits) / double(accesses) : 0; }
};
CacheAccount cache_account(const FrameRun& run, Unit cache);

/// The least cycles that the machine can need for a frame's work: a node, a triangle and a pass of shade a
/// cycle in each pipeline, or one every box_interval(), tri_interval and shade_interval cycles, a ray every
/// raygen_interval cycles, and what the
/// memory's data bus can carry.
struct Bound {
    double nodes = 0, triangles = 0, passes = 0, rays = 0, memory = 0;   ///< cycles
    std::string unit;     ///< "trav", "tri", "shade", "raygen" or "memory": the largest of the five
    double cycles = 0;    ///< of it
    double reached = 0;   ///< bound / cycles of the frame
};
Bound bound_of(const Config& config, int khz, const FrameRun& run);
/// The memory's peak, bytes per second; 64 bytes every mem_interval cycles for the ideal one.
double peak_bytes_per_second(const Config& config, int khz);

/// What limits a frame, in words.
std::string bottleneck(const Config& config, int khz, const FrameRun& run);

inline std::uint64_t bytes_read(const FrameTiming& run) { return run.memory.reads * 64; }
/// Frames, what the host does before each included.
inline double per_second(const FrameTiming& run, int khz) {
    return run.cycles ? khz * 1e3 / double(run.all_cycles()) : 0;
}

}   // namespace rayclock

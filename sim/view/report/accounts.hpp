#pragma once
// Accounts of a frame: how units spend their cycles, cache hit rates, lower bounds and the bottleneck.
#include <string>
#include <vector>

#include "sim/run/frame/frame.hpp"

namespace rayclock {

/// The cycles of a unit in a frame, summed over the pipelines: busy + starved + stalled = instances * cycles.
struct UnitAccount {
    struct Part {
        std::string cause;
        std::uint64_t cycles = 0;
    };
    std::string unit;
    int instances = 1;
    std::uint64_t count = 0;   ///< completed pieces of work
    std::uint64_t busy = 0, starved = 0, stalled = 0;
    std::vector<Part> busy_by, starved_by, stalled_by;
};
std::vector<UnitAccount> unit_accounts(const Config& config, const FrameResult& run);

/// The look-ups of a cache.
struct CacheAccount {
    std::uint64_t accesses = 0, hits = 0;
    std::uint64_t merged = 0;   ///< look-ups that missed while the line was already in flight
    double hit_rate() const { return accesses ? double(hits) / double(accesses) : 0; }
};
CacheAccount cache_account(const FrameResult& run, Unit cache);

/// A lower bound for the cycles of a frame's work, and the unit that sets it. A pipeline handles one node
/// every box_interval() cycles and one triangle every tri_interval cycles. It handles one pass of shade every
/// shade_interval cycles and one ray every raygen_interval cycles. The memory is limited by the bandwidth of
/// its data bus.
struct Bound {
    double nodes = 0, triangles = 0, passes = 0, rays = 0, memory = 0;   ///< cycles
    std::string unit;     ///< the unit with the largest bound: "trav", "tri", "shade", "raygen" or "memory"
    double cycles = 0;    ///< the largest of the five bounds
    double reached = 0;   ///< bound / cycles of the frame
};
Bound bound_of(const Config& config, int khz, const FrameResult& run);
/// Returns the memory's peak bandwidth in bytes per second. The ideal memory has 64 bytes every mem_interval
/// cycles.
double peak_bytes_per_second(const Config& config, int khz);

/// Returns a sentence that names the limit of a frame and the losses of the limiting unit.
std::string bottleneck(const Config& config, int khz, const FrameResult& run);

inline std::uint64_t bytes_read(const FrameTiming& run) { return run.memory.reads * 64; }
/// Returns frames per second, including the host's work before each frame.
inline double per_second(const FrameTiming& run, int khz) {
    return run.cycles ? khz * 1e3 / double(run.all_cycles()) : 0;
}

}   // namespace rayclock

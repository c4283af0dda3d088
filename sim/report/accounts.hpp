#pragma once
#include <string>
#include <vector>

#include "sim/engine/engine.hpp"

namespace rayclock {

/// What a unit did in every cycle of a run: took in work, had none, or had some and could not take it. Sums to the cycles.
struct UnitAccount {
    std::string unit;
    std::uint64_t count = 0;     ///< pieces of work taken in
    std::uint64_t busy = 0, starved = 0, stalled = 0;
    std::string cause;           ///< what a stall waits for
};
std::vector<UnitAccount> unit_accounts(const ChannelCounts& counts, std::uint64_t cycles);

/// The least cycles that one pipeline can need for this work: one node and one triangle per cycle.
struct Bound {
    std::string unit;            ///< "trav" (node visits) or "tri" (triangle tests)
    std::uint64_t cycles = 0;
    double reached = 0;          ///< bound / cycles of the run
};
Bound bound_of(const FrameRun& run);

inline std::uint64_t node_steps(const FrameRun& run) { return run.counts[index(Channel::node_req)].moved; }
inline std::uint64_t triangle_tests(const FrameRun& run) { return run.counts[index(Channel::tri_req)].moved; }
/// Bytes read from memory: 64 a node, 32 a triangle.
inline std::uint64_t bytes_read(const FrameRun& run) {
    return node_steps(run) * 64 + run.counts[index(Channel::prim_req)].moved * 32;
}

} // namespace rayclock

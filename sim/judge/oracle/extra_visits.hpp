#pragma once
// Measures the cost of conservative boxes. It traces a frame's rays through the memory image three times. The
// first pass uses the machine's box test, the second an exact test of the same quantised boxes. The third
// uses an exact test of the boxes before quantisation.
#include <cstdint>

#include <utility>

#include "model/engine/bvh/box.hpp"
#include "model/layout/memory_image.hpp"
#include "sim/judge/oracle/overlap.hpp"

namespace rayclock {

/// The work of one traversal.
struct WalkWork {
    std::uint64_t visits = 0;      ///< visited nodes, the root included
    std::uint64_t triangles = 0;   ///< tested triangles
    std::uint64_t taken = 0;       ///< child boxes that the test accepted
};

/// The counts of all rays.
struct ExtraVisits {
    std::uint64_t rays = 0;
    std::uint64_t boxes = 0;         ///< child boxes that the machine tested
    std::uint64_t boxes_extra = 0;   ///< accepted ones whose quantised box the ray does not meet
    std::uint64_t boxes_lost = 0;    ///< rejected ones whose quantised box the ray meets: a fault
    std::uint64_t t_late = 0;        ///< accepted ones with a t_near beyond the true entry: a fault
    std::uint64_t other_hits = 0;    ///< rays whose closest hit differs between the traversals: a fault
    WalkWork machine;                ///< box() with the machine's rounded distances
    WalkWork exact;                  ///< exact entries and hits with quantised boxes
    WalkWork real;   ///< exact entries and hits with boxes before quantisation (Node::lo and hi)

    /// rounding() returns the visits that the machine's rounding adds, as a fraction of those with exact
    /// tests. quantisation() returns those that quantised boxes add.
    double rounding() const {
        return exact.visits > 0 ? double(machine.visits) / double(exact.visits) - 1 : 0;
    }
    double quantisation() const {
        return real.visits > 0 ? double(exact.visits) / double(real.visits) - 1 : 0;
    }
};

/// Returns the corners of a child's quantised box, from the node's bytes.
std::pair<oracle::LatticeVec, oracle::LatticeVec> quantised_box(const WideNode& node, std::size_t child);

/// Traces every `every`-th pixel of the frame, counted row by row, on all cores. All traversals use TreeWalk
/// with the distances of their own test.
ExtraVisits extra_visits(const MemoryImage& image, const Frame& frame, const Config& config, int every = 1);

}   // namespace rayclock

#pragma once
// What conservatism costs: a frame's rays walked through the memory image three times, with the box test of
// the machine, with an exact one of the same quantised boxes, and with an exact one of the boxes before they
// were quantised.
#include <cstdint>

#include <utility>

#include "model/layout/memory_image.hpp"
#include "model/engine/bvh/box.hpp"
#include "sim/judge/oracle/overlap.hpp"

namespace rayclock {

/// One way of walking.
struct WalkWork {
    std::uint64_t visits = 0;      ///< nodes, the root too
    std::uint64_t triangles = 0;   ///< tested
    std::uint64_t taken = 0;       ///< child boxes that the test took
};

struct ExtraVisits {
    std::uint64_t rays = 0;
    std::uint64_t boxes = 0;         ///< child boxes that the machine tested
    std::uint64_t boxes_extra = 0;   ///< of these taken, although the ray does not meet the quantised box
    std::uint64_t boxes_lost = 0;    ///< of these not taken, although it does: a fault
    std::uint64_t t_late = 0;        ///< of those taken, with a t_near beyond the entry: a fault
    std::uint64_t other_hits = 0;    ///< rays whose closest hit differs between the walks: a fault
    WalkWork machine;                ///< box(), distances rounded as the machine has them
    WalkWork exact;                  ///< exact entries and hits, quantised boxes
    WalkWork real;                   ///< exact entries and hits, boxes as they were before Node::lo and hi

    /// Visits that the machine's rounding adds to those of exact boxes, in parts of these; and those that
    /// quantisation adds.
    double rounding() const {
        return exact.visits > 0 ? double(machine.visits) / double(exact.visits) - 1 : 0;
    }
    double quantisation() const {
        return real.visits > 0 ? double(exact.visits) / double(real.visits) - 1 : 0;
    }
};

/// A child's quantised box, from the bytes: its corners.
std::pair<oracle::LatticeVec, oracle::LatticeVec> quantised_box(const WideNode& node, std::size_t child);

/// Every `every`-th pixel of the frame, counted row by row; on all cores. All walks are TreeWalk's, with the
/// distances of each test.
ExtraVisits extra_visits(const MemoryImage& image, const Frame& frame, const Config& config, int every = 1);

}   // namespace rayclock

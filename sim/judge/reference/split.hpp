#pragma once
// Dividing a set of boxes in two by the surface area heuristic over bins of centroids.
#include <algorithm>
#include <limits>
#include <span>

#include "sim/judge/reference/hierarchy.hpp"

namespace rayclock {

/// A box that grows; empty at first.
struct RefExtent {
    float lo[3] = {inf, inf, inf};
    float hi[3] = {-inf, -inf, -inf};
    static constexpr float inf = std::numeric_limits<float>::infinity();

    void add(const float (&l)[3], const float (&h)[3]) {
        for (int a = 0; a < 3; ++a) {
            lo[a] = std::min(lo[a], l[a]);
            hi[a] = std::max(hi[a], h[a]);
        }
    }
    /// Returns half of the surface; the heuristic needs only ratios.
    float area() const {
        const float x = hi[0] - lo[0], y = hi[1] - lo[1], z = hi[2] - lo[2];
        return x < 0 ? 0 : x * y + y * z + z * x;
    }
};

/// The bounds of the boxes themselves and of their doubled centroids (lo + hi).
struct RefSummary {
    RefExtent bounds, centroids;
};
RefSummary summarise(std::span<const RefBox> boxes);

/// Returns the cost of testing the primitives of a leaf, in units of one binary traversal step.
float leaf_cost(std::size_t primitives);

/// Reorders `boxes` so that the first n go left and the rest right, and returns n, 0 < n < boxes.size().
/// Returns 0 if a leaf costs no more and is small enough. Needs at least two boxes.
std::size_t split_by_area(std::span<RefBox> boxes, const RefSummary& summary);

/// Does the same by the median along the widest axis of centroids. It halves exactly, so the depth stays
/// logarithmic.
std::size_t split_by_count(std::span<RefBox> boxes, const RefSummary& summary);

}   // namespace rayclock

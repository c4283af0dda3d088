#pragma once
// Where to cut a cell across an axis, by the surface area heuristic.
#include "model/engine/kd/cell.hpp"

namespace rayclock::kd {

constexpr double cut_cost = 8, test_cost = 20, empty_factor = 0.9;

/// A cut, what it costs, and how many items lie on each of its sides.
struct Split : Cut {
    double cost = 0;
    std::size_t below = 0, above = 0;
    double lower = 0, upper = 0;   ///< of planes in any direction: with which probabilities sides are met
};

/// The cost of a cut, if a ray that meets the cell meets its sides with these probabilities. Up to 16 items
/// cost a test each. More than that will be cut again, so they cost less than as many tests: 16 (n /
/// 16)^(13/16).
double cost_of(double lower, std::size_t below, double upper, std::size_t above);

/// Tries planes across the three axes at both ends of all items, and keeps what is cheaper than `best`: O(n).
/// No more than `most` items lie on both sides together.
void try_axes(const Items& items, const LatticeBox& cell, std::size_t most, Split& best);

}   // namespace rayclock::kd

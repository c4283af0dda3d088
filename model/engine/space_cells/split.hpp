#pragma once
// Chooses planes across the axes of a cell by the surface area heuristic.
#include "model/engine/space_cells/cell.hpp"

namespace rayclock::space_cells {

constexpr double cut_cost = 8, test_cost = 20, empty_factor = 0.9;

/// A cut, its cost, and the number of items on each side.
struct Split : Cut {
    double cost = 0;
    std::size_t below = 0, above = 0;
    double lower = 0, upper = 0;   ///< for planes in any direction: probabilities of meeting the sides
};

/// Returns the cost of a cut. `lower` and `upper` are the probabilities that a ray that meets the cell meets
/// this side. Up to 16 items cost a test each. More items will be cut again, so they cost fewer tests:
/// 16 (n / 16)^(13/16).
double cost_of(double lower, std::size_t below, double upper, std::size_t above);

/// Tries planes across the three axes at both ends of all items, and replaces `best` by any cheaper one, in
/// O(n) time after sorting by digits. Skips a plane with more than `most` items on both sides together.
void try_axes(const Items& items, const LatticeBox& cell, std::size_t most, Split& best);

}   // namespace rayclock::space_cells

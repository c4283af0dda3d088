#pragma once
// Where to cut a cell across an axis, by the surface area heuristic.
#include "model/accel/kd/cell.hpp"

namespace rayclock::kd {

constexpr double visit_cost = 15, test_cost = 20, empty_factor = 0.8;

/// A cut, what it costs, and how many items lie on each of its sides.
struct Split : Cut {
    double cost = 0;
    std::size_t below = 0, above = 0;
};

/// The cost of a cut, if a ray that meets the cell meets its sides with these probabilities.
double cost_of(double lower, std::size_t below, double upper, std::size_t above);

/// Tries planes across the three axes, and keeps what is cheaper than `best`. Up to 512 items: both ends of
/// all of them; beyond that 64 planes of each axis, and the ends of all. No more than `most` items lie on
/// both sides together.
void try_axes(const Items& items, const LatticeBox& cell, std::size_t most, Split& best);

}   // namespace rayclock::kd

#pragma once
// The Pareto front of speed, error and cost over a sweep's points, and its knee.
#include <optional>
#include <string>
#include <vector>

#include "sim/explore/sweep/cost.hpp"
#include "sim/explore/sweep/evaluate_points.hpp"

namespace rayclock::sweep {

/// One point's figures, with signs so that less is better in each; empty if one is missing.
using Figures = std::optional<std::vector<double>>;

/// Returns for each point whether it is on the front. Such a point has figures, and no other point is at
/// least as good in all of them and better in one. So equal points are all on the front, or none is.
std::vector<bool> front(const std::vector<Figures>& points);

/// The knee of a front in a plane. Each figure is normalised to its range over the front, so the ends lie at
/// (0, 1) and (1, 0). The knee is the point farthest below the chord between them; among equals, the first.
/// Nothing if the front has fewer than three distinct points, or if none lies below the chord.
struct PlaneKnee {
    std::size_t point = 0;
    double distance = 0;   ///< from the chord, 0 to sqrt(1/2)
};
std::optional<PlaneKnee> knee_of(const std::vector<Figures>& points);

/// A figure that the front compares.
struct Measure {
    std::string key;   ///< column of the table
    double sign = 1;   ///< -1 if more is better
    std::optional<double> (*value)(const Result&);
};

/// A front over a sweep. Speed is fps, film_fps for several frames, and mrays_per_s for a stream of rays.
/// Error is pixels_other_primitive. Cost is multipliers, memory_bytes if no point has multipliers, or a
/// figure of the chip. If some points have this figure, the others have no hardware and are not on the front.
struct Front {
    std::vector<Measure> measures;   ///< error, cost, speed
    bool has_error = true;           ///< false for a stream of rays: the error is then 0 for every point
    std::string why;                 ///< the reason for an automatic choice of cost; else empty
    std::vector<bool> pareto;        ///< [point]: on the front of all three measures
    /// The knee of the first pair of measures whose own front has one. The pairs are error and cost, error
    /// and speed, cost and speed.
    std::optional<PlaneKnee> knee;
    std::array<std::size_t, 2> plane{};   ///< the two measures of the knee
};
Front front_of(const std::vector<Result>& results, Cost cost = Cost::multipliers);

/// Returns the figures of all points in the given measures.
std::vector<Figures> figures_in(const std::vector<Result>& results, const std::vector<Measure>& measures);

}   // namespace rayclock::sweep

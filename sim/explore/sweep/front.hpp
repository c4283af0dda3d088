#pragma once
// Which points are worth having: the Pareto front of speed, error and cost, and its knee.
#include <optional>
#include <string>
#include <vector>

#include "sim/explore/sweep/cost.hpp"
#include "sim/explore/sweep/run.hpp"

namespace rayclock::sweep {

/// One point's figures, turned so that less is better in each; nothing if the point has not all of them.
using Figures = std::optional<std::vector<double>>;

/// Whether each point is on the front: it has figures, and no other point is as good in all of them and
/// better in one. So equal points are all on it, or none is.
std::vector<bool> front(const std::vector<Figures>& points);

/// The knee of a front in a plane: both figures are divided by their range over the front, so that its ends
/// lie at (0, 1) and (1, 0), and the point is taken that lies farthest below the chord between them; of equal
/// ones the first. Nothing if fewer than three different points are on the front, or none lies below the
/// chord.
struct PlaneKnee {
    std::size_t point = 0;
    double distance = 0;   ///< from the chord, 0 to sqrt(1/2)
};
std::optional<PlaneKnee> knee_of(const std::vector<Figures>& points);

/// A figure that the front weighs.
struct Measure {
    std::string key;   ///< column
    double sign = 1;   ///< -1: more is better
    std::optional<double> (*value)(const Result&);
};

/// A front over a sweep. Speed is fps, or film_fps of more frames than one; error is pixels_other_primitive,
/// cost is what was chosen: multipliers, or memory_bytes if no point has multipliers; or a figure of the
/// chip. If some points have that figure, those without are no hardware and not on the front.
struct Front {
    std::vector<Measure> measures;   ///< error, cost, speed
    std::string why;                 ///< the cost is this one, if nobody chose it; else empty
    std::vector<bool> pareto;        ///< [point], in all three measures
    /// The knee is that of the first pair of measures whose own front has one: error and cost, error and
    /// speed, cost and speed.
    std::optional<PlaneKnee> knee;
    std::array<std::size_t, 2> plane{};   ///< the pair's measures
};
Front front_of(const std::vector<Result>& results, Cost cost = Cost::multipliers);

/// Figures of all points in some measures.
std::vector<Figures> figures_in(const std::vector<Result>& results, const std::vector<Measure>& measures);

}   // namespace rayclock::sweep

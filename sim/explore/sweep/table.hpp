#pragma once
// A sweep's figures as table, CSV and JSON.
#include "sim/view/report/limits.hpp"
#include "sim/explore/sweep/front.hpp"

namespace rayclock::sweep {

/// One point's cells after the axes; a figure that is missing is empty. What was there from the beginning
/// stays where it is.
std::vector<std::string> cells(const Result& result, bool pareto, bool knee);

/// Of the whole table: axes, then figures.
std::vector<std::string> column_names(const std::vector<Axis>& axes);
/// True for a column whose cells are words, as "memory", and not numbers.
bool has_words(const std::vector<Axis>& axes, const std::string& column);
/// A column of numbers; a cell that is empty has none.
std::vector<std::optional<double>> column_values(const std::vector<Axis>& axes,
                                                 const std::vector<Result>& results, const Front& front,
                                                 const std::string& column);

std::string csv(const std::vector<Axis>& axes, const std::vector<Result>& results, const Front& front);
std::string text(const std::vector<Axis>& axes, const Outcome& outcome, const Front& front);
nlohmann::ordered_json points_json(const std::vector<Axis>& axes, const std::vector<Result>& results,
                                   const Front& front);
nlohmann::ordered_json knee_json(const std::vector<Axis>& axes, const std::vector<Result>& results,
                                 const Front& front);

/// What is said of the point that is farthest from the reference, beyond the limits, and how many points are:
/// far_from_reference(). Empty if none is.
std::string far_points(const std::vector<Axis>& axes, const std::vector<Result>& results,
                       const Limits& limits);
/// The limits, and for each point whether it is beyond one; null of a point without a picture.
nlohmann::ordered_json far_json(const std::vector<Axis>& axes, const std::vector<Result>& results,
                                const Limits& limits);

/// A value of an axis: a number if it is one, else the word.
nlohmann::ordered_json value_json(const std::string& value);

/// "coord_bits 16, dir_bits 18".
std::string name_of(const std::vector<Axis>& axes, const Result& result);

}   // namespace rayclock::sweep

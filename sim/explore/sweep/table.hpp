#pragma once
// The figures of a sweep as table, CSV and JSON.
#include "sim/explore/sweep/front.hpp"
#include "sim/view/report/limits.hpp"

namespace rayclock::sweep {

/// Returns the cells of a point after its axes; missing figures are empty. New columns are only ever added
/// after the existing ones.
std::vector<std::string> table_cells(const Result& result, bool pareto, bool knee);

/// Returns the column names of the whole table: axes, then figures.
std::vector<std::string> column_names(const std::vector<Axis>& axes);
/// Returns true for a column whose cells are words such as "memory", not numbers.
bool has_words(const std::vector<Axis>& axes, const std::string& column);
/// Returns true if a column compares pictures, so that it is empty for a stream of rays and for a sample.
bool is_of_picture(const std::string& column);
/// Returns a column's numbers; empty cells have none.
std::vector<std::optional<double>> column_values(const std::vector<Axis>& axes,
                                                 const std::vector<Result>& results, const Front& front,
                                                 const std::string& column);

std::string csv(const std::vector<Axis>& axes, const std::vector<Result>& results, const Front& front);
std::string text(const std::vector<Axis>& axes, const Evaluation& outcome, const Front& front);
nlohmann::ordered_json points_json(const std::vector<Axis>& axes, const std::vector<Result>& results,
                                   const Front& front);
nlohmann::ordered_json knee_json(const std::vector<Axis>& axes, const std::vector<Result>& results,
                                 const Front& front);

/// Returns the sentence of far_from_reference() for the worst point beyond the limits, with the number of
/// such points. Empty if there is none.
std::string far_points(const std::vector<Axis>& axes, const std::vector<Result>& results,
                       const Limits& limits);
/// Returns the limits, and for each point whether it exceeds one; null for a point without a picture.
nlohmann::ordered_json far_json(const std::vector<Axis>& axes, const std::vector<Result>& results,
                                const Limits& limits);

/// Returns a value of an axis: a number if it is one, else the word.
nlohmann::ordered_json value_json(const std::string& value);

/// Returns a point's values: "coord_bits 16, dir_bits 18".
std::string name_of(const std::vector<Axis>& axes, const Result& result);

}   // namespace rayclock::sweep

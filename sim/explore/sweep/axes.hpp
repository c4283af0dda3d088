#pragma once
// The input of a sweep: axes, and the grid of points that they span.
#include <string>
#include <vector>

#include "model/core/config.hpp"

namespace rayclock::sweep {

constexpr std::size_t max_points = 10000;

/// An axis: one parameter or several linked ones, and its values.
struct Axis {
    std::string key;                   ///< a configuration parameter or clock; linked ones as a/b
    std::vector<std::string> values;   ///< values of linked parameters as 16/32
};

/// Parses key=1,2,4 or key=12:20:2 (from, to, step); a/b=1/8,2/4 changes several parameters together. Throws
/// UserError.
Axis parse_axis(const std::string& text);

/// A point of the grid.
struct Point {
    std::vector<std::string> values;   ///< [axis]
    Config config;
    int khz = 0;
    std::string refused;   ///< the error message if these values are not a legal combination
};

/// Returns the grid, the last axis fastest. If `base` shades, origin_bits follows the other widths unless it
/// is an axis. `clock` parses a value of the axis `clock` to kHz. An illegal combination becomes a refused
/// point. Throws UserError if a value is legal in no combination.
std::vector<Point> make_points(const std::vector<Axis>& axes, const Config& base, int khz,
                               int (*clock)(const std::string&));

/// Returns everything that determines a frame's rays, as text. Configurations with equal text share a trace.
std::string trace_format(const Config& config);

/// The part of a sweep that one machine computes: 1 to `of`. Part 1 of 1 is the whole sweep.
struct Shard {
    int part = 1, of = 1;
    bool is_whole() const { return of == 1; }
};

/// Parses "2/4". Throws UserError.
Shard parse_shard(const std::string& text);
/// Formats a shard as "2/4".
std::string name_of(const Shard& shard);

}   // namespace rayclock::sweep

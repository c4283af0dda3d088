#pragma once
// What a sweep runs over: axes, and the grid of points that they span.
#include <string>
#include <vector>

#include "model/core/config.hpp"

namespace rayclock::sweep {

constexpr std::size_t most_points = 10000;

struct Axis {
    std::string key;                   ///< a parameter of the configuration, or clock; linked ones as a/b
    std::vector<std::string> values;   ///< of linked ones as 16/32
};

/// key=1,2,4 or key=12:20:2 (from, to, step); a/b=1/8,2/4 changes several together. Throws UserError.
Axis parse_axis(const std::string& text);

struct Point {
    std::vector<std::string> values;   ///< [axis]
    Config config;
    int khz = 0;
    std::string refused;   ///< the sentence, if these values do not go together
};

/// The grid, the last axis fastest. If `base` shades, origin_bits follows the other widths unless it is an
/// axis. `clock` reads a value of the axis `clock`, in kHz. A combination that is
/// no legal configuration is a refused point; a value that is legal in no combination is a UserError.
std::vector<Point> make_points(const std::vector<Axis>& axes, const Config& base, int khz,
                               int (*clock)(const std::string&));

/// What decides a frame's rays, as text: configurations that agree here share one trace.
std::string trace_format(const Config& config);

/// The part of a sweep that one machine works out: 1 to `of`. Part 1 of 1 is the whole.
struct Shard {
    int part = 1, of = 1;
    bool is_whole() const { return of == 1; }
};

/// "2/4". Throws UserError.
Shard parse_shard(const std::string& text);
/// "2/4".
std::string name_of(const Shard& shard);

}   // namespace rayclock::sweep

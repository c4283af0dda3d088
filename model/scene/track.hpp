// A value over time. scenes/README.md has the form in files.
#pragma once
#include <vector>

namespace rayclock {

/// What a value does between two keys. `cubic` is glTF's CUBICSPLINE: each key has three values, the tangent
/// that comes in, the value, and the tangent that goes out.
enum class Between { linear, step, cubic };

/// A value over time: keys in rising order of their times, seconds. Before the first and after the last it
/// stays as it is there. Rotations that are linear are slerped, the shorter way. An empty track says nothing.
template <class Value> struct Track {
    std::vector<double> times;
    std::vector<Value> values;   ///< one for each time; of a cubic one three
    Between between = Between::linear;

    bool empty() const { return times.empty(); }
    /// The value at a time; `otherwise` if the track is empty.
    Value at(double time, const Value& otherwise) const;
};

}   // namespace rayclock

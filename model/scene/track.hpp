#pragma once
// A value over time. scenes/README.md has its form in files.
#include <vector>

namespace rayclock {

/// Interpolation between two keys. `cubic` is glTF's CUBICSPLINE: each key has three values, the incoming
/// tangent, the value, and the outgoing tangent.
enum class Interpolation { linear, step, cubic };

/// A value over time: keys in rising order of their times, in seconds. Before the first key and after the
/// last one the value is constant. Linear rotations are slerped, the shorter way.
template <class Value> struct Track {
    std::vector<double> times;
    std::vector<Value> values;   ///< one per time; three per time if cubic
    Interpolation interpolation = Interpolation::linear;

    bool empty() const { return times.empty(); }
    /// Returns the value at a time; `otherwise` if the track is empty.
    Value at(double time, const Value& otherwise) const;
};

}   // namespace rayclock

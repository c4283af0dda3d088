#pragma once
// Scales and ticks of diagrams.
#include <string>
#include <vector>

namespace rayclock::plot {

/// The scale of one side of a panel, linear or logarithmic.
class Scale {
public:
    /// Covers the values with a margin. A logarithmic scale covers the values above 0, and places 0 below
    /// them.
    Scale(const std::vector<double>& values, bool logarithmic);

    /// Returns the position of a value: 0 at one end, 1 at the other.
    double place(double value) const;

    struct Tick {
        double value = 0;
        std::string label;
    };
    const std::vector<Tick>& ticks() const { return ticks_; }

private:
    void make_linear(double lo, double hi);
    void make_logarithmic(double lo, double hi, bool zero);

    bool logarithmic_;
    double lo_ = 0, hi_ = 1;   ///< ends of the scale, or their logarithms
    double zero_ = 0;          ///< position of value 0 in the same units
    std::vector<Tick> ticks_;
};

}   // namespace rayclock::plot

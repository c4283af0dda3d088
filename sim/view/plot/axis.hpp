#pragma once
#include <string>
#include <vector>

namespace rayclock::plot {

/// Values along one side of a panel, linear or logarithmic.
class Scale {
public:
    /// Covers the values with some room around. Logarithmic: the values above 0 do, and 0 gets a place of its
    /// own below them.
    Scale(const std::vector<double>& values, bool logarithmic);

    /// 0 at one end, 1 at the other.
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
    double lo_ = 0, hi_ = 1;   ///< ends; logarithms if logarithmic
    double zero_ = 0;          ///< where 0 lies, likewise
    std::vector<Tick> ticks_;
};

}   // namespace rayclock::plot

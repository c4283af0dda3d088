// Chooses ranges and ticks of linear and logarithmic axes.
#include "sim/view/plot/axis.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace rayclock::plot {

namespace {

/// Formats 1,250,000 as 1.25M, 0.002 unchanged.
std::string label_of(double value) {
    if (std::abs(value) >= 1e6) return fmt::format("{:g}M", value / 1e6);
    if (std::abs(value) >= 1e4) return fmt::format("{:g}k", value / 1e3);
    return fmt::format("{:g}", std::abs(value) < 1e-12 ? 0 : value);
}

constexpr double room = 0.06;   // margin beyond the outermost values, as a share of the side

}   // namespace

Scale::Scale(const std::vector<double>& values, bool logarithmic) : logarithmic_(logarithmic) {
    double lo = 1e300, hi = -1e300;
    bool zero = false;
    for (const double v : values) {
        if (logarithmic && v <= 0) {
            zero = true;
            continue;
        }
        lo = std::min(lo, v);
        hi = std::max(hi, v);
    }
    if (hi < lo) lo = hi = 1;
    if (logarithmic)
        make_logarithmic(std::log10(lo), std::log10(hi), zero);
    else
        make_linear(lo, hi);
}

void Scale::make_linear(double lo, double hi) {
    // The least half width keeps nearly equal values close together.
    const double middle = (lo + hi) / 2, least = std::max(std::abs(middle) * 0.002, 1e-9);
    const double half = std::max((hi - lo) / 2, least) / (1 - 2 * room);
    lo_ = middle - half;
    hi_ = middle + half;
    const double rough = (hi_ - lo_) / 6, decade = std::pow(10, std::floor(std::log10(rough)));
    const double step = decade * (rough <= decade * 1.5 ? 1
                                  : rough <= decade * 3 ? 2
                                  : rough <= decade * 7 ? 5
                                                        : 10);
    for (double at = std::ceil(lo_ / step); at * step <= hi_; ++at)
        ticks_.push_back({at * step, label_of(at * step)});
}

void Scale::make_logarithmic(double lo, double hi, bool zero) {
    const double reach = std::max(hi - lo, 0.3) / (1 - 2 * room), middle = (lo + hi) / 2;
    lo_ = middle - reach / 2;
    hi_ = middle + reach / 2;
    const bool finer = reach < 2.5;
    for (int decade = int(std::floor(lo_)); decade <= int(std::ceil(hi_)); ++decade)
        for (const int digit : {1, 2, 5}) {
            const double value = digit * std::pow(10, decade), at = std::log10(value);
            if ((digit == 1 || finer) && at >= lo_ && at <= hi_) ticks_.push_back({value, label_of(value)});
        }
    if (!zero) return;
    zero_ = lo_ - 0.06 * reach;
    lo_ = zero_ - 0.06 * reach;
    ticks_.push_back({0, "0"});
}

double Scale::place(double value) const {
    const double at = !logarithmic_ ? value : value > 0 ? std::log10(value) : zero_;
    return (at - lo_) / (hi_ - lo_);
}

}   // namespace rayclock::plot

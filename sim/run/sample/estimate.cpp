// The combined ratio estimator over strata with two measured parts each.
#include "sim/run/sample/estimate.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rayclock::sample {

namespace {
constexpr double normal_975 = 1.959963984540054;
}   // namespace

// Newton's method on the distribution function, which Simpson's rule integrates. The function is concave
// above 0, so that the steps from the normal quantile rise to the root. The tests compare it with Boost.
double student_975(double n) {
    if (n > 1e6) return normal_975;   // the powers below would lose all digits
    n = std::max(n, 1.0);
    const double scale =
        std::exp(std::lgamma((n + 1) / 2) - std::lgamma(n / 2)) / std::sqrt(n * std::numbers::pi);
    const auto density = [=](double t) { return scale * std::pow(1 + t * t / n, -(n + 1) / 2); };
    const auto area = [=](double t) {
        constexpr int steps = 256;
        double sum = density(0) + density(t);
        for (int i = 1; i < steps; ++i) sum += (i % 2 ? 4 : 2) * density(t * i / steps);
        return sum * t / steps / 3;
    };
    double t = normal_975;
    for (double step = 1; step > 1e-9;) {
        step = (0.475 - area(t)) / density(t);
        t += step;
    }
    return t;
}

namespace {

/// Returns the total over all strata, estimated from the measured parts alone.
double expanded(const std::vector<Stratum>& strata, const PartValues& y) {
    double sum = 0;
    for (std::size_t s = 0; s < strata.size(); ++s)
        sum += strata[s].size * (y.pairs[s].first + y.pairs[s].second) / 2;
    return sum;
}

/// Returns an estimate with this error.
Estimate with_error(double value, double variance, double degrees) {
    return {value, variance == 0 ? 0 : student_975(degrees) * std::sqrt(variance), variance, degrees};
}

/// Returns the estimate `value` of the total of y.
Estimate estimated(double value, const std::vector<Stratum>& strata, const PartValues& y,
                   const Auxiliary& x) {
    const double of_parts = expanded(strata, x.parts);
    const double ratio = of_parts > 0 ? expanded(strata, y) / of_parts : 0,
                 scale = of_parts > 0 ? x.total / of_parts : 1;
    double variance = 0, squares = 0;
    for (std::size_t s = 0; s < strata.size(); ++s) {
        const double size = strata[s].size,
                     residual = (y.pairs[s].first - y.pairs[s].second) -
                                ratio * (x.parts.pairs[s].first - x.parts.pairs[s].second),
                     part = size * (size - 2) * residual * residual / 4 * scale * scale;
        variance += part;
        squares += part * part;
    }
    const double of_pixels = ratio * ratio * x.variance;   // of the total of x, from many single pixels
    if (variance + of_pixels == 0) return {value};
    // Satterthwaite's degrees of freedom, for residuals with heavy tails: docs/guide/sampling.md.
    const double count = double(strata.size()),
                 degrees =
                     squares == 0 ? count : std::clamp(2 * variance * variance / squares - 1, 1.0, count),
                 both = std::pow((variance + of_pixels) / std::max(variance, of_pixels / 1e6), 2);
    return with_error(value, variance + of_pixels, degrees * both);
}

}   // namespace

Estimate total(const Auxiliary& x) {
    return with_error(x.parts.certain + x.total, x.variance, Estimate::many);
}

Estimate total(const std::vector<Stratum>& strata, const PartValues& y, const Auxiliary& x) {
    const double of_parts = expanded(strata, x.parts), scale = of_parts > 0 ? x.total / of_parts : 1;
    return estimated(y.certain + expanded(strata, y) * scale, strata, y, x);
}

Estimate ratio(const std::vector<Stratum>& strata, const PartValues& above, const PartValues& below,
               const Auxiliary& x) {
    const double whole = total(strata, below, x).value;
    if (whole == 0) return {};
    const double value = total(strata, above, x).value / whole;
    PartValues residual;
    for (std::size_t s = 0; s < above.pairs.size(); ++s)
        residual.pairs.emplace_back(above.pairs[s].first - value * below.pairs[s].first,
                                    above.pairs[s].second - value * below.pairs[s].second);
    const Estimate error = estimated(0, strata, residual, x).times(1 / whole);
    return {value, error.half_width, error.variance, error.degrees};
}

Estimate mean(const std::vector<Estimate>& estimates) {
    double sum = 0, variance = 0, squares = 0;
    for (const Estimate& e : estimates) {
        sum += e.value;
        variance += e.variance;
        squares += e.variance * e.variance / e.degrees;
    }
    const double degrees = squares == 0 ? Estimate::many : variance * variance / squares;
    return with_error(sum, variance, degrees).times(1 / double(estimates.size()));
}

}   // namespace rayclock::sample

// The combined ratio estimator over strata with two measured parts each.
#include "sim/run/sample/estimate.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rayclock::sample {

// G. W. Hill, Algorithm 396: Student's t-quantiles, Communications of the ACM 13 (1970). The tests compare it
// with Boost.
double student_975(double n) {
    constexpr double p = 0.05, half_pi = std::numbers::pi / 2;
    if (n <= 1) return 12.706204736432095;   // the Cauchy distribution, which the algorithm leaves out
    const double a = 1 / (n - 0.5), b = 48 * 48 / (a * a), d1 = ((20700 * a / b - 98) * a - 16) * a + 96.36,
                 d = ((94.5 / (b + d1) - 3) / b + 1) * std::sqrt(a * half_pi) * n;
    double y = std::pow(d * p, 2 / n);
    if (y > 0.05 + a) {
        double x = -1.959963984540054;   // the normal quantile of p / 2
        y = x * x;
        double c = d1;
        if (n < 5) c += 0.3 * (n - 4.5) * (x + 0.6);
        c = (((0.05 * d * x - 5) * x - 7) * x - 2) * x + b + c;
        y = (((((0.4 * y + 6.3) * y + 36) * y + 94.5) / c - y - 3) / b + 1) * x;
        y = std::expm1(a * y * y);
    } else {
        y = ((1 / (((n + 6) / (n * y) - 0.089 * d - 0.822) * (n + 2) * 3) + 0.5 / (n + 4)) * y - 1) *
                (n + 1) / (n + 2) +
            1 / y;
    }
    return std::sqrt(n * y);
}

namespace {

constexpr double normal_975 = 1.959963984540054;

/// Returns the total over all strata that the measured parts alone give.
double expanded(const std::vector<Stratum>& strata, const PartValues& y) {
    double sum = 0;
    for (std::size_t s = 0; s < strata.size(); ++s)
        sum += strata[s].size * (y.pairs[s].first + y.pairs[s].second) / 2;
    return sum;
}

double half_width(const std::vector<Stratum>& strata, const PartValues& y, const Auxiliary& x) {
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
    if (variance + of_pixels == 0) return 0;
    // Satterthwaite's degrees of freedom. A squared residual of a normal distribution has a mean square of
    // three times its squared mean.
    const double count = double(strata.size()),
                 degrees =
                     squares == 0 ? count : std::clamp(3 * variance * variance / squares - 2, 1.0, count),
                 both = std::pow((variance + of_pixels) / std::max(variance, of_pixels / 1e6), 2);
    return student_975(degrees * both) * std::sqrt(variance + of_pixels);
}

}   // namespace

Estimate total(const Auxiliary& x) { return {x.parts.certain + x.total, normal_975 * std::sqrt(x.variance)}; }

Estimate total(const std::vector<Stratum>& strata, const PartValues& y, const Auxiliary& x) {
    const double of_parts = expanded(strata, x.parts), scale = of_parts > 0 ? x.total / of_parts : 1;
    return {y.certain + expanded(strata, y) * scale, half_width(strata, y, x)};
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
    return {value, half_width(strata, residual, x) / whole};
}

}   // namespace rayclock::sample

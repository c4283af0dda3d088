#pragma once
// Estimates of a frame's totals from measured parts, with 95 % confidence intervals. docs/guide/sampling.md
// derives the formulas.
#include <cstdint>
#include <vector>

#include "sim/run/sample/design.hpp"

namespace rayclock::sample {

/// An estimate and the half-width of its 95 % confidence interval.
struct Estimate {
    double value = 0, half_width = 0;
    double variance = 0, degrees = many;   ///< the half-width follows from these
    static constexpr double many = 1e9;    ///< degrees of freedom of a normal distribution
    Estimate times(double factor) const {
        return {value * factor, half_width * factor, variance * factor * factor, degrees};
    }
    double relative() const { return value == 0 ? 0 : half_width / value; }
};

/// Returns the 97.5 % quantile of Student's t for any degrees of freedom of at least 1, to six digits.
double student_975(double degrees);

/// Values of one figure in the measured parts: in the first and the last part, and in pairs by stratum.
struct PartValues {
    double certain = 0;   ///< sum over the first and the last part
    std::vector<std::pair<double, double>> pairs;
};

/// An auxiliary variable x, known exactly in the measured parts. Single pixels estimate its total.
struct Auxiliary {
    PartValues parts;
    double total = 0;      ///< estimate over all parts except the first and the last
    double variance = 0;   ///< of that estimate
};

/// Estimates the total of x itself, from the single pixels.
Estimate total(const Auxiliary& x);
/// The combined ratio estimator: the figure per x in the strata, times the total of x.
Estimate total(const std::vector<Stratum>& strata, const PartValues& y, const Auxiliary& x);
/// Returns the mean of independent estimates, such as those of the frames of a film.
Estimate mean(const std::vector<Estimate>& estimates);
/// Estimates the ratio of two totals. Its error is smaller than theirs, since they vary together.
Estimate ratio(const std::vector<Stratum>& strata, const PartValues& above, const PartValues& below,
               const Auxiliary& x);

}   // namespace rayclock::sample

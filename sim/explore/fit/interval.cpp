// Bits of intervals, and decimal text of 128-bit integers.
#include "sim/explore/fit/interval.hpp"

namespace rayclock::fit {

namespace {

/// Bits of a number that is not negative.
int length(Int128 value) {
    int bits = 0;
    for (; value > 0; value >>= 1) ++bits;
    return bits;
}

}   // namespace

int unsigned_bits(const Interval& a) { return a.empty() ? 1 : std::max(1, length(a.hi)); }

int signed_bits(const Interval& a) {
    if (a.empty()) return 1;
    const auto of = [](Int128 value) { return 1 + length(value < 0 ? -(value + 1) : value); };
    return std::max(of(a.lo), of(a.hi));
}

std::string text(Int128 value) {
    if (value == 0) return "0";
    std::string digits;
    for (Int128 rest = value; rest != 0; rest /= 10)
        digits.insert(digits.begin(), char('0' + int(rest < 0 ? -(rest % 10) : rest % 10)));
    return value < 0 ? "-" + digits : digits;
}

}   // namespace rayclock::fit

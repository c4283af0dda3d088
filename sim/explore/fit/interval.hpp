#pragma once
// Interval arithmetic in whole numbers: what a signal can be, from what its operands can be. Exact in 128
// bits; the widest signal of the machine, a product of numerator and determinant, has 125.
#include <algorithm>
#include <string>

namespace rayclock::fit {

__extension__ using Wide = __int128;

/// All whole numbers from lo to hi; nothing if lo > hi, and then every result is nothing.
struct Interval {
    Wide lo = 1, hi = 0;

    bool empty() const { return lo > hi; }
    bool holds(Wide value) const { return lo <= value && value <= hi; }
    friend bool operator==(const Interval&, const Interval&) = default;
};

inline Interval point(Wide value) { return {value, value}; }

/// The smallest interval that holds both.
inline Interval hull(const Interval& a, const Interval& b) {
    if (a.empty()) return b;
    if (b.empty()) return a;
    return {std::min(a.lo, b.lo), std::max(a.hi, b.hi)};
}
inline Interval meet(const Interval& a, const Interval& b) {
    return {std::max(a.lo, b.lo), std::min(a.hi, b.hi)};
}

inline Interval operator-(const Interval& a) { return {-a.hi, -a.lo}; }
inline Interval operator+(const Interval& a, const Interval& b) {
    return a.empty() || b.empty() ? Interval{} : Interval{a.lo + b.lo, a.hi + b.hi};
}
inline Interval operator-(const Interval& a, const Interval& b) { return a + -b; }
inline Interval operator*(const Interval& a, const Interval& b) {
    if (a.empty() || b.empty()) return {};
    const Wide p = a.lo * b.lo, q = a.lo * b.hi, r = a.hi * b.lo, s = a.hi * b.hi;
    return {std::min({p, q, r, s}), std::max({p, q, r, s})};
}

/// Times 2^n; divided by 2^n and rounded down, or up.
inline Interval left(const Interval& a, int n) { return a * point(Wide(1) << n); }
inline Interval right(const Interval& a, int n) { return {a.lo >> n, a.hi >> n}; }
inline Interval right_up(const Interval& a, int n) { return -right(-a, n); }

/// The low n bits of what is not negative.
inline Interval low_bits(const Interval& a, int n) {
    return a.empty() || a.hi >> n == 0 ? a : Interval{0, (Wide(1) << n) - 1};
}

/// |a|, and what of it is not below zero.
inline Interval magnitude(const Interval& a) {
    if (a.empty()) return {};
    if (a.lo >= 0) return a;
    return a.hi <= 0 ? -a : Interval{0, std::max(-a.lo, a.hi)};
}
inline Interval not_negative(const Interval& a) { return meet(a, {0, std::max(Wide(0), a.hi)}); }

/// Fewest bits that hold every value of it, at least 1: two's complement, or without a sign.
int signed_bits(const Interval& a);
int unsigned_bits(const Interval& a);

/// In decimal.
std::string text(Wide value);

}   // namespace rayclock::fit

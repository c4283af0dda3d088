#pragma once
// Interval arithmetic in integers: the range of a signal follows from the ranges of its operands. It is exact
// in 128 bits; the machine's widest signal, a product of numerator and determinant, has 125.
#include <algorithm>
#include <string>

namespace rayclock::fit {

__extension__ using Int128 = __int128;

/// All integers from lo to hi. It is empty if lo > hi; operations on empty intervals give empty ones.
struct Interval {
    Int128 lo = 1, hi = 0;

    bool empty() const { return lo > hi; }
    bool holds(Int128 value) const { return lo <= value && value <= hi; }
    friend bool operator==(const Interval&, const Interval&) = default;
};

inline Interval point(Int128 value) { return {value, value}; }

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
    const Int128 p = a.lo * b.lo, q = a.lo * b.hi, r = a.hi * b.lo, s = a.hi * b.hi;
    return {std::min({p, q, r, s}), std::max({p, q, r, s})};
}

/// Return a 2^n, and a / 2^n rounded down and up.
inline Interval left(const Interval& a, int n) { return a * point(Int128(1) << n); }
inline Interval right(const Interval& a, int n) { return {a.lo >> n, a.hi >> n}; }
inline Interval right_up(const Interval& a, int n) { return -right(-a, n); }

/// Returns the range of the low n bits of a non-negative number.
inline Interval low_bits(const Interval& a, int n) {
    return a.empty() || a.hi >> n == 0 ? a : Interval{0, (Int128(1) << n) - 1};
}

/// Return the range of |a|, and the non-negative part of a.
inline Interval magnitude(const Interval& a) {
    if (a.empty()) return {};
    if (a.lo >= 0) return a;
    return a.hi <= 0 ? -a : Interval{0, std::max(-a.lo, a.hi)};
}
inline Interval not_negative(const Interval& a) { return meet(a, {0, std::max(Int128(0), a.hi)}); }

/// Return the fewest bits that hold every value, at least 1: in two's complement, and without a sign.
int signed_bits(const Interval& a);
int unsigned_bits(const Interval& a);

/// Returns the value in decimal.
std::string text(Int128 value);

}   // namespace rayclock::fit

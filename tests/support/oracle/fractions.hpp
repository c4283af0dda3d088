#pragma once
// Exact truth for the arithmetic units, in integers and fractions of any size. It follows from the geometry
// alone. It shares no formula with the units that it judges, and assumes only the rounding that they promise.
// Needs Boost, so no part of the program includes it.
#include <array>
#include <optional>

#include <boost/multiprecision/cpp_int.hpp>

// Division of a fraction by an integer. Boost 1.82 and 1.83 have a special case for the fractions 0 and 1. It
// takes the integer as the new denominator with its sign, so that 0 / -5 is less than 0 and 1 / -5 is
// greater. Every operator finds this overload first, because it is not a template.
namespace boost::multiprecision::backends {

inline void eval_divide(cpp_rational_backend& result, const cpp_rational_backend& a, cpp_int_backend<> b) {
    cpp_rational_backend quotient(a);
    eval_divide(quotient, cpp_rational_backend(b));
    result = quotient;
}

}   // namespace boost::multiprecision::backends

namespace rayclock::oracle {

using Int = boost::multiprecision::cpp_int;
using Rational = boost::multiprecision::cpp_rational;
using Point = std::array<Int, 3>;

template <class V> Point point(const V& v) { return {Int(v[0]), Int(v[1]), Int(v[2])}; }

/// Returns 2^exponent.
inline Rational power_of_two(int exponent) {
    return exponent >= 0 ? Rational(Int(1) << exponent) : Rational(Int(1), Int(1) << -exponent);
}

/// Returns the largest integer not above q; ceil() returns the smallest one not below q.
inline Int floor(const Rational& q) {
    const Int num = numerator(q), den = denominator(q);   // den > 0; division truncates towards zero
    const Int cut = num / den;
    return num < 0 && cut * den != num ? Int(cut - 1) : cut;
}
inline Int ceil(const Rational& q) { return -floor(-q); }

// ---- Ray and triangle.

/// A value that moves with an infinitesimal eps > 0: c[0] + c[1] eps + c[2] eps^2 + c[3] eps^3.
template <class Number> using Moving = std::array<Number, 4>;

/// Returns the sign for eps -> 0+: that of the lowest coefficient that is not zero.
template <class Number> int sign(const Moving<Number>& m) {
    for (const Number& c : m)
        if (c != 0) return c > 0 ? 1 : -1;
    return 0;
}

/// Three linear equations in t, u, v; their right sides move.
template <class Number> struct Equations {
    std::array<std::array<Number, 3>, 3> left;
    std::array<Moving<Number>, 3> right;
};

/// The solution as fractions above / below. `below` is the determinant of the left side or its negative.
template <class Number> struct Solution {
    std::array<Moving<Number>, 3> above;
    Number below;
};

/// Solves by Gauss-Jordan elimination in the form in which integers stay integers: every division is exact.
/// See Bareiss, "Sylvester's identity and multistep integer-preserving Gaussian elimination", 1968. Returns
/// nothing if the left side is singular.
template <class Number> std::optional<Solution<Number>> solve(Equations<Number> e) {
    Number before = 1;
    for (std::size_t k = 0; k < 3; ++k) {
        std::size_t pivot = k;
        while (pivot < 3 && e.left[pivot][k] == 0) ++pivot;
        if (pivot == 3) return std::nullopt;
        std::swap(e.left[k], e.left[pivot]);
        std::swap(e.right[k], e.right[pivot]);
        const Number top = e.left[k][k];
        for (std::size_t row = 0; row < 3; ++row) {
            if (row == k) continue;
            const Number factor = e.left[row][k];
            const auto eliminate = [&](Number& x, const Number& from) {
                x = (x * top - factor * from) / before;
            };
            for (std::size_t i = 0; i < 3; ++i) eliminate(e.left[row][i], e.left[k][i]);
            for (std::size_t i = 0; i < 4; ++i) eliminate(e.right[row][i], e.right[k][i]);
        }
        before = top;
    }
    return Solution<Number>{e.right, before};
}

/// The crossing of a ray and a triangle: o + t d = (1 - u - v) a + u b + v c. `volume` is six times that of
/// the tetrahedron (d, b - a, c - a).
struct Crossing {
    Rational t, u, v, volume;
};

/// Returns the crossing of a ray with a triangle at t > 0. The origin o + (eps, eps^2, eps^3), eps -> 0+,
/// decides whether the ray passes inside. So a ray through an edge or a corner belongs to one side. All other
/// values hold for the unmoved origin. A triangle seen edge-on is not crossed.
///
/// Coordinates have at most 60 bits. Then the last products have 2 * 3 * 61 + 4 bits and fit; they would
/// throw if they did not.
inline std::optional<Crossing> crossing(const Point& o, const Point& d, const Point& a, const Point& b,
                                        const Point& c) {
    using Whole = boost::multiprecision::checked_int512_t;
    Equations<Whole> e;
    for (std::size_t k = 0; k < 3; ++k) {
        e.left[k] = {Whole(-d[k]), Whole(b[k] - a[k]), Whole(c[k] - a[k])};
        e.right[k][0] = Whole(o[k] - a[k]);
        e.right[k][k + 1] = 1;
    }
    const auto solved = solve(e);
    if (!solved) return std::nullopt;
    const auto& [t, u, v] = solved->above;
    const Whole& below = solved->below;
    const Moving<Whole> w{below - u[0] - v[0], -u[1] - v[1], -u[2] - v[2], -u[3] - v[3]};
    const int turned = below < 0 ? -1 : 1;
    if (sign(u) * turned < 0 || sign(v) * turned < 0 || sign(w) * turned < 0 || t[0] * turned <= 0)
        return std::nullopt;
    const Int size(abs(below));
    const auto over = [&](const Whole& above) { return Rational(Int(above * turned), size); };
    return Crossing{over(t[0]), over(u[0]), over(v[0]), Rational(size)};
}

/// Returns true if a hit at t of primitive `prim` precedes one at other_t of other_prim. It does if it is
/// nearer, or equally near with a lower or the same number.
inline bool goes_before(const Rational& t, std::uint32_t prim, const Rational& other_t,
                        std::uint32_t other_prim) {
    return t < other_t || (t == other_t && prim <= other_prim);
}

// ---- Ray and box.

struct Box {
    Point lo, hi;
    Point step;   ///< distance between two adjacent quantised planes
};

/// The distances at which a ray is inside a box. Without `leave` the interval has no end.
struct Interval {
    Rational enter;
    std::optional<Rational> leave;
};

/// The errors that the box test may make: its reciprocals have `precision` bits, and it does not distinguish
/// distances beyond `most`.
struct Licence {
    int precision = 0;
    Rational most;
    Int drift = 0;   ///< error of the origin on each axis
};

/// Returns the part with t >= 0 of the ray o + d t / unit that lies in the closed box, or nothing.
///
/// A licence grants the errors of the box test. With R-bit reciprocals, a reciprocal of the direction that is
/// cut to an R-bit mantissa is low by less than 2^(1-R) of its value. One unit added to it makes it high by
/// as much. The product with the distance to the node's corner is rounded to a multiple of a unit. The unit
/// is the value of one plane step with a reciprocal of 1, which is again 2^(1-R) of the true time for a plane
/// step. Finally t is rounded to an integer. So either end of each axis' interval may lie outwards by
///     2^(1-R) (|t| + t_step) + 1,    t_step: the time that the ray needs for one plane step of the axis.
/// A drift of the origin adds its own time, which is longer by the reciprocal's error.
///
/// If a component of d is zero, o is compared on the grid of planes: less than one step outside may count as
/// inside.
inline std::optional<Interval> interval(const Point& o, const Point& d, const Box& box, const Rational& unit,
                                        const Licence* licence = nullptr) {
    Interval in{0, std::nullopt};
    for (std::size_t k = 0; k < 3; ++k) {
        if (d[k] == 0) {
            const Int slack = licence ? Int(box.step[k] - 1) : Int(0);
            if (o[k] < box.lo[k] - slack || o[k] > box.hi[k] + slack) return std::nullopt;
            continue;
        }
        const auto time = [&](const Int& way) { return Rational(way, abs(d[k])) * unit; };
        const auto slack = [&](const Rational& t) {
            if (!licence) return Rational(0);
            const Rational drift = time(licence->drift);
            return Rational(power_of_two(1 - licence->precision) * (abs(t) + time(box.step[k]) + drift) + 1 +
                            drift);
        };
        const Rational enter = d[k] > 0 ? time(box.lo[k] - o[k]) : time(o[k] - box.hi[k]);
        const Rational leave = d[k] > 0 ? time(box.hi[k] - o[k]) : time(o[k] - box.lo[k]);
        in.enter = std::max(in.enter, Rational(enter - slack(enter)));
        const Rational last = leave + slack(leave);
        if (!in.leave || last < *in.leave) in.leave = last;
    }
    if (licence) {
        in.enter = std::min(in.enter, licence->most);
        if (in.leave) in.leave = std::min(*in.leave, licence->most);
    }
    if (in.leave && in.enter > *in.leave) return std::nullopt;
    return in;
}

// ---- Camera ray.

/// Returns the number of binary digits of |d|.
inline int digits(const Int& d) {
    int n = 0;
    for (Int rest = abs(d); rest != 0; rest >>= 1) ++n;
    return n;
}

/// Returns 1 / |d|, scaled to (2^(R-1), 2^R]: the value that an R-bit reciprocal must bracket. d must not be
/// 0.
inline Rational scaled_reciprocal(const Int& d, int precision) {
    return power_of_two(precision - 1 + digits(d)) / Rational(abs(d));
}

/// Returns the integer nearest to q; halves round up.
inline Int nearest(const Rational& q) { return floor(q + Rational(1, 2)); }

/// Returns raygen's result for a direction from the camera's registers (model/core/frame.hpp). The direction
/// is multiplied by the largest power of two up to 2^max_doubled for which all components lie within
/// -2^(bits-1) <= d < 2^(bits-1). Then each component is rounded to the nearest integer in that range.
inline std::array<Int, 3> filled(std::array<Rational, 3> d, int bits, int max_doubled) {
    const Int end = Int(1) << (bits - 1);
    const auto fits_twice = [&](const Rational& q) { return -end <= 2 * q && 2 * q < end; };
    for (int n = 0; n < max_doubled && fits_twice(d[0]) && fits_twice(d[1]) && fits_twice(d[2]); ++n)
        for (Rational& q : d) q *= 2;
    std::array<Int, 3> whole;
    for (std::size_t k = 0; k < 3; ++k) whole[k] = std::min<Int>(nearest(d[k]), end - 1);
    return whole;
}

/// Returns the magnitude of the largest component.
inline Int longest(const std::array<Int, 3>& d) {
    return std::max<Int>(abs(d[0]), std::max<Int>(abs(d[1]), abs(d[2])));
}

}   // namespace rayclock::oracle

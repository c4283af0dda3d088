#pragma once
// Exact truth about rays and spheres and about rays and planes, in fractions of any size. It follows from the
// geometry alone: on a sphere, the distance from the centre has a certain square. The value of that square at
// three points decides everything: both ends of the path and the point nearest to the centre. No square root
// is taken.
#include "tests/support/oracle/fractions.hpp"

namespace rayclock::oracle {

using Place3 = std::array<Rational, 3>;

/// A sphere and a line o + t d.
struct Ball {
    Place3 o, d, centre;
    Rational radius_squared;

    /// Returns the squared distance from the centre minus the squared radius: positive outside.
    Rational outside(const Rational& t) const {
        Rational sum = -radius_squared;
        for (std::size_t k = 0; k < 3; ++k) {
            const Rational way = o[k] + t * d[k] - centre[k];
            sum += way * way;
        }
        return sum;
    }
    bool moves() const { return d[0] != 0 || d[1] != 0 || d[2] != 0; }
    /// Returns the t at which the line is nearest to the centre. Requires moves().
    Rational middle() const {
        Rational along = 0, square = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            along += d[k] * (o[k] - centre[k]);
            square += d[k] * d[k];
        }
        return -along / square;
    }
    Rational speed_squared() const { return d[0] * d[0] + d[1] * d[1] + d[2] * d[2]; }
};

/// How the ray t > 0 meets the sphere: it enters at the near point if it comes from outside, and leaves at
/// the far point otherwise.
enum class SphereRoot { none, near, far };
inline SphereRoot meets(const Ball& ball) {
    if (!ball.moves()) return SphereRoot::none;
    const Rational start = ball.outside(0), middle = ball.middle();
    if (start > 0) return middle > 0 && ball.outside(middle) <= 0 ? SphereRoot::near : SphereRoot::none;
    if (start == 0) return middle > 0 ? SphereRoot::far : SphereRoot::none;
    return SphereRoot::far;
}
/// Decides for a ray that starts on the sphere, up to rounding, and goes inward: only the far point counts.
inline SphereRoot meets_from_its_surface(const Ball& ball) {
    return meets(ball) == SphereRoot::none ? SphereRoot::none : SphereRoot::far;
}

/// Returns true if the near or far crossing lies at t or before.
inline bool reached(const Ball& ball, SphereRoot which, const Rational& t) {
    const Rational middle = ball.middle();
    return which == SphereRoot::near ? t >= middle || ball.outside(t) <= 0
                                     : t >= middle && ball.outside(t) >= 0;
}

/// Returns true if the segment 0 < t < end crosses or touches the sphere.
inline bool between(const Ball& ball, const Rational& end) {
    if (!ball.moves()) return false;
    const Rational first = ball.outside(0), last = ball.outside(end), middle = ball.middle();
    if ((first < 0 && last > 0) || (first > 0 && last < 0)) return true;
    const bool inside_way = middle > 0 && middle < end;
    if (first > 0)
        return inside_way && ball.outside(middle) <= 0;   // enters and leaves; leaves at `end` at the latest
    if (first < 0) return false;                          // at most the last point lies on it
    return middle > 0 && 2 * middle < end;   // the other crossing of a line that starts on the sphere
}

/// Returns the crossing of a line with the plane a + u (b - a) + v (c - a) at t > 0, or nothing.
inline std::optional<Crossing> plane_crossing(const Place3& o, const Place3& d, const Place3& a,
                                              const Place3& b, const Place3& c) {
    Equations<Rational> e;
    for (std::size_t k = 0; k < 3; ++k) {
        e.left[k] = {Rational(-d[k]), Rational(b[k] - a[k]), Rational(c[k] - a[k])};
        e.right[k][0] = o[k] - a[k];
    }
    const auto solved = solve(e);
    if (!solved) return std::nullopt;
    const auto& [above, below] = *solved;
    const Rational t = above[0][0] / below;
    if (t <= 0) return std::nullopt;
    return Crossing{t, above[1][0] / below, above[2][0] / below, abs(below)};
}

}   // namespace rayclock::oracle

#pragma once
// Exact truth about rays and spheres, and rays and planes, in fractions of any size. Written from the
// geometry: a sphere is where the distance from its centre has a certain square; what happens on the way is
// told by that square's value at three points, the way's ends and the point nearest to the centre. No root is
// taken. Needs Boost; used by tests only.
#include "sim/judge/oracle/exact.hpp"

namespace rayclock::oracle {

using Place3 = std::array<Rational, 3>;

/// A sphere and a line o + t d.
struct Ball {
    Place3 o, d, centre;
    Rational radius_squared;

    /// Square of the distance from the centre, less that of the radius: positive outside.
    Rational outside(const Rational& t) const {
        Rational sum = -radius_squared;
        for (std::size_t k = 0; k < 3; ++k) {
            const Rational way = o[k] + t * d[k] - centre[k];
            sum += way * way;
        }
        return sum;
    }
    bool moves() const { return d[0] != 0 || d[1] != 0 || d[2] != 0; }
    /// Where the line is nearest to the centre; it must move.
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

/// How the ray t > 0 meets the sphere. It goes in at the near point if it comes from outside, out at the far
/// one otherwise.
enum class Meets { no, near, far };
inline Meets meets(const Ball& ball) {
    if (!ball.moves()) return Meets::no;
    const Rational start = ball.outside(0), middle = ball.middle();
    if (start > 0) return middle > 0 && ball.outside(middle) <= 0 ? Meets::near : Meets::no;
    if (start == 0) return middle > 0 ? Meets::far : Meets::no;
    return Meets::far;
}
/// A ray that starts on the sphere as well as its numbers can say, and goes inward: only the far point is
/// meant.
inline Meets meets_from_its_surface(const Ball& ball) {
    return meets(ball) == Meets::no ? Meets::no : Meets::far;
}

/// The near or far crossing lies at t or before.
inline bool reached(const Ball& ball, Meets which, const Rational& t) {
    const Rational middle = ball.middle();
    return which == Meets::near ? t >= middle || ball.outside(t) <= 0 : t >= middle && ball.outside(t) >= 0;
}

/// The way 0 < t < end crosses or touches the sphere.
inline bool between(const Ball& ball, const Rational& end) {
    if (!ball.moves()) return false;
    const Rational first = ball.outside(0), last = ball.outside(end), middle = ball.middle();
    if ((first < 0 && last > 0) || (first > 0 && last < 0)) return true;
    const bool inside_way = middle > 0 && middle < end;
    if (first > 0)
        return inside_way && ball.outside(middle) <= 0;   // in and out again, the last at `end` at most
    if (first < 0) return false;                          // and the last point at most on it
    return middle > 0 && 2 * middle < end;                // the other crossing of one that starts on it
}

/// Where a line meets a plane a + u (b - a) + v (c - a), t > 0.
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

#pragma once
// The truth about secondary rays: is the way from a point of a surface free, to a light or without end? By
// signed volumes, in 128 bits.
//
// The surface stands in the way of all that lies behind it. A surface that holds the light does not: the end
// does not count. Otherwise the way may pass exactly through edges and corners, run in a triangle's plane, or
// begin on several surfaces at once. What is right then? Whatever holds for points beside it. So the way is
// moved by e m1 + e^2 m2 + ..., e -> 0+, for several sets of directions m, m1 leading off the surface to the
// side on which the way leaves. If all of them find it blocked, or all find it free, that is the truth; if
// not, either answer is right. In eight sets the directions are just any; in the ninth m1 is the way itself,
// which then has left all that touches its first point, and the axes follow.
//
// Widths: for a point with den < 2^(2N+M+1) no volume is above 6 2^(5N+M+1), and 128 bits do for 5N + M <=
// 123.
#include <optional>
#include <span>

#include "sim/judge/oracle/surface.hpp"

namespace rayclock::oracle {

/// The point num / den, den > 0.
struct Place {
    Triple<Int128> num{};
    Int128 den = 1;
};

/// A way from a point to a lattice point, or along a direction without end.
struct Path {
    Place from;
    std::optional<Vec3i> to;
    Vec3i direction{};
};

/// The point lies in the triangle's plane.
bool in_plane(const Place& place, const Corners& triangle);

/// What the way meets, looked at triangle by triangle.
class Sight {
public:
    /// `surface` holds path.from, which is in_plane; the way leaves it on the side `facing` of its normal (1
    /// or -1).
    Sight(const Path& path, const Corners& surface, int facing);

    /// False once nothing can change any more: the way is blocked for certain.
    bool look(const Corners& triangle);

    enum class Answer { free, blocked, either };
    Answer answer() const;

private:
    static constexpr int sets = 9;
    static constexpr unsigned all = (1u << sets) - 1;
    struct Set {
        std::array<Triple<Int128>, 4> moves{};
    };
    /// The five signs that decide about a triangle: on which side of its plane the way begins and ends, and
    /// on which side of each edge it passes. 0 is undecided.
    struct Signs {
        int begin, end, ab, bc, ca;
    };
    Signs signs(const Corners& triangle) const;
    int moved_plane(const Corners& triangle, const Set& set) const;
    int moved_edge(const Vec3i& p, const Vec3i& q, const Set& set) const;

    Path path_;
    Triple<Int128> way_;   ///< of any length
    std::array<Set, sets> sets_;
    unsigned blocked_ = 0;   ///< bit i: by set i
};

}   // namespace rayclock::oracle

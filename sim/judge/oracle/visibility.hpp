#pragma once
// Exact truth about secondary rays: is the path from a point of a surface free, to a light or to infinity? By
// signed volumes in 128 bits.
//
// The surface blocks everything behind it. A surface that holds the light does not block, because the end of
// the path does not count. Otherwise the path may pass exactly through edges and corners, run in a triangle's
// plane, or begin on several surfaces at once. Then the truth is the one that holds for nearby points. So the
// path is moved by e m1 + e^2 m2 + ..., e -> 0+, for several sets of directions m. The direction m1 leads off
// the surface to the side on which the path leaves. If all sets find the path blocked, or all find it free,
// that is the truth. If not, either answer is right. Eight sets have arbitrary directions. In the ninth, m1
// is the path itself, which then has left all that touches its first point, and the axes follow.
//
// Widths: for a point with den < 2^(2N+M+1), every volume is below 6 2^(5N+M+1). So 128 bits suffice for 5N +
// M <= 123.
#include <optional>
#include <span>

#include "sim/judge/oracle/surface.hpp"

namespace rayclock::oracle {

/// The point num / den, den > 0.
struct RationalPoint {
    Triple<Int128> num{};
    Int128 den = 1;
};

/// A path from a point to a lattice point, or along a direction to infinity.
struct Path {
    RationalPoint from;
    std::optional<Vec3i> to;
    Vec3i direction{};
};

/// Returns true if the point lies in the triangle's plane.
bool in_plane(const RationalPoint& place, const Corners& triangle);

/// Collects what the path meets, one triangle at a time.
class Visibility {
public:
    /// `surface` must hold path.from (see in_plane()). `facing` is the side of its normal on which the path
    /// leaves it: 1 or -1.
    Visibility(const Path& path, const Corners& surface, int facing);

    /// Tests a triangle. Returns false once no other triangle can change the answer, because the path is
    /// blocked.
    bool add(const Corners& triangle);

    enum class Answer { free, blocked, either };
    Answer answer() const;

private:
    static constexpr int sets = 9;
    static constexpr unsigned all = (1u << sets) - 1;
    struct Set {
        std::array<Triple<Int128>, 4> moves{};
    };
    /// The five signs that decide about a triangle; 0 is undecided. They are the sides of its plane on which
    /// the path begins and ends, and the side of each edge on which it passes.
    struct Signs {
        int begin, end, ab, bc, ca;
    };
    Signs signs(const Corners& triangle) const;
    int moved_plane(const Corners& triangle, const Set& set) const;
    int moved_edge(const Vec3i& p, const Vec3i& q, const Set& set) const;

    Path path_;
    Triple<Int128> way_;   ///< direction of the path; its length is arbitrary
    std::array<Set, sets> sets_;
    unsigned blocked_ = 0;   ///< bit i: blocked for set i
};

}   // namespace rayclock::oracle

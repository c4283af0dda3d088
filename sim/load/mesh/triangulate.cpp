// Ear clipping that tests a corner again only when its obstacle is gone. The triangles equal those of the
// plain algorithm. docs/decisions/input-files.md has the times.
#include "sim/load/mesh/triangulate.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace rayclock {
namespace {

using Points = std::vector<glm::dvec2>;

double cross(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

/// Returns twice the signed area of a triangle.
double turn(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) { return cross(b - a, c - a); }

/// Projects the polygon along the axis of its largest area component. The result runs counter-clockwise.
Points flatten(std::span<const glm::dvec3> corners) {
    glm::dvec3 area(0);
    const glm::dvec3 origin = corners[0];
    for (std::size_t i = 0; i < corners.size(); ++i)
        area += glm::cross(corners[i] - origin, corners[(i + 1) % corners.size()] - origin);
    int drop = 0;
    for (int axis = 1; axis < 3; ++axis)
        if (std::abs(area[axis]) > std::abs(area[drop])) drop = axis;
    int u = (drop + 1) % 3, v = (drop + 2) % 3;
    if (area[drop] < 0) std::swap(u, v);
    Points flat;
    for (const glm::dvec3& p : corners) flat.emplace_back((p - origin)[u], (p - origin)[v]);
    return flat;
}

constexpr std::uint32_t none = ~std::uint32_t{0};

/// The rest of the polygon, as a ring of corner numbers, and the corners that may be ears.
///
/// A corner is not an ear while a spot with reflex corners lies in its triangle. Corners only ever stop being
/// reflex, so a spot outside the triangle needs no second test. A corner waits for the spot in its triangle.
/// While its neighbours stay the same, it tests every spot once instead of once per round. Spots are sorted
/// by x, and many corners in one place make one spot.
class CornerRing {
public:
    explicit CornerRing(const Points& points)
        : points_(points), corners_(points.size()), may_be_ear_((points.size() + 63) / 64, 0) {
        const std::uint32_t n = size();
        for (std::uint32_t i = 0; i < n; ++i) {
            corners_[i].next = (i + 1) % n;
            corners_[i].previous = (i + n - 1) % n;
        }
        for (std::uint32_t i = 0; i < n; ++i) {
            corners_[i].is_reflex = bend(i) <= 0;
            mark(i);
        }
        find_spots();
    }

    std::uint32_t next(std::uint32_t i) const { return corners_[i].next; }
    std::uint32_t previous(std::uint32_t i) const { return corners_[i].previous; }

    /// Returns the first ear from `at` on, around the ring. Returns `at` itself if there is no ear.
    std::uint32_t ear_from(std::uint32_t at) {
        for (std::uint32_t i = marked(at, size()); i != none; i = marked(i + 1, size()))
            if (is_ear(i)) return i;
        for (std::uint32_t i = marked(0, at); i != none; i = marked(i + 1, at))
            if (is_ear(i)) return i;
        return at;
    }

    void remove(std::uint32_t i) {
        const std::uint32_t before = previous(i), after = next(i);
        corners_[before].next = after;
        corners_[after].previous = before;
        corners_[i].is_gone = true;
        unmark(i);
        no_longer_reflex(i);
        // Cutting an ear only shrinks the interior angles next to it: a convex corner stays convex.
        for (const std::uint32_t side : {before, after}) {
            if (corners_[side].is_reflex && bend(side) > 0) no_longer_reflex(side);
            corners_[side].looked_at = 0;   // its triangle has changed
            mark(side);
        }
    }

private:
    std::uint32_t size() const { return static_cast<std::uint32_t>(points_.size()); }
    double bend(std::uint32_t i) const { return turn(points_[previous(i)], points_[i], points_[next(i)]); }

    void find_spots() {
        std::vector<std::uint32_t> reflex;
        for (std::uint32_t i = 0; i < size(); ++i)
            if (corners_[i].is_reflex) reflex.push_back(i);
        const auto place = [&](std::uint32_t i) { return std::pair(points_[i].x, points_[i].y); };
        std::sort(reflex.begin(), reflex.end(),
                  [&](std::uint32_t a, std::uint32_t b) { return place(a) < place(b); });
        for (const std::uint32_t i : reflex) {
            if (spots_.empty() || spots_.back().p != points_[i]) spots_.push_back({points_[i]});
            ++spots_.back().reflex;
            corners_[i].spot = static_cast<std::uint32_t>(spots_.size() - 1);
        }
    }

    std::uint32_t first_spot(double x) const {
        const auto found = std::lower_bound(spots_.begin(), spots_.end(), x,
                                            [](const Spot& s, double least) { return s.p.x < least; });
        return static_cast<std::uint32_t>(found - spots_.begin());
    }

    /// Returns true for a convex corner without reflex or straight corners in its triangle. Otherwise the
    /// corner waits for the spot in its triangle.
    bool is_ear(std::uint32_t i) {
        unmark(i);
        const glm::dvec2 a = points_[previous(i)], b = points_[i], c = points_[next(i)];
        if (!(turn(a, b, c) > 0)) return false;   // no ear until a neighbour goes
        const glm::dvec2 lo = glm::min(a, glm::min(b, c)), hi = glm::max(a, glm::max(b, c));
        std::uint32_t& k = corners_[i].looked_at;
        for (k = std::max(k, first_spot(lo.x)); k < spots_.size() && spots_[k].p.x <= hi.x; ++k) {
            const glm::dvec2 p = spots_[k].p;
            if (spots_[k].reflex == 0 || p.y < lo.y || p.y > hi.y) continue;
            // Other corners in the same place only touch, as bridges to holes do. They do not block.
            if (p == a || p == b || p == c) continue;
            if (turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0) {
                waiting_.push_back({i, spots_[k].first_waiting});
                spots_[k].first_waiting = static_cast<std::uint32_t>(waiting_.size() - 1);
                return false;
            }
        }
        mark(i);
        return true;
    }

    /// Marks the corners that wait for a spot once it has no reflex corner. A corner whose triangle has
    /// changed meanwhile is tested needlessly.
    void no_longer_reflex(std::uint32_t r) {
        if (!corners_[r].is_reflex) return;
        corners_[r].is_reflex = false;
        Spot& spot = spots_[corners_[r].spot];
        if (--spot.reflex > 0) return;
        for (std::uint32_t w = spot.first_waiting; w != none; w = waiting_[w].next)
            if (!corners_[waiting_[w].who].is_gone) mark(waiting_[w].who);
        spot.first_waiting = none;
    }

    void mark(std::uint32_t i) { may_be_ear_[i / 64] |= std::uint64_t{1} << i % 64; }
    void unmark(std::uint32_t i) { may_be_ear_[i / 64] &= ~(std::uint64_t{1} << i % 64); }

    /// Returns the first marked corner of [from, end).
    std::uint32_t marked(std::uint32_t from, std::uint32_t end) const {
        if (from >= end) return none;
        std::uint64_t word = may_be_ear_[from / 64] & ~std::uint64_t{0} << from % 64;
        for (std::uint32_t at = from / 64;; word = may_be_ear_[at]) {
            if (word != 0) {
                const std::uint32_t i = 64 * at + static_cast<std::uint32_t>(std::countr_zero(word));
                return i < end ? i : none;
            }
            if (64 * ++at >= end) return none;
        }
    }

    struct InRing {
        std::uint32_t next = 0, previous = 0;
        std::uint32_t looked_at = 0;   ///< first spot that this corner's triangle has not been tested with
        std::uint32_t spot = none;     ///< of a reflex corner
        bool is_reflex = false, is_gone = false;
    };
    /// One place, and the reflex corners in it.
    struct Spot {
        glm::dvec2 p;
        std::uint32_t reflex = 0;             ///< number of reflex corners
        std::uint32_t first_waiting = none;   ///< first corner, in `waiting_`, that waits for this spot
    };
    struct Waiting {
        std::uint32_t who, next;
    };

    const Points& points_;
    std::vector<InRing> corners_;
    std::vector<Spot> spots_;
    std::vector<Waiting> waiting_;
    std::vector<std::uint64_t> may_be_ear_;   ///< one bit per corner
};

}   // namespace

void triangulate(std::span<const glm::dvec3> corners, std::vector<std::array<std::uint32_t, 3>>& out) {
    if (corners.size() == 3) return out.push_back({0, 1, 2});
    const Points points = flatten(corners);
    CornerRing ring(points);
    std::uint32_t at = 1;   // splits a quad from corner 0 to corner 2, as is usual
    for (std::size_t left = corners.size(); left > 3; --left) {
        const std::uint32_t ear = ring.ear_from(at);
        out.push_back({ring.previous(ear), ear, ring.next(ear)});
        // Skip the next corner, so that a round polygon does not become a fan of slivers.
        at = ring.next(ring.next(ear));
        ring.remove(ear);
    }
    out.push_back({ring.previous(at), at, ring.next(at)});
}

}   // namespace rayclock

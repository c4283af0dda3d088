#pragma once
// Exact truth about rays and a whole surface in integers: the closest hit and every crossing.
#include <cstdint>
#include <vector>

#include "model/layout/memory_image.hpp"
#include "model/scene/hit.hpp"
#include "model/scene/scene.hpp"
#include "sim/judge/oracle/cross.hpp"
#include "sim/judge/oracle/tree.hpp"

namespace rayclock::oracle {

__extension__ using Int128 = __int128;

/// A hit at o + d num / den, den > 0.
struct ExactHit {
    std::uint32_t primitive = no_primitive;
    Int128 num = 0, den = 1;
    int sense = 0;   ///< 1: the ray enters (see Passage), -1: it leaves

    /// Returns true if this hit is nearer, or equally near with a lower number. num < 2^(3N+1) <= 2^61 and
    /// den < 2^(2N+M+1) <= 2^63, so the products fit.
    bool before(const ExactHit& other) const {
        const Int128 mine = num * other.den, theirs = other.num * den;
        return other.primitive == no_primitive || mine < theirs ||
               (mine == theirs && primitive < other.primitive);
    }
};

/// Returns the scene's triangles on the lattice, by primitive number. Triangles without area are included and
/// never hit.
std::vector<Corners> snapped(const Scene& scene, const Lattice& lattice);

/// Triangles with the oracle's own search tree, which skips no triangle that a ray meets (tree.hpp). Moving
/// the origin by an infinitesimal step does not matter. If the rays of all small steps meet the closed
/// triangle, so does the ray in the limit, and it meets the closed box.
class Surface {
public:
    /// Enlarges the boxes by `margin` lattice steps on all sides. Tests that may accept a triangle which the
    /// ray only nearly meets need a margin.
    explicit Surface(std::vector<Corners> triangles, int margin = 0);

    /// Returns the closest triangle along o + t d, t > 0; of equally close ones the lowest number.
    ExactHit closest(const Vec3i& o, const Vec3i& d) const;

    /// Fills `found` with the numbers of all triangles that the ray may meet; clears it first.
    void candidates(const Vec3i& o, const Vec3i& d, std::vector<std::uint32_t>& found) const;

    /// Calls meet(number) for triangles that may meet the segment between two points, until it returns false.
    /// The margin must be at least one step.
    template <class Meet> void along(const glm::dvec3& from, const glm::dvec3& to, const Meet& meet) const {
        const tree::Ray way(from, to - from);
        bool goes_on = true;
        tree_.nearest_first(
            way, [&](double near) { return !goes_on || near > 2 * way.main_size(); },
            [&](std::uint32_t place) { goes_on = goes_on && meet(tree_.order()[place]); });
    }

    const std::vector<Corners>& triangles() const { return triangles_; }
    /// Returns the bounds of all triangles.
    Extent bounds() const;

private:
    std::vector<Corners> triangles_;
    Tree tree_;
    std::vector<Corners> ordered_;   ///< in the order of the leaves
};

/// Returns the crossing of triangle `primitive`, or no_primitive.
ExactHit exact_hit(const Vec3i& o, const Vec3i& d, const Corners& triangle, std::uint32_t primitive);

}   // namespace rayclock::oracle

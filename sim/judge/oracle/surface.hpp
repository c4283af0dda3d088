#pragma once
// The truth about rays and a whole surface: closest hit and every crossing, in exact integers.
#include <cstdint>
#include <vector>

#include "model/layout/memory_image.hpp"
#include "sim/judge/oracle/cross.hpp"
#include "sim/judge/oracle/tree.hpp"
#include "model/scene/hit.hpp"
#include "model/scene/scene.hpp"

namespace rayclock::oracle {

__extension__ using Int128 = __int128;

/// The hit lies at o + d num / den, den > 0.
struct ExactHit {
    std::uint32_t primitive = no_primitive;
    Int128 num = 0, den = 1;
    int sense = 0;   ///< 1: the ray enters (see Passage), -1: it leaves

    /// Nearer, or as near and of a lower number. num < 2^(3N+1) <= 2^61 and den < 2^(2N+M+1) <= 2^63, so
    /// products fit.
    bool before(const ExactHit& other) const {
        const Int128 mine = num * other.den, theirs = other.num * den;
        return other.primitive == no_primitive || mine < theirs ||
               (mine == theirs && primitive < other.primitive);
    }
};

/// Scene's triangles on the lattice, by primitive number; those without area are there, and never hit.
std::vector<Corners> snapped(const Scene& scene, const Lattice& lattice);

/// Triangles with a search tree of the oracle's own, which skips none that a ray meets (tree.hpp). Moving the
/// origin by an infinitesimal step does not matter: the moved rays of all small steps meet the closed
/// triangle, hence in the limit the ray itself does, and with it the closed box.
class Surface {
public:
    /// Boxes are `margin` lattice steps larger on all sides: for tests that may take a triangle which the ray
    /// only comes near to.
    explicit Surface(std::vector<Corners> triangles, int margin = 0);

    /// Closest triangle along o + t d, t > 0; of equal ones the lowest number.
    ExactHit closest(const Vec3i& o, const Vec3i& d) const;

    /// Numbers of all triangles that the ray may meet; `found` is cleared first.
    void candidates(const Vec3i& o, const Vec3i& d, std::vector<std::uint32_t>& found) const;

    /// Calls meet(number) for triangles that may meet the way between two points anywhere, until it returns
    /// false. The margin must be one step at least.
    template <class Meet> void along(const glm::dvec3& from, const glm::dvec3& to, const Meet& meet) const {
        const tree::Ray way(from, to - from);
        bool goes_on = true;
        tree_.nearest_first(
            way, [&](double near) { return !goes_on || near > 2 * way.main_size(); },
            [&](std::uint32_t place) { goes_on = goes_on && meet(tree_.order()[place]); });
    }

    const std::vector<Corners>& triangles() const { return triangles_; }
    /// Of all triangles.
    Extent bounds() const;

private:
    std::vector<Corners> triangles_;
    Tree tree_;
    std::vector<Corners> ordered_;   ///< as the leaves have them
};

/// The crossing of triangle `primitive`, or no_primitive.
ExactHit exact_hit(const Vec3i& o, const Vec3i& d, const Corners& triangle, std::uint32_t primitive);

}   // namespace rayclock::oracle

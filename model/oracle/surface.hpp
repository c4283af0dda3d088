#pragma once
// The truth about rays and a whole surface: closest hit and every crossing, in exact integers.
#include <cstdint>
#include <vector>

#include "model/accel/memory_image.hpp"
#include "model/oracle/cross.hpp"
#include "model/scene/hit.hpp"
#include "model/scene/scene.hpp"

namespace rayclock::oracle {

__extension__ using Int128 = __int128;

/// The hit lies at o + d num / den, den > 0.
struct ExactHit {
    std::uint32_t primitive = no_primitive;
    Int128 num = 0, den = 1;
    int sense = 0;   ///< 1: the ray enters (see Passage), -1: it leaves

    /// Nearer, or as near and of a lower number. num < 2^(3N+1) <= 2^61 and den < 2^(2N+M+1) <= 2^63, so products fit.
    bool before(const ExactHit& other) const {
        const Int128 mine = num * other.den, theirs = other.num * den;
        return other.primitive == no_primitive || mine < theirs || (mine == theirs && primitive < other.primitive);
    }
};

/// Scene's triangles on the lattice, by primitive number; those without area are there, and never hit.
std::vector<Corners> snapped(const Scene& scene, const Lattice& lattice);

/// Triangles with a search tree of the oracle's own: four children a node, split at medians, boxes in whole lattice steps.
///
/// No triangle that a ray meets is skipped. A subtree is passed over only if no point o + s d, s >= 0, lies in the closed box
/// around its triangles, for one of these reasons, each of which rules that out by itself:
///  - on some axis the box lies behind the origin;
///  - for two axes i and j, f(p) = d_i (p_j - o_j) - d_j (p_i - o_i), which is 0 along the whole ray, has one sign in all of
///    the box (f is linear, so its extremes are centre +- half widths; this includes d_i = 0 and the box beside the ray);
///  - for `closest`, the ray reaches the box's near plane of some axis after the best hit.
/// Moving the origin by an infinitesimal step does not matter: the moved rays of all small steps meet the closed triangle,
/// hence in the limit the ray itself does, and with it the closed box. All values are whole numbers below 2^53 (twice a
/// difference times a direction: N + 2 + M bits, and a sum), so doubles hold them exactly.
class Surface {
public:
    /// Boxes are `margin` lattice steps larger on all sides: for tests that may take a triangle which the ray only comes near to.
    explicit Surface(std::vector<Corners> triangles, int margin = 0);
    ~Surface();

    /// Closest triangle along o + t d, t > 0; of equal ones the lowest number.
    ExactHit closest(const Vec3i& o, const Vec3i& d) const;

    /// Numbers of all triangles that the ray may meet; `found` is cleared first.
    void candidates(const Vec3i& o, const Vec3i& d, std::vector<std::uint32_t>& found) const;

    const std::vector<Corners>& triangles() const { return triangles_; }

private:
    struct Node;
    std::uint32_t build(std::uint32_t first, std::uint32_t count);

    std::vector<Corners> triangles_;
    int margin_ = 0;
    std::vector<Corners> ordered_;        ///< as the leaves have them
    std::vector<std::uint32_t> order_;    ///< their numbers
    std::vector<Node> nodes_;
    std::uint32_t root_ = ~0u;   ///< none
};

/// The crossing of triangle `primitive`, or no_primitive.
ExactHit exact_hit(const Vec3i& o, const Vec3i& d, const Corners& triangle, std::uint32_t primitive);

} // namespace rayclock::oracle

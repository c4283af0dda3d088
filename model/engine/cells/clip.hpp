#pragma once
// The part of a primitive that lies in a cell of a kd-tree.
#include <optional>
#include <span>

#include "model/layout/tree.hpp"

namespace rayclock::cells {

/// A cell's side of a plane in any direction: n . x <= at, or >= at on the upper side.
struct Wall {
    Vec3i normal{};
    std::int32_t at = 0;
    bool upper = false;
};
using Walls = std::span<const Wall>;
constexpr std::size_t most_walls = 40;

/// Returns bounds, rounded outward, of the part of a primitive in a closed cell, or nothing if it has no part
/// there. The bounds are never too small, and a primitive with a point in the cell is never lost.
///
/// A triangle is clipped to the cell by Sutherland and Hodgman's method in double precision, with a cell that
/// is `slack` larger on all sides. In each of the six clips the new corners are within 2^-29 of the exact
/// ones of the input polygon. The way to the plane is a difference of two doubles, exact except for its last
/// bit, and so is the quotient. So a point of the triangle in the cell is within 6 * 2^-29 of the final
/// polygon, and no clip by a plane that is `slack` away removes it. The bounds are rounded outward by more
/// than that.
///
/// A sphere's surface counts unless the cell lies a step outside its radius, or two steps inside it. For a
/// full box the result is the intersection of both boxes; walls never cut it. docs/proofs/bsp.md covers
/// walls.
class Clipper {
public:
    /// `margin`: most steps between a hit and its primitive.
    Clipper(const PrimData& prim, int coord_bits, int margin);
    /// For a full box: an instance in the scene's tree (levels/upper.hpp).
    explicit Clipper(const LatticeBox& solid) : bounds_(solid), is_full_(true) {}
    std::optional<LatticeBox> operator()(const LatticeBox& cell, Walls walls = {}) const;
    /// The range of n . x over everything that may be hit, in whole numbers rounded outward. It is exact for
    /// a triangle.
    struct Reach {
        std::int64_t lo = 0, hi = 0;
    };
    Reach reach(const Vec3i& normal) const;

private:
    std::optional<LatticeBox> triangle(const LatticeBox& cell, Walls walls) const;
    bool meets_sphere(const LatticeBox& cell) const;

    PrimData prim_;
    LatticeBox bounds_;   ///< of the whole primitive
    double margin_ = 0;
    std::int64_t radius_ = 0;   ///< of a sphere, rounded up
    bool hollow_ = true;        ///< the whole sphere lies in the lattice, so its interior has no hit
    bool is_full_ = false;      ///< it is a full box
};

}   // namespace rayclock::cells

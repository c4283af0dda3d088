#pragma once
// The part of a primitive that lies in a cell of space.
#include <optional>
#include <span>

#include "model/layout/tree.hpp"

namespace rayclock::space_cells {

/// A cell's side of a plane in any direction: n . x <= at, or >= at on the upper side.
struct Wall {
    Vec3i normal{};
    std::int32_t at = 0;
    bool upper = false;
};
using Walls = std::span<const Wall>;
constexpr std::size_t max_walls = 40;

/// Returns bounds, rounded outward, of the part of a primitive in a closed cell, or nothing if it has no part
/// there. The bounds are never too small, and a primitive with a point in the cell is never lost.
///
/// A triangle is clipped by Sutherland and Hodgman's method in double precision, to a cell that is `slack`
/// larger on all sides. In each of the six clips the new corners are within 2^-29 of the exact corners of the
/// clipped input polygon. Distances to the plane are differences of two doubles. They and their quotient are
/// exact except for the last bit. So a point of the triangle in the cell is within 6 * 2^-29 of the final
/// polygon, and no clip by a plane that is `slack` away removes it. The bounds are rounded outward by more
/// than 6 * 2^-29.
///
/// A sphere has no part in a cell that lies a step outside its radius, or two steps inside it. For a full
/// box the result is the intersection of both boxes; walls never cut it. docs/proofs/bsp.md covers
/// walls.
class Clipper {
public:
    /// `margin`: the largest distance between a hit and its primitive, in steps.
    Clipper(const PrimData& prim, int coord_bits, int margin);
    /// For a full box: an instance in the scene's tree (levels/upper.hpp).
    explicit Clipper(const LatticeBox& solid) : bounds_(solid), is_full_(true) {}
    std::optional<LatticeBox> operator()(const LatticeBox& cell, Walls walls = {}) const;
    /// The range of n . x over all points that may be hit, rounded outward to whole numbers. It is exact for
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

}   // namespace rayclock::space_cells

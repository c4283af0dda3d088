#pragma once
// What of a primitive lies in a cell of a kd-tree.
#include <optional>
#include <span>

#include "model/layout/tree.hpp"

namespace rayclock::kd {

/// A side of a plane in any direction that a cell lies on: n . x <= at, or >= at on the upper side.
struct Wall {
    Vec3i normal{};
    std::int32_t at = 0;
    bool upper = false;
};
using Walls = std::span<const Wall>;
constexpr std::size_t most_walls = 40;

/// Bounds, rounded outward, of what of a primitive lies in a closed cell; nothing if nothing does. What is
/// given is never too small, and a primitive that has a point in the cell is never lost.
///
/// A triangle is clipped to the cell by Sutherland and Hodgman's method in double precision, to a cell that
/// is `slack` larger on all sides. Of each of the six clips the new corners are within 2^-29 of exact ones of
/// the polygon that it was given: the way to the plane is a difference of two doubles, exact but for its last
/// bit, and so is the quotient. So a point of the triangle in the cell is within 6 * 2^-29 of the polygon at
/// the end, and no clip by a plane that is `slack` away takes it off. The bounds are rounded outward by more
/// than that. A sphere's surface is there unless the cell lies a step outside its radius, or two inside it.
/// A full box has what both boxes have in common; walls, which it is never cut by, take nothing off.
/// Of walls, which lie in any direction: docs/bsp.md.
class Clipper {
public:
    /// `margin`: steps by which a hit may lie beside its primitive.
    Clipper(const PrimData& prim, int coord_bits, int margin);
    /// Of a box, which is full: what an instance is in the scene's tree (levels/upper.hpp).
    explicit Clipper(const LatticeBox& solid) : bounds_(solid), is_full_(true) {}
    std::optional<LatticeBox> operator()(const LatticeBox& cell, Walls walls = {}) const;
    /// How far n . x of all that may be hit reaches, in whole numbers rounded outward; exact of a triangle.
    struct Reach {
        std::int64_t lo = 0, hi = 0;
    };
    Reach reach(const Vec3i& normal) const;

private:
    std::optional<LatticeBox> triangle(const LatticeBox& cell, Walls walls) const;
    bool meets_sphere(const LatticeBox& cell) const;

    PrimData prim_;
    LatticeBox bounds_;   ///< of all of it
    double margin_ = 0;
    std::int64_t radius_ = 0;   ///< of a sphere, rounded up
    bool hollow_ = true;        ///< all of the sphere lies in the lattice: no hit is in it
    bool is_full_ = false;      ///< it is a box
};

}   // namespace rayclock::kd

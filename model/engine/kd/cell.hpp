#pragma once
// Cells of space, and what of the primitives lies in them: what every structure of planes is built of.
#include <memory>
#include <vector>

#include "model/engine/kd/clip.hpp"

namespace rayclock::kd {

/// A cell of space: cut by a plane, not cut but walked in two parts (no_axis, a normal of zeros), or a leaf.
struct Cell {
    std::uint32_t axis = no_axis;   ///< if there are parts
    Vec3i normal{};                 ///< of planes in any direction, in place of an axis
    std::int32_t at = 0;
    LatticeBox bounds;   ///< of what is in it; inverted if nothing is, or it has no end
    std::unique_ptr<Cell> lower, upper;
    std::vector<std::uint32_t> prims;   ///< of a leaf: which of those given to the builder
    std::uint32_t count = 0;            ///< of primitives in it, in all its parts
    bool begins = false;                ///< a treelet, even if the one that it is met in has planes left
    float lower_share = 1, upper_share = 1;   ///< of its surface, if a plane in any direction cuts it
    double inside = 0;   ///< the cost of all below, if it begins a treelet (treelets.hpp)
    bool is_leaf() const { return !lower; }
};
using CellPtr = std::unique_ptr<Cell>;

struct Item {
    std::uint32_t prim = 0;
    LatticeBox box;   ///< of what lies in the cell
};
using Items = std::vector<Item>;

inline LatticeBox bounds_of(const Items& items) {
    LatticeBox bounds;
    for (const Item& item : items) bounds.add(item.box);
    return bounds;
}
/// A cell that is not cut.
CellPtr leaf_of(const Items& items);

/// A plane cuts a cell in two.
struct Cut {
    std::size_t axis = no_axis;   ///< no_axis: it lies in any direction
    std::int32_t plane = 0;       ///< x_axis, or n . x
    bool flat_above = false;      ///< on which side is what lies in the plane
    Vec3i normal{};
    bool is_there() const { return axis != no_axis || normal != Vec3i{}; }
};

/// What is known of where a cell lies: it is in the box, and on its side of each wall.
struct Region {
    LatticeBox box;
    std::vector<Wall> walls{};
    std::size_t own = 0;   ///< walls from here on are of the treelet that the cell is in
    /// One side of a cut.
    Region part(const Cut& cut, bool upper) const;
};

/// The primitives of a scene, as far as they have an end; or boxes.
class Pieces {
public:
    Pieces(const std::vector<PrimData>& prims, const Config& config);
    /// Of full boxes, which must lie in the lattice. One that is all of it has no end.
    Pieces(const std::vector<LatticeBox>& boxes, const Config& config);
    std::size_t size() const { return clippers_.size(); }
    /// All of them, in all of space.
    Items all() const;
    const LatticeBox& space() const { return space_; }
    const Clipper& of(std::uint32_t prim) const { return clippers_[prim]; }
    /// What lies on both sides of a cut through a cell. A primitive is below a plane if some of it is
    /// strictly below, and above likewise. What lies in the plane goes to one side: a ray that meets it there
    /// is on both.
    void divide(const Items& items, const Region& region, const Cut& cut, Items& lower, Items& upper) const;
    /// How far n . x of an item reaches, rounded outward.
    Clipper::Reach reach(const Item& item, const Vec3i& normal) const;
    /// The tree over all of them, with the planes without end beside it in a part of their own.
    CellPtr with_endless(CellPtr tree) const;
    bool has_endless() const { return !endless_.empty(); }

private:
    void take(const Item& item, const Region& region, Items& out) const;

    std::vector<Clipper> clippers_;
    std::vector<std::uint32_t> endless_;
    LatticeBox space_;
};

}   // namespace rayclock::kd

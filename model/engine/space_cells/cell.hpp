#pragma once
// Cells of space and the primitives in them, from which every structure of planes is made.
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "model/core/config.hpp"
#include "model/engine/space_cells/axis.hpp"
#include "model/engine/space_cells/clip.hpp"

namespace rayclock::space_cells {

/// A cell of space: cut by a plane, walked in two parts without a cut (no_axis, a normal of zeros), or a
/// leaf.
struct Cell {
    std::uint32_t axis = no_axis;   ///< if there are parts
    Vec3i normal{};                 ///< replaces the axis for planes in any direction
    std::int32_t at = 0;
    LatticeBox bounds;   ///< of its contents; inverted if empty or infinite
    std::unique_ptr<Cell> lower, upper;
    std::vector<std::uint32_t> prims;         ///< of a leaf: numbers of primitives as given to the builder
    std::uint32_t count = 0;                  ///< number of primitives in all its parts
    bool begins = false;                      ///< begins a treelet, even if the treelet above has planes left
    float lower_share = 1, upper_share = 1;   ///< shares of its surface, if a plane in any direction cuts it
    double inside = 0;   ///< the cost of everything below, if it begins a treelet (treelets.hpp)
    bool is_leaf() const { return !lower; }
};
using CellPtr = std::unique_ptr<Cell>;

struct Item {
    std::uint32_t prim = 0;
    LatticeBox box;   ///< of the part in the cell
};
using Items = std::vector<Item>;

inline LatticeBox bounds_of(const Items& items) {
    LatticeBox bounds;
    for (const Item& item : items) bounds.add(item.box);
    return bounds;
}
/// Returns a cell that is not cut.
CellPtr leaf_of(const Items& items);

/// A plane that cuts a cell in two.
struct Cut {
    std::size_t axis = no_axis;   ///< no_axis: the plane may have any direction
    std::int32_t plane = 0;       ///< coordinate on the axis, or n . x
    bool flat_above = false;      ///< items in the plane go to the upper side
    Vec3i normal{};
    bool is_there() const { return axis != no_axis || normal != Vec3i{}; }
};

/// The space that surely contains a cell: inside the box, and on one side of each wall.
struct Region {
    LatticeBox box;
    std::vector<Wall> walls{};
    std::size_t own = 0;   ///< walls from here on belong to the cell's treelet
    /// Returns one side of a cut.
    Region part(const Cut& cut, bool upper) const;
};

/// The finite primitives of a scene, or boxes.
class Pieces {
public:
    Pieces(const std::vector<PrimData>& prims, const Config& config);
    /// Takes full boxes, which must lie in the lattice. A box that fills the lattice counts as infinite.
    Pieces(const std::vector<LatticeBox>& boxes, const Config& config);
    std::size_t size() const { return clippers_.size(); }
    /// Returns all pieces, clipped to space.
    Items all() const;
    const LatticeBox& space() const { return space_; }
    const Clipper& of(std::uint32_t prim) const { return clippers_[prim]; }
    /// Distributes the items of a cell to both sides of a cut. A primitive goes to each side that contains a
    /// part of it off the plane. An item in the plane goes to one side only: a ray that meets it is on both
    /// sides there.
    void divide(const Items& items, const Region& region, const Cut& cut, Items& lower, Items& upper) const;
    /// Returns the range of n . x over an item, rounded outward.
    Clipper::Reach reach(const Item& item, const Vec3i& normal) const;
    /// Returns the tree over all pieces, with infinite planes in a separate part next to it.
    CellPtr with_endless(CellPtr tree) const;
    bool has_endless() const { return !endless_.empty(); }
    /// A builder calls tell() for every cell, on any thread. `report` may throw to stop the builder.
    void report_to(std::function<void()> report) { report_ = std::move(report); }
    void tell() const {
        if (report_) report_();
    }

private:
    void take(const Item& item, const Region& region, Items& out) const;

    std::vector<Clipper> clippers_;
    std::vector<std::uint32_t> endless_;
    LatticeBox space_;
    std::function<void()> report_;
};

}   // namespace rayclock::space_cells

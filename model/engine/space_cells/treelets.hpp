#pragma once
// Chooses the cells of a tree that begin a treelet, and the cuts to undo.
#include "model/core/config.hpp"
#include "model/engine/space_cells/cell.hpp"

namespace rayclock::space_cells {

/// The chip visits treelets, so the cost depends on which planes share one. Dynamic programming from the
/// leaves up chooses them, as for the box tree (collapse.hpp). Each cell under a treelet's root has one of
/// three roles: it is a leaf, it begins a new treelet, or a plane of the treelet cuts it, if any are left.
///
/// Planes of a treelet are free. A visit costs 17 per level of planes, a test 20. Each is weighted by the
/// probability that a ray that meets the tree's root also meets the cell. The estimate of this probability is
/// the surface of the part of the treelet's box that the planes leave. So treelets near the leaves are full,
/// and a plane that does not justify a visit is undone.
class Treelets {
public:
    explicit Treelets(const Config& config);
    /// Returns Cell::inside of a cell whose parts all have theirs.
    double inside(const Cell& cell) const;
    /// Marks all treelets of a tree, and makes leaves. The root begins a treelet. With `under` it lies in one
    /// instead, below a plane that cuts nothing.
    void settle(Cell& root, bool under) const;

private:
    /// The known extent of an exit's cell: a box, and roughly the cell's share of the box's surface.
    struct Space {
        LatticeBox box;
        double share = 1;
        double area() const { return share * box.area(); }
    };
    enum class Role { leaf, root, cut };
    struct Choice {
        double cost = 0;
        Role role = Role::leaf;
    };
    static Space part(const Space& space, const Cell& cell, bool upper);
    /// Returns the best role of a cell if the treelet has `levels` levels of planes left.
    Choice best(const Cell& cell, const Space& space, int levels) const;
    double parts(const Cell& cell, const Space& space, int levels) const;
    void settle(Cell& cell, const Space& space, int levels) const;
    void settle_parts(Cell& cell, const Space& space, int levels) const;

    int levels_ = 0;
};

}   // namespace rayclock::space_cells

#pragma once
// Which cells of a tree begin a treelet, and which are not cut after all.
#include "model/engine/kd/cell.hpp"
#include "model/core/config.hpp"

namespace rayclock::kd {

/// What the chip visits are treelets, and which planes share one is a choice. It is made by dynamic
/// programming from the leaves up, as the box tree's is (collapse.hpp): under a treelet's root, each cell
/// that is met as one of its exits is a leaf, or a treelet of its own, or is cut on by a plane of the same
/// treelet while it has one. Planes of a treelet are free; a visit costs 50, a test 20, both as often as a
/// ray that meets the root of the tree meets the cell, that is by the surface of what planes have left of the
/// treelet's box. So treelets near the leaves are full, and a plane that is not worth a visit is taken back.
class Treelets {
public:
    explicit Treelets(const Config& config);
    /// Cell::inside of a cell all of whose parts have it.
    double inside(const Cell& cell) const;
    /// Marks all treelets of a tree, and makes leaves. Its root begins one, or is in one `under` another
    /// plane that cuts nothing.
    void settle(Cell& root, bool under) const;

private:
    /// What is known of an exit's cell: a box, and which share of the box's surface it has, about.
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
    /// The best that a cell can be if so many levels of planes are left in the treelet.
    Choice best(const Cell& cell, const Space& space, int levels) const;
    double parts(const Cell& cell, const Space& space, int levels) const;
    void settle(Cell& cell, const Space& space, int levels) const;
    void settle_parts(Cell& cell, const Space& space, int levels) const;

    int levels_ = 0;
};

}   // namespace rayclock::kd

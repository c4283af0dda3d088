#pragma once
// The planes and cells of a node, shared by all writers of cells as lines.
#include "model/engine/space_cells/cell.hpp"

namespace rayclock::space_cells {

/// A cell, or some of a leaf's primitives. A leaf too large for one exit is walked in parts.
struct CellPart {
    const Cell* cell = nullptr;
    std::size_t first = 0, count = 0;   ///< range of a leaf's primitives
    explicit CellPart(const Cell* c = nullptr) : cell(c), count(c ? c->prims.size() : 0) {}
    CellPart(const Cell* c, std::size_t f, std::size_t n) : cell(c), first(f), count(n) {}
    bool is_empty() const { return !cell || (cell->is_leaf() && count == 0); }
    /// True if it is not cut further: one exit of `most` primitives holds it.
    bool is_leaf(std::size_t most) const { return is_empty() || (cell->is_leaf() && count <= most); }
    std::uint32_t prim(std::size_t i) const { return cell->prims[first + i]; }
    CellPart lower() const {
        return cell->is_leaf() ? CellPart(cell, first, count / 2) : CellPart(cell->lower.get());
    }
    CellPart upper() const {
        return cell->is_leaf() ? CellPart(cell, first + count / 2, count - count / 2)
                               : CellPart(cell->upper.get());
    }
};

/// Computes the exits of a node for a part of a cell, with at most `most` primitives in each exit, and writes
/// the node's planes and box. `Engine` is the descriptor of an engine of cells (model/engine/engines.hpp).
template <class Engine> class Exits {
    using Node = typename Engine::Node;

public:
    explicit Exits(std::size_t most) : most_(most) {}

    std::array<CellPart, max_width> of(const CellPart& place, int node_width, Node& node) {
        const LatticeBox& bounds = place.cell->bounds;
        node.open = bounds.lo[0] > bounds.hi[0];
        if (!node.open) node.lo = bounds.lo, node.hi = bounds.hi;
        fill(place, 0, 0, std::size_t(node_width), node);
        return exits_;
    }

private:
    /// Fills the part of the node under plane `plane`, whose exits start at `exit`.
    void fill(const CellPart& place, std::size_t plane, std::size_t exit, std::size_t exits, Node& node) {
        if (exits == 1 || plane + 1 >= max_width) {   // the second condition is for GCC 14's analysis
            exits_[exit] = place;
            return;
        }
        const bool cut = !place.is_leaf(most_) && (plane == 0 || !place.cell->begins);
        if (cut && !place.cell->is_leaf())
            Engine::put(*place.cell, plane, node);
        else
            Engine::put_none(plane, node);
        fill(cut ? place.lower() : place, 2 * plane + 1, exit, exits / 2, node);
        fill(cut ? place.upper() : CellPart(), 2 * plane + 2, exit + exits / 2, exits / 2, node);
    }

    std::size_t most_;
    std::array<CellPart, max_width> exits_;
};

}   // namespace rayclock::space_cells

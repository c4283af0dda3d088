#pragma once
// Bounding spheres for the children of a tree's nodes.
#include <functional>

#include "model/engine/bvh/collapse.hpp"
#include "model/engine/spheres/enclose.hpp"

namespace rayclock::spheres {

/// The globe around the contents of each child of each node that the collapse makes of a tree.
class GlobesAround {
public:
    /// `add` appends the beads of one of the tree's boxes. Any thread may call it.
    using AddBeads = std::function<void(std::uint32_t box, std::vector<Bead>& out)>;
    GlobesAround(const BinaryTree& tree, const bvh::Collapse& collapse, const AddBeads& add);
    /// Returns the globe of a child, by its node in the tree.
    const Globe& operator[](std::uint32_t node) const { return globes_[node]; }

private:
    std::vector<Globe> globes_;
};

}   // namespace rayclock::spheres

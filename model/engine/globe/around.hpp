#pragma once
#include <functional>

#include "model/engine/bvh/collapse.hpp"
#include "model/engine/globe/enclose.hpp"

namespace rayclock {

/// The globe around all that is below each child of each node that the collapse makes of a tree.
class GlobesAround {
public:
    /// `add` appends the beads of one of the boxes that the tree was built over; called by any thread.
    using AddBeads = std::function<void(std::uint32_t box, std::vector<Bead>& out)>;
    GlobesAround(const BinaryTree& tree, const Collapse& collapse, const AddBeads& add);
    /// Of a child, by its node in the tree.
    const Globe& operator[](std::uint32_t node) const { return globes_[node]; }

private:
    std::vector<Globe> globes_;
};

}   // namespace rayclock

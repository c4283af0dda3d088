#pragma once
#include "model/accel/collapse.hpp"
#include "model/accel/globe/enclose.hpp"

namespace rayclock {

/// The globe around all primitives below each child of each node that the collapse makes of a tree.
class GlobesAround {
public:
    GlobesAround(const BinaryTree& tree, const Collapse& collapse, const std::vector<PrimData>& prims,
                 const Config& config);
    /// Of a child, by its node in the tree.
    const Globe& operator[](std::uint32_t node) const { return globes_[node]; }

private:
    std::vector<Globe> globes_;
};

}   // namespace rayclock

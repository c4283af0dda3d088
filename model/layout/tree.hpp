#pragma once
// The binary tree over the lattice boxes of a scene's triangles. The builder makes it, the optimiser improves
// it, and the collapse reads it.
//
// All decisions are integer or double arithmetic that does not depend on the order of the work. So the tree
// is the same for every number of threads. Each leaf holds one triangle. The collapse forms larger leaves
// (collapse.hpp).
#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include "model/core/payloads.hpp"

namespace rayclock {

/// A box of lattice points, both corners included. An empty box is inverted.
struct LatticeBox {
    static constexpr std::int32_t far = std::numeric_limits<std::int32_t>::max();
    Vec3i lo{far, far, far}, hi{-far, -far, -far};

    void add(const LatticeBox& other) {
        for (std::size_t k = 0; k < 3; ++k) {
            lo[k] = std::min(lo[k], other.lo[k]);
            hi[k] = std::max(hi[k], other.hi[k]);
        }
    }
    void add(const Vec3i& point) { add(LatticeBox{point, point}); }
    /// Returns half the surface area, exact because extents have at most 20 bits. The box must not be empty.
    double area() const {
        const double x = hi[0] - lo[0], y = hi[1] - lo[1], z = hi[2] - lo[2];
        return x * y + y * z + z * x;
    }
    /// Returns twice the centre along an axis.
    std::int32_t centre(std::size_t axis) const { return lo[axis] + hi[axis]; }
    friend bool operator==(const LatticeBox&, const LatticeBox&) = default;
};
inline LatticeBox merged(LatticeBox a, const LatticeBox& b) {
    a.add(b);
    return a;
}

constexpr std::uint32_t no_node = ~0u;

struct BinaryNode {
    LatticeBox box;
    std::uint32_t left = no_node;    ///< of a leaf: number of its box among those given to the builder
    std::uint32_t right = no_node;   ///< of a leaf: no_node
    bool is_leaf() const { return right == no_node; }
};

struct BinaryTree {
    std::vector<BinaryNode> nodes;
    std::uint32_t root = 0;
};

}   // namespace rayclock

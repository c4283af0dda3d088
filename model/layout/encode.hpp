#pragma once
// Writes nodes and primitives in the form in which memory holds them.
#include <span>

#include "model/layout/tree.hpp"
#include "model/core/config.hpp"

namespace rayclock {

constexpr std::size_t words_per_line = std::size_t(line_bits / 32),
                      words_per_half = std::size_t(half_line_bits / 32);

/// A child of a node to be written: its exact box, and its number of triangles (0: an inner child). Inner
/// children come first.
struct NodeChild {
    LatticeBox box;
    std::uint32_t triangles = 0;
};

/// Returns the node that holds the children, quantised outward. `org` is the minimum corner of all boxes.
/// Each axis has the finest exponent that reaches the maximum corner; lo is rounded down and hi up. So a
/// dequantised box contains the exact one.
Node encode_node(std::span<const NodeChild> children, std::uint32_t base, const Config& config);

/// Writes a payload right-aligned into memory that is zero. `scratch` only saves an allocation.
template <class P>
void write_payload(const P& payload, const Config& config, std::uint32_t* at, Words& scratch) {
    pack(payload, config, scratch);
    std::copy(scratch.begin(), scratch.end(), at);
}

/// Returns plane `k` of a node's child along `axis`, in lattice steps.
inline std::int64_t dequantised(const Node& node, std::uint32_t k, std::size_t axis) {
    return node.org[axis] + (std::int64_t(k) << node.exp[axis]);
}

}   // namespace rayclock

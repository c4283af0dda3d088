#pragma once
// One node and one triangle as they lie in memory.
#include <span>

#include "model/layout/tree.hpp"
#include "model/core/config.hpp"

namespace rayclock {

constexpr std::size_t words_per_line = std::size_t(line_bits / 32),
                      words_per_half = std::size_t(half_line_bits / 32);

/// Children of a node to be, inner ones first: real boxes, and how many triangles (0: an inner child).
struct NodeChild {
    LatticeBox box;
    std::uint32_t triangles = 0;
};

/// Quantises outward: org the minimum corner of all boxes, per axis the finest exponent that reaches the
/// maximum corner, lo rounded down and hi up. So a dequantised box holds the real one.
Node encode_node(std::span<const NodeChild> children, std::uint32_t base, const Config& config);

/// Writes a payload right-aligned into memory that is zero; `scratch` only saves an allocation.
template <class P>
void write_payload(const P& payload, const Config& config, std::uint32_t* at, Words& scratch) {
    pack(payload, config, scratch);
    std::copy(scratch.begin(), scratch.end(), at);
}

/// Plane `k` of a node's child along `axis`, in lattice steps.
inline std::int64_t dequantised(const Node& node, std::uint32_t k, std::size_t axis) {
    return node.org[axis] + (std::int64_t(k) << node.exp[axis]);
}

}   // namespace rayclock

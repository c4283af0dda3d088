// Quantises the child boxes of a node.
#include "model/engine/bvh/encode.hpp"

namespace rayclock::bvh {

namespace {

std::uint32_t ceil_shift(std::uint32_t value, std::uint32_t shift) {
    return (value + (1u << shift) - 1) >> shift;
}

}   // namespace

Node encode_node(std::span<const NodeChild> children, std::uint32_t base, const Config& config) {
    LatticeBox all;
    for (const NodeChild& child : children) all.add(child.box);
    Node node;
    node.org = all.lo;
    node.base = base;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t extent = std::uint32_t(all.hi[k] - all.lo[k]),
                            steps = (1u << config.box_bits) - 1;
        while (ceil_shift(extent, node.exp[k]) > steps) ++node.exp[k];
    }
    for (std::size_t i = 0; i < children.size(); ++i) {
        node.kind[i] = 1 + children[i].triangles;
        for (std::size_t k = 0; k < 3; ++k) {
            node.lo[3 * i + k] = std::uint32_t(children[i].box.lo[k] - node.org[k]) >> node.exp[k];
            node.hi[3 * i + k] = ceil_shift(std::uint32_t(children[i].box.hi[k] - node.org[k]), node.exp[k]);
        }
    }
    return node;
}

}   // namespace rayclock::bvh

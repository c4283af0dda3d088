#pragma once
// The payloads of node units, as far as engines share them, and the resulting leaves. A node unit decides the
// nodes of one structure (NodeUnit in model/machine/links.hpp). Nodes are in model/engine/*/node.hpp.
// payloads.hpp explains the symbols.
#include <array>
#include <cstdint>

#include "model/core/config.hpp"
#include "model/core/layout.hpp"
#include "model/core/lines.hpp"

namespace rayclock {

/// trav -> a node unit: the ray in the form of the slab test, and the node from memory.
template <class Node> struct BoxRayReq {
    std::uint32_t ray = 0;
    Vec3i o{};   ///< with B fraction bits if the chip shades
    std::array<std::uint32_t, 3> neg{}, recip{}, len{};
    Node node;
    template <class V> void fields(V& v, const Config& c) {
        v("ray", ray, c.ray_bits());
        v("o", o, c.origin_width(), 3);
        v("neg", neg, 1, 3);
        v("recip", recip, c.recip_bits + 1, 3);
        v("len", len, exp_bits, 3);
        node.fields(v, c);
    }
};

/// A node unit -> trav: the children that the ray's line meets in front of its origin.
/// Inner children come first, then leaves, each sorted by (t_near, offset). Entries beyond are zero. `count`
/// is 0 for inner children.
struct NodeAnswer {
    std::uint32_t ray = 0;
    std::uint32_t base = 0;
    std::uint32_t inner = 0, leaves = 0;             ///< number of each
    std::array<std::uint32_t, max_width> t_near{};   ///< rounded down
    std::array<std::uint32_t, max_width> offset{};   ///< from base, in half lines
    std::array<std::uint32_t, max_width> count{};
    template <class V> void fields(V& v, const Config& c) {
        v("ray", ray, c.ray_bits());
        v("base", base, c.addr_bits);
        v("inner", inner, c.group_bits());
        v("leaves", leaves, c.group_bits());
        v("t_near", t_near, c.t_bits(), c.node_width);
        v("offset", offset, offset_bits, c.node_width);
        v("count", count, count_bits, c.node_width);
    }
};

/// trav -> list: the leaves of a node that a ray meets, nearest first. Entries beyond are zero. There is at
/// least one leaf, and it is not beyond the ray's distance to beat.
struct Leaves {
    std::uint32_t ray = 0;
    std::uint32_t base = 0;
    std::uint32_t leaves = 0;   ///< number of leaves
    /// Distance at which the ray enters each leaf, rounded down.
    std::array<std::uint32_t, max_width> t_near{};
    /// Offset of the leaf's first primitive from base, in half lines.
    std::array<std::uint32_t, max_width> offset{};
    std::array<std::uint32_t, max_width> count{};   ///< number of its primitives
    template <class V> void fields(V& v, const Config& c) {
        v("ray", ray, c.ray_bits());
        v("base", base, c.addr_bits);
        v("leaves", leaves, c.group_bits());
        v("t_near", t_near, c.t_bits(), c.node_width);
        v("offset", offset, offset_bits, c.node_width);
        v("count", count, count_bits, c.node_width);
    }
};

}   // namespace rayclock

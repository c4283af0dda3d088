#pragma once
// The payloads of the units that decide nodes: trav's requests, the answers, and the resulting leaves.
// payloads.hpp explains the symbols.
#include <array>
#include <cstdint>

#include "model/core/config.hpp"
#include "model/core/layout.hpp"
#include "model/core/lines.hpp"

namespace rayclock {

/// trav -> box: the ray, and the node from memory.
struct BoxReq {
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

/// trav -> treelet: the ray, and the node of a kd-tree from memory.
struct TreeletReq {
    std::uint32_t ray = 0;
    Vec3i o{};
    std::array<std::uint32_t, 3> neg{}, recip{}, len{};
    Treelet treelet;
    template <class V> void fields(V& v, const Config& c) {
        v("ray", ray, c.ray_bits());
        v("o", o, c.origin_width(), 3);
        v("neg", neg, 1, 3);
        v("recip", recip, c.recip_bits + 1, 3);
        v("len", len, exp_bits, 3);
        treelet.fields(v, c);
    }
};

/// trav -> slant: the ray with its direction, and the node with planes in any direction from memory.
struct SlantReq {
    std::uint32_t ray = 0;
    Vec3i o{};
    std::array<std::uint32_t, 3> recip{}, len{};
    Vec3i along{};   ///< direction, shifted up to ray_dir_bits: aligned() in model/engine/bsp/slant.hpp
    Slant slant;
    template <class V> void fields(V& v, const Config& c) {
        v("ray", ray, c.ray_bits());
        v("o", o, c.origin_width(), 3);
        v("recip", recip, c.recip_bits + 1, 3);
        v("len", len, exp_bits, 3);
        v("along", along, c.ray_dir_bits(), 3);
        slant.fields(v, c);
    }
};

/// trav -> globe: the ray in the form of the globe test (globe_ray() in model/engine/globe/globe.hpp), and
/// the node.
struct GlobeReq {
    std::uint32_t ray = 0;
    Vec3i o{};
    Vec3i toward{};          ///< direction, scaled so that its largest component fills toward_bits
    std::uint32_t len = 0;   ///< bits of that component before scaling, as in Ray
    GlobeNode node;
    template <class V> void fields(V& v, const Config& c) {
        v("ray", ray, c.ray_bits());
        v("o", o, c.origin_width(), 3);
        v("toward", toward, toward_bits, 3);
        v("len", len, exp_bits);
        node.fields(v, c);
    }
};

/// box, treelet, globe, slant -> trav: the children that the ray's line meets in front of its origin. Inner
/// children come first, then leaves, each sorted by (t_near, offset). Entries beyond are zero. `count` is 0
/// for inner children.
struct BoxRsp {
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
    std::uint32_t leaves = 0;                        ///< number of leaves
    std::array<std::uint32_t, max_width> t_near{};   ///< distance at which the ray enters each leaf, rounded
                                                     ///< down
    std::array<std::uint32_t, max_width> offset{};   ///< of the leaf's first primitive from base, in half
                                                     ///< lines
    std::array<std::uint32_t, max_width> count{};    ///< number of its primitives
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

#pragma once
// The node of a hierarchy of globes, and the request to globe.
#include <array>
#include <cstdint>

#include "model/core/config.hpp"
#include "model/core/lines.hpp"

namespace rayclock {

/// A node of a hierarchy of globes in a memory line of 64 bytes (right-aligned). A *globe* is a bounding
/// sphere; a *sphere* is a primitive. Only the structure is called "spheres": in the
/// parameter `structure`, and so in the names of this folder and its namespace. Globe i has its centre at org
/// + (centre << exp) and the radius radius << exp, in lattice steps. Kinds and the block at line `base` are
/// those of Node.
struct GlobeNode {
    Vec3i org{};
    std::uint32_t exp = 0;
    std::uint32_t base = 0;
    std::array<std::uint32_t, max_width> kind{};
    std::array<std::uint32_t, 3 * max_width> centre{};   ///< [3 * child + axis]
    std::array<std::uint32_t, max_width> radius{};
    template <class V> void fields(V& v, const Config& c) {
        v("org", org, c.coord_bits, 3);
        v("exp", exp, exp_bits);
        v("base", base, c.addr_bits);
        v("kind", kind, count_bits, c.node_width);
        v("centre", centre, globe_bits, 3 * c.node_width);
        v("radius", radius, globe_bits, c.node_width);
    }
};

/// trav -> globe: the ray in the form of the globe test (globe_ray() in model/engine/spheres/globe.hpp), and
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

}   // namespace rayclock

#pragma once
// The node of a tree of planes in any direction, and the request to slant.
#include <array>
#include <cstdint>

#include "model/core/config.hpp"
#include "model/core/lines.hpp"

namespace rayclock {

/// A node of a tree of planes in any direction, in a memory line of 64 bytes (right-aligned). Plane i holds
/// the lattice points x with `normal`[3 i ..] . x = `at`[i]; its lower side has smaller products. A normal of
/// zeros marks a missing plane. All other fields are those of Treelet.
struct Slant {
    std::uint32_t open = 0;
    Vec3i lo{}, hi{};
    std::array<std::int32_t, 3 * (max_width - 1)> normal{};   ///< [3 * plane + axis]
    std::array<std::int32_t, max_width - 1> at{};
    std::uint32_t base = 0;
    std::array<std::uint32_t, max_width> kind{};
    template <class V> void fields(V& v, const Config& c) {
        v("open", open, 1);
        v("lo", lo, c.coord_bits, 3);
        v("hi", hi, c.coord_bits, 3);
        v("normal", normal, normal_step_bits, 3 * c.planes_of_node());
        v("at", at, c.offset_of_plane_bits(), c.planes_of_node());
        v("base", base, c.addr_bits);
        v("kind", kind, count_bits, c.node_width);
    }
};

/// trav -> slant: the ray with its direction, and the node with planes in any direction from memory.
struct SlantReq {
    std::uint32_t ray = 0;
    Vec3i o{};
    std::array<std::uint32_t, 3> recip{}, len{};
    Vec3i along{};   ///< direction, shifted up to ray_dir_bits: slant_direction() in
                     ///< model/engine/bsp/slant.hpp
    Slant node;
    template <class V> void fields(V& v, const Config& c) {
        v("ray", ray, c.ray_bits());
        v("o", o, c.origin_width(), 3);
        v("recip", recip, c.recip_bits + 1, 3);
        v("len", len, exp_bits, 3);
        v("along", along, c.ray_dir_bits(), 3);
        node.fields(v, c);
    }
};

}   // namespace rayclock

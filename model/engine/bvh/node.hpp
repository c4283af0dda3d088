#pragma once
// The node of a tree of boxes, and the request to box.
#include <array>
#include <cstdint>

#include "model/core/config.hpp"
#include "model/core/lines.hpp"
#include "model/core/node_payloads.hpp"

namespace rayclock {

/// A node of a tree of boxes in a memory line of 64 bytes (right-aligned). Child boxes are quantised relative
/// to `org`: plane k lies at org + (k << exp). kind: 0 empty, 1 inner node, 1 + n a leaf of n triangles.
/// Inner children come first. The block of children starts at line `base`: one line per inner child in slot
/// order, then the leaves' triangles, 32 bytes each.
struct Node {
    Vec3i org{};
    std::array<std::uint32_t, 3> exp{};
    std::uint32_t base = 0;
    std::array<std::uint32_t, max_width> kind{};
    std::array<std::uint32_t, 3 * max_width> lo{}, hi{};   ///< [3 * child + axis]
    template <class V> void fields(V& v, const Config& c) {
        v("org", org, c.coord_bits, 3);
        v("exp", exp, exp_bits, 3);
        v("base", base, c.addr_bits);
        v("kind", kind, count_bits, c.node_width);
        v("lo", lo, c.box_bits, 3 * c.node_width);
        v("hi", hi, c.box_bits, 3 * c.node_width);
    }
};

using BoxReq = BoxRayReq<Node>;

}   // namespace rayclock

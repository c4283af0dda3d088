#pragma once
// The node of a kd-tree, and the request to treelet.
#include <array>
#include <cstdint>

#include "model/core/config.hpp"
#include "model/core/lines.hpp"
#include "model/core/node_payloads.hpp"

namespace rayclock {

/// A node of a kd-tree in a memory line of 64 bytes (right-aligned): a treelet of log2 W levels of planes.
/// The closed box `lo`..`hi` bounds the contents of its cell; with `open` set, the box is ignored.
///
/// Planes are in heap order: plane 0 cuts the treelet's cell, planes 1 and 2 cut its lower and upper half,
/// and so on. Plane i lies at `at`[i] on axis `axis`[i]. Axis 3 marks a missing plane, whose two sides are
/// the whole cell. Exit 0 is on the lower side of all planes on its way, exit W - 1 on the upper side.
///
/// kind: 0 empty, 1 a treelet, 1 + n a leaf of n primitives. The block at line `base` holds one line for each
/// exit to a treelet, in order, then the leaves' primitives, 32 bytes each.
struct Treelet {
    std::uint32_t open = 0;
    Vec3i lo{}, hi{};
    std::array<std::uint32_t, max_width - 1> axis{};
    std::array<std::int32_t, max_width - 1> at{};
    std::uint32_t base = 0;
    std::array<std::uint32_t, max_width> kind{};
    template <class V> void fields(V& v, const Config& c) {
        v("open", open, 1);
        v("lo", lo, c.coord_bits, 3);
        v("hi", hi, c.coord_bits, 3);
        v("axis", axis, 2, c.planes_of_node());
        v("at", at, c.coord_bits, c.planes_of_node());
        v("base", base, c.addr_bits);
        v("kind", kind, count_bits, c.node_width);
    }
};

using TreeletReq = BoxRayReq<Treelet>;

}   // namespace rayclock

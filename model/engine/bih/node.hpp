#pragma once
// The node of a bounding interval hierarchy, and the request to bih.
#include <array>
#include <cstdint>

#include "model/core/config.hpp"
#include "model/core/lines.hpp"
#include "model/core/node_payloads.hpp"

namespace rayclock {

/// A node of a bounding interval hierarchy in a memory line of 64 bytes (right-aligned): log2 W levels of
/// pairs of planes across one axis each (Waechter and Keller 2006, "Instant ray tracing: the bounding
/// interval hierarchy"). The lower half holds primitives up to `lower_to`, the upper half primitives from
/// `upper_from` on. The halves may overlap, or leave a gap. Every primitive is in one half only.
///
/// Pairs are in heap order, and exits, kinds and the block at line `base` are those of a treelet
/// (kd/node.hpp). Axis 3 marks a missing pair, whose two halves are the whole cell. The box `lo`..`hi` bounds
/// the contents, because a ray's stack keeps no interval of the ray; with `open` set, the box is ignored.
struct BihNode {
    std::uint32_t open = 0;
    Vec3i lo{}, hi{};
    std::array<std::uint32_t, max_width - 1> axis{};
    std::array<std::int32_t, max_width - 1> lower_to{}, upper_from{};
    std::uint32_t base = 0;
    std::array<std::uint32_t, max_width> kind{};
    template <class V> void fields(V& v, const Config& c) {
        v("open", open, 1);
        v("lo", lo, c.coord_bits, 3);
        v("hi", hi, c.coord_bits, 3);
        v("axis", axis, 2, c.planes_of_node());
        v("lower_to", lower_to, c.coord_bits, c.planes_of_node());
        v("upper_from", upper_from, c.coord_bits, c.planes_of_node());
        v("base", base, c.addr_bits);
        v("kind", kind, count_bits, c.node_width);
    }
};

using BihReq = BoxRayReq<BihNode>;

}   // namespace rayclock

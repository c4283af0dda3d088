#pragma once
// A node unit's answer in the parts that trav keeps and sends on.
#include "model/core/payloads.hpp"

namespace rayclock {

/// The inner children of a node that a ray meets, nearest first. trav keeps this part of the answer until the
/// node's leaves are tested. Entries beyond `inner` are ignored.
struct Children {
    std::uint32_t base = 0;
    std::uint32_t inner = 0;
    std::array<std::uint32_t, max_width> t_near{};
    std::array<std::uint32_t, max_width> slot{};   ///< line from base
    template <class V> void fields(V& v, const Config& c) {
        v("base", base, c.addr_bits);
        v("inner", inner, c.group_bits());
        v("t_near", t_near, c.t_bits(), c.node_width);
        v("slot", slot, c.slot_bits(), c.node_width);
    }
};

/// Return the two parts of a node unit's answer.
Children children_of(const NodeAnswer& answer);
Leaves leaves_of(const NodeAnswer& answer);

}   // namespace rayclock

#pragma once
// Don't-care outputs: no unit reads them, so a replaced unit may drive them with any value. Elastic
// verification does not compare them, and `rayclock template` lists them. The table has a row for each rule.
#include <array>
#include <cstdint>

#include "model/core/payloads.hpp"
#include "model/machine/links.hpp"

namespace rayclock {

/// A rule for the payload of one link.
struct DontCare {
    Unit unit;   ///< that gives the value; another unit may pass it on
    Link link;
    const char* fields;
    const char* when;
};
/// trav passes the entries of an answer on to list, which does not read them either.
inline constexpr auto dont_cares = [] {
    constexpr const char *fields = "t_near, offset, count", *beyond = "in the entries from inner + leaves on",
                         *beyond_leaves = "in the entries from leaves on";
    std::array<DontCare, 2 + 2 * node_units.size()> all{
        DontCare{Unit::tri, Link::tri_rsp, "num, det, prim, t, u, v, back", "if closer is 0"},
        DontCare{Unit::trav, Link::leaves, fields, beyond_leaves}};
    std::size_t n = 2;
    for (const NodeUnit& u : node_units) {
        all[n++] = {u.unit, u.rsp, fields, beyond};
        all[n++] = {u.unit, Link::leaves, fields, beyond_leaves};
    }
    return all;
}();
/// Returns true if one of the units marked in `free` may drive the fields of a rule for this link.
constexpr bool is_free(Link link, const std::array<bool, unit_count>& free) {
    for (const DontCare& rule : dont_cares)
        if (rule.link == link && free[index(rule.unit)]) return true;
    return false;
}

/// Copies the don't-care fields of `wanted` to `got`. The values in `wanted` decide which fields these are.
template <class P> void drop_dont_care(Link, const P&, P&) {}
inline void drop_dont_care(Link, const TriRsp& wanted, TriRsp& got) {
    if (wanted.closer || got.closer) return;
    const std::uint32_t ray = got.ray;
    got = wanted;
    got.ray = ray;
}
/// Copies the entries of a node's answer, or of its leaves, from number `first` on.
template <class P> void copy_entries(std::size_t first, const P& wanted, P& got) {
    for (std::size_t i = first; i < wanted.t_near.size(); ++i) {
        got.t_near[i] = wanted.t_near[i];
        got.offset[i] = wanted.offset[i];
        got.count[i] = wanted.count[i];
    }
}
inline void drop_dont_care(Link, const NodeAnswer& wanted, NodeAnswer& got) {
    copy_entries(wanted.inner + wanted.leaves, wanted, got);
}
inline void drop_dont_care(Link, const Leaves& wanted, Leaves& got) {
    copy_entries(wanted.leaves, wanted, got);
}

}   // namespace rayclock

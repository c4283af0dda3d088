#pragma once
// Outputs that nobody reads: a unit of one's own may drive them as it likes. Elastic verification does not
// compare them, and `rayclock template` lists them. One row for each rule.
#include <array>
#include <cstdint>

#include "model/core/payloads.hpp"
#include "model/machine/links.hpp"

namespace rayclock {

/// A rule for the payload of one link.
struct DontCare {
    Unit unit;   ///< that drives the link
    Link link;
    const char* fields;
    const char* when;
};
inline constexpr std::array dont_cares{
    DontCare{Unit::tri, Link::tri_rsp, "num, det, prim, t, u, v, back", "closer is 0"},
    DontCare{Unit::box, Link::box_rsp, "t_near, offset, count", "entries from inner + leaves on"},
};
/// Returns true if a rule exists for the link.
constexpr bool has_dont_care(Link link) {
    for (const DontCare& rule : dont_cares)
        if (rule.link == link) return true;
    return false;
}

/// Makes the fields equal in both payloads that nobody reads. `wanted` decides which ones these are.
template <class P> void drop_dont_care(Link, const P&, P&) {}
inline void drop_dont_care(Link, const TriRsp& wanted, TriRsp& got) {
    if (wanted.closer || got.closer) return;
    const std::uint32_t ray = got.ray;
    got = wanted;
    got.ray = ray;
}
inline void drop_dont_care(Link link, const BoxRsp& wanted, BoxRsp& got) {
    if (link != Link::box_rsp) return;
    for (std::size_t i = wanted.inner + wanted.leaves; i < wanted.t_near.size(); ++i) {
        got.t_near[i] = wanted.t_near[i];
        got.offset[i] = wanted.offset[i];
        got.count[i] = wanted.count[i];
    }
}

}   // namespace rayclock

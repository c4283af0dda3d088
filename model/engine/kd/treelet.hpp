#pragma once
// The unit treelet: nodes of planes across the axes.
#include "model/engine/kd/node.hpp"
#include "model/engine/space_cells/decide.hpp"

namespace rayclock {

/// A treelet unpacked for the model.
struct WideTreelet : WideExits {
    using WideExits::WideExits;
    std::array<std::uint8_t, max_width - 1> axis{};
    std::array<std::int32_t, max_width - 1> at{};
};
WideTreelet widen(const Treelet& treelet, int node_width);

/// Returns the exits of a treelet that a ray meets, conservatively. It never leaves out an exit in whose
/// closed cell the ray has a point o + s d with s > 0, and the exit's t_near is never beyond that point
/// (docs/proofs/planes.md).
///
/// With r and x as in the box test (bvh/box.hpp), let w be the way from the origin to a plane, along the ray
/// and in lattice steps. It is rounded down to w_lo and up to w_hi. The ray enters the far side at f =
/// floor(2^x r w_lo) at the earliest. It leaves the near side at f + floor(f / 2^(R-1)) + 2 + 2^(x+R) (w_hi -
/// w_lo) at the latest. If w_hi <= 0, the ray is on the far side only, from the start. For a ray that does
/// not move on the axis, only the side matters. An exit is met if the latest entry on its way is not beyond
/// the earliest end. Mirror of rtl/engine/kd/rc_treelet.sv, latency kd::Engine::latency() + 1, one treelet
/// per cycle.
///
/// Returns the children of `exits` that are met, one bit each, and writes t_near by child.
std::uint32_t treelet_exits(const BoxRay& ray, const WideTreelet& treelet, const Config& config,
                            std::uint32_t* t_near);
/// Returns the unit's answer.
inline NodeAnswer treelet(const TreeletReq& req, const Config& config) {
    const WideTreelet wide = widen(req.node, config.node_width);
    std::array<std::uint32_t, max_width> t_near;
    const std::uint32_t hits =
        treelet_exits({req.o, req.neg, req.recip, req.len}, wide, config, t_near.data());
    return node_answer(req.ray, hits, t_near.data(), wide.exits);
}

}   // namespace rayclock

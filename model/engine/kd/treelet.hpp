#pragma once
#include "model/engine/bvh/box.hpp"

namespace rayclock {

/// The exits of a treelet (or a slant, model/engine/bsp) unpacked for the model. They are told as children of
/// a node are, inner ones first, so that what follows (trav, list) need not know which structure they come
/// from; `exit` says where each of them lies.
struct WideExits {
    WideNode exits;                               ///< no planes, org and exp
    std::array<std::uint8_t, max_width> exit{};   ///< [child]
    bool open = false;                            ///< has no box
    Vec3i lo{}, hi{};

    WideExits() = default;
    template <class Line> WideExits(const Line& line, int node_width)
        : open(line.open != 0), lo(line.lo), hi(line.hi) {
        place(line.base, line.kind, std::size_t(node_width));
    }

private:
    void place(std::uint32_t base, const std::array<std::uint32_t, max_width>& kind, std::size_t width);
};
/// A treelet unpacked.
struct WideTreelet : WideExits {
    using WideExits::WideExits;
    std::array<std::uint8_t, max_width - 1> axis{};
    std::array<std::int32_t, max_width - 1> at{};
};
WideTreelet widen(const Treelet& treelet, int node_width);

/// What a plane says of a ray: where on it the side that the ray meets first may end, and the other may
/// begin.
struct PlaneSides {
    bool near = true, far = true;   ///< whether the ray may be on the side that it meets first; on the other
    bool turned = false;            ///< the ray meets the upper side first
    std::uint32_t near_to = 0;      ///< no point of the near side is beyond
    std::uint32_t far_from = 0;     ///< no point of the far side is before
};
PlaneSides plane_sides(const BoxRay& ray, std::uint32_t axis, std::int32_t at, const Config& config);

/// Of all planes of a treelet, in the order of a heap.
using AllSides = std::array<PlaneSides, max_width - 1>;
/// The exits that are met within the box, bit by bit, and t_near by child.
std::uint32_t exits_met(const BoxRay& ray, const WideExits& treelet, const AllSides& sides,
                        const Config& config, std::uint32_t* t_near);

/// Which exits of a treelet a ray meets, conservative: an exit in whose closed cell the ray has a point o + s
/// d with s > 0 is never left out, and its t_near is never beyond that point (docs/planes.md).
///
/// With r and x as in the box test (box.hpp), the way w from the origin to a plane, along the ray and in
/// lattice steps, is rounded down to w_lo and up to w_hi. The far side is entered at f = floor(2^x r w_lo) at
/// the earliest, the near side left at f + floor(f / 2^(R-1)) + 2 + 2^(x+R) (w_hi - w_lo) at the latest. If
/// w_hi <= 0, the ray is on the far side only, and from the start. Of a ray that does not move on the axis,
/// only the side matters. An exit is met if the latest entry on its way is not beyond the earliest end.
/// Mirror of rtl/engine/kd/rc_treelet.sv, latency Config::treelet_latency() + 1, one treelet per cycle.
///
/// Gives the children of `exits` that are met, bit by bit, and t_near by child.
std::uint32_t treelet_exits(const BoxRay& ray, const WideTreelet& treelet, const Config& config,
                            std::uint32_t* t_near);
/// The unit's answer.
inline BoxRsp treelet(const TreeletReq& req, const Config& config) {
    const WideTreelet wide = widen(req.treelet, config.node_width);
    std::array<std::uint32_t, max_width> t_near;
    const std::uint32_t hits =
        treelet_exits({req.o, req.neg, req.recip, req.len}, wide, config, t_near.data());
    return box_answer(req.ray, hits, t_near.data(), wide.exits);
}

}   // namespace rayclock

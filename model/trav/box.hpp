#pragma once
#include "model/core/payloads.hpp"

namespace rayclock {

/// A node unpacked for the model: planes by axis, and where each child lies in the block.
struct WideNode {
    Vec3i org{};
    std::array<std::uint32_t, 3> exp{};
    std::uint32_t base = 0;
    int children = 0;
    std::array<std::array<float, max_width>, 3> lo{}, hi{};   ///< whole numbers
    std::array<double, max_width> key{};                      ///< place in the order but for t_near; see box.cpp
};
WideNode widen(const Node& node, int node_width);

/// What the slab test needs of a ray; made once per ray.
struct BoxRay {
    Vec3i o{};
    std::array<std::uint32_t, 3> neg{}, recip{}, len{};
};

/// Slab test of all children of a node, conservative: a box that holds a point of the ray is never left out, and its
/// t_near is never beyond that point.
///
/// Per axis, with r <= 2^(M+R-1) / (|d| << (M - len)) < r + 1 and plane distance D + (q << e), D = org - o (both
/// negated for d < 0): near = floor(2^x r (D + q 2^e)) and far = ceil(2^x (r + 1) (D + q 2^e)), x = F + M - len - R,
/// where D r / 2^e is first rounded down for near and D (r + 1) / 2^e up for far. Negative near is 0, negative far a
/// miss; both saturate at all ones. A zero component only asks whether o lies between the planes (rounded outward).
/// Mirror of rtl/trav/rc_box.sv, latency Config::box_latency() + 1, one node per cycle.
void box_children(const BoxRay& ray, const WideNode& node, const Config& config, BoxRsp& out);
BoxRsp box(const BoxReq& req, const Config& config);

} // namespace rayclock

#pragma once
// The unit box: nodes with child boxes.
#include "model/core/payloads.hpp"
#include "model/engine/bvh/node.hpp"

namespace rayclock {

/// A node unpacked for the model: planes by axis, and the place of each child in the block. Inner children
/// come first.
struct alignas(32) WideNode {
    std::array<std::int32_t, 4> org{};   ///< the fourth entry is 0, here and in exp
    std::array<std::uint8_t, 4> exp{};
    std::uint32_t base = 0;
    std::uint8_t children = 0, children_mask = 0, inner_mask = 0;
    std::array<std::uint8_t, 2 * 3 * max_width> planes{};    ///< [(3 * hi + axis) * 8 + child]
    std::array<std::uint8_t, max_width> offset{}, count{};   ///< as in BoxRsp
};
/// Reads a node's fields directly from its line, without unpacking a Node.
class NodeReader {
public:
    explicit NodeReader(const Config& config);
    WideNode operator()(const std::uint32_t* line) const;

private:
    int coord_bits_, addr_bits_, box_bits_, node_width_;
    int org_ = 0, exp_ = 0, base_ = 0, kind_ = 0, lo_ = 0, hi_ = 0;   ///< lowest bit of each field
};
WideNode widen(const Node& node, int node_width);

/// The part of a ray that the slab test uses; computed once per ray.
struct BoxRay {
    Vec3i o{};   ///< with B fraction bits if the chip shades
    std::array<std::uint32_t, 3> neg{}, recip{}, len{};
};
template <class Moving> BoxRay box_ray(const Moving& ray) {   ///< a Ray or a Change
    return {ray.o, {ray.d[0] < 0, ray.d[1] < 0, ray.d[2] < 0}, ray.recip, ray.len};
}

/// Performs the slab test of all children of a node, conservatively. It never leaves out a box that holds a
/// point of the ray, and the box's t_near is never beyond that point.
///
/// Per axis, with r <= 2^(M+R-1) / (|d| << (M - len)) < r + 1 and plane distance D + (q << e), D = org - o
/// (both negated for d < 0):
///       near = floor(2^x r (D + q 2^e)), far = ceil(2^x (r + 1) (D + q 2^e)), x = F + M - len - R.
/// D r / 2^e is first rounded down for near, and D (r + 1) / 2^e up for far. A negative near is 0, a negative
/// far a miss; both saturate at all ones. For a zero component, o must lie between the planes (rounded
/// outward).
///
/// If the chip shades, M is ray_dir_bits() here, which is also the base of len. o may then lie between
/// lattice points: D of near uses the point further along the ray, D of far the other one (docs/origins.md,
/// Boxes). Mirror of rtl/engine/bvh/rc_box.sv, latency engine::Bvh::latency() + 1, one node every
/// Config::box_interval() cycles.
///
/// Returns the children met, one bit each, and writes t_near by child.
using BoxTest = std::uint32_t(const BoxRay& ray, const WideNode& node, const Config& config,
                              std::uint32_t* t_near);
BoxTest box_children;
/// Performs the same test without the processor's wider vectors, for the tests.
BoxTest box_children_plain;
/// Returns the unit's answer: the children met, inner ones first, then leaves, both nearest first.
BoxRsp box_answer(std::uint32_t ray, std::uint32_t hits, const std::uint32_t* t_near, const WideNode& node);
BoxRsp box(const BoxReq& req, const Config& config, BoxTest* test = box_children);

}   // namespace rayclock

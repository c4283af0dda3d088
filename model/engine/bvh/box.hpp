#pragma once
// The unit box: nodes with child boxes.
#include "model/engine/box_ray.hpp"
#include "model/engine/bvh/node.hpp"
#include "model/engine/node_answer.hpp"

namespace rayclock {

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
/// lattice points: D of near uses the point further along the ray, D of far the other one
/// (docs/proofs/origins.md, Boxes). Mirror of rtl/engine/bvh/rc_box.sv, latency bvh::Engine::latency() + 1,
/// one node every Config::box_interval() cycles.
///
/// Returns the children met, one bit each, and writes t_near by child.
using BoxTest = std::uint32_t(const BoxRay& ray, const WideNode& node, const Config& config,
                              std::uint32_t* t_near);
BoxTest box_children;
/// Performs the same test without the processor's wider vectors, for the tests.
BoxTest box_children_plain;
/// Returns the unit's answer.
NodeAnswer box(const BoxReq& req, const Config& config, BoxTest* test = box_children);

}   // namespace rayclock

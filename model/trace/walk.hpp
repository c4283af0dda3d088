#pragma once
#include "model/isect/primitive.hpp"
#include "model/list/ray_tests.hpp"
#include "model/trace/decoder.hpp"
#include "model/bvh/box.hpp"
#include "model/bvh/stack.hpp"

namespace rayclock {

/// *What* one ray does: the units' pure functions in the order in which a ray meets them. The sequence of
/// nodes, tests and results does not depend on *when* anything happens, so the same walk serves to record
/// traces and to say what every link of the machine must carry.
class Walk {
public:
    Walk(const Frame& frame, const Config& config, const Decoder& decoder);

    /// raygen: the camera ray of a pixel; the next node is the root.
    const Ray& start(const Slot& slot);
    /// Any ray, made as raygen would.
    const Ray& start_at(const Ray& ray);
    std::uint32_t node() const { return node_; }
    std::uint32_t children() const { return decoder_->node(node_).children; }   ///< of the next node

    /// box, on the next node, and trav on its answer. True if list has a triangle to be tested.
    bool test_node();
    bool has_leaves() const { return has_leaves_; }    ///< what it returned
    const Leaves& leaves() const { return leaves_; }   ///< that trav gave to list
    std::uint32_t prim() const { return tests_.prim(); }
    /// tri, on the next triangle.
    const TriRsp& test_triangle();
    /// list, on tri's answer. True if there is another triangle.
    bool advance() { return tests_.advance(tri_); }

    /// list -> trav, when no triangle is left.
    Tested tested() const { return tests_.tested(); }
    /// trav: to the next node, or the ray's end. Returns how many groups were dropped on the way.
    int decide(bool& done);
    /// Groups on the ray's stack now.
    int stack_height() const { return stack_.height(); }

    const Ray& ray() const { return ray_; }
    const BoxRay& box_ray() const { return box_ray_; }
    const BoxRsp& boxes() const { return boxes_; }
    const Best& best() const { return tests_.best(); }
    const TriRsp& tri() const { return tri_; }
    Closest closest() const { return tests_.closest(); }

private:
    const Frame* frame_;
    const Config* config_;
    const Decoder* decoder_;
    TriTest* test_;
    Ray ray_;
    BoxRay box_ray_;
    BoxRsp boxes_;
    Leaves leaves_;
    bool has_leaves_ = false;
    RayTests tests_;
    Stack stack_;
    TriRsp tri_;
    std::uint32_t node_ = 0;
};

}   // namespace rayclock

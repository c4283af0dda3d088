#pragma once
#include "model/core/payloads.hpp"
#include "model/core/ring.hpp"
#include "model/trav/box.hpp"

namespace rayclock {

/// The walk through the tree: takes a step (the inner children of the node just tested and the distance to beat), goes to
/// the nearest of them that can still matter, keeps the others on the ray's stack as one group, or pops.
///
/// Two stages. In the first a step is accepted and the top of the ray's stack read; in the second the next node, or the
/// ray's end, is decided. A popped group whose nearest child is too far costs the ray another turn through both stages
/// (recirculation, which goes before new steps), unless `below`, the nearest t_near of everything under it, says that
/// nothing there can matter either. New rays start at the root when no step waits. Mirror of rtl/trav/rc_trav.sv.
class Trav {
public:
    Trav(const Frame& frame, const Config& config);

    bool ray_ready() const { return !spawn_.full(); }
    bool step_ready() const { return !again_; }
    bool node_valid() const { return !nodes_.empty() || !spawn_.empty(); }
    NodeReq node() const { return spawning() ? NodeReq{spawn_.front(), root_} : nodes_.front(); }
    bool done_valid() const { return !done_.empty(); }
    std::uint32_t done() const { return done_.front(); }
    const BoxRay& box_ray(std::uint32_t ray) const { return rays_[ray]; }

    /// One clock edge: what came in (null if nothing), and which outputs were taken.
    void clock(const Ray* ray, const Step* step, bool node_taken, bool done_taken);

    std::uint64_t recirculations() const { return recirculations_; }

private:
    /// Siblings left for later, nearest first; `below` is the smallest t_near of all groups under this one.
    struct Group {
        std::uint32_t base = 0, count = 0, below = 0;
        std::array<std::uint32_t, max_width> t_near{}, slot{};
    };

    bool spawning() const { return node_link_.second(!nodes_.empty()); }
    void decide();
    void pop(std::uint32_t ray, std::uint32_t t_best);
    void visit(std::uint32_t ray, std::uint32_t base, std::uint32_t slot) { nodes_.push({ray, base + slot}); }
    Group& group(std::uint32_t ray, std::uint32_t level) { return stacks_[ray * depth_ + level]; }

    std::uint32_t root_, beyond_, depth_;
    std::vector<BoxRay> rays_;
    std::vector<Group> stacks_;
    std::vector<std::uint32_t> heights_;
    Ring<std::uint32_t> spawn_;
    Ring<NodeReq> nodes_;
    Ring<std::uint32_t> done_;
    Merge node_link_;
    bool again_ = false;              // recirculation register
    std::uint32_t again_ray_ = 0, again_t_ = 0;
    bool s1_valid_ = false;           // second stage
    Step s1_{};
    std::uint64_t recirculations_ = 0;
};

} // namespace rayclock

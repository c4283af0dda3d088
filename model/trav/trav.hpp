#pragma once
#include "model/base/ring.hpp"
#include "model/trav/stack.hpp"

namespace rayclock {

/// The walk through the tree: when. Takes rays whose node is tested, and gives out those that go to a node
/// and those that are done; where they go is decided by a Stack.
///
/// Two stages. In the first a step is accepted and the top of the ray's stack read; in the second the next
/// node, or the ray's end, is decided. A dropped group costs the ray another turn through both stages
/// (recirculation, which goes before new steps). New rays start at the root when no step waits. Mirror of
/// rtl/trav/rc_trav.sv.
class Trav {
public:
    explicit Trav(const Config& config) : spawn_(2), nodes_(config.contexts), done_(config.contexts) {}

    bool ray_ready() const { return !spawn_.full(); }
    bool step_ready() const { return !again_; }
    bool node_valid() const { return !nodes_.empty() || !spawn_.empty(); }
    bool spawning() const {
        return node_link_.second(!nodes_.empty());
    }   ///< the node on offer is a new ray's root
    std::uint32_t node_ray() const { return spawning() ? spawn_.front() : nodes_.front(); }
    bool done_valid() const { return !done_.empty(); }
    std::uint32_t done_ray() const { return done_.front(); }
    bool idle() const { return !again_ && !s1_valid_; }   ///< nothing in the two stages

    const char* where(std::uint32_t ray) const {
        return spawn_.contains(RayNumber(ray))   ? "trav: new, waits for the root's link"
               : nodes_.contains(RayNumber(ray)) ? "trav: waits for the link to node_cache"
               : done_.contains(RayNumber(ray))  ? "trav: done, waits for its hit to be taken"
               : (s1_valid_ && s1_ == ray) || (again_ && again_ray_ == ray) ? "trav: being decided"
                                                                            : nullptr;
    }

    /// One clock edge: rays that came in (null if none), and which outputs were taken. `decide(ray)` tells
    /// the kind of turn that the ray in the second stage takes.
    template <class Decide> void clock(const std::uint32_t* ray, const std::uint32_t* step, bool node_taken,
                                       bool done_taken, Decide&& decide) {
        // Everything that leaves, leaves before anything enters: a queue shows a new entry in the next cycle.
        if (done_taken) done_.pop();
        const bool spawn = spawning();
        node_link_.clock(node_valid(), node_taken, spawn);
        if (node_taken && spawn)
            spawn_.pop();
        else if (node_taken)
            nodes_.pop();
        // Stage 0 looks at the recirculation register before stage 1 may set it again.
        const bool turn = again_;
        const std::uint32_t returned = again_ray_;
        again_ = false;
        if (s1_valid_) switch (decide(s1_)) {
                case Turn::Kind::visit: nodes_.push(RayNumber(s1_)); break;
                case Turn::Kind::done: done_.push(RayNumber(s1_)); break;
                case Turn::Kind::again:
                    again_ = true;
                    again_ray_ = s1_;
                    break;
            }
        s1_valid_ = turn || step;
        if (turn)
            s1_ = returned;
        else if (step)
            s1_ = *step;
        if (ray) spawn_.push(RayNumber(*ray));
    }

private:
    Ring<RayNumber, 2> spawn_;
    RayRing nodes_, done_;
    Merge node_link_;
    bool again_ = false, s1_valid_ = false;   // recirculation register, second stage
    std::uint32_t again_ray_ = 0, s1_ = 0;
};

}   // namespace rayclock

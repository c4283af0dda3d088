#pragma once
#include "model/base/ring.hpp"
#include "model/bvh/stack.hpp"

namespace rayclock {

/// The walk through the tree: when. Takes rays whose node's leaves are tested, from list, or need not be, and
/// gives out those that go to a node and those that are done; where they go is decided by a Stack.
///
/// Rays without leaves wait in a queue; those that list has tested go first. Two stages. In the first a step
/// of one of them is accepted and the top of the ray's stack read; in the second the next
/// node, or the ray's end, is decided. A dropped group costs the ray another turn through both stages
/// (recirculation, which goes before new steps). New rays start at the root when no step waits. Mirror of
/// rtl/bvh/rc_trav.sv.
class Trav {
public:
    explicit Trav(const Config& config)
        : spawn_(2), leafless_(config.contexts), nodes_(config.contexts), done_(config.contexts) {}

    bool ray_ready() const { return !spawn_.full(); }
    bool step_ready() const { return !again_; }
    /// Whether a ray takes its step, and which one is next, if list offers one (null if it does not).
    bool step_valid(bool offered) const { return offered || !leafless_.empty(); }
    bool takes_leafless(bool offered) const { return step_link_.second(offered); }
    std::uint32_t leafless_ray() const { return leafless_.front(); }
    bool tested_ready(bool offered) const { return step_ready() && !takes_leafless(offered); }
    bool node_valid() const { return !nodes_.empty() || !spawn_.empty(); }
    bool spawning() const {
        return node_link_.second(!nodes_.empty());
    }   ///< the node on offer is a new ray's root
    std::uint32_t node_ray() const { return spawning() ? spawn_.front() : nodes_.front(); }
    bool done_valid() const { return !done_.empty(); }
    std::uint32_t done_ray() const { return done_.front(); }
    bool idle() const { return !again_ && !s1_valid_; }   ///< nothing in the two stages

    const char* where(std::uint32_t ray) const {
        return spawn_.contains(RayNumber(ray))      ? "trav: new, waits for the root's link"
               : nodes_.contains(RayNumber(ray))    ? "trav: waits for the link to node_cache"
               : done_.contains(RayNumber(ray))     ? "trav: done, waits for its hit to be taken"
               : leafless_.contains(RayNumber(ray)) ? "trav: no leaf to be tested, waits for its step"
               : (s1_valid_ && s1_ == ray) || (again_ && again_ray_ == ray) ? "trav: being decided"
                                                                            : nullptr;
    }

    /// What came in one cycle (null if nothing): new rays, rays that box has answered and that have no leaf
    /// to be tested, rays that list offers; and which outputs were taken.
    struct Moves {
        const std::uint32_t *ray = nullptr, *leafless = nullptr, *tested = nullptr;
        bool node_taken = false, done_taken = false;
    };
    /// One clock edge. `decide(ray)` tells the kind of turn that the ray in the second stage takes.
    template <class Decide> void clock(const Moves& moves, Decide&& decide) {
        // Everything that leaves, leaves before anything enters: a queue shows a new entry in the next cycle.
        if (moves.done_taken) done_.pop();
        const bool spawn = spawning();
        node_link_.clock(node_valid(), moves.node_taken, spawn);
        if (moves.node_taken && spawn)
            spawn_.pop();
        else if (moves.node_taken)
            nodes_.pop();
        const bool valid = step_valid(moves.tested), step = valid && step_ready(),
                   leafless = takes_leafless(moves.tested);
        step_link_.clock(valid, step, leafless);
        const std::uint32_t stepping = !step ? 0 : leafless ? leafless_.front() : *moves.tested;
        if (step && leafless) leafless_.pop();
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
            s1_ = stepping;
        if (moves.ray) spawn_.push(RayNumber(*moves.ray));
        if (moves.leafless) leafless_.push(RayNumber(*moves.leafless));
    }

private:
    Ring<RayNumber, 2> spawn_;
    RayRing leafless_, nodes_, done_;
    Merge step_link_, node_link_;
    bool again_ = false, s1_valid_ = false;   // recirculation register, second stage
    std::uint32_t again_ray_ = 0, s1_ = 0;
};

}   // namespace rayclock

#pragma once
// The unit trav in time. stack.hpp has its decisions.
#include "model/core/ring.hpp"
#include "model/core/stages.hpp"
#include "model/unit/trav/stack.hpp"

namespace rayclock {

/// The walk through the tree in time. It accepts rays whose node's leaves are tested, from list, or that have
/// no leaf to test. It sends rays to nodes, and reports those that are done. A Stack decides where they go.
///
/// Rays without leaves wait in a queue; those that list has tested have priority. There are two stages. The
/// first accepts a step of one ray and reads the top of its stack. The second decides the next node, or the
/// ray's end. After a dropped group the ray passes through both stages again (recirculation, which has
/// priority over new steps).
///
/// New rays start at the root when no step waits. With two levels, rays that xform has changed go to their
/// mesh's root, before new ones. A fast chip has more stages between the two, and reports an end a cycle
/// later. Mirror of rtl/unit/trav/rc_trav.sv.
class Trav {
public:
    explicit Trav(const Config& config)
        : stack_delay_(Stages(config).stack_delay),
          spawn_(2),
          changed_(config.has_instances() ? config.contexts : 1),
          leafless_(config.contexts),
          nodes_(config.contexts),
          done_(config.contexts) {}

    bool ray_ready() const { return !spawn_.full(); }
    bool step_ready() const { return !again_; }
    /// step_valid(): a ray has a step to take. takes_leafless(): it is one without leaves. `offered`: list
    /// offers one.
    bool step_valid(bool offered) const { return offered | !leafless_.empty(); }
    bool takes_leafless(bool offered) const { return step_link_.second(offered); }
    bool tested_ready(bool offered) const { return step_ready() & !takes_leafless(offered); }
    template <bool levels = false> bool node_valid() const {
        return !nodes_.empty() | !spawn_.empty() | (levels && !changed_.empty());
    }
    /// True if the node on offer is a root, of a new ray or of one that changed.
    bool spawning() const { return node_link_.second(!nodes_.empty()); }
    template <bool levels = false, bool few = false> std::uint32_t node_ray() const {
        const RayNumber root = spawn_.front(), node = nodes_.front<few>();
        if constexpr (levels)
            if (spawning() && !root_link_.second(!changed_.empty())) return changed_.front<few>();
        return select(spawning(), root, node);
    }
    bool done_valid() const { return !done_.empty(); }
    template <bool few = false> std::uint32_t done_ray() const { return done_.front<few>(); }
    /// True if the stages are empty.
    bool idle() const { return !(again_ | s1_valid_ | (between_ != 0) | ended_.valid); }

    const char* where(std::uint32_t ray) const {
        return spawn_.contains(RayNumber(ray))      ? "trav: new, waits for the root's link"
               : changed_.contains(RayNumber(ray))  ? "trav: changed, waits for the mesh's root's link"
               : nodes_.contains(RayNumber(ray))    ? "trav: waits for the link to node_cache"
               : done_.contains(RayNumber(ray))     ? "trav: done, waits for its hit to be taken"
               : leafless_.contains(RayNumber(ray)) ? "trav: no leaf to be tested, waits for its step"
               : is_decided(ray)                    ? "trav: being decided"
                                                    : nullptr;
    }

    /// The inputs of one cycle: new rays, rays that the node unit has answered and that have no leaf to test,
    /// rays that list offers, and the outputs that were accepted.
    struct Moves {
        LinkRay ray, leafless, tested;
        bool node_taken = false, done_taken = false;
        LinkRay change{};   // from xform, with two levels
    };
    /// One clock edge. `decide(ray, valid)` returns the turn of the ray in the second stage, if it is valid.
    /// `plain`: a chip with up to RayRing::most_few contexts that is not fast.
    template <bool levels = false, bool plain = false, class Decide>
    void clock(const Moves& moves, Decide&& decide) {
        // Pops come before pushes: a queue shows a new entry in the next cycle.
        done_.pop(moves.done_taken);
        const bool spawn = spawning();
        node_link_.clock(node_valid<levels>(), moves.node_taken, spawn);
        const bool change = levels && !root_link_.second(!changed_.empty());   // before a new ray
        if constexpr (levels) {
            root_link_.clock(!changed_.empty() | !spawn_.empty(), moves.node_taken & spawn, !change);
            changed_.pop(moves.node_taken & spawn & change);
            changed_.push<plain>(RayNumber(moves.change.ray), moves.change.valid);
        }
        spawn_.pop(moves.node_taken & spawn & !change);
        nodes_.pop(moves.node_taken & !spawn);
        const bool offered = moves.tested.valid, valid = step_valid(offered), step = valid & step_ready(),
                   leafless = takes_leafless(offered);
        step_link_.clock(valid, step, leafless);
        const std::uint32_t without = leafless_.front<plain>(),
                            stepping = select(leafless, without, moves.tested.ray);
        leafless_.pop(step & leafless);
        // Stage 0 reads the recirculation register before stage 1 may set it again.
        const bool turn = again_;
        const std::uint32_t returned = again_ray_;
        const LinkRay last = plain ? LinkRay{s1_valid_, s1_} : last_stage();
        const Decision::Flags went = decide(last.ray, last.valid);
        nodes_.push<plain>(RayNumber(last.ray), went.visit);
        if (plain || stack_delay_ == 0) {
            done_.push<plain>(RayNumber(last.ray), went.done);
        } else {   // reported from a register, because list is far away
            done_.push(RayNumber(ended_.ray), ended_.valid);
            ended_ = {went.done, last.ray};
        }
        again_ = went.again;
        again_ray_ = last.ray;
        if (!plain && stack_delay_ != 0) pass_on();
        s1_valid_ = turn | step;
        s1_ = select(turn, returned, stepping);
        spawn_.push(RayNumber(moves.ray.ray), moves.ray.valid);
        leafless_.push<plain>(RayNumber(moves.leafless.ray), moves.leafless.valid);
    }

private:
    /// Returns the ray that is decided in this cycle.
    LinkRay last_stage() const {
        if (stack_delay_ == 0) return {s1_valid_, s1_};
        return {bool(between_ >> (stack_delay_ - 1) & 1), waiting_[std::size_t(stack_delay_ - 1)]};
    }
    /// Advances the stages between the second and the last. Bit i of between_ is set if waiting_[i] is valid.
    void pass_on() {
        for (int i = stack_delay_ - 1; i > 0; --i) waiting_[std::size_t(i)] = waiting_[std::size_t(i - 1)];
        waiting_[0] = RayNumber(s1_);
        between_ = (between_ << 1 | std::uint32_t(s1_valid_)) & ((1u << stack_delay_) - 1);
    }
    bool is_decided(std::uint32_t ray) const {
        for (int i = 0; i < stack_delay_; ++i)
            if ((between_ >> i & 1) && waiting_[std::size_t(i)] == ray) return true;
        return (s1_valid_ && s1_ == ray) || (again_ && again_ray_ == ray) ||
               (ended_.valid && ended_.ray == ray);
    }

    int stack_delay_;   // stages between the second stage and the decision
    std::uint32_t between_ = 0;
    std::array<RayNumber, 4> waiting_{};
    Ring<RayNumber, 2> spawn_;
    RayRing changed_, leafless_, nodes_, done_;
    Merge step_link_, node_link_, root_link_;   // root_link_: of changed_ and spawn_
    bool again_ = false, s1_valid_ = false;     // recirculation register, second stage
    std::uint32_t again_ray_ = 0, s1_ = 0;
    LinkRay ended_{};   // in a fast chip, before done_
};

}   // namespace rayclock

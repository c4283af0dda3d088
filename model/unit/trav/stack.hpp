#pragma once
// A ray's stack, and its decisions.
#include <algorithm>
#include <cassert>
#include <vector>

#include "model/unit/trav/children.hpp"
#include "model/unit/trav/order.hpp"

namespace rayclock {

/// The decision where a ray goes after a node.
struct Decision {
    enum class Action : std::uint8_t {
        visit,   ///< to the node at `addr`
        again,   ///< a group was dropped: decide again, without new children
        done,    ///< nothing is left that can matter
    };
    /// The action as flags. Without a decision none is set.
    struct Flags {
        bool visit = false, again = false, done = false;
    };
    Action action = Action::done;
    std::uint32_t addr = 0;
    Flags flags() const { return {action == Action::visit, action == Action::again, action == Action::done}; }
};

/// One ray's stack of sibling groups, and the decision where the ray goes next: trav without timing.
///
/// The ray visits the nearest inner child, and the stack keeps its siblings as one group. Without a child
/// that can still matter, the stack is popped. Each group holds `below`, the smallest t_near of all groups
/// under it. So a ray for which no group there matters ends immediately. A group whose nearest child is too
/// far is dropped, one per decision. A stop empties the stack, and the ray is done. Mirror of
/// rtl/unit/trav/rc_stack.sv.
///
/// `Order` defines distances and the order of children; the machine's is ByDistance.
template <class Order> class GroupStack {
public:
    using Time = typename Order::Time;
    using Key = typename Order::Key;

    /// `beyond`: the largest distance.
    GroupStack(int depth, Time beyond) : beyond_(beyond), groups_(std::size_t(depth) + 1) {}
    explicit GroupStack(const Config& config) : GroupStack(config.stack_depth, (1u << config.t_bits()) - 1) {}

    /// Returns the place for the sorted keys of the next node's inner children. Fill it before decide().
    Key* place() { return groups_[height_].keys.data(); }
    /// Decides after a node whose leaves are tested. Its inner children that the ray meets lie from line
    /// `base` on.
    RAYCLOCK_INLINE Decision decide(Time t_best, bool stop, std::uint32_t base, std::uint32_t inner) {
        if (stop) {
            height_ = 0;
            return {};
        }
        Group& g = groups_[height_];
        if (inner == 0 || t_best < Order::near(g.keys[0])) return pop(t_best);
        const Decision forward{Decision::Action::visit, base + Order::child(g.keys[0])};
        if (inner == 1) return forward;
        assert(height_ + 1 < groups_.size() && "the compiled scene promised a shallower stack");
        g.below = beyond_;
        if (height_ > 0) {
            const Group& under = groups_[height_ - 1];
            g.below = std::min(under.nearest(), under.below);
        }
        g.base = base;
        g.next = 1;
        g.end = inner;
        ++height_;
        return forward;
    }
    /// Decides in the form of the payloads. After a dropped group there are no new children.
    Decision decide(const Tested& tested, const Children& c = {}) {
        for (std::size_t i = 0; i < c.inner; ++i) place()[i] = Order::key(c.t_near[i], c.slot[i]);
        return decide(tested.t_best, tested.stop != 0, c.base, c.inner);
    }
    void clear() { height_ = 0; }
    int height() const { return int(height_); }

private:
    struct Group {
        std::array<Key, max_width> keys;   ///< keys next..end - 1 are left
        std::uint32_t base, next, end;
        Time below;
        Time nearest() const { return Order::near(keys[next]); }
    };
    RAYCLOCK_INLINE Decision pop(Time t_best) {
        if (height_ == 0) return {};
        Group& top = groups_[height_ - 1];
        if (!(t_best < top.nearest())) {
            const Decision decision{Decision::Action::visit, top.base + Order::child(top.keys[top.next])};
            if (++top.next == top.end) --height_;
            return decision;
        }
        if (height_ == 1 || t_best < top.below) {
            height_ = 0;
            return {};
        }
        --height_;
        return {Decision::Action::again, 0};
    }

    Time beyond_;
    std::size_t height_ = 0;
    std::vector<Group> groups_;   // one more than the depth: new children are sorted above the top group
};
using Stack = GroupStack<ByDistance>;

}   // namespace rayclock

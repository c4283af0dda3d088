#pragma once
#include <algorithm>
#include <cassert>
#include <vector>

#include "model/unit/trav/children.hpp"
#include "model/unit/trav/order.hpp"

namespace rayclock {

/// Where a ray goes after a node.
struct Turn {
    enum class Kind : std::uint8_t {
        visit,   ///< to the node at `addr`
        again,   ///< a group was dropped: decide once more, with no new children
        done,    ///< nothing is left that can matter
    };
    /// The same as flags, none of which is set if there is no turn.
    struct Flags {
        bool visit = false, again = false, done = false;
    };
    Kind kind = Kind::done;
    std::uint32_t addr = 0;
    Flags flags() const { return {kind == Kind::visit, kind == Kind::again, kind == Kind::done}; }
};

/// One ray's stack of sibling groups, and the decision where the ray goes next: what trav does, without when.
///
/// The nearest inner child is visited and its siblings kept as one group; without a child that can still
/// matter the stack is popped. Each group knows `below`, the smallest t_near of all groups under it, so that
/// a ray for which nothing there matters is done at once. A group whose nearest child is too far is dropped,
/// one a turn. A stop empties the stack: the ray is done. Mirror of rtl/unit/trav/rc_stack.sv.
///
/// `Order` says what distances are, and how children are put in order by them; the machine's is ByDistance.
template <class Order> class GroupStack {
public:
    using Time = typename Order::Time;
    using Key = typename Order::Key;

    /// `beyond`: no distance is larger.
    GroupStack(int depth, Time beyond) : beyond_(beyond), groups_(std::size_t(depth) + 1) {}
    explicit GroupStack(const Config& config) : GroupStack(config.stack_depth, (1u << config.t_bits()) - 1) {}

    /// Where the keys of the next node's inner children belong, in order, before decide().
    Key* place() { return groups_[height_].keys.data(); }
    /// After a node whose leaves are tested. Its inner children that the ray meets lie from line `base` on.
    RAYCLOCK_INLINE Turn decide(Time t_best, bool stop, std::uint32_t base, std::uint32_t inner) {
        if (stop) {
            height_ = 0;
            return {};
        }
        Group& g = groups_[height_];
        if (inner == 0 || t_best < Order::near(g.keys[0])) return pop(t_best);
        const Turn forward{Turn::Kind::visit, base + Order::child(g.keys[0])};
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
    /// The same in the payloads' form; in another turn there are no new children.
    Turn decide(const Tested& tested, const Children& c = {}) {
        for (std::size_t i = 0; i < c.inner; ++i) place()[i] = Order::key(c.t_near[i], c.slot[i]);
        return decide(tested.t_best, tested.stop != 0, c.base, c.inner);
    }
    void clear() { height_ = 0; }
    int height() const { return int(height_); }

private:
    struct Group {
        std::array<Key, max_width> keys;   ///< of these next..end - 1 are left
        std::uint32_t base, next, end;
        Time below;
        Time nearest() const { return Order::near(keys[next]); }
    };
    RAYCLOCK_INLINE Turn pop(Time t_best) {
        if (height_ == 0) return {};
        Group& top = groups_[height_ - 1];
        if (!(t_best < top.nearest())) {
            const Turn turn{Turn::Kind::visit, top.base + Order::child(top.keys[top.next])};
            if (++top.next == top.end) --height_;
            return turn;
        }
        if (height_ == 1 || t_best < top.below) {
            height_ = 0;
            return {};
        }
        --height_;
        return {Turn::Kind::again, 0};
    }

    Time beyond_;
    std::size_t height_ = 0;
    std::vector<Group> groups_;   // one more than the depth: in the one above the top children are sorted
};
using Stack = GroupStack<ByDistance>;

}   // namespace rayclock

#pragma once
#include <vector>

#include "model/bvh/children.hpp"

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
/// one a turn. A stop empties the stack: the ray is done. Mirror of rtl/bvh/rc_stack.sv.
class Stack {
public:
    explicit Stack(const Config& config)
        : beyond_((1u << config.t_bits()) - 1), groups_(std::size_t(config.stack_depth)) {}

    /// After a node whose leaves are tested; in another turn there are no new children.
    Turn decide(const Tested& tested, const Children& children = {});
    void clear() { height_ = 0; }
    int height() const { return height_; }

private:
    struct Group {
        std::uint32_t base = 0, count = 0, below = 0;
        std::array<std::uint32_t, max_width> t_near{}, slot{};
    };
    Turn pop(std::uint32_t t_best);

    std::uint32_t beyond_;
    int height_ = 0;
    std::vector<Group> groups_;
};

}   // namespace rayclock

#include "model/bvh/stack.hpp"

#include <algorithm>
#include <cassert>

namespace rayclock {

Turn Stack::decide(const Tested& tested, const Children& c) {
    if (tested.stop) {
        height_ = 0;
        return {};
    }
    if (c.inner == 0 || c.t_near[0] > tested.t_best) return pop(tested.t_best);
    const Turn forward{Turn::Kind::visit, c.base + c.slot[0]};
    if (c.inner == 1) return forward;
    assert(std::size_t(height_) < groups_.size() && "the compiled scene promised a shallower stack");
    Group& g = groups_[std::size_t(height_)];
    g.below = beyond_;
    if (height_ > 0) {
        const Group& under = groups_[std::size_t(height_ - 1)];
        g.below = std::min(under.t_near[0], under.below);
    }
    g.base = c.base;
    g.count = c.inner - 1;
    for (std::size_t i = 0; i < g.count; ++i) {
        g.t_near[i] = c.t_near[i + 1];
        g.slot[i] = c.slot[i + 1];
    }
    ++height_;
    return forward;
}

Turn Stack::pop(std::uint32_t t_best) {
    if (height_ == 0) return {};
    Group& top = groups_[std::size_t(height_ - 1)];
    if (top.t_near[0] <= t_best) {
        const Turn turn{Turn::Kind::visit, top.base + top.slot[0]};
        if (--top.count == 0) {
            --height_;
            return turn;
        }
        for (std::size_t i = 0; i < top.count; ++i) {
            top.t_near[i] = top.t_near[i + 1];
            top.slot[i] = top.slot[i + 1];
        }
        return turn;
    }
    if (height_ == 1 || top.below > t_best) {
        height_ = 0;
        return {};
    }
    --height_;
    return {Turn::Kind::again, 0};
}

}   // namespace rayclock

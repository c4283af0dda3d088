#include "model/list/leaves.hpp"

namespace rayclock {

bool Leaves::begin(const BoxRsp& boxes) {
    group_ = boxes;
    return begin();
}

bool Leaves::begin() {
    leaf_ = triangle_ = 0;
    return group_.leaves > 0 && group_.t_near[group_.inner] <= t_best();
}

bool Leaves::advance(const TriRsp& tri) {
    if (tri.closer) {
        best_ = {1, tri.num, tri.det, tri.prim};
        found_ = {tri.ray, 1, tri.prim, tri.t, tri.u, tri.v, tri.back};   // zeros, if any hit will do
        if (any_) return false;
    }
    if (triangle_ + 1 < group_.count[group_.inner + leaf_]) {
        ++triangle_;
        return true;
    }
    triangle_ = 0;
    ++leaf_;
    return leaf_ < group_.leaves && group_.t_near[group_.inner + leaf_] <= t_best();
}

Step Leaves::step(std::uint32_t ray) const {
    Step step{ray, t_best(), group_.base, stop() ? 0 : group_.inner, group_.t_near, {}, stop()};
    for (std::size_t i = 0; i < max_width; ++i) step.slot[i] = group_.offset[i] >> 1;
    return step;
}

Closest Leaves::closest(std::uint32_t ray) const {
    if (!best_.found) return {ray, 0, 0, 0, 0, 0, 0};
    Closest closest = found_;
    closest.ray = ray;
    return closest;
}

}   // namespace rayclock

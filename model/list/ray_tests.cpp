#include "model/list/ray_tests.hpp"

namespace rayclock {

bool RayTests::advance(const TriRsp& tri) {
    if (tri.closer) {
        best_ = {1, tri.num, tri.det, tri.prim};
        found_ = {tri.ray, 1, tri.prim, tri.t, tri.u, tri.v, tri.back};   // zeros, if any hit will do
        if (any_) return false;
    }
    if (triangle_ + 1 < leaves_.count[leaf_]) {
        ++triangle_;
        return true;
    }
    triangle_ = 0;
    ++leaf_;
    return leaf_ < leaves_.leaves && leaves_.t_near[leaf_] <= t_best();
}

Closest RayTests::closest() const {
    if (!best_.found) return {ray_, 0, 0, 0, 0, 0, 0};
    Closest closest = found_;
    closest.ray = ray_;
    return closest;
}

}   // namespace rayclock

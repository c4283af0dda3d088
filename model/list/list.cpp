#include "model/list/list.hpp"

namespace rayclock {

constexpr int inbox_depth = 4;

List::List(const Config& config)
    : beyond_((1u << config.t_bits()) - 1), rays_(std::size_t(config.contexts)), groups_(std::size_t(config.contexts)),
      cursors_(std::size_t(config.contexts)), bests_(std::size_t(config.contexts)), founds_(std::size_t(config.contexts)),
      inbox_(inbox_depth), prims_(config.contexts), steps_(config.contexts) {}

Step List::step() const {
    const Ending& end = steps_.front();
    const BoxRsp& group = groups_[end.ray];
    Step step{end.ray, end.t_best, group.base, group.inner, group.t_near, {}};
    for (std::size_t i = 0; i < max_width; ++i) step.slot[i] = group.offset[i] >> 1;
    return step;
}

TriReq List::tri_req(std::uint32_t ray, const PrimData& triangle) const {
    return {ray, rays_[ray].o, rays_[ray].d, triangle, bests_[ray]};
}

Closest List::closest(std::uint32_t ray) const {
    if (!bests_[ray].found) return {ray, 0, 0, 0, 0, 0};
    return founds_[ray];
}

void List::clock(const Ray* ray, const BoxRsp* boxes, const TriRsp* tri, bool prim_taken, bool step_taken) {
    if (prim_taken) prims_.pop();
    if (step_taken) steps_.pop();
    const Queue taken = tri ? advance(*tri) : Queue::none;
    if (!inbox_.empty()) start(taken);
    if (boxes) inbox_.push(*boxes);
    if (ray) {
        rays_[ray->ray] = *ray;
        bests_[ray->ray] = {};
    }
}

List::Queue List::advance(const TriRsp& tri) {
    const std::uint32_t ray = tri.ray;
    if (tri.closer) {
        bests_[ray] = {1, tri.num, tri.det, tri.prim};
        founds_[ray] = {ray, 1, tri.prim, tri.t, tri.u, tri.v};
    }
    const BoxRsp& group = groups_[ray];
    const Cursor at = cursors_[ray];
    if (at.triangle + 1 < group.count[group.inner + at.leaf]) {
        fetch(ray, {at.leaf, at.triangle + 1});
        return Queue::prim;
    }
    if (at.leaf + 1 < group.leaves && group.t_near[group.inner + at.leaf + 1] <= t_best(ray)) {
        fetch(ray, {at.leaf + 1, 0});
        return Queue::prim;
    }
    steps_.push({ray, t_best(ray)});
    return Queue::step;
}

void List::start(Queue taken) {
    const BoxRsp& boxes = inbox_.front();
    const bool leaf = boxes.leaves > 0 && boxes.t_near[boxes.inner] <= t_best(boxes.ray);
    if (taken == (leaf ? Queue::prim : Queue::step)) return;
    groups_[boxes.ray] = boxes;
    if (leaf) fetch(boxes.ray, {0, 0});
    else steps_.push({boxes.ray, t_best(boxes.ray)});
    inbox_.pop();
}

void List::fetch(std::uint32_t ray, Cursor cursor) {
    const BoxRsp& group = groups_[ray];
    cursors_[ray] = cursor;
    prims_.push({ray, 2 * group.base + group.offset[group.inner + cursor.leaf] + cursor.triangle});
}

} // namespace rayclock

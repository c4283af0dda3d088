#include "model/list/list.hpp"

namespace rayclock {

List::List(const Config& config)
    : beyond_((1u << config.t_bits()) - 1), rays_(std::size_t(config.contexts)), groups_(std::size_t(config.contexts)),
      cursors_(std::size_t(config.contexts)), bests_(std::size_t(config.contexts)), founds_(std::size_t(config.contexts)),
      next_(config.contexts), first_(config.contexts), tested_(config.contexts), leafless_(config.contexts) {}

Step List::step() const {
    const Ending& end = leaving() ? leafless_.front() : tested_.front();
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
    // What leaves, leaves before anything enters: a queue shows a new entry in the next cycle.
    const bool start = starting(), leave = leaving();
    prim_link_.clock(prim_valid(), prim_taken, start);
    step_link_.clock(step_valid(), step_taken, leave);
    if (prim_taken) (start ? first_ : next_).pop();
    if (step_taken) (leave ? leafless_ : tested_).pop();
    if (tri) advance(*tri);
    if (boxes) begin(*boxes);
    if (ray) {
        rays_[ray->ray] = *ray;
        bests_[ray->ray] = {};
    }
}

void List::begin(const BoxRsp& boxes) {
    groups_[boxes.ray] = boxes;
    if (boxes.leaves > 0 && boxes.t_near[boxes.inner] <= t_best(boxes.ray)) first_.push(fetch(boxes.ray, {0, 0}));
    else leafless_.push({boxes.ray, t_best(boxes.ray)});
}

void List::advance(const TriRsp& tri) {
    const std::uint32_t ray = tri.ray;
    if (tri.closer) {
        bests_[ray] = {1, tri.num, tri.det, tri.prim};
        founds_[ray] = {ray, 1, tri.prim, tri.t, tri.u, tri.v};
    }
    const BoxRsp& group = groups_[ray];
    const Cursor at = cursors_[ray];
    if (at.triangle + 1 < group.count[group.inner + at.leaf])
        next_.push(fetch(ray, {at.leaf, at.triangle + 1}));
    else if (at.leaf + 1 < group.leaves && group.t_near[group.inner + at.leaf + 1] <= t_best(ray))
        next_.push(fetch(ray, {at.leaf + 1, 0}));
    else
        tested_.push({ray, t_best(ray)});
}

PrimReq List::fetch(std::uint32_t ray, Cursor cursor) {
    const BoxRsp& group = groups_[ray];
    cursors_[ray] = cursor;
    return {ray, 2 * group.base + group.offset[group.inner + cursor.leaf] + cursor.triangle};
}

} // namespace rayclock

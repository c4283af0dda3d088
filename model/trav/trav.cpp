#include "model/trav/trav.hpp"

#include <algorithm>
#include <cassert>

namespace rayclock {

Trav::Trav(const Frame& frame, const Config& config)
    : root_(frame.root), beyond_((1u << config.t_bits()) - 1), depth_(std::uint32_t(config.stack_depth)),
      rays_(std::size_t(config.contexts)), stacks_(std::size_t(config.contexts * config.stack_depth)),
      heights_(std::size_t(config.contexts)), spawn_(2), nodes_(config.contexts), done_(config.contexts) {}

void Trav::clock(const Ray* ray, const Step* step, bool node_taken, bool done_taken) {
    // Everything that leaves, leaves before anything enters: a queue shows a new entry in the next cycle.
    if (done_taken) done_.pop();
    const bool spawn = spawning();
    node_link_.clock(node_valid(), node_taken, spawn);
    if (node_taken && spawn) spawn_.pop();
    else if (node_taken) nodes_.pop();
    // Stage 0 looks at the recirculation register before stage 1 may set it again.
    const bool turn = again_;
    const Step returned{again_ray_, again_t_, 0, 0, {}, {}};
    again_ = false;
    if (s1_valid_) decide();
    s1_valid_ = turn || step;
    if (turn) s1_ = returned;
    else if (step) s1_ = *step;

    if (ray) {
        rays_[ray->ray] = {ray->o, {ray->d[0] < 0, ray->d[1] < 0, ray->d[2] < 0}, ray->recip, ray->len};
        spawn_.push(ray->ray);
    }
}

void Trav::decide() {
    const Step& s = s1_;
    if (s.inner == 0 || s.t_near[0] > s.t_best) return pop(s.ray, s.t_best);
    visit(s.ray, s.base, s.slot[0]);
    if (s.inner == 1) return;
    std::uint32_t& height = heights_[s.ray];
    assert(height < depth_ && "the compiled scene promised a shallower stack");
    Group& g = group(s.ray, height);
    g.below = beyond_;
    if (height > 0) g.below = std::min(group(s.ray, height - 1).t_near[0], group(s.ray, height - 1).below);
    g.base = s.base;
    g.count = s.inner - 1;
    for (std::size_t i = 0; i + 1 < max_width; ++i) {
        g.t_near[i] = s.t_near[i + 1];
        g.slot[i] = s.slot[i + 1];
    }
    ++height;
}

void Trav::pop(std::uint32_t ray, std::uint32_t t_best) {
    std::uint32_t& height = heights_[ray];
    if (height == 0) return done_.push(ray);
    Group& top = group(ray, height - 1);
    if (top.t_near[0] <= t_best) {
        visit(ray, top.base, top.slot[0]);
        if (--top.count == 0) {
            --height;
            return;
        }
        for (std::size_t i = 0; i + 1 < max_width; ++i) {
            top.t_near[i] = top.t_near[i + 1];
            top.slot[i] = top.slot[i + 1];
        }
        return;
    }
    if (height == 1 || top.below > t_best) {
        height = 0;
        return done_.push(ray);
    }
    --height;
    again_ = true;
    again_ray_ = ray;
    again_t_ = t_best;
    ++recirculations_;
}

} // namespace rayclock

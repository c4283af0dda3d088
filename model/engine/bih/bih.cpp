// The unit bih: pairs of planes, and the exits that a ray meets.
#include "model/engine/bih/bih.hpp"

#include "model/engine/space_cells/axis.hpp"

namespace rayclock {

WideBih widen(const BihNode& node, int node_width) {
    WideBih wide(node, node_width);
    for (std::size_t i = 0; i + 1 < std::size_t(node_width); ++i) {
        wide.axis[i] = std::uint8_t(node.axis[i]);
        wide.lower_to[i] = node.lower_to[i];
        wide.upper_from[i] = node.upper_from[i];
    }
    return wide;
}

PlaneSides pair_sides(const BoxRay& ray, std::uint32_t axis, std::int32_t lower_to, std::int32_t upper_from,
                      const Config& config) {
    const bool neg = axis < no_axis && ray.neg[axis] != 0;
    PlaneSides sides = plane_sides(ray, axis, neg ? upper_from : lower_to, config);
    const PlaneSides other = plane_sides(ray, axis, neg ? lower_to : upper_from, config);
    sides.far = other.far;
    sides.far_from = other.far_from;
    return sides;
}

std::uint32_t bih_exits(const BoxRay& ray, const WideBih& node, const Config& config, std::uint32_t* t_near) {
    AllSides sides;
    for (std::size_t i = 0; i + 1 < std::size_t(config.node_width); ++i)
        sides[i] = pair_sides(ray, node.axis[i], node.lower_to[i], node.upper_from[i], config);
    return exits_met(ray, node, sides, config, t_near);
}

NodeAnswer bih_answer(const BihReq& req, const Config& config) {
    const WideBih wide = widen(req.node, config.node_width);
    std::array<std::uint32_t, max_width> t_near;
    const std::uint32_t hits = bih_exits({req.o, req.neg, req.recip, req.len}, wide, config, t_near.data());
    return node_answer(req.ray, hits, t_near.data(), wide.exits);
}

}   // namespace rayclock

// Quantises the globes of a node.
#include "model/engine/spheres/encode.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

namespace rayclock::spheres {

namespace {

constexpr double max_steps = (1 << globe_bits) - 1;

/// Writes a globe in steps of 2^exp from `org`. Returns false if it does not fit.
bool place(const Globe& globe, const Vec3i& org, std::uint32_t exp, std::size_t i, GlobeNode& node) {
    const double step = double(std::uint32_t(1) << exp);
    glm::dvec3 moved;
    for (int k = 0; k < 3; ++k) {
        const double from = globe.centre[k] - org[std::size_t(k)], steps = std::round(from / step);
        if (steps > max_steps) return false;
        node.centre[3 * i + std::size_t(k)] = std::uint32_t(steps);
        moved[k] = from - steps * step;
    }
    const double radius = std::ceil((globe.radius + glm::length(moved)) / step);
    node.radius[i] = std::uint32_t(std::min(radius, max_steps));
    return radius <= max_steps;
}

}   // namespace

GlobeNode encode_globes(std::span<const GlobeChild> children, std::uint32_t base, const Config& config) {
    GlobeNode node;
    node.base = base;
    const std::int32_t least = -(1 << (config.coord_bits - 1));
    for (std::size_t k = 0; k < 3; ++k) {
        node.org[k] = std::numeric_limits<std::int32_t>::max();
        for (const GlobeChild& child : children)
            node.org[k] = std::min(node.org[k], std::int32_t(std::floor(child.globe.centre[int(k)])));
        node.org[k] = std::max(node.org[k], least);
    }
    for (bool fits = false; !fits; node.exp += !fits) {
        fits = true;
        for (std::size_t i = 0; i < children.size() && fits; ++i)
            fits = place(children[i].globe, node.org, node.exp, i, node);
    }
    for (std::size_t i = 0; i < children.size(); ++i) node.kind[i] = 1 + children[i].primitives;
    return node;
}

}   // namespace rayclock::spheres

// The unit globe: which globes of a node a ray meets.
#include "model/engine/spheres/globe.hpp"

#include <algorithm>
#include <bit>
#include <cstdlib>

#include "model/engine/spheres/tables.hpp"
#include "model/unit/tri/vectors.hpp"

namespace rayclock {

namespace {

constexpr int radius_frac = 3;                        ///< distances are compared in eighths of a node's step
constexpr int drop = toward_bits - 2 - radius_frac;   ///< from a product with the direction to an eighth
/// No component of a relevant distance reaches this.
constexpr std::int64_t distance_limit = 1 << (toward_bits - 1);

/// Values that all globes of a node share.
struct Sight {
    Vec3l moment{};             ///< (D x e) / 2^exp
    std::int64_t way = 0;       ///< D . e, in units of 2^(exp + 13)
    std::int64_t slack = 0;     ///< s
    std::int64_t square = 0;    ///< |e|^2 / 2^18, rounded up
    std::int64_t inverse = 0;   ///< K
    std::int64_t least = 0;     ///< least A + H of a globe that is not behind the origin
    int shift = 0;              ///< shift of K (A - H)
};

/// Returns 2^(49 + n) / |e|^2, and n.
std::int64_t inverse_of(std::int64_t square, int& n) {
    n = std::max(0, int(std::bit_width(std::uint64_t(square))) - 33);
    const auto z = std::uint32_t(square >> (16 + n)) & 0xffff;
    const TableEntry& entry = near_inverse_table()[z >> 9];
    return entry.value - (entry.step * (z & 511) >> 9);
}

Sight sight_of(const GlobeRay& ray, const WideGlobes& node, const Config& c) {
    Vec3l d{}, e{};
    Sight sight;
    std::int64_t away = 2, along = 0, square = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        d[k] = node.children.org[k] - (ray.o[k] >> c.origin_frac());
        e[k] = ray.toward[k];
        away += std::abs(d[k]);
        along += d[k] * e[k];
        square += e[k] * e[k];
    }
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
        sight.moment[k] = (d[i] * e[j] - d[j] * e[i]) >> node.exp;
    }
    const bool shades = c.shading != 0;
    int n = 0;
    sight.way = (along - (shades ? 49 << drop : 0)) >> (node.exp + drop);
    sight.slack = (((away >> drop) + (shades ? 15 : 1)) >> node.exp) + 3;
    sight.square = (square >> toward_bits) + 1;
    sight.inverse = inverse_of(square, n);
    sight.least = shades ? -99 : -1;
    sight.shift = c.t_frac_bits + c.ray_dir_bits() - 20 - int(ray.len) + int(node.exp) - n;
    return sight;
}

/// Returns the root rounded up.
std::int64_t root_up(std::int64_t square) {
    const int g = (int(std::bit_width(std::uint64_t(square))) - 1) / 2;
    const std::int64_t i = g >= 3 ? square >> (2 * g - 6) : square << (6 - 2 * g);
    const std::int64_t root = root_up_table()[std::size_t(i - 64)].value;
    return g >= 8 ? root << (g - 8) : (root + (1 << (8 - g)) - 1) >> (8 - g);
}

}   // namespace

GlobeRay globe_ray(const Ray& ray, const Config& config) {
    GlobeRay out;
    out.o = ray.o;
    std::uint32_t used = 0;
    for (const std::int32_t d : ray.d) used |= std::uint32_t(d ^ d >> 31);
    out.len = std::uint32_t(std::bit_width(used));
    const int up = toward_bits - 1 - int(out.len);
    if (ray.kind != RayKind::shadow) out.len += std::uint32_t(config.ray_dir_bits() - config.dir_bits);
    constexpr std::int32_t most = (1 << (toward_bits - 1)) - 1;
    for (std::size_t k = 0; k < 3; ++k)
        out.toward[k] = up >= 0 ? ray.d[k] * (1 << up) : std::min((ray.d[k] + (1 << (-up - 1))) >> -up, most);
    return out;
}

WideGlobes widen(const GlobeNode& node, int node_width) {
    WideGlobes wide;
    wide.exp = node.exp;
    WideNode& children = wide.children;
    children.base = node.base;
    for (std::size_t k = 0; k < 3; ++k) children.org[k] = node.org[k];
    std::uint32_t inner = 0, primitives = 0;
    for (int i = 0; i < node_width; ++i) inner += node.kind[std::size_t(i)] == 1;
    for (std::size_t i = 0; i < std::size_t(node_width) && node.kind[i] != 0; ++i) {
        for (std::size_t k = 0; k < 3; ++k) wide.centre[k][i] = std::int32_t(node.centre[3 * i + k]);
        wide.radius[i] = std::int32_t(node.radius[i]);
        children.count[i] = std::uint8_t(node.kind[i] - 1);
        children.offset[i] = std::uint8_t(node.kind[i] == 1 ? 2 * i : 2 * inner + primitives);
        primitives += node.kind[i] - 1;
        ++children.children;
    }
    children.children_mask = std::uint8_t((1u << children.children) - 1);
    children.inner_mask = std::uint8_t((1u << inner) - 1);
    return wide;
}

std::uint32_t globe_children(const GlobeRay& ray, const WideGlobes& node, const Config& c,
                             std::uint32_t* t_near) {
    const Sight sight = sight_of(ray, node, c);
    const std::int64_t beyond = (std::int64_t(1) << c.t_bits()) - 1;
    std::uint32_t hits = 0;
    for (std::size_t i = 0; i < node.children.children; ++i) {
        Vec3l q{};
        for (std::size_t k = 0; k < 3; ++k) q[k] = node.centre[k][i];
        bool met = true;
        std::int64_t sum = 0, along = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t x = (k + 1) % 3, y = (k + 2) % 3;
            const std::int64_t moment = sight.moment[k] + q[x] * ray.toward[y] - q[y] * ray.toward[x],
                               far = (moment ^ moment >> 63) >> drop;
            met = met && far < distance_limit;
            sum += far * far;
            along += q[k] * ray.toward[k];
        }
        const std::int64_t reach = (std::int64_t(node.radius[i]) << radius_frac) + sight.slack,
                           most = (reach * reach * sight.square) >> 14;
        t_near[i] = 0;
        if (!met || sum > most) continue;
        const std::int64_t way = sight.way + (along >> drop), half = root_up(most + 1 - sum);
        if (way + half < sight.least) continue;
        hits |= 1u << i;
        const std::int64_t times = sight.inverse * std::max<std::int64_t>(way - half, 0);
        const std::int64_t t = sight.shift < 0 ? times >> std::min(-sight.shift, 63)
                               : times > beyond >> std::min(sight.shift, 62) ? beyond
                                                                             : times << sight.shift;
        t_near[i] = std::uint32_t(std::min(t, beyond));
    }
    return hits;
}

}   // namespace rayclock

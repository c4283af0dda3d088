#include "model/trav/box.hpp"

#include <algorithm>
#include <bit>
#include <cstring>

// Wider vectors where the processor has them; the results are the same, since every operation is exact.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__)
#define RAYCLOCK_CLONES __attribute__((target_clones("avx2", "default")))
#else
#define RAYCLOCK_CLONES
#endif

namespace rayclock {

namespace {

// Four children at a time, in double precision: every value is an integer below 2^53 times a power of two, so that
// products, sums and comparisons are exact and no rounding is left to the machine.
using Planes = float __attribute__((vector_size(16)));
using Lanes = double __attribute__((vector_size(32)));
using Mask = std::int64_t __attribute__((vector_size(32)));
constexpr std::size_t halves = max_width / 4;

/// 2^exponent, exact.
double power_of_two(int exponent) { return std::bit_cast<double>(std::uint64_t(1023 + exponent) << 52); }

/// One axis of the slab test, ready for the children's planes.
struct Axis {
    double near, far;             // D r / 2^e down, D (r + 1) / 2^e up
    double near_step, far_step;   // signed r and r + 1
    double scale;                 // to t's unit
    const float* near_q;
    const float* far_q;
    bool zero;
};

Axis make_axis(const BoxRay& ray, const WideNode& node, std::size_t k, const Config& c) {
    const bool neg = ray.neg[k] != 0;
    const int e = int(node.exp[k]);
    const std::int64_t distance = neg ? std::int64_t(ray.o[k]) - node.org[k] : std::int64_t(node.org[k]) - ray.o[k];
    const std::int64_t r = ray.recip[k], r_up = r + (ray.len[k] != 0);
    Axis axis;
    axis.near = double((distance * r) >> e);
    axis.far = double(-((-distance * r_up) >> e));
    axis.near_step = double(neg ? -r : r);
    axis.far_step = double(neg ? -r_up : r_up);
    axis.scale = power_of_two(c.t_frac_bits + c.dir_bits - int(ray.len[k]) - c.recip_bits + e);
    axis.near_q = neg ? node.hi[k].data() : node.lo[k].data();
    axis.far_q = neg ? node.lo[k].data() : node.hi[k].data();
    axis.zero = ray.len[k] == 0;
    return axis;
}


/// Where the ray is inside all slabs of each child: t in [near, far], not yet rounded; far < 0 for a miss.
struct Interval {
    alignas(32) std::array<double, max_width> near, far;
};
RAYCLOCK_CLONES void intersect(const std::array<Axis, 3>& axes, double beyond, Interval& t) {
    for (std::size_t h = 0; h < halves; ++h) {
        Lanes near{}, far = near + (beyond + 1);
        for (const Axis& a : axes) {
            Planes near_q, far_q;
            std::memcpy(&near_q, a.near_q + 4 * h, sizeof near_q);
            std::memcpy(&far_q, a.far_q + 4 * h, sizeof far_q);
            const Lanes n = (a.near + __builtin_convertvector(near_q, Lanes) * a.near_step) * a.scale;
            const Lanes f = (a.far + __builtin_convertvector(far_q, Lanes) * a.far_step) * a.scale;
            if (a.zero) {
                const Mask outside = n > 0.0 || f < 0.0;
                far = outside ? Lanes{} - 1.0 : far;
            } else {
                near = n > near ? n : near;
                far = f < far ? f : far;
            }
        }
        std::memcpy(&t.near[4 * h], &near, sizeof near);
        std::memcpy(&t.far[4 * h], &far, sizeof far);
    }
}

} // namespace

WideNode widen(const Node& node, int node_width) {
    WideNode wide;
    wide.org = node.org;
    wide.exp = node.exp;
    wide.base = node.base;
    std::uint32_t inner = 0, triangles = 0;
    for (int i = 0; i < node_width; ++i) inner += node.kind[std::size_t(i)] == 1;
    for (std::size_t i = 0; i < std::size_t(node_width) && node.kind[i] != 0; ++i, ++wide.children) {
        for (std::size_t k = 0; k < 3; ++k) {
            wide.lo[k][i] = float(node.lo[3 * i + k]);
            wide.hi[k][i] = float(node.hi[3 * i + k]);
        }
        wide.count[i] = std::uint8_t(node.kind[i] - 1);
        wide.offset[i] = std::uint8_t(wide.count[i] == 0 ? 2 * i : 2 * inner + triangles);
        triangles += wide.count[i];
    }
    return wide;
}

void box_children(const BoxRay& ray, const WideNode& node, const Config& config, BoxRsp& out) {
    const double beyond = double((1u << config.t_bits()) - 1);
    Interval t;
    intersect({make_axis(ray, node, 0, config), make_axis(ray, node, 1, config), make_axis(ray, node, 2, config)}, beyond, t);
    out.base = node.base;
    out.inner = out.leaves = 0;
    std::array<std::uint64_t, max_width> key;
    std::size_t n = 0;
    for (std::size_t i = 0; i < std::size_t(node.children); ++i) {
        // near rounded down and far up: floor(near) <= ceil(far) is floor(near) - 1 < far, for far >= 0.
        const std::uint32_t near = std::uint32_t(std::min(t.near[i], beyond));
        if (!(double(near) - 1 < t.far[i]) || t.far[i] < 0) continue;
        const bool leaf = node.count[i] != 0;
        (leaf ? out.leaves : out.inner) += 1;
        // Order: inner children first, then t_near, then place in memory; the count rides along.
        const std::uint64_t entry = std::uint64_t(leaf) << 40 | std::uint64_t(near) << 9 | std::uint64_t(node.offset[i]) << 3 | node.count[i];
        std::size_t at = n++;
        for (; at > 0 && key[at - 1] > entry; --at) key[at] = key[at - 1];
        key[at] = entry;
    }
    out.t_near.fill(0);
    out.offset.fill(0);
    out.count.fill(0);
    for (std::size_t i = 0; i < n; ++i) {
        out.t_near[i] = std::uint32_t(key[i] >> 9 & 0x7fff'ffff);
        out.offset[i] = std::uint32_t(key[i] >> 3 & 63);
        out.count[i] = std::uint32_t(key[i] & 7);
    }
}

BoxRsp box(const BoxReq& req, const Config& config) {
    BoxRsp rsp;
    rsp.ray = req.ray;
    box_children({req.o, req.neg, req.recip, req.len}, widen(req.node, config.node_width), config, rsp);
    return rsp;
}

} // namespace rayclock

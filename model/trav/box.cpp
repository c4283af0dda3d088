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

// Four children at a time, in double precision: every value is a whole number below 2^53 times a power of two, so that
// products, sums and comparisons are exact and no rounding is left to the machine.
using Planes = float __attribute__((vector_size(16)));
using Whole = std::int32_t __attribute__((vector_size(16)));
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


/// A child's place in the order: leaf, t_near, offset, with the count riding along. Children that are missed come last.
/// Below 2^42, so that it is exact in a double.
using Keys = std::array<double, max_width>;
constexpr double leaf_key = 0x1p40, missed_key = 0x1p50;
constexpr int near_shift = 9;   // above offset (6 bits) and count (3 bits)

/// Keys of the children whose interval on the ray is not empty: near rounded down <= far rounded up, and far >= 0.
/// floor(near) <= ceil(far) is floor(near) - 1 < far.
RAYCLOCK_CLONES void intersect(const std::array<Axis, 3>& axes, const WideNode& node, double beyond, Keys& keys) {
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
        near = near < beyond ? near : Lanes{} + beyond;
        const Lanes down = __builtin_convertvector(__builtin_convertvector(near, Whole), Lanes);
        Lanes key;
        std::memcpy(&key, &node.key[4 * h], sizeof key);
        const Mask hit = down - 1.0 < far && far >= 0.0;
        key = hit ? key + down * double(1 << near_shift) : Lanes{} + missed_key;
        std::memcpy(&keys[4 * h], &key, sizeof key);
    }
}

/// Puts two keys in order without a branch, which no predictor could guess.
void order(std::uint64_t& a, std::uint64_t& b) {
    const std::uint64_t exchange = (a ^ b) & -std::uint64_t(b < a);
    a ^= exchange;
    b ^= exchange;
}

/// Batcher's merge sort of the first four or of all eight.
void sort_four(std::uint64_t* k) {
    order(k[0], k[1]), order(k[2], k[3]);
    order(k[0], k[2]), order(k[1], k[3]);
    order(k[1], k[2]);
}
void sort_eight(std::uint64_t* k) {
    sort_four(k);
    sort_four(k + 4);
    order(k[0], k[4]), order(k[1], k[5]), order(k[2], k[6]), order(k[3], k[7]);
    order(k[2], k[4]), order(k[3], k[5]);
    order(k[1], k[2]), order(k[3], k[4]), order(k[5], k[6]);
}

} // namespace

WideNode widen(const Node& node, int node_width) {
    WideNode wide;
    wide.org = node.org;
    wide.exp = node.exp;
    wide.base = node.base;
    wide.key.fill(missed_key);
    std::uint32_t inner = 0, triangles = 0;
    for (int i = 0; i < node_width; ++i) inner += node.kind[std::size_t(i)] == 1;
    for (std::size_t i = 0; i < std::size_t(node_width) && node.kind[i] != 0; ++i, ++wide.children) {
        for (std::size_t k = 0; k < 3; ++k) {
            wide.lo[k][i] = float(node.lo[3 * i + k]);
            wide.hi[k][i] = float(node.hi[3 * i + k]);
        }
        const std::uint32_t count = node.kind[i] - 1;
        const std::uint32_t offset = count == 0 ? std::uint32_t(2 * i) : 2 * inner + triangles;
        wide.key[i] = (count == 0 ? 0 : leaf_key) + double(offset << 3 | count);
        triangles += count;
    }
    return wide;
}

void box_children(const BoxRay& ray, const WideNode& node, const Config& config, BoxRsp& out) {
    const double beyond = double((1u << config.t_bits()) - 1);
    Keys keys;
    intersect({make_axis(ray, node, 0, config), make_axis(ray, node, 1, config), make_axis(ray, node, 2, config)}, node, beyond, keys);

    // Those that are hit, packed; most nodes have few.
    std::array<std::uint64_t, max_width> hit;
    hit.fill(~std::uint64_t(0));
    std::uint32_t hits = 0, inner = 0;
    for (const double key : keys) {
        hit[hits & (max_width - 1)] = std::uint64_t(std::int64_t(key));
        hits += key < missed_key;
        inner += key < leaf_key;
    }
    if (hits < max_width) hit[hits] = ~std::uint64_t(0);
    if (hits > 4) sort_eight(hit.data());
    else if (hits > 1) sort_four(hit.data());

    out.base = node.base;
    out.inner = inner;
    out.leaves = hits - inner;
    out.t_near.fill(0);
    out.offset.fill(0);
    out.count.fill(0);
    for (std::size_t i = 0; i < hits; ++i) {
        out.t_near[i] = std::uint32_t(hit[i] >> near_shift & 0x7fff'ffff);
        out.offset[i] = std::uint32_t(hit[i] >> 3 & 63);
        out.count[i] = std::uint32_t(hit[i] & 7);
    }
}

BoxRsp box(const BoxReq& req, const Config& config) {
    BoxRsp rsp;
    rsp.ray = req.ray;
    box_children({req.o, req.neg, req.recip, req.len}, widen(req.node, config.node_width), config, rsp);
    return rsp;
}

} // namespace rayclock

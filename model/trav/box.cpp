#include "model/trav/box.hpp"

#include <algorithm>

namespace rayclock {

namespace {

/// One axis of the slab test, ready for the children's planes.
struct Axis {
    std::int64_t near, far;                 // D r / 2^e down, D (r + 1) / 2^e up
    std::int64_t near_step, far_step;       // signed r and r + 1
    const std::uint8_t* near_q;
    const std::uint8_t* far_q;
    int shift;                              // V counts 2^-shift of t's unit
    bool zero;
};

Axis make_axis(const BoxRay& ray, const WideNode& node, std::size_t k, const Config& c) {
    const bool neg = ray.neg[k] != 0;
    const int e = int(node.exp[k]);
    const std::int64_t distance = neg ? std::int64_t(ray.o[k]) - node.org[k] : std::int64_t(node.org[k]) - ray.o[k];
    const std::int64_t r = ray.recip[k], r_up = r + (ray.len[k] != 0);
    Axis axis;
    axis.near = (distance * r) >> e;
    axis.far = -((-distance * r_up) >> e);
    axis.near_step = neg ? -r : r;
    axis.far_step = neg ? -r_up : r_up;
    axis.near_q = neg ? node.hi[k].data() : node.lo[k].data();
    axis.far_q = neg ? node.lo[k].data() : node.hi[k].data();
    axis.shift = c.t_frac_bits + c.dir_bits - int(ray.len[k]) - c.recip_bits + e;
    axis.zero = ray.len[k] == 0;
    return axis;
}

std::int64_t scale_down(std::int64_t v, int shift, std::int64_t most) {
    return std::min(shift >= 0 ? v << shift : v >> -shift, most);
}
std::int64_t scale_up(std::int64_t v, int shift, std::int64_t most) {
    return std::min(shift >= 0 ? v << shift : -(-v >> -shift), most);
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
            wide.lo[k][i] = std::uint8_t(node.lo[3 * i + k]);
            wide.hi[k][i] = std::uint8_t(node.hi[3 * i + k]);
        }
        wide.count[i] = std::uint8_t(node.kind[i] - 1);
        wide.offset[i] = std::uint8_t(wide.count[i] == 0 ? 2 * i : 2 * inner + triangles);
        triangles += wide.count[i];
    }
    return wide;
}

void box_children(const BoxRay& ray, const WideNode& node, const Config& config, BoxRsp& out) {
    const std::int64_t beyond = (std::int64_t(1) << config.t_bits()) - 1;
    std::array<std::int64_t, max_width> near{}, far{};
    far.fill(beyond);
    for (std::size_t k = 0; k < 3; ++k) {
        const Axis a = make_axis(ray, node, k, config);
        for (std::size_t i = 0; i < std::size_t(node.children); ++i) {
            const std::int64_t n = a.near + a.near_q[i] * a.near_step;
            const std::int64_t f = a.far + a.far_q[i] * a.far_step;
            if (f < 0 || (a.zero && n > 0)) far[i] = -1;
            if (a.zero) continue;
            if (n > 0) near[i] = std::max(near[i], scale_down(n, a.shift, beyond));
            if (f >= 0) far[i] = std::min(far[i], scale_up(f, a.shift, beyond));
        }
    }
    out.base = node.base;
    out.inner = out.leaves = 0;
    std::array<std::uint64_t, max_width> key{};
    std::size_t n = 0;
    for (std::size_t i = 0; i < std::size_t(node.children); ++i) {
        if (near[i] > far[i]) continue;
        const bool leaf = node.count[i] != 0;
        (leaf ? out.leaves : out.inner) += 1;
        // Order: inner children first, then t_near, then place in memory; the count rides along.
        const std::uint64_t entry = std::uint64_t(leaf) << 40 | std::uint64_t(near[i]) << 9 | std::uint64_t(node.offset[i]) << 3 | node.count[i];
        std::size_t at = n++;
        for (; at > 0 && key[at - 1] > entry; --at) key[at] = key[at - 1];
        key[at] = entry;
    }
    for (std::size_t i = 0; i < max_width; ++i) {
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

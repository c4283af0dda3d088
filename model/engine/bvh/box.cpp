// The unit box: unpacks nodes, tests their children and sorts the answer.
#include "model/engine/bvh/box.hpp"

#include "model/engine/bvh/slab.hpp"

namespace rayclock {

namespace {

/// Sets the place of a child's triangles or node. Call it for the children in order.
void place_child(WideNode& node, std::uint32_t kind, std::uint32_t inner, std::uint32_t& triangles) {
    const std::size_t i = node.children;
    node.count[i] = std::uint8_t(kind - 1);
    node.offset[i] = std::uint8_t(kind == 1 ? 2 * i : 2 * inner + triangles);
    triangles += kind - 1;
    ++node.children;
}
void set_masks(WideNode& node, std::uint32_t inner) {
    node.children_mask = std::uint8_t((1u << node.children) - 1);
    node.inner_mask = std::uint8_t((1u << inner) - 1);
}

/// Returns `width` <= 32 bits of a line, from bit `at` on.
std::uint32_t bits_at(const std::uint32_t* line, int at, int width) {
    const int word = at / 32;
    const std::uint64_t two = line[word] | std::uint64_t(word < 15 ? line[word + 1] : 0) << 32;
    return std::uint32_t(two >> at % 32 & ((std::uint64_t(1) << width) - 1));
}

/// Records the lowest bit of each field of Node::fields.
struct PlaceVisitor {
    int at;
    std::array<int, 6> lowest{};
    std::size_t next = 0;
    template <class T> void operator()(const char*, const T&, int width) { lowest[next++] = at -= width; }
    template <class T, std::size_t n>
    void operator()(const char*, const std::array<T, n>&, int width, int count) {
        lowest[next++] = at -= width * count;
    }
};

}   // namespace

namespace plain {
#include "model/engine/bvh/slab.inl"
}   // namespace plain

std::uint32_t box_children_plain(const BoxRay& ray, const WideNode& node, const Config& config,
                                 std::uint32_t* t_near) {
    return plain::slab_test(slab_ray(ray, config), node, node.children, t_near);
}

#ifdef RAYCLOCK_AVX2
#pragma GCC push_options
#pragma GCC target("avx2")
#define RAYCLOCK_WITH_AVX2
namespace avx2 {
#include "model/engine/bvh/slab.inl"
static void test(const SlabRay& ray, const WideNode& node, std::uint32_t* t_near, std::uint32_t& hits) {
    hits = slab_test(ray, node, node.children, t_near);
}
}   // namespace avx2
#undef RAYCLOCK_WITH_AVX2
#pragma GCC pop_options

std::uint32_t box_children(const BoxRay& ray, const WideNode& node, const Config& config,
                           std::uint32_t* t_near) {
    if (!__builtin_cpu_supports("avx2")) return box_children_plain(ray, node, config, t_near);
    std::uint32_t hits = 0;
    avx2::test(slab_ray(ray, config), node, t_near, hits);
    return hits;
}
#else
std::uint32_t box_children(const BoxRay& ray, const WideNode& node, const Config& config,
                           std::uint32_t* t_near) {
    return box_children_plain(ray, node, config, t_near);
}
#endif

WideNode widen(const Node& node, int node_width) {
    WideNode wide;
    wide.base = node.base;
    for (std::size_t k = 0; k < 3; ++k) {
        wide.org[k] = node.org[k];
        wide.exp[k] = std::uint8_t(node.exp[k]);
    }
    std::uint32_t inner = 0, triangles = 0;
    for (int i = 0; i < node_width; ++i) inner += node.kind[std::size_t(i)] == 1;
    for (std::size_t i = 0; i < std::size_t(node_width) && node.kind[i] != 0; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            wide.planes[k * max_width + i] = std::uint8_t(node.lo[3 * i + k]);
            wide.planes[(3 + k) * max_width + i] = std::uint8_t(node.hi[3 * i + k]);
        }
        place_child(wide, node.kind[i], inner, triangles);
    }
    set_masks(wide, inner);
    return wide;
}

NodeReader::NodeReader(const Config& config)
    : coord_bits_(config.coord_bits),
      addr_bits_(config.addr_bits),
      box_bits_(config.box_bits),
      node_width_(config.node_width) {
    PlaceVisitor place{bits_of<Node>(config), {}, 0};
    Node{}.fields(place, config);
    org_ = place.lowest[0], exp_ = place.lowest[1], base_ = place.lowest[2];
    kind_ = place.lowest[3], lo_ = place.lowest[4], hi_ = place.lowest[5];
}

WideNode NodeReader::operator()(const std::uint32_t* line) const {
    WideNode wide;
    wide.base = bits_at(line, base_, addr_bits_);
    for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t org = bits_at(line, org_ + int(k) * coord_bits_, coord_bits_);
        wide.org[k] = std::int32_t(org << (32 - coord_bits_)) >> (32 - coord_bits_);
        wide.exp[k] = std::uint8_t(bits_at(line, exp_ + int(k) * exp_bits, exp_bits));
    }
    const auto kind = [&](int i) { return bits_at(line, kind_ + i * count_bits, count_bits); };
    std::uint32_t inner = 0, triangles = 0;
    for (int i = 0; i < node_width_; ++i) inner += kind(i) == 1;
    for (int i = 0; i < node_width_ && kind(i) != 0; ++i) place_child(wide, kind(i), inner, triangles);
    const std::uint32_t plane = (1u << box_bits_) - 1;
    for (std::size_t i = 0; i < wide.children; ++i) {
        const int at = int(3 * i) * box_bits_;
        std::uint32_t lo = bits_at(line, lo_ + at, 3 * box_bits_),
                      hi = bits_at(line, hi_ + at, 3 * box_bits_);
        for (std::size_t k = 0; k < 3; ++k, lo >>= box_bits_, hi >>= box_bits_) {
            wide.planes[k * max_width + i] = std::uint8_t(lo & plane);
            wide.planes[(3 + k) * max_width + i] = std::uint8_t(hi & plane);
        }
    }
    set_masks(wide, inner);
    return wide;
}

NodeAnswer box(const BoxReq& req, const Config& config, BoxTest* test) {
    const WideNode node = widen(req.node, config.node_width);
    std::array<std::uint32_t, max_width> t_near;
    const std::uint32_t hits = test({req.o, req.neg, req.recip, req.len}, node, config, t_near.data());
    return node_answer(req.ray, hits, t_near.data(), node);
}

}   // namespace rayclock

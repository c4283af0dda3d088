// The extremes of a memory image and a frame. Products with the direction are bounded for each triangle, so
// that det, u, v are as tight as a box of directions allows: each is linear in d, with a vector that the
// triangle and the eye fix.
#include <cstdlib>

#include "model/engine/bvh/decode.hpp"
#include "model/layout/words.hpp"
#include "model/unit/raygen/raygen.hpp"
#include "sim/explore/fit/ranges.hpp"

namespace rayclock::fit {

namespace {

using Vec = std::array<Int128, 3>;

Vec minus(const Vec3i& a, const Vec3i& b) {
    return {Int128(a[0]) - b[0], Int128(a[1]) - b[1], Int128(a[2]) - b[2]};
}
Vec cross(const Vec& a, const Vec& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
void add(Interval& range, Int128 value) { range = hull(range, point(value)); }
void add(Interval& range, const Interval& more) { range = hull(range, more); }

/// Returns the range of d . a over all directions.
Interval dot(const Extremes::Axes& d, const Vec& a) {
    return d[0] * point(a[0]) + d[1] * point(a[1]) + d[2] * point(a[2]);
}
/// Returns the range of component k of d x e.
Interval turned(const Extremes::Axes& d, const Vec& e, std::size_t k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    return d[i] * point(e[j]) - d[j] * point(e[i]);
}

/// Returns the range of raygen's sum for the pixels x and y.
Interval sum_of(const Frame& f, std::size_t k, const Interval& x, const Interval& y) {
    return point(f.corner[k]) + point(f.right[k]) * x + point(f.down[k]) * y;
}

/// Computes this pixel by pixel: the box of all directions may contain zero although no direction is near it.
void measure_directions(const Frame& f, const Config& config, Extremes& e) {
    e.least_direction = std::int64_t(1) << 62;
    for (std::uint32_t y = 0; y < f.height; ++y)
        for (std::uint32_t x = 0; x < f.width; ++x) {
            const Vec3i d = pixel_direction(x, y, f, config);
            std::int64_t largest = 0;
            for (std::size_t k = 0; k < 3; ++k) {
                add(e.direction[k], d[k]);
                largest = std::max(largest, std::abs(std::int64_t(d[k])));
            }
            e.least_direction = std::min(e.least_direction, largest);
        }
}

void measure_frame(const Frame& f, const Config& config, Extremes& e) {
    const Interval x{0, Int128(f.width) - 1}, y{0, Int128(f.height) - 1};
    for (std::size_t k = 0; k < 3; ++k) {
        e.eye[k] = point(f.eye[k]);
        e.corner[k] = point(f.corner[k]), e.right[k] = point(f.right[k]), e.down[k] = point(f.down[k]);
        add(e.right_x, e.right[k] * x);
        add(e.down_y, e.down[k] * y);
        e.sum[k] = sum_of(f, k, x, y);
    }
    measure_directions(f, config, e);
}

void measure_triangle(const PrimData& t, const Vec3i& eye, Extremes& e) {
    const Vec e1 = minus(t.b, t.a), e2 = minus(t.c, t.a), s = minus(eye, t.a);
    const Vec n = cross(e1, e2), det = cross(e2, e1), u = cross(e2, s), v = cross(s, e1);
    for (std::size_t k = 0; k < 3; ++k) {
        for (const Vec3i& corner : {t.a, t.b, t.c}) {
            add(e.vertex[k], corner[k]);
            add(e.reach, std::abs(std::int64_t(corner[k]) - eye[k]));
        }
        add(e.edge[k], e1[k]);
        add(e.edge[k], e2[k]);
        add(e.to_eye[k], s[k]);
        add(e.normal[k], n[k]);
        const Interval p1 = turned(e.direction, e1, k), p2 = turned(e.direction, e2, k);
        add(e.p1[k], p1);
        add(e.p2[k], p2);
        add(e.edge_term, p2 * point(e1[k]));
        add(e.edge_term, p2 * point(s[k]));
        add(e.edge_term, p1 * point(s[k]));
        add(e.num_term, n[k] * s[k]);
    }
    add(e.det, dot(e.direction, det));
    add(e.u, dot(e.direction, u));
    add(e.v, dot(e.direction, v));
    add(e.w, dot(e.direction, {det[0] - u[0] - v[0], det[1] - u[1] - v[1], det[2] - u[2] - v[2]}));
    add(e.num, n[0] * s[0] + n[1] * s[1] + n[2] * s[2]);
    add(e.prim, t.prim);
}

void measure_node(const Node& node, const Config& config, Extremes& e) {
    Int128 inner = 0, leaves = 0, triangles = 0;
    add(e.base, node.base);
    for (std::size_t i = 0; i < std::size_t(config.node_width); ++i) {
        add(e.kind, node.kind[i]);
        inner += node.kind[i] == 1;
    }
    for (std::size_t i = 0; i < std::size_t(config.node_width) && node.kind[i] != 0; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            Extremes::Group& group = e.groups[k][node.exp[k]];
            add(group.origin, node.org[k]);
            add(group.lo, node.lo[3 * i + k]);
            add(group.hi, node.hi[3 * i + k]);
        }
        if (node.kind[i] == 1) {
            add(e.offset, Int128(2 * i));
            add(e.slot, Int128(i));
            add(e.node, Int128(node.base) + Int128(i));
        } else {
            ++leaves;
            add(e.offset, 2 * inner + triangles);
            for (std::uint32_t n = 0; n + 1 < node.kind[i]; ++n)
                add(e.half_line, 2 * (Int128(node.base) + inner) + triangles++);
        }
    }
    add(e.inner, Interval{0, inner});
    add(e.leaves, Interval{0, leaves});
}

}   // namespace

Extremes extremes(const MemoryImage& image, const Frame& frame, const Config& config) {
    Extremes e;
    measure_frame(frame, config, e);
    e.node = point(frame.root);
    bvh::for_each_node(
        image, frame.root, config, [&](const Node& node, std::uint32_t inner, std::uint32_t triangles) {
            measure_node(node, config, e);
            for (std::uint32_t i = 0; i < triangles; ++i)
                measure_triangle(read_primitive(image, 2 * (node.base + inner) + i, config), frame.eye, e);
        });
    return e;
}

}   // namespace rayclock::fit

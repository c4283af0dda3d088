// Draws origins and directions for hard cases.
#include "sim/explore/stress/aim.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "model/base/axes.hpp"

namespace rayclock::stress {

namespace {

/// Fits v into the bits of a direction. If there is room, multiplies it by a whole number; else returns the
/// nearest direction that fits.
Vec3i fitted(const Vec3l& v, int dir_bits, Rng& rng) {
    std::int64_t size = 0;
    for (const std::int64_t x : v) size = std::max(size, std::abs(x));
    if (size == 0) return any_direction(dir_bits, rng);
    const std::int64_t limit = most(dir_bits), room = limit / size;
    if (room == 0)
        return by_axis([&](std::size_t k) {
            return std::int32_t(std::llround(double(v[k]) * double(limit) / double(size)));
        });
    const std::int64_t factor = rng.below(3) == 0 ? room : 1 + std::int64_t(rng.next() % std::uint64_t(room));
    return by_axis([&](std::size_t k) { return std::int32_t(v[k] * factor); });
}

}   // namespace

Weights weights(Target target, Rng& rng) {
    if (target == Target::any) target = Target(rng.below(3));
    Weights w{1, 0, 0};
    if (target == Target::edge) {
        const int of = 2 + rng.below(4);
        w.b = 1 + rng.below(of - 1);
        w.a = of - w.b;
    } else if (target == Target::inside) {
        w = {1 + rng.below(3), 1 + rng.below(3), 1 + rng.below(3)};
    }
    for (int turns = rng.below(3); turns > 0; --turns) w = {w.c, w.a, w.b};
    return w;
}

Vec3i towards(const Vec3i& o, const oracle::Corners& t, const Weights& w, int dir_bits, Rng& rng) {
    const std::int64_t sum = w.a + w.b + w.c;
    const auto way = [&](std::size_t k) {
        return std::int64_t(w.a) * t.a[k] + std::int64_t(w.b) * t.b[k] + std::int64_t(w.c) * t.c[k] -
               sum * o[k];
    };
    return fitted(by_axis(way), dir_bits, rng);
}

Vec3i towards(const Vec3i& o, const Vec3i& point, int dir_bits, Rng& rng) {
    return towards(o, {point, point, point}, {1, 0, 0}, dir_bits, rng);
}

Vec3i any_direction(int dir_bits, Rng& rng) {
    const int limit = most(dir_bits);
    Vec3i d{};
    do
        for (auto& x : d) x = rng.below(2 * limit + 1) - limit;
    while (d == Vec3i{});
    return d;
}

Vec3i axis_direction(int dir_bits, Rng& rng) {
    const int size = rng.below(2) ? most(dir_bits) : 1 + rng.below(most(dir_bits));
    Vec3i d{};
    d[std::size_t(rng.below(3))] = rng.below(2) ? size : -size;
    return d;
}

Vec3i outside(const Mesh& mesh, int coord_bits, Rng& rng) {
    const int limit = most(coord_bits);
    const std::size_t axis = std::size_t(rng.below(3));
    const bool near = rng.below(2) != 0;
    Vec3i o{};
    for (std::size_t k = 0; k < 3; ++k) {
        const int size = mesh.hi[k] - mesh.lo[k] + 1;
        const int lo = near ? std::max(-limit, mesh.lo[k] - size / 4 - 1) : -limit,
                  hi = near ? std::min(limit, mesh.hi[k] + size / 4 + 1) : limit;
        o[k] = lo + rng.below(hi - lo + 1);
        if (k != axis) continue;
        const int below = mesh.lo[k] - lo, above = hi - mesh.hi[k];
        const int place = rng.below(below + above);
        o[k] = place < below ? lo + place : mesh.hi[k] + 1 + (place - below);
    }
    return o;
}

double scale(int coord_bits, int least, Rng& rng) {
    double size = 0.7 * most(coord_bits);
    for (int steps = rng.below(4); steps > 0 && size / 8 >= least; --steps) size /= 8;
    return size;
}

}   // namespace rayclock::stress

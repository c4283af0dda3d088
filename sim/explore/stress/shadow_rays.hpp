#pragma once
// Random cameras, targets and lights around a mesh, chosen to be difficult for secondary-ray origins.
#include <algorithm>
#include <vector>

#include "model/base/axes.hpp"
#include "model/base/rng.hpp"
#include "sim/judge/oracle/cross.hpp"
#include "sim/judge/oracle/tree.hpp"

namespace rayclock {

/// Returns the nearest point of the lattice of N bits, whose lowest coordinate is excluded.
inline Vec3i inside_lattice(const Vec3i& p, int bits) {
    const int most = (1 << (bits - 1)) - 1;
    return by_axis([&](std::size_t k) { return std::clamp(p[k], -most, most); });
}

/// Draws cameras, targets and lights for one mesh from a seed.
class ShadowRays {
public:
    ShadowRays(const std::vector<oracle::Corners>& mesh, const oracle::Extent& bounds, int coord_bits,
               std::uint64_t seed)
        : mesh_(mesh), bounds_(bounds), bits_(coord_bits), rng_(seed) {}

    int below(int n) { return rng_.below(n); }
    int between(int lo, int hi) { return lo + below(hi - lo + 1); }

    Vec3i camera() {
        const int kind = below(4);
        if (kind == 0) return any_point();
        if (kind == 1) return point_in_bounds();
        const Vec3i at = corner();
        const int reach = kind == 2 ? 40 : 1 << below(bits_ - 1);
        return near(at, reach);
    }

    /// Returns a target, doubled so that midpoints of edges are exact: a corner, a midpoint, or a point
    /// inside a triangle.
    Vec3i target() {
        const oracle::Corners& t = any_triangle();
        const int weights[][3] = {{2, 0, 0}, {1, 1, 0}, {0, 1, 1}, {1, 0, 1}};
        if (const int kind = below(8); kind < 4)
            return by_axis([&, w = weights[kind]](std::size_t k) {
                return w[0] * t.a[k] + w[1] * t.b[k] + w[2] * t.c[k];
            });
        const std::int64_t u = below(1025), v = below(1025 - int(u));
        return by_axis(
            [&](std::size_t k) { return int(((1024 - u - v) * t.a[k] + u * t.b[k] + v * t.c[k]) / 512); });
    }

    /// Returns a light for a hit near `hit` on triangle t.
    Vec3i light(const oracle::Corners& t, const Vec3i& hit) {
        switch (below(7)) {
            case 0: return any_point();
            case 1: return point_in_bounds();
            case 2: return near(hit, 2 << below(5));
            case 3: {
                const Vec3i at = corner();
                return near(at, below(2));
            }
            case 4:
                return inside_lattice(
                    {bounds_.hi[0] + 3, below(2) != 0 ? bounds_.hi[1] + 3 : bounds_.lo[1] - 3, 7}, bits_);
            default: {   // in the triangle's plane or slightly off it
                const int u = between(-3, 3), v = between(-3, 3), reach = below(3);
                const auto in_plane = [&](std::size_t k) {
                    return t.a[k] + u * (t.b[k] - t.a[k]) + v * (t.c[k] - t.a[k]);
                };
                return near(by_axis(in_plane), reach);
            }
        }
    }

private:
    const oracle::Corners& any_triangle() { return mesh_[std::size_t(below(int(mesh_.size())))]; }
    Vec3i any_point() {
        const int most = (1 << (bits_ - 1)) - 1;
        return by_axis([&](std::size_t) { return between(-most, most); });
    }
    Vec3i point_in_bounds() {
        return by_axis([&](std::size_t k) { return between(bounds_.lo[k], bounds_.hi[k]); });
    }
    Vec3i near(const Vec3i& p, int reach) {
        return inside_lattice(by_axis([&](std::size_t k) { return p[k] + between(-reach, reach); }), bits_);
    }
    Vec3i corner() {
        const oracle::Corners& t = any_triangle();
        return std::array{t.a, t.b, t.c}[std::size_t(below(3))];
    }

    const std::vector<oracle::Corners>& mesh_;
    oracle::Extent bounds_;
    int bits_;
    Rng rng_;
};

}   // namespace rayclock

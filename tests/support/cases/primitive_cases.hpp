#pragma once
// Shared by the tests of all primitive tests: configurations, a closed sphere, and rays aimed at it.
#include <algorithm>
#include <cmath>

#include "model/unit/tri/tri_test.hpp"
#include "model/engine/check.hpp"
#include "model/scene/builtin.hpp"
#include "tests/support/cases/tri_cases.hpp"

namespace rayclock::test {

inline Config with_test(const std::string& test, int coord_bits = 18) {
    Config config;
    config.coord_bits = coord_bits;
    config.dir_bits = std::min(24, 62 - 2 * coord_bits);
    set_parameter(config, "primitive_test", test, "test");
    check_config(config, "test");
    return config;
}

inline TriRsp run_test(const Config& config, const Vec3i& o, const Vec3i& d, const PrimData& triangle,
                       const Best& best = {}) {
    TriRsp rsp;
    tri_test_of(config)(o, d, triangle, best, config, rsp);
    return rsp;
}

/// Returns a closed sphere around the lattice's centre; all triangles have the same orientation.
inline std::vector<PrimData> sphere(int size, double radius) {
    const Scene scene = make_builtin("icosphere:" + std::to_string(size));
    std::vector<PrimData> all;
    for (const auto& t : scene.triangles) {
        std::array<Vec3i, 3> corner;
        for (std::size_t i = 0; i < 3; ++i)
            for (int k = 0; k < 3; ++k)
                corner[i][std::size_t(k)] =
                    std::int32_t(std::lround(scene.vertices[t.vertex[i]][k] * radius));
        all.push_back({corner[0], corner[1], corner[2], std::uint32_t(all.size())});
    }
    return all;
}

/// Draws a point at least this far from the centre. towards() returns a direction to `target`, as long as M
/// bits allow.
inline Vec3i far_origin(Draw& draw, int coord_bits, double distance) {
    const int most = (1 << (coord_bits - 1)) - 1;
    for (;;) {
        Vec3i o;
        for (auto& x : o) x = draw.between(-most, most);
        if (std::hypot(o[0], o[1], o[2]) >= distance) return o;
    }
}
inline Vec3i towards(const Vec3i& o, const std::array<double, 3>& target, int dir_bits) {
    std::array<double, 3> way;
    double longest = 0;
    for (std::size_t k = 0; k < 3; ++k) longest = std::max(longest, std::abs(way[k] = target[k] - o[k]));
    const double scale = (std::ldexp(1, dir_bits - 1) - 1) / longest;
    Vec3i d;
    for (std::size_t k = 0; k < 3; ++k) d[k] = std::int32_t(std::lround(way[k] * scale));
    return d;
}

/// Returns a weighted point of a triangle.
inline std::array<double, 3> inside(const PrimData& t, double b, double c) {
    std::array<double, 3> p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = t.a[k] + b * (t.b[k] - t.a[k]) + c * (t.c[k] - t.a[k]);
    return p;
}

/// Returns the number of triangles that accept a ray. The ray comes from outside the closed sphere, so all of
/// them lie ahead.
inline int crossings(const Config& config, const std::vector<PrimData>& all, const Vec3i& o, const Vec3i& d) {
    return int(std::count_if(all.begin(), all.end(),
                             [&](const PrimData& t) { return run_test(config, o, d, t).closer != 0; }));
}

}   // namespace rayclock::test

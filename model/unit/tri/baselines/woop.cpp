// The test of woop.hpp.
#include "model/unit/tri/baselines/woop.hpp"

#include <cstdlib>
#include <utility>

#include "model/unit/tri/baselines/float_hit.hpp"

namespace rayclock {

void woop_test(const Vec3i& o, const Vec3i& d, const PrimData& triangle, const Best& best,
               const Config& config, TriRsp& out) {
    no_hit(out);
    std::size_t kz = 0;
    for (std::size_t k = 1; k < 3; ++k)
        if (std::abs(d[k]) > std::abs(d[kz])) kz = k;
    if (d[kz] == 0) return;
    std::size_t kx = (kz + 1) % 3, ky = (kz + 2) % 3;
    if (d[kz] < 0) std::swap(kx, ky);   // keeps the winding
    const float sx = float(d[kx]) / float(d[kz]), sy = float(d[ky]) / float(d[kz]), sz = 1.0f / float(d[kz]);

    struct Corner {
        float x, y, z;
    };
    const auto sheared = [&](const Vec3i& p) {
        const float x = float(p[kx]) - float(o[kx]), y = float(p[ky]) - float(o[ky]),
                    z = float(p[kz]) - float(o[kz]);
        return Corner{x - sx * z, y - sy * z, z};
    };
    const Corner a = sheared(triangle.a), b = sheared(triangle.b), c = sheared(triangle.c);
    const float w = c.x * b.y - c.y * b.x;   // weights of a, b, c
    const float u = a.x * c.y - a.y * c.x;
    const float v = b.x * a.y - b.y * a.x;
    if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return;
    const float det = u + v + w;
    if (det == 0) return;
    const float z = w * (sz * a.z) + u * (sz * b.z) + v * (sz * c.z);
    const float inverse = 1.0f / det;
    const float t = z * inverse;
    if (!(t > 0)) return;
    float_hit(t, u * inverse, v * inverse, triangle, best, config, out);
}

}   // namespace rayclock

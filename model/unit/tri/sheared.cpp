// The test of sheared.hpp, and the shear of a direction.
#include "model/unit/tri/sheared.hpp"

#include <cassert>
#include <cstdlib>

#include "model/unit/tri/edges.hpp"
#include "model/unit/tri/tri_test.hpp"
#include "model/unit/tri/tri.hpp"

namespace rayclock {

namespace {

struct Corner {
    std::int64_t x, y, z;
};

Corner sheared(const Vec3i& p, const Vec3i& o, const Shear& shear, int frac) {
    const std::size_t kz = shear.axis, kx = kz == 2 ? 0 : kz + 1, ky = kz == 0 ? 2 : kz - 1;
    const std::int64_t z = std::int64_t(p[kz]) - o[kz], half = std::int64_t(1) << (frac - 1);
    return {std::int64_t(p[kx]) - o[kx] + ((half - shear.slope[0] * z) >> frac),
            std::int64_t(p[ky]) - o[ky] + ((half - shear.slope[1] * z) >> frac), z};
}

std::int64_t planar_cross(const Corner& p, const Corner& q) { return p.x * q.y - p.y * q.x; }

/// Returns the sign of the edge function of p, q: 1 or -1; 0 if p = q. A zero is decided as if the ray passed
/// at (eps, eps^2).
int side(std::int64_t edge, const Corner& p, const Corner& q) {
    const std::int64_t decides = edge != 0 ? edge : p.y != q.y ? p.y - q.y : q.x - p.x;
    return (decides > 0) - (decides < 0);
}

}   // namespace

Shear shear_of(const Vec3i& d, const Config& config) {
    Shear shear;
    for (std::uint32_t k = 1; k < 3; ++k)
        if (std::abs(d[k]) > std::abs(d[shear.axis])) shear.axis = k;
    const std::int32_t dz = d[shear.axis];
    shear.neg = dz < 0;
    shear.size = std::uint32_t(std::abs(dz));
    if (dz == 0) return shear;
    for (std::size_t i = 0; i < 2; ++i) {
        const std::int32_t along = d[(shear.axis + 1 + i) % 3];
        const std::uint32_t twice =
            std::uint32_t((std::uint64_t(std::abs(along)) << (config.slope_frac_bits() + 1)) / shear.size);
        const auto magnitude = std::int32_t((twice + 1) >> 1);
        shear.slope[i] = (along < 0) != (dz < 0) ? -magnitude : magnitude;
    }
    return shear;
}

void sheared_test(const Vec3i& o, const Shear& shear, const PrimData& triangle, const Best& best,
                  const Config& config, TriRsp& out) {
    no_hit(out);
    const int frac = config.slope_frac_bits();
    const Corner a = sheared(triangle.a, o, shear, frac), b = sheared(triangle.b, o, shear, frac),
                 c = sheared(triangle.c, o, shear, frac);
    const std::int64_t u = planar_cross(c, a), v = planar_cross(a, b), w = planar_cross(b, c),
                       det = u + v + w;
    if (det == 0 || shear.size == 0) return;
    const int sign = det < 0 ? -1 : 1;
    if (side(u, c, a) != sign || side(v, a, b) != sign || side(w, b, c) != sign) return;

    const std::int64_t num_raw = w * a.z + u * b.z + v * c.z;
    const std::int64_t size = sign * det, num = (sign < 0) != (shear.neg != 0) ? -num_raw : num_raw;
    assert(size < std::int64_t(1) << (config.edge_bits() - 1) &&
           std::abs(num) < std::int64_t(1) << (config.num_bits() - 1));
    if (num <= 0 || !goes_before(num, size, triangle.prim, best)) return;
    out.closer = 1;
    out.num = num;
    out.det = size;
    out.prim = triangle.prim;
    out.t = distance(num, size * std::int64_t(shear.size), config);
    out.u = barycentric(sign * u, size, config);
    out.v = barycentric(sign * v, size, config);
}

void sheared_test(const Vec3i& o, const Vec3i& d, const PrimData& triangle, const Best& best,
                  const Config& config, TriRsp& out) {
    sheared_test(o, shear_of(d, config), triangle, best, config, out);
}

}   // namespace rayclock

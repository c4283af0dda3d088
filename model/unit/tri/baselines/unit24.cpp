// The test of unit24.hpp, and its 24-bit float.
#include "model/unit/tri/baselines/unit24.hpp"

#include <bit>
#include <limits>

#include "model/unit/tri/baselines/float_hit.hpp"

namespace rayclock {

namespace {

using DoubleVec = std::array<double, 3>;

/// A row of the map. direction() applies its linear part, point() also adds the constant.
struct Row {
    DoubleVec linear;
    double constant;
};

DoubleVec double_cross(const DoubleVec& a, const DoubleVec& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double double_dot(const DoubleVec& a, const DoubleVec& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Row row(const DoubleVec& normal, double over, const DoubleVec& a) {
    const DoubleVec linear{normal[0] / over, normal[1] / over, normal[2] / over};
    return {{float24(linear[0]), float24(linear[1]), float24(linear[2])}, float24(-double_dot(linear, a))};
}
double direction(const Row& r, const DoubleVec& d) {
    return float24(float24(float24(r.linear[0] * d[0]) + float24(r.linear[1] * d[1])) +
                   float24(r.linear[2] * d[2]));
}
double point(const Row& r, const DoubleVec& p) { return float24(direction(r, p) + r.constant); }

}   // namespace

double float24(double x) {
    constexpr int drop = 52 - 16;
    constexpr double least = 0x1p-62, most = 0x1.ffffp63;
    auto bits = std::bit_cast<std::uint64_t>(x);
    // A carry into the exponent is correct.
    bits += (std::uint64_t(1) << (drop - 1)) - 1 + ((bits >> drop) & 1);
    bits &= ~((std::uint64_t(1) << drop) - 1);
    const auto rounded = std::bit_cast<double>(bits);
    const double size = std::abs(rounded);
    if (!(size <= most)) return x != x ? x : std::copysign(std::numeric_limits<double>::infinity(), x);
    return size < least ? std::copysign(0.0, x) : rounded;
}

void unit24_test(const Vec3i& o, const Vec3i& d, const PrimData& triangle, const Best& best,
                 const Config& config, TriRsp& out) {
    no_hit(out);
    const auto vec = [](const Vec3i& p) { return DoubleVec{double(p[0]), double(p[1]), double(p[2])}; };
    const auto rounded = [](const Vec3i& p) {
        return DoubleVec{float24(p[0]), float24(p[1]), float24(p[2])};
    };
    const auto minus = [](const DoubleVec& x, const DoubleVec& y) {
        return DoubleVec{x[0] - y[0], x[1] - y[1], x[2] - y[2]};
    };
    const DoubleVec a = vec(triangle.a), e1 = minus(vec(triangle.b), a), e2 = minus(vec(triangle.c), a),
                    n = double_cross(e1, e2);
    const double nn = double_dot(n, n);
    if (nn == 0) return;
    // Rows of the inverse of (e1 e2 n): e2 x n, n x e1 and n, divided by n . n.
    const Row rx = row(double_cross(e2, n), nn, a), ry = row(double_cross(n, e1), nn, a), rz = row(n, nn, a);
    const DoubleVec from = rounded(o), along = rounded(d);
    const double dz = direction(rz, along);
    if (dz == 0) return;
    const double t = float24(-point(rz, from) / dz);
    if (!(t > 0) || std::isinf(t)) return;
    const double u = float24(point(rx, from) + float24(t * direction(rx, along)));
    const double v = float24(point(ry, from) + float24(t * direction(ry, along)));
    if (!(u >= 0 && v >= 0 && float24(u + v) <= 1)) return;
    float_hit(t, u, v, triangle, best, config, out);
}

}   // namespace rayclock

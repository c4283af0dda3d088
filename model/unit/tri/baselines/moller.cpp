// The test of moller.hpp.
#include "model/unit/tri/baselines/moller.hpp"

#include "model/unit/tri/baselines/float_hit.hpp"

namespace rayclock {

namespace {

using FloatVec = std::array<float, 3>;

FloatVec float_minus(const Vec3i& a, const Vec3i& b) {
    return {float(a[0]) - float(b[0]), float(a[1]) - float(b[1]), float(a[2]) - float(b[2])};
}
FloatVec float_cross(const FloatVec& a, const FloatVec& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
float float_dot(const FloatVec& a, const FloatVec& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

}   // namespace

void moller_test(const Vec3i& o, const Vec3i& d, const PrimData& triangle, const Best& best,
                 const Config& config, TriRsp& out) {
    no_hit(out);
    const FloatVec e1 = float_minus(triangle.b, triangle.a), e2 = float_minus(triangle.c, triangle.a),
                   dir{float(d[0]), float(d[1]), float(d[2])};
    const FloatVec p = float_cross(dir, e2);
    const float det = float_dot(e1, p);
    if (det == 0) return;
    const float inverse = 1.0f / det;
    const FloatVec s = float_minus(o, triangle.a);
    const float u = float_dot(s, p) * inverse;
    if (!(u >= 0 && u <= 1)) return;
    const FloatVec q = float_cross(s, e1);
    const float v = float_dot(dir, q) * inverse;
    if (!(v >= 0 && u + v <= 1)) return;
    const float t = float_dot(e2, q) * inverse;
    if (!(t > 0)) return;
    float_hit(t, u, v, triangle, best, config, out);
}

}   // namespace rayclock

// The test of moller.hpp.
#include "model/unit/isect/moller.hpp"

#include "model/unit/isect/float_hit.hpp"

namespace rayclock {

namespace {

using Vec = std::array<float, 3>;

Vec minus(const Vec3i& a, const Vec3i& b) {
    return {float(a[0]) - float(b[0]), float(a[1]) - float(b[1]), float(a[2]) - float(b[2])};
}
Vec cross(const Vec& a, const Vec& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
float dot(const Vec& a, const Vec& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

}   // namespace

void moller_test(const Vec3i& o, const Vec3i& d, const PrimData& triangle, const Best& best,
                 const Config& config, TriRsp& out) {
    no_hit(out);
    const Vec e1 = minus(triangle.b, triangle.a), e2 = minus(triangle.c, triangle.a),
              dir{float(d[0]), float(d[1]), float(d[2])};
    const Vec p = cross(dir, e2);
    const float det = dot(e1, p);
    if (det == 0) return;
    const float inverse = 1.0f / det;
    const Vec s = minus(o, triangle.a);
    const float u = dot(s, p) * inverse;
    if (!(u >= 0 && u <= 1)) return;
    const Vec q = cross(s, e1);
    const float v = dot(dir, q) * inverse;
    if (!(v >= 0 && u + v <= 1)) return;
    const float t = dot(e2, q) * inverse;
    if (!(t > 0)) return;
    float_hit(t, u, v, triangle, best, config, out);
}

}   // namespace rayclock

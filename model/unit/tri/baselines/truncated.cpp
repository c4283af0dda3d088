// The test of truncated.hpp.
#include "model/unit/tri/baselines/truncated.hpp"

#include "model/unit/tri/baselines/float_hit.hpp"
#include "model/unit/tri/tri.hpp"

namespace rayclock {

namespace {

__extension__ using Wide = __int128;

constexpr int kept_frac = 16;

std::int64_t shifted(std::int64_t x, int left) {
    return left >= 0 ? x * (std::int64_t(1) << left) : x >> -left;
}
Vec3l shifted(const Vec3i& x, int left) {
    return {shifted(x[0], left), shifted(x[1], left), shifted(x[2], left)};
}
Vec3l truncated_minus(const Vec3l& a, const Vec3l& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
std::int64_t product(std::int64_t a, std::int64_t b) { return (a * b) >> kept_frac; }
Vec3l truncated_cross(const Vec3l& a, const Vec3l& b) {
    return {product(a[1], b[2]) - product(a[2], b[1]), product(a[2], b[0]) - product(a[0], b[2]),
            product(a[0], b[1]) - product(a[1], b[0])};
}
std::int64_t truncated_dot(const Vec3l& a, const Vec3l& b) {
    return product(a[0], b[0]) + product(a[1], b[1]) + product(a[2], b[2]);
}

}   // namespace

void truncated_test(const Vec3i& o, const Vec3i& d, const PrimData& triangle, const Best& best,
                    const Config& config, TriRsp& out) {
    no_hit(out);
    const int up = kept_frac + 1 - config.coord_bits, dir_up = kept_frac + 1 - config.dir_bits;
    const Vec3l a = shifted(triangle.a, up), dir = shifted(d, dir_up);
    const Vec3l e1 = truncated_minus(shifted(triangle.b, up), a),
                e2 = truncated_minus(shifted(triangle.c, up), a), s = truncated_minus(shifted(o, up), a);
    const Vec3l p = truncated_cross(dir, e2), q = truncated_cross(s, e1);
    const std::int64_t det_raw = truncated_dot(e1, p);
    if (det_raw == 0) return;
    const std::int64_t sign = det_raw < 0 ? -1 : 1, size = sign * det_raw;
    const std::int64_t u = sign * truncated_dot(s, p), v = sign * truncated_dot(dir, q),
                       along = sign * truncated_dot(e2, q);
    if (u < 0 || v < 0 || u + v > size || along <= 0) return;
    // Both scales are undone exactly: t is 2^(N-M) times its value in the cube.
    const int back = up - dir_up;
    const std::int64_t num = shifted(along, std::max(0, -back)), det = shifted(size, std::max(0, back));
    if (best.found) {
        const Wide mine = Wide(num) * best.det, theirs = Wide(best.num) * det;
        if (mine > theirs || (mine == theirs && triangle.prim > best.prim)) return;
    }
    out.closer = 1;
    out.num = num;
    out.det = det;
    out.prim = triangle.prim;
    out.t = distance(num, det, config);
    out.u = barycentric(u, size, config);
    out.v = barycentric(v, size, config);
}

}   // namespace rayclock

#include "model/isect/tri.hpp"

#include "model/isect/any.hpp"
#include "model/isect/sheared.hpp"
#include "model/isect/vectors.hpp"

namespace rayclock {

namespace {

__extension__ using Wide = __int128;

std::int64_t dot(const Vec3l& a, const Vec3l& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// True if the edge function is positive, a zero being decided by the first non-zero component of its
/// gradient; `flip` turns all signs.
bool inside(std::int64_t edge, const Vec3l& gradient, bool flip) {
    const std::int64_t decides = edge != 0          ? edge
                                 : gradient[0] != 0 ? gradient[0]
                                 : gradient[1] != 0 ? gradient[1]
                                                    : gradient[2];
    return flip ? decides < 0 : decides > 0;
}

}   // namespace

void tri_test(const Vec3i& o, const Vec3i& d, const PrimData& triangle, const Best& best,
              const Config& config, TriRsp& out) {
    out.closer = out.back = 0;
    out.num = out.det = 0;
    out.prim = out.t = out.u = out.v = 0;

    const Vec3l e1 = minus(triangle.b, triangle.a), e2 = minus(triangle.c, triangle.a),
                s = minus(o, triangle.a);
    const Vec3l dir{d[0], d[1], d[2]};
    const Vec3l p1 = cross(dir, e1), p2 = cross(dir, e2);
    const std::int64_t det = dot(p2, e1);
    if (det == 0) return;
    const bool flip = det < 0;
    const std::int64_t u = dot(p2, s), v = -dot(p1, s), w = det - u - v;
    const Vec3l grad_v{-p1[0], -p1[1], -p1[2]}, grad_w{p1[0] - p2[0], p1[1] - p2[1], p1[2] - p2[2]};
    // Nearly always no edge function is zero; then their signs alone decide, without a branch for each.
    if (u != 0 && v != 0 && w != 0) {
        if (((u ^ det) | (v ^ det) | (w ^ det)) < 0) return;
    } else if (!inside(u, p2, flip) || !inside(v, grad_v, flip) || !inside(w, grad_w, flip)) {
        return;
    }

    const std::int64_t num_raw = dot(cross(e1, e2), s);
    const std::int64_t num = flip ? -num_raw : num_raw, size = flip ? -det : det;
    if (num <= 0) return;
    if (best.found) {
        const Wide mine = Wide(num) * best.det, theirs = Wide(best.num) * size;
        if (mine > theirs || (mine == theirs && triangle.prim > best.prim)) return;
    }
    out.closer = 1;
    out.back = flip && config.shading;
    out.num = num;
    out.det = size;
    out.prim = triangle.prim;
    out.t = distance(num, size, config);
    out.u = barycentric(flip ? -u : u, size, config);
    out.v = barycentric(flip ? -v : v, size, config);
}

TriRsp tri(const TriReq& req, const Config& config) {
    TriRsp rsp;
    rsp.ray = req.ray;
    if (config.shading) {
        Ray ray;
        ray.o = req.o;
        ray.d = req.d;
        ray.kind = req.kind;
        ray.self = req.self;
        ray.inside = req.inside;
        ray.finite = req.finite;
        any_test(ray, req.triangle, req.best, config, rsp);
    } else if (config.is_sheared()) {
        sheared_test(req.o, req.shear, req.triangle, req.best, config, rsp);
    } else {
        tri_test_of(config)(req.o, req.d, req.triangle, req.best, config, rsp);
    }
    return rsp;
}

}   // namespace rayclock

// The unit tri, and its exact test in 64 bits.
#include "model/unit/tri/tri.hpp"

#include "model/unit/tri/edges.hpp"
#include "model/unit/tri/sheared.hpp"
#include "model/unit/tri/any_primitive.hpp"

namespace rayclock {

void tri_test(const Vec3i& o, const Vec3i& d, const PrimData& triangle, const Best& best,
              const Config& config, TriRsp& out) {
    no_hit(out);
    Edges<std::int64_t> e;
    bool flip = false;
    if (!meet(minus(o, triangle.a), {d[0], d[1], d[2]}, triangle, 0, true, e, flip) ||
        !goes_before(e.num, e.det, triangle.prim, best))
        return;
    put_hit(e, flip, triangle.prim, config, out);
    out.t = distance(e.num, e.det, config);
    out.u = barycentric(e.u, e.det, config);
    out.v = barycentric(e.v, e.det, config);
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
        ray.is_inside = req.is_inside;
        ray.is_partial = req.is_partial;
        any_primitive_test(ray, req.triangle, req.best, config, rsp);
    } else if (config.is_sheared()) {
        sheared_test(req.o, req.shear, req.triangle, req.best, config, rsp);
    } else {
        tri_test_of(config)(req.o, req.d, req.triangle, req.best, config, rsp);
    }
    return rsp;
}

}   // namespace rayclock

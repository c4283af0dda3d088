#include "model/xform/xform.hpp"

#include "model/raygen/raygen.hpp"

namespace rayclock {
namespace {

/// round(A v + b): the product and the sum are exact.
Vec3i mapped(const Placement& p, const Vec3i& v, const Vec3l& b, int frac) {
    Vec3i out;
    for (std::size_t i = 0; i < 3; ++i) {
        std::int64_t sum = b[i] + (std::int64_t(1) << (frac - 1));
        for (std::size_t k = 0; k < 3; ++k) sum += std::int64_t(p.a[3 * i + k]) * v[k];
        out[i] = std::int32_t(sum >> frac);
    }
    return out;
}

}   // namespace

Change xform(const XformReq& req, const Config& config) {
    const Placement& p = req.placement;
    const int frac = config.map_frac();
    const Ray moved =
        make_ray(mapped(p, req.o, p.b, frac), mapped(p, req.d, {}, frac), config, RayKind::camera);
    return {req.ray, p.root, p.first, moved.o, moved.d, moved.recip, moved.len};
}

}   // namespace rayclock

// Maps rays into an instance's space.
#include "model/unit/xform/xform.hpp"

#include "model/unit/raygen/raygen.hpp"

namespace rayclock {

Vec3l unrounded(const Placement& p, const Vec3i& v, const Vec3l& b) {
    Vec3l out = b;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t k = 0; k < 3; ++k) out[i] += std::int64_t(p.a[3 * i + k]) * v[k];
    return out;
}

Vec3i moved_point(const Placement& p, const Vec3i& o, RayKind kind, const Config& config) {
    const int whole = kind == RayKind::shadow ? config.origin_frac() : 0, frac = config.map_frac() + whole;
    Vec3l b;
    for (std::size_t i = 0; i < 3; ++i)
        b[i] = p.b[i] * (std::int64_t(1) << config.origin_frac()) + (std::int64_t(1) << (frac - 1));
    const Vec3l sum = unrounded(p, o, b);
    Vec3i out;
    for (std::size_t i = 0; i < 3; ++i) out[i] = std::int32_t((sum[i] >> frac) * (1 << whole));
    return out;
}

Vec3i moved_direction(const Placement& p, const Vec3i& d, const Config& config) {
    const int frac = config.map_frac();
    const std::int64_t half = std::int64_t(1) << (frac - 1);
    const Vec3l sum = unrounded(p, d, {half, half, half});
    return {std::int32_t(sum[0] >> frac), std::int32_t(sum[1] >> frac), std::int32_t(sum[2] >> frac)};
}

Change xform(const XformReq& req, const Config& config) {
    const Placement& p = req.placement;
    const auto kind = req.kind;
    const bool is_home = config.has_homes() && kind != RayKind::camera && req.home.line == p.here;
    const Ray moved = is_home ? make_ray(req.home.o, req.home.d, config, kind)
                              : make_ray(moved_point(p, req.o, kind, config),
                                         moved_direction(p, req.d, config), config, kind);
    return {req.ray, p.root, p.first, p.here, moved.o, moved.d, moved.recip, moved.len, req.kind};
}

}   // namespace rayclock

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

Ray xform(const Ray& ray, const Placement& placement, const Config& config) {
    const int frac = map_frac(config);
    Ray moved = make_ray(mapped(placement, ray.o, placement.b, frac), mapped(placement, ray.d, {}, frac),
                         config, RayKind(ray.kind));
    moved.ray = ray.ray;
    return moved;
}

}   // namespace rayclock

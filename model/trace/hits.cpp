// Converts hits to scene units.
#include "model/trace/hits.hpp"

#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "model/unit/raygen/raygen.hpp"

namespace rayclock {

HitScale::HitScale(const Frame& frame, const Lattice& lattice, const Config& config)
    : frame_(frame),
      config_(config),
      shape_(lattice.pitch / lattice.coarsest()),
      depth_(std::ldexp(lattice.coarsest(), -(config.dir_bits - 1 + config.t_frac_bits))),
      weight_(std::ldexp(1.0, -config.bary_bits)) {}

Hit HitScale::operator()(const HitOut& out) const {
    if (!out.closest.found) return {};
    const Vec3i d = pixel_direction(out.x, out.y, frame_, config_);
    const double length = glm::length(shape_ * glm::dvec3(d[0], d[1], d[2]));
    return {out.closest.prim, float(out.closest.t * length * depth_), float(out.closest.u * weight_),
            float(out.closest.v * weight_)};
}

float depth_on_plane(const Closest& hit, const Surface& plane, const Vec3i& eye, const Lattice& lattice,
                     const Config& config) {
    const std::int64_t most = (std::int64_t(1) << (config.uv_bits() - 1)) - 1;
    std::array<double, 2> along{};
    for (std::size_t i = 0; i < 2; ++i) {
        const std::uint32_t bits = (i == 0 ? hit.u : hit.v) << (32 - config.uv_bits());
        const std::int64_t sides = std::int32_t(bits) >> (32 - config.uv_bits());
        if (sides >= most || sides <= -most - 1) return std::numeric_limits<float>::infinity();
        along[i] = std::ldexp(double(sides), -config.bary_bits);
    }
    glm::dvec3 way{};
    for (std::size_t k = 0; k < 3; ++k)
        way[int(k)] =
            plane.a[k] + along[0] * (plane.b[k] - plane.a[k]) + along[1] * (plane.c[k] - plane.a[k]) - eye[k];
    return float(glm::length(way * lattice.pitch));
}

}   // namespace rayclock

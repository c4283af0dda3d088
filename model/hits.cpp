#include "model/hits.hpp"

#include <cmath>

#include <glm/geometric.hpp>

#include "model/raygen/raygen.hpp"

namespace rayclock {

HitScale::HitScale(const Frame& frame, const Lattice& lattice, const Config& config)
    : frame_(frame), shape_(lattice.pitch / lattice.coarsest()), depth_(std::ldexp(lattice.coarsest(), -(config.dir_bits - 1 + config.t_frac_bits))), weight_(std::ldexp(1.0, -config.bary_bits)) {}

Hit HitScale::operator()(const HitOut& out) const {
    if (!out.closest.found) return {};
    const Vec3i d = pixel_direction(out.x, out.y, frame_);
    const double length = glm::length(shape_ * glm::dvec3(d[0], d[1], d[2]));
    return {out.closest.prim, float(out.closest.t * length * depth_), float(out.closest.u * weight_), float(out.closest.v * weight_)};
}

} // namespace rayclock

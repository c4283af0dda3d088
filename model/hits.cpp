#include "model/hits.hpp"

#include <cmath>

#include "model/raygen/raygen.hpp"

namespace rayclock {

Hit to_hit(const HitOut& out, const Frame& frame, const Lattice& lattice, const Config& config) {
    if (!out.closest.found) return {};
    const Vec3i d = pixel_direction(out.x, out.y, frame);
    const double length = std::sqrt(double(d[0]) * d[0] + double(d[1]) * d[1] + double(d[2]) * d[2]);
    const double t = std::ldexp(double(out.closest.t), -(config.dir_bits - 1 + config.t_frac_bits));
    return {out.closest.prim, float(t * length * lattice.pitch), float(std::ldexp(double(out.closest.u), -config.bary_bits)),
            float(std::ldexp(double(out.closest.v), -config.bary_bits))};
}

} // namespace rayclock

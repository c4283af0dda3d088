#pragma once
// Rays at the instances of a placed scene, as the camera and shade send them.
#include <algorithm>
#include <cmath>
#include <vector>

#include "model/unit/raygen/raygen.hpp"
#include "model/scene/placed.hpp"
#include "model/unit/shade/bounce/bounce.hpp"
#include "model/fixed/unit_vector.hpp"
#include "tests/support/scenes/hard_meshes.hpp"
namespace rayclock {

inline Vec3i unit_towards(const glm::dvec3& d, int bits) {
    Vec3l wide{};
    for (std::size_t k = 0; k < 3; ++k) wide[k] = std::int64_t(d[int(k)] * std::ldexp(1, bits));
    return unit_vector(wide);
}

/// Targets of rays, and the rays.
class Aim {
public:
    Aim(const PlacedScene& scene, const Lattice& lattice, const Config& config, std::uint32_t seed)
        : config_(config), draw_(seed) {
        for (const Instance& instance : scene.instances)
            for (const glm::dvec3& v : scene.meshes[instance.mesh].vertices)
                corners_.push_back((glm::dvec3(instance.place * glm::dvec4(v, 1)) - lattice.centre) /
                                   lattice.pitch);
    }

    double number() { return draw_(); }

    /// Draws a ray from the eye towards a point between two corners.
    Ray camera_ray(const Vec3i& eye) {
        const double share = 0.5 + 0.5 * draw_();
        const glm::dvec3 d = share * corner() + (1 - share) * corner() - glm::dvec3(eye[0], eye[1], eye[2]);
        const double most = std::ldexp(1, config_.dir_bits - 1) - 1,
                     largest = std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z), 1e-9});
        Vec3i full{};
        for (std::size_t k = 0; k < 3; ++k) full[k] = std::int32_t(d[int(k)] * most / largest);
        return make_ray(ray_origin(eye, config_), full, config_);
    }

    /// Draws a direction as shade makes it: towards a corner, or anywhere.
    Vec3i direction(const Vec3l& from) {
        glm::dvec3 d = draw_.point() + glm::dvec3(1e-6);
        if (draw_() < 0.5) {
            for (int k = 0; k < 3; ++k)
                d[k] = -std::ldexp(double(from[std::size_t(k)]), -config_.origin_bits);
            d = (d + corner()) * std::ldexp(1, -config_.coord_bits);
        }
        return direction_of(unit_towards(d, 30), config_);
    }

    /// Draws a light anywhere, close to a point, or at a corner.
    Vec3i light(const Vec3l& near) {
        const int end = (1 << (config_.coord_bits - 1)) - 1;
        const double kind = draw_(), size = kind < 0 ? end : kind < 0.3 ? 1 : std::pow(2.0, 8 * kind);
        const glm::dvec3 at_corner = corner();
        Vec3i at{};
        for (std::size_t k = 0; k < 3; ++k) {
            const double middle = kind < 0     ? 0
                                  : kind < 0.3 ? at_corner[int(k)]
                                               : std::ldexp(double(near[k]), -config_.origin_bits);
            at[k] = std::int32_t(std::clamp(std::round(middle + size * draw_()), double(-end), double(end)));
        }
        return at;
    }

private:
    const glm::dvec3& corner() {
        return corners_[std::min(corners_.size() - 1,
                                 std::size_t((0.5 + 0.5 * draw_()) * double(corners_.size())))];
    }

    const Config& config_;
    Draw draw_;
    std::vector<glm::dvec3> corners_;   // on the scene's lattice, not rounded
};

}   // namespace rayclock

#pragma once
// Convex bodies, whose surface is the expected share of lines that meet them.
#include <vector>

#include <glm/vec3.hpp>

#include "model/core/payloads.hpp"

namespace rayclock::test {

/// A convex body, given by the planes around it: all x with n . x <= at for each plane.
class Convex {
public:
    void below(const Vec3i& normal, std::int64_t at) { planes_.push_back({normal, at}); }
    void above(const Vec3i& normal, std::int64_t at);
    void within(const Vec3i& lo, const Vec3i& hi);
    /// Returns the surface. Both sides of a body without thickness count. The body must lie in the lattice.
    double surface() const;

private:
    struct Plane {
        Vec3i normal{};
        std::int64_t at = 0;
    };
    static bool same(const Plane& a, const Plane& b);
    double face(std::size_t plane) const;

    std::vector<Plane> planes_;
};

}   // namespace rayclock::test

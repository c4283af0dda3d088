#pragma once
// A convex solid, and the share of its surface on each side of a plane. The surface area heuristic uses it
// for cells that planes in any direction cut. Correctness does not depend on its accuracy.
#include <array>
#include <vector>

#include <glm/vec3.hpp>

#include "model/layout/tree.hpp"

namespace rayclock::bsp {

class Solid {
public:
    explicit Solid(const LatticeBox& box);
    double area() const { return area_; }
    /// The surfaces of the parts with n . x <= at and n . x >= at, both including the face on the plane.
    struct Halves {
        double lower = 0, upper = 0;
    };
    Halves halves(const glm::dvec3& normal, double at) const;
    /// Keeps only one of the parts.
    void cut(const glm::dvec3& normal, double at, bool upper);

private:
    using Corners = std::vector<glm::dvec3>;
    struct Face {
        Corners corners;        ///< counterclockwise, seen from outside
        glm::dvec3 outward{};   ///< perpendicular to the face, with its area as length
    };
    static glm::dvec3 outward_of(const Corners& corners);
    void measure();

    std::vector<Face> faces_;
    double area_ = 0;
};

}   // namespace rayclock::bsp

#pragma once
// A convex solid, and how much of its surface lies on each side of a plane: what the surface area heuristic
// asks of a cell that planes in any direction cut. Nothing that must be right depends on it.
#include <array>
#include <vector>

#include <glm/vec3.hpp>

#include "model/layout/tree.hpp"

namespace rayclock::bsp {

class Solid {
public:
    explicit Solid(const LatticeBox& box);
    double area() const { return area_; }
    /// The surfaces of the parts with n . x <= at and n . x >= at.
    struct Halves {
        double lower = 0, upper = 0;
    };
    Halves halves(const glm::dvec3& normal, double at) const;
    /// One of the parts.
    void cut(const glm::dvec3& normal, double at, bool upper);

private:
    using Corners = std::vector<glm::dvec3>;
    struct Face {
        Corners corners;        ///< counterclockwise, seen from outside
        glm::dvec3 outward{};   ///< at right angles to it, as long as its area
    };
    static glm::dvec3 outward_of(const Corners& corners);
    void measure();

    std::vector<Face> faces_;
    double area_ = 0;
};

}   // namespace rayclock::bsp

// Making the parts of a scene: flat and smooth ones side by side, exact joining. How they are put in their
// places is model/scene/placed.hpp.
#pragma once
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "model/scene/placed.hpp"

namespace rayclock {

/// One corner of a triangle as a file gives it. A normal that is zero means that there is none.
struct Corner {
    glm::dvec3 position{0};
    glm::dvec3 normal{0};
};

/// Collects triangles. Corners with equal positions and normals, to the last bit, become one vertex;
/// triangles with two corners in the same place are points or lines and are left out.
class PartBuilder {
public:
    PartBuilder(std::size_t triangles, bool is_smooth);   ///< `triangles` is a guess
    void add(const Corner& a, const Corner& b, const Corner& c, std::uint32_t material);
    Scene take() { return std::move(part_); }
    std::uint64_t dropped() const { return dropped_; }   ///< triangles that were left out

private:
    std::uint32_t vertex(const Corner& corner);
    std::size_t slot(const glm::dvec3& position, const glm::dvec3& normal) const;
    void grow();
    bool is_smooth_;
    std::uint64_t dropped_ = 0;
    Scene part_;
    std::vector<std::uint32_t> table_;   ///< open hashing, a power of two, at most two thirds in use
};

/// Gives a flat part its facets' normals, so that it can stand beside smooth ones and stay flat.
void make_smooth(Scene& part);

/// The same of a part with instances.
void make_smooth(PlacedScene& part);
/// Something in it has normals, so that all must have some.
bool has_normals(const PlacedScene& part);

}   // namespace rayclock

#pragma once
// Writes shapes into scenes, and helpers of the generators.
#include <array>
#include <cstdint>
#include <initializer_list>
#include <vector>

#include <glm/vec3.hpp>

#include "model/scene/builtin.hpp"
#include "model/scene/placed.hpp"
#include "model/scene/scene.hpp"

namespace rayclock {

/// Haines' tessellation factor f. A sphere is six f x f grids; a cone or cylinder has 4 f sectors by default.
constexpr int tessellation = 3;
constexpr int sphere_triangles = 12 * tessellation * tessellation;
constexpr int sphere_vertices = 6 * tessellation * tessellation + 2;
constexpr int cone_sectors = 4 * tessellation;
constexpr std::uint64_t cone_triangles(int sectors) { return 2 * static_cast<std::uint64_t>(sectors); }
constexpr std::uint64_t cone_vertices(int sectors) { return 2 * static_cast<std::uint64_t>(sectors); }

/// Appends shapes to a scene. Every shape has its own vertices, in one run, and its triangles share them.
/// Triangles are counter-clockwise seen from outside and have the material set last. A scene has normals
/// throughout or none.
class MeshWriter {
public:
    explicit MeshWriter(Scene& scene, Primitives primitives = Primitives::triangles,
                        int sectors = cone_sectors);

    /// Reserves memory. Without normals, those of vertex(), flat() and cone() are dropped.
    void reserve(std::uint64_t vertices, const PrimitiveCounts& counts, bool with_normals);

    /// Set the material of the following triangles: a new one, or one of the scene's by number.
    void material(const Material& material);
    void use_material(std::uint32_t number) { material_ = number; }

    std::uint32_t vertex(const glm::dvec3& position);
    std::uint32_t vertex(const glm::dvec3& position, const glm::dvec3& normal);
    void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);

    /// Writes a planar convex polygon, cut as a fan, with its face normal at every corner.
    void flat(std::initializer_list<glm::dvec3> corners);

    /// Writes one native sphere, or a closed equal-angle cube grid with radial normals.
    void sphere(const glm::dvec3& centre, double radius);

    /// Writes a side without caps: base ring first, then apex ring.
    void cone(const glm::dvec3& base, double base_radius, const glm::dvec3& apex, double apex_radius);

private:
    Scene& scene_;
    Primitives primitives_;
    int sectors_;   ///< of a cone
    bool with_normals_ = true;
    std::uint32_t material_ = 0;
    std::vector<glm::dvec3> sphere_points_;   ///< of the unit sphere
    std::vector<std::array<std::uint32_t, 3>> sphere_faces_;
};

glm::dvec3 unit(const glm::dvec3& v);

/// Unit vectors across a unit axis: the start of a cone's ring, and the direction a quarter turn further.
struct Circle {
    glm::dvec3 start, quarter;
};
Circle ring_around(const glm::dvec3& axis);

/// ball_mesh() returns a closed unit sphere, cut as in sphere(); ball_at() returns an instance of it.
SharedMesh ball_mesh(std::uint32_t material);
Instance ball_at(const glm::dvec3& centre, double radius, std::uint32_t mesh);

/// Returns a pseudo-random number in [0, 1), the same on every machine.
double chance(std::uint32_t i);

/// Returns white lights of strength 1/sqrt(n) each.
std::vector<Light> white_lights(std::initializer_list<glm::dvec3> positions);

/// Returns Phong's exponent for a highlight that falls to one half at `degrees`, 0 < degrees < 90.
double shine_of(double degrees);

}   // namespace rayclock

#pragma once
#include <array>
#include <cstdint>
#include <initializer_list>
#include <vector>

#include <glm/vec3.hpp>

#include "model/scene/builtin.hpp"
#include "model/scene/placed.hpp"
#include "model/scene/scene.hpp"

namespace rayclock {

/// Haines' tessellation factor f: a sphere is six f x f grids, a cone or cylinder 4 f sectors if no other
/// number is asked for.
constexpr int tessellation = 3;
constexpr int sphere_triangles = 12 * tessellation * tessellation;
constexpr int sphere_vertices = 6 * tessellation * tessellation + 2;
constexpr int cone_sectors = 4 * tessellation;
constexpr std::uint64_t cone_triangles(int sectors) { return 2 * static_cast<std::uint64_t>(sectors); }
constexpr std::uint64_t cone_vertices(int sectors) { return 2 * static_cast<std::uint64_t>(sectors); }

/// Appends shapes to a scene. Every shape has vertices of its own, in one run, and its triangles share them;
/// triangles are counter-clockwise seen from outside and get the material that was set last.
/// A scene is written either with normals throughout or without any.
class MeshWriter {
public:
    explicit MeshWriter(Scene& scene, Primitives primitives = Primitives::triangles,
                        int sectors = cone_sectors);

    /// Memory for what is to come. Without normals, those of vertex(), flat() and cone() are dropped.
    void reserve(std::uint64_t vertices, const PrimitiveCounts& counts, bool with_normals);

    /// The material of the triangles to come: a new one, or one of the scene's by number.
    void material(const Material& material);
    void use_material(std::uint32_t number) { material_ = number; }

    std::uint32_t vertex(const glm::dvec3& position);
    std::uint32_t vertex(const glm::dvec3& position, const glm::dvec3& normal);
    void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);

    /// Planar convex polygon, cut as a fan, with its face normal at every corner.
    void flat(std::initializer_list<glm::dvec3> corners);

    /// One native sphere; or closed, an equal-angle cube grid (spd.md 5), normals radial.
    void sphere(const glm::dvec3& centre, double radius);

    /// Side only, no caps: base ring first, then apex ring.
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

/// Unit vectors across a unit axis in which the ring of a cone begins, and which lies a quarter further on.
struct Ring {
    glm::dvec3 start, quarter;
};
Ring ring_around(const glm::dvec3& axis);

/// A closed unit sphere, as sphere() cuts it, and an instance of it.
SharedMesh ball_mesh(std::uint32_t material);
Instance ball_at(const glm::dvec3& centre, double radius, std::uint32_t mesh);

/// Numbers from 0 to below 1 that look like chance, the same everywhere.
double chance(std::uint32_t i);

/// White lights of strength 1/sqrt(n) each (spd.md 2.2).
std::vector<Light> white_lights(std::initializer_list<glm::dvec3> positions);

/// Phong's exponent for a highlight that falls to one half at `degrees` (spd.md 2.4), 0 < degrees < 90.
double shine_of(double degrees);

}   // namespace rayclock

// Tessellation as in Haines' package. The unit sphere is cut once; copies are scaled and moved.
#include "model/scene/generate/mesh_writer.hpp"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace rayclock {
namespace {

constexpr int f = tessellation;

/// Returns grid line k = 0..f of a cube side from -1 to 1, at equal angles seen from the centre. It is odd,
/// with exact ends.
double grid_line(int k) {
    if (k == 0 || k == f) return k == 0 ? -1 : 1;
    return std::tan(std::numbers::pi / 4 * (2 * k - f) / f);
}

}   // namespace

glm::dvec3 unit(const glm::dvec3& v) { return v / glm::length(v); }

// Two rounds of multiply and fold (Wellons 2018, "Prospecting for hash functions", lowbias32).
double chance(std::uint32_t i) {
    i = (i ^ i >> 16) * 0x7feb352du;
    i = (i ^ i >> 15) * 0x846ca68bu;
    return double((i ^ i >> 16) >> 8) / (1 << 24);
}

std::vector<Light> white_lights(std::initializer_list<glm::dvec3> positions) {
    std::vector<Light> lights;
    for (const glm::dvec3& position : positions)
        lights.push_back({position, glm::dvec3(1 / std::sqrt(static_cast<double>(positions.size())))});
    return lights;
}

double shine_of(double degrees) {
    return std::log(0.5) / std::log(std::cos(degrees * std::numbers::pi / 180));
}

Circle ring_around(const glm::dvec3& axis) {
    glm::dvec3 start = glm::cross(axis, {0, 0, 1});
    if (glm::length(start) < 1e-9) start = glm::cross(axis, {1, 0, 0});
    start = unit(start);
    return {start, glm::cross(axis, start)};
}

SharedMesh ball_mesh(std::uint32_t material) {
    Scene ball;
    MeshWriter writer(ball);
    writer.use_material(material);
    writer.sphere(glm::dvec3(0), 1);
    return {"ball", std::move(ball.vertices), std::move(ball.normals), std::move(ball.triangles)};
}

Instance ball_at(const glm::dvec3& centre, double radius, std::uint32_t mesh) {
    glm::dmat4 place{glm::dmat3(radius)};
    place[3] = glm::dvec4(centre, 1);
    return {"a ball", mesh, place, {}};
}

MeshWriter::MeshWriter(Scene& scene, Primitives primitives, int sectors)
    : scene_(scene), primitives_(primitives), sectors_(sectors) {
    // Points of the (f+1)^3 lattice on the cube's surface. Sides that meet in an edge use the same points.
    std::uint32_t number[f + 1][f + 1][f + 1] = {};
    const auto on_surface = [](int k) { return k == 0 || k == f; };
    for (int x = 0; x <= f; ++x)
        for (int y = 0; y <= f; ++y)
            for (int z = 0; z <= f; ++z) {
                if (!on_surface(x) && !on_surface(y) && !on_surface(z)) continue;
                number[x][y][z] = static_cast<std::uint32_t>(sphere_points_.size());
                sphere_points_.push_back(unit({grid_line(x), grid_line(y), grid_line(z)}));
            }
    for (int axis = 0; axis < 3; ++axis)
        for (const int side : {0, f})
            for (int i = 0; i < f; ++i)
                for (int j = 0; j < f; ++j) {
                    const auto at = [&](int u, int v) {
                        int k[3] = {};
                        k[axis] = side;
                        // On the far side u, v and the outward normal are right-handed; on the near side swap
                        // u and v.
                        k[(axis + 1) % 3] = side == f ? u : v;
                        k[(axis + 2) % 3] = side == f ? v : u;
                        return number[k[0]][k[1]][k[2]];
                    };
                    sphere_faces_.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
                    sphere_faces_.push_back({at(i + 1, j + 1), at(i, j + 1), at(i, j)});
                }
}

void MeshWriter::reserve(std::uint64_t vertices, const PrimitiveCounts& counts, bool with_normals) {
    with_normals_ = with_normals;
    scene_.vertices.reserve(vertices);
    scene_.normals.reserve(with_normals ? vertices : 0);
    scene_.triangles.reserve(counts.triangles);
    scene_.spheres.reserve(counts.spheres);
}

void MeshWriter::material(const Material& material) {
    material_ = static_cast<std::uint32_t>(scene_.materials.size());
    scene_.materials.push_back(material);
}

std::uint32_t MeshWriter::vertex(const glm::dvec3& position) {
    scene_.vertices.push_back(position);
    return static_cast<std::uint32_t>(scene_.vertices.size() - 1);
}

std::uint32_t MeshWriter::vertex(const glm::dvec3& position, const glm::dvec3& normal) {
    if (with_normals_) scene_.normals.push_back(normal);
    return vertex(position);
}

void MeshWriter::triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    scene_.triangles.push_back({{a, b, c}, material_});
}

void MeshWriter::flat(std::initializer_list<glm::dvec3> corners) {
    const glm::dvec3* p = corners.begin();
    const glm::dvec3 normal = unit(glm::cross(p[1] - p[0], p[2] - p[1]));
    const auto first = static_cast<std::uint32_t>(scene_.vertices.size());
    for (const glm::dvec3& corner : corners) vertex(corner, normal);
    for (std::uint32_t i = 2; i < corners.size(); ++i) triangle(first, first + i - 1, first + i);
}

void MeshWriter::sphere(const glm::dvec3& centre, double radius) {
    if (primitives_ == Primitives::native) {
        scene_.spheres.push_back({centre, radius, material_});
        return;
    }
    const auto first = static_cast<std::uint32_t>(scene_.vertices.size());
    for (const glm::dvec3& p : sphere_points_) vertex(centre + radius * p, p);
    for (const auto& [a, b, c] : sphere_faces_) triangle(first + a, first + b, first + c);
}

void MeshWriter::cone(const glm::dvec3& base, double base_radius, const glm::dvec3& apex,
                      double apex_radius) {
    const double length = glm::length(apex - base);
    const glm::dvec3 axis = (apex - base) / length;
    const auto [start, quarter] = ring_around(axis);

    const auto first = static_cast<std::uint32_t>(scene_.vertices.size());
    for (const bool at_apex : {false, true})
        for (int k = 0; k < sectors_; ++k) {
            const double angle = 2 * std::numbers::pi * k / sectors_;
            const glm::dvec3 outward = std::cos(angle) * start + std::sin(angle) * quarter;
            const glm::dvec3 normal = unit(length * outward + (base_radius - apex_radius) * axis);
            vertex(at_apex ? apex + apex_radius * outward : base + base_radius * outward, normal);
        }
    const auto sectors = static_cast<std::uint32_t>(sectors_);
    for (std::uint32_t k = 0; k < sectors; ++k) {
        const std::uint32_t a = first + k, b = first + (k + 1) % sectors;
        triangle(a, b, b + sectors);
        triangle(b + sectors, a + sectors, a);
    }
}

}   // namespace rayclock

// Writes instances out as triangles.
#include "model/scene/placed.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "model/base/error.hpp"

namespace rayclock {
namespace {

constexpr std::uint64_t max_vertices = std::numeric_limits<std::uint32_t>::max();

/// Makes room for `more` items, and at least doubles the capacity. An exact reserve() for each of many copies
/// would move all items each time.
template <class Item> void make_room(std::vector<Item>& list, std::size_t more) {
    if (list.size() + more > list.capacity()) list.reserve(std::max(list.size() + more, 2 * list.size()));
}

/// `Part` has vertices, normals, triangles and coordinates: a Scene or a SharedMesh.
template <class Part> void append_triangles(Scene& scene, const Part& part, const glm::dmat4& place,
                                            std::optional<std::uint32_t> material,
                                            std::uint32_t material_base) {
    if (scene.vertices.size() + part.vertices.size() > max_vertices)
        throw UserError("more than 2^32 - 1 vertices");
    const auto base = static_cast<std::uint32_t>(scene.vertices.size());
    const glm::dmat3 linear(place);
    const double volume = glm::determinant(linear);
    make_room(scene.vertices, part.vertices.size());
    make_room(scene.normals, part.normals.size());
    make_room(scene.triangles, part.triangles.size());
    for (const glm::dvec3& v : part.vertices) scene.vertices.push_back(glm::dvec3(place * glm::dvec4(v, 1)));
    if (!part.normals.empty()) {
        // Cofactors instead of the inverse: the same directions, and no division by a small volume.
        const glm::dmat3 cofactors(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                                   glm::cross(linear[0], linear[1]));
        for (const glm::dvec3& n : part.normals) {
            const glm::dvec3 turned = unit_or_zero((volume < 0 ? -1.0 : 1.0) * (cofactors * n));
            scene.normals.push_back(turned == glm::dvec3(0) ? n : turned);
        }
    }
    if (!part.coordinates.empty() || !scene.coordinates.empty()) {
        const std::size_t missing = scene.triangles.size() - scene.coordinates.size();
        make_room(scene.coordinates, missing + part.triangles.size());
        scene.coordinates.resize(scene.triangles.size());
        for (std::size_t i = 0; i < part.triangles.size(); ++i) {
            CornerCoordinates corners = part.coordinates.empty() ? CornerCoordinates{} : part.coordinates[i];
            if (volume < 0) std::swap(corners[1], corners[2]);
            scene.coordinates.push_back(corners);
        }
    }
    for (Triangle t : part.triangles) {
        for (std::uint32_t& v : t.vertex) v += base;
        if (volume < 0) std::swap(t.vertex[1], t.vertex[2]);
        t.material = material ? *material : t.material + material_base;
        scene.triangles.push_back(t);
    }
}

}   // namespace

// Scaled first, so no square overflows or underflows.
glm::dvec3 unit_or_zero(glm::dvec3 v) {
    const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    if (!(largest > 0) || !std::isfinite(largest)) return glm::dvec3(0);
    v = v / largest;
    return v / std::sqrt(glm::dot(v, v));
}

void append(Scene& scene, const Scene& part, const glm::dmat4& place, std::optional<std::uint32_t> material,
            std::uint32_t material_base) {
    append_triangles(scene, part, place, material, material_base);
    const glm::dmat3 linear(place);
    const auto moved = [&](const glm::dvec3& p) { return glm::dvec3(place * glm::dvec4(p, 1)); };
    const auto material_of = [&](const auto& primitive) {
        return material ? *material : primitive.material + material_base;
    };
    for (const Sphere& s : part.spheres)
        scene.spheres.push_back({moved(s.centre), s.radius * glm::length(linear[0]), material_of(s),
                                 linear / glm::length(linear[0]) * s.turn});
    for (const Plane& p : part.planes)
        scene.planes.push_back({moved(p.point), linear * p.u, linear * p.v, material_of(p), p.coordinates});
}

std::uint64_t primitive_count(const PlacedScene& scene) {
    std::uint64_t count = primitive_count(scene.own);
    for (const Instance& instance : scene.instances) count += scene.meshes[instance.mesh].triangles.size();
    return count;
}

InstanceNumbers::InstanceNumbers(const PlacedScene& scene) : firsts_{scene.own.triangles.size()} {
    for (const Instance& instance : scene.instances)
        firsts_.push_back(firsts_.back() + scene.meshes[instance.mesh].triangles.size());
}

std::uint32_t InstanceNumbers::of(std::uint64_t primitive) const {
    if (primitive < firsts_.front() || primitive >= firsts_.back()) return none;
    return std::uint32_t(std::ranges::upper_bound(firsts_, primitive) - firsts_.begin() - 1);
}

Scene flat_copy(const PlacedScene& scene) {
    Scene flat = scene.own;
    for (const Instance& instance : scene.instances)
        append_triangles(flat, scene.meshes[instance.mesh], instance.place, instance.material, 0);
    return flat;
}

Scene flattened(PlacedScene scene) {
    if (scene.instances.empty() && scene.motion.empty()) return std::move(scene.own);
    Scene flat = flat_copy(scene);
    flat.placed = std::make_shared<const PlacedScene>(std::move(scene));
    return flat;
}

}   // namespace rayclock

#pragma once
// Measurements of meshes for the tests of scenes. Vertices count as equal if they are equal bit by bit,
// shared or not. That makes a mesh watertight for a tracer.
#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <utility>

#include <glm/geometric.hpp>

#include "model/base/error.hpp"
#include "model/scene/scene.hpp"

namespace rayclock {

struct Range {
    std::size_t begin, end;   ///< of triangles
};

using Point = std::array<double, 3>;
inline Point point(const glm::dvec3& p) { return {p.x + 0.0, p.y + 0.0, p.z + 0.0}; }   // -0 becomes 0

/// Returns how many directed edges lack their opposite, or occur more than once.
inline std::size_t open_edges(const Scene& scene, Range range) {
    std::map<std::pair<Point, Point>, int> edges;
    for (std::size_t i = range.begin; i < range.end; ++i)
        for (std::size_t k = 0; k < 3; ++k) {
            const auto& vertex = scene.triangles[i].vertex;
            ++edges[{point(scene.vertices[vertex[k]]), point(scene.vertices[vertex[(k + 1) % 3]])}];
        }
    std::size_t open = 0;
    for (const auto& [edge, times] : edges) {
        const auto opposite = edges.find({edge.second, edge.first});
        open += times != 1 || opposite == edges.end() || opposite->second != 1;
    }
    return open;
}

/// Returns the signed volume by Gauss: positive if triangles are counter-clockwise seen from outside.
inline double volume(const Scene& scene, Range range) {
    double six_volumes = 0;
    for (std::size_t i = range.begin; i < range.end; ++i) {
        const auto& v = scene.triangles[i].vertex;
        six_volumes += glm::dot(scene.vertices[v[0]], glm::cross(scene.vertices[v[1]], scene.vertices[v[2]]));
    }
    return six_volumes / 6;
}

inline Range whole(const Scene& scene) { return {0, scene.triangles.size()}; }

inline glm::dvec3 face_normal(const Scene& scene, std::size_t triangle) {
    const auto& v = scene.triangles[triangle].vertex;
    const glm::dvec3& a = scene.vertices[v[0]];
    return glm::cross(scene.vertices[v[1]] - a, scene.vertices[v[2]] - a);
}

/// Returns the message of the UserError that `call` throws; empty if it throws none.
template <class Call> std::string refusal(const Call& call) {
    try {
        call();
    } catch (const UserError& error) {
        return error.what();
    }
    return {};
}

}   // namespace rayclock

#include "model/shade/shade.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <glm/geometric.hpp>
#include <tbb/parallel_for.h>

namespace rayclock {
namespace {

/// Where a hit lies on the scene as given, and the normal there, on the eye's side.
struct SurfacePoint {
    glm::dvec3 position;
    glm::dvec3 normal;
    glm::dvec3 to_eye;
};

/// Unit vector along v, or `otherwise` where v has no direction.
glm::dvec3 unit_or(const glm::dvec3& v, const glm::dvec3& otherwise) {
    const double length = glm::length(v);
    return length > 0 && std::isfinite(length) ? v / length : otherwise;
}

/// Smooth normals can face away from the eye near a silhouette although the triangle faces it; the triangle
/// decides which side is seen, and its normal stands in where the smooth one vanishes.
SurfacePoint surface_point(const Scene& scene, const Hit& hit, const glm::dvec3& eye) {
    const auto& vertex = scene.triangles.at(hit.primitive).vertex;
    const glm::dvec3 &a = scene.vertices[vertex[0]], &b = scene.vertices[vertex[1]], &c = scene.vertices[vertex[2]];
    const double v1 = hit.u, v2 = hit.v, v0 = 1 - v1 - v2;
    SurfacePoint point;
    point.position = v0 * a + v1 * b + v2 * c;
    point.to_eye = unit_or(eye - point.position, {0, 0, 1});
    glm::dvec3 flat = unit_or(glm::cross(b - a, c - a), point.to_eye);
    if (glm::dot(flat, point.to_eye) < 0) flat = -flat;
    point.normal = flat;
    if (!scene.normals.empty()) {
        const auto& n = scene.normals;
        point.normal = unit_or(v0 * n[vertex[0]] + v1 * n[vertex[1]] + v2 * n[vertex[2]], flat);
        if (glm::dot(point.normal, flat) < 0) point.normal = -point.normal;
    }
    return point;
}

/// Phong 1975, "Illumination for computer generated pictures", in Haines' terms: the ambient term, and for every
/// light Lambert's cosine and the cosine between the light's mirrored direction and the eye to the power `shine`.
glm::dvec3 colour_at(const Scene& scene, const Material& material, const SurfacePoint& point) {
    glm::dvec3 sum = material.ambient * material.colour;
    for (const Light& light : scene.lights) {
        const glm::dvec3 to_light = unit_or(light.position - point.position, point.normal);
        const double lambert = glm::dot(point.normal, to_light);
        if (!(lambert > 0)) continue;
        const glm::dvec3 mirrored = 2 * lambert * point.normal - to_light;
        const double phong = std::pow(std::max(0.0, glm::dot(mirrored, point.to_eye)), material.shine);
        sum += light.colour * (material.diffuse * lambert * material.colour + material.highlight * phong);
    }
    return sum;
}

} // namespace

Picture shade(const Scene& scene, const HitFrame& frame) {
    if (!scene.camera) throw std::logic_error("shade() needs scene.camera: highlights depend on the eye");
    const glm::dvec3 eye = scene.camera->eye;
    Picture picture{frame.size, std::vector<glm::vec3>(frame.hits.size(), glm::vec3(scene.background))};
    tbb::parallel_for(0, frame.size.height, [&](int y) {
        const std::size_t begin = static_cast<std::size_t>(y) * frame.size.width;
        for (std::size_t i = begin; i < begin + frame.size.width; ++i) {
            const Hit& hit = frame.hits[i];
            if (hit.primitive == no_primitive) continue;
            const SurfacePoint point = surface_point(scene, hit, eye);
            const Material& material = scene.materials.at(scene.triangles[hit.primitive].material);
            picture.pixels[i] = glm::vec3(colour_at(scene, material, point));
        }
    });
    return picture;
}

} // namespace rayclock

// Shades plain hits, on all cores.
#include "model/scene/hit_shading.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <mutex>
#include <optional>
#include <stdexcept>

#include <tbb/parallel_for.h>
#include <glm/geometric.hpp>

#include "model/scene/folded.hpp"

namespace rayclock {
namespace {

/// The point of a hit on the scene as given, and the normal there, on the eye's side.
struct ShadedPoint {
    glm::dvec3 position;
    glm::dvec3 normal;
    glm::dvec3 to_eye;
    const Material* material;
    glm::dvec3 colour;
};

/// Returns the unit vector along v, or `otherwise` where v has no direction.
glm::dvec3 unit_or(const glm::dvec3& v, const glm::dvec3& otherwise) {
    const double length = glm::length(v);
    return length > 0 && std::isfinite(length) ? v / length : otherwise;
}

/// Sets the direction to the eye, and the normal: `outside` turned to the eye.
void finish(ShadedPoint& point, const glm::dvec3& eye, const glm::dvec3& outside) {
    point.to_eye = unit_or(eye - point.position, {0, 0, 1});
    point.normal = unit_or(outside, point.to_eye);
    if (glm::dot(point.normal, point.to_eye) < 0) point.normal = -point.normal;
}

/// Multiplies the point's colour by its material's texture, if there is one. `detail`: texture_detail().
void apply_texture(const Scene& scene, const glm::dvec2& st, double depth, double spread, ShadedPoint& point,
                   const std::function<double(const Texture&)>& detail) {
    if (!point.material->texture) return;
    const Texture& texture = scene.textures[*point.material->texture];
    const double lod = level_of_detail(detail(texture), depth, spread, glm::dot(point.normal, point.to_eye));
    point.colour *= filtered(texture, st, level_of(texture, lod));
}

/// Returns a point on a triangle. Smooth normals can face away from the eye near a silhouette although the
/// triangle faces it. So the flat normal decides which side is seen, and it replaces a smooth normal that
/// vanishes. The order of the vertices decides which side is outside. If the sum of the corner normals points
/// inwards, all three are turned.
ShadedPoint on_triangle(const Scene& scene, const PlacedTriangle& triangle, const Hit& hit,
                        const glm::dvec3& eye, double spread) {
    const auto& [a, b, c] = triangle.vertices;
    const double v1 = hit.u, v2 = hit.v, v0 = 1 - v1 - v2;
    ShadedPoint point;
    point.material = &scene.materials.at(triangle.material);
    point.colour = point.material->colour;
    point.position = v0 * a + v1 * b + v2 * c;
    const glm::dvec3 outside = glm::cross(b - a, c - a);
    finish(point, eye, outside);
    if (triangle.is_smooth) {
        const auto& n = triangle.normals;
        const bool is_turned = glm::dot(n[0] + n[1] + n[2], outside) < 0,
                   is_back = glm::dot(outside, point.to_eye) < 0;
        const glm::dvec3 smooth = v0 * n[0] + v1 * n[1] + v2 * n[2];
        point.normal = unit_or(is_turned != is_back ? -smooth : smooth, point.normal);
    }
    const auto& [p, q, r] = triangle.coordinates;
    apply_texture(scene, v0 * p + v1 * q + v2 * r, hit.depth, spread, point, [&](const Texture& texture) {
        return texture_detail(texture, triangle.vertices, triangle.coordinates);
    });
    return point;
}

/// Returns a point on a sphere: at the hit's depth along the pixel's ray.
ShadedPoint on_sphere(const Scene& scene, const Sphere& sphere, const Hit& hit, const glm::dvec3& eye,
                      const glm::dvec3& direction, double spread) {
    ShadedPoint point;
    point.material = &scene.materials.at(sphere.material);
    point.colour = point.material->colour;
    point.position = eye + static_cast<double>(hit.depth) * glm::normalize(direction);
    const glm::dvec3 outside = unit_or(point.position - sphere.centre, {0, 1, 0});
    finish(point, eye, outside);
    apply_texture(scene, octahedral_place(outside), hit.depth, spread, point,
                  [&](const Texture& texture) { return texture_detail(texture, sphere); });
    return point;
}

/// Returns a point on a plane: the hit counts squares from the plane's point.
ShadedPoint on_plane(const Scene& scene, const Plane& plane, const Hit& hit, const glm::dvec3& eye,
                     double spread) {
    ShadedPoint point;
    point.material = &scene.materials.at(plane.material);
    const bool is_other =
        point.material->checkered && std::fmod(std::floor(hit.u) + std::floor(hit.v), 2.0f) != 0;
    point.colour = is_other ? point.material->other : point.material->colour;
    point.position =
        plane.point + static_cast<double>(hit.u) * plane.u + static_cast<double>(hit.v) * plane.v;
    finish(point, eye, glm::cross(plane.u, plane.v));
    const auto& [a, b, c] = plane.coordinates;
    apply_texture(scene, a + double(hit.u) * (b - a) + double(hit.v) * (c - a), hit.depth, spread, point,
                  [&](const Texture& texture) { return texture_detail(texture, plane); });
    return point;
}

/// Returns a triangle of a flat scene.
PlacedTriangle triangle_of(const Scene& scene, std::uint32_t number) {
    const Triangle& triangle = scene.triangles[number];
    PlacedTriangle out;
    out.is_smooth = !scene.normals.empty();
    out.material = triangle.material;
    if (!scene.coordinates.empty()) out.coordinates = scene.coordinates[number];
    for (std::size_t k = 0; k < 3; ++k) {
        out.vertices[k] = scene.vertices[triangle.vertex[k]];
        if (out.is_smooth) out.normals[k] = scene.normals[triangle.vertex[k]];
    }
    return out;
}

ShadedPoint surface_point(const Scene& scene, const InstancedTriangles* instanced, const Hit& hit,
                          const glm::dvec3& eye, const glm::dvec3& direction, double spread) {
    if (instanced) return on_triangle(scene, (*instanced)(hit.primitive), hit, eye, spread);
    const std::size_t triangles = scene.triangles.size(), spheres = scene.spheres.size();
    if (hit.primitive < triangles)
        return on_triangle(scene, triangle_of(scene, hit.primitive), hit, eye, spread);
    if (hit.primitive < triangles + spheres)
        return on_sphere(scene, scene.spheres[hit.primitive - triangles], hit, eye, direction, spread);
    return on_plane(scene, scene.planes.at(hit.primitive - triangles - spheres), hit, eye, spread);
}

/// Phong 1975, "Illumination for computer generated pictures", in Haines' terms. It sums the ambient term and
/// two terms per light: Lambert's cosine, and the cosine between the light's mirrored direction and the eye
/// to the power `shine`.
glm::dvec3 colour_at(const Scene& scene, const ShadedPoint& point) {
    const Material& material = *point.material;
    glm::dvec3 sum = material.ambient * point.colour;
    for (const Light& light : scene.lights) {
        const glm::dvec3 to_light = unit_or(light.position - point.position, point.normal);
        const double lambert = glm::dot(point.normal, to_light);
        if (!(lambert > 0)) continue;
        const glm::dvec3 mirrored = 2 * lambert * point.normal - to_light;
        const double phong = std::pow(std::max(0.0, glm::dot(mirrored, point.to_eye)), material.shine);
        sum += light.colour * (material.diffuse * lambert * point.colour + material.highlight * phong);
    }
    return sum;
}

}   // namespace

Picture shade(const Scene& scene, const HitFrame& frame, const Progress& progress) {
    if (!scene.camera) throw std::logic_error("shade() needs scene.camera: highlights depend on the eye");
    const glm::dvec3 eye = scene.camera->eye;
    const std::optional<InstancedTriangles> instanced =
        is_folded(scene) ? std::make_optional<InstancedTriangles>(*scene.placed) : std::nullopt;
    const double spread = sample_spread(*scene.camera, frame.size, 1);
    const PixelRays rays = !scene.spheres.empty() ? pixel_rays(*scene.camera, frame.size) : PixelRays{};
    Picture picture{frame.size, std::vector<glm::vec3>(frame.hits.size(), glm::vec3(scene.background))};
    std::mutex reporting;
    std::uint64_t done = 0;
    tbb::parallel_for(0, frame.size.height, [&](int y) {
        const std::size_t begin = static_cast<std::size_t>(y) * frame.size.width;
        for (std::size_t i = begin; i < begin + frame.size.width; ++i) {
            const Hit& hit = frame.hits[i];
            if (hit.primitive == no_primitive) continue;
            const glm::dvec3 direction = rays.direction(static_cast<double>(i - begin), y);
            picture.pixels[i] = glm::vec3(colour_at(
                scene, surface_point(scene, instanced ? &*instanced : nullptr, hit, eye, direction, spread)));
        }
        if (!progress) return;
        const std::lock_guard lock(reporting);
        progress("shading", ++done, std::uint64_t(frame.size.height));
    });
    return picture;
}

}   // namespace rayclock

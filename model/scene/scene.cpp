// The conditions for every scene, whatever its source. Comparisons are written so that NaN fails them.
#include "model/scene/scene.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"
#include "model/core/config.hpp"
#include "model/scene/hit.hpp"
#include "model/scene/view.hpp"

namespace rayclock {
namespace {

/// A property of a material and its range.
struct Range {
    const char* name;
    double Material::*value;
    double most;
};
constexpr double no_limit = std::numeric_limits<double>::max();
constexpr Range material_ranges[] = {
    {"ambient", &Material::ambient, 1},     {"diffuse", &Material::diffuse, 1},
    {"highlight", &Material::highlight, 1}, {"mirror", &Material::mirror, 1},
    {"transmit", &Material::transmit, 1},   {"cutoff", &Material::cutoff, 1},
    {"shine", &Material::shine, no_limit},
};

bool is_within(const glm::dvec3& v, double most) {
    return v.x >= 0 && v.y >= 0 && v.z >= 0 && v.x <= most && v.y <= most && v.z <= most;
}

std::string numbered(const char* what, std::size_t i) {
    return std::string(what) + " " + std::to_string(i) + " (counted from 0)";
}

struct Judge {
    const Scene& scene;
    const std::string& where;

    [[noreturn]] void refuse(const std::string& sentence) const { throw UserError(where + ": " + sentence); }

    void counts() const {
        if (primitive_count(scene) == 0) refuse("there is nothing to see: no triangle, no sphere, no plane");
        if (primitive_count(scene) >= no_primitive)
            refuse(std::to_string(primitive_count(scene)) + " primitives are too many; the most is " +
                   std::to_string(no_primitive - 1));
        if (scene.materials.empty()) refuse("there are no materials");
        if (scene.lights.size() > std::size_t(max_lights))
            refuse("there are " + std::to_string(scene.lights.size()) + " lights; the most is " +
                   std::to_string(max_lights));
    }

    void vertices() const {
        for (std::size_t i = 0; i < scene.vertices.size(); ++i)
            if (!is_finite(scene.vertices[i]))
                refuse(numbered("vertex", i) + " is " + text_of(scene.vertices[i]) + ", not a finite point");
        if (!scene.normals.empty() && scene.normals.size() != scene.vertices.size())
            refuse("there are " + std::to_string(scene.normals.size()) + " normals for " +
                   std::to_string(scene.vertices.size()) + " vertices");
    }

    void triangles() const {
        for (std::size_t i = 0; i < scene.triangles.size(); ++i) {
            const Triangle& t = scene.triangles[i];
            for (const std::uint32_t vertex : t.vertex)
                if (vertex >= scene.vertices.size())
                    index("triangle", i, "vertex", vertex, scene.vertices.size());
            material_of("triangle", i, t.material);
        }
    }

    void textures() const {
        for (const Texture& texture : scene.textures)
            if (!texture.pyramid || texture.pyramid->levels.empty())
                refuse("the texture " + shown(texture.name) + " has no picture");
        for (std::size_t i = 0; i < scene.materials.size(); ++i)
            if (const auto texture = scene.materials[i].texture; texture && *texture >= scene.textures.size())
                index("material", i, "texture", *texture, scene.textures.size());
        if (scene.coordinates.empty()) {
            for (std::size_t i = 0; i < scene.triangles.size(); ++i)
                if (scene.materials[scene.triangles[i].material].texture)
                    refuse(numbered("triangle", i) + " has a texture and no coordinates on it");
            return;
        }
        if (scene.coordinates.size() != scene.triangles.size())
            refuse("there are coordinates of " + std::to_string(scene.coordinates.size()) +
                   " triangles, and there are " + std::to_string(scene.triangles.size()));
        for (std::size_t i = 0; i < scene.coordinates.size(); ++i)
            for (const glm::dvec2& corner : scene.coordinates[i])
                for (const double x : {corner.x, corner.y})
                    if (!(std::abs(x) <= max_coordinate))
                        refuse(numbered("triangle", i) + " has the texture coordinate " + text_of(x) +
                               ", which must lie within -" + text_of(max_coordinate) + " and " +
                               text_of(max_coordinate));
    }

    void spheres() const {
        for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
            const Sphere& s = scene.spheres[i];
            if (!is_finite(s.centre))
                refuse(numbered("sphere", i) + " has the centre " + text_of(s.centre) +
                       ", not a finite point");
            if (!(s.radius > 0) || !std::isfinite(s.radius))
                refuse(numbered("sphere", i) + " has the radius " + text_of(s.radius) +
                       ", which must be above 0 and finite");
            material_of("sphere", i, s.material);
        }
    }

    void planes() const {
        for (std::size_t i = 0; i < scene.planes.size(); ++i) {
            const Plane& p = scene.planes[i];
            if (!is_finite(p.point))
                refuse(numbered("plane", i) + " goes through " + text_of(p.point) + ", not a finite point");
            for (const glm::dvec3& side : {p.u, p.v})
                if (!is_finite(side) || side == glm::dvec3(0))
                    refuse(numbered("plane", i) + " has the side " + text_of(side) +
                           ", not a direction of finite length");
            // Below this the direction of the normal is mostly rounding.
            if (!(glm::length(glm::cross(unit_of(p.u), unit_of(p.v))) > 1e-9))
                refuse(numbered("plane", i) + " has the sides " + text_of(p.u) + " and " + text_of(p.v) +
                       ", which are parallel");
            for (const glm::dvec2& at : p.coordinates)
                for (const double x : {at.x, at.y})
                    if (!(std::abs(x) <= max_given_coordinate))
                        refuse(numbered("plane", i) + " has the texture coordinate " + text_of(x) +
                               ", which must lie within -" + text_of(max_given_coordinate) + " and " +
                               text_of(max_given_coordinate));
            material_of("plane", i, p.material);
        }
    }

    void material_of(const char* what, std::size_t i, std::uint32_t material) const {
        if (material >= scene.materials.size()) index(what, i, "material", material, scene.materials.size());
    }

    [[noreturn]] void index(const char* what, std::size_t i, const std::string& part, std::uint32_t used,
                            std::size_t count) const {
        refuse(std::string(what) + " " + std::to_string(i) + " uses " + part + " " + std::to_string(used) +
               " (counted from 0), and there are " + std::to_string(count));
    }

    void extent() const {
        const Bounds box = bounds(scene);
        if (!is_finite(box.hi - box.lo))
            refuse("the scene reaches from " + text_of(box.lo) + " to " + text_of(box.hi) +
                   ", further than a double can tell");
    }

    void materials() const {
        for (std::size_t i = 0; i < scene.materials.size(); ++i) {
            const Material& m = scene.materials[i];
            const std::string name = "material " + std::to_string(i) + " " + shown(m.name) + " has ";
            const bool good = is_finite(m.colour) && is_finite(m.other) &&
                              is_finite({m.ambient, m.diffuse, m.highlight}) &&
                              is_finite({m.shine, m.mirror, m.transmit}) && is_finite({m.cutoff, m.index, 0});
            if (!good) refuse(name + "a value that is not a finite number");
            for (const glm::dvec3& colour : {m.colour, m.other})
                if (!is_within(colour, 1))
                    refuse(name + "the colour " + text_of(colour) + ", which must lie within 0 and 1");
            for (const Range& range : material_ranges)
                if (const double x = m.*range.value; !(x >= 0 && x <= range.most))
                    refuse(name + range.name + " " + text_of(x) + ", which must " +
                           (range.most == no_limit ? "not be negative" : "lie within 0 and 1"));
            if (m.transmit > 0 && !(m.index > 0))
                refuse(name + "the refractive index " + text_of(m.index) + ", which must be above 0");
        }
    }

    void lights() const {
        for (std::size_t i = 0; i < scene.lights.size(); ++i) {
            const Light& light = scene.lights[i];
            const std::string name = numbered("light", i);
            if (!is_finite(light.position))
                refuse(name + " is at " + text_of(light.position) + ", not a finite point");
            if (!is_finite(light.colour))
                refuse(name + " has the colour " + text_of(light.colour) + ", not finite numbers");
            if (!is_within(light.colour, max_light))
                refuse(name + " has the colour " + text_of(light.colour) + ", which must lie within 0 and " +
                       text_of(max_light));
        }
        if (!is_finite(scene.background) || !is_within(scene.background, 1))
            refuse("the background " + text_of(scene.background) +
                   " is not a colour: three numbers within 0 and 1");
    }
};

/// Bounds that grow with every point; empty at first.
struct Growing {
    Bounds box{glm::dvec3(std::numeric_limits<double>::infinity()),
               glm::dvec3(-std::numeric_limits<double>::infinity())};
    void add(const glm::dvec3& lo, const glm::dvec3& hi) {
        box.lo = glm::min(box.lo, lo);
        box.hi = glm::max(box.hi, hi);
    }
};

}   // namespace

std::optional<std::uint32_t> texture_of(const Scene& scene, std::size_t primitive) {
    const auto of = [&](const auto& it) { return scene.materials[it.material].texture; };
    if (primitive < scene.triangles.size())
        return scene.coordinates.empty() ? std::nullopt : of(scene.triangles[primitive]);
    primitive -= scene.triangles.size();
    return primitive < scene.spheres.size() ? of(scene.spheres[primitive])
                                            : of(scene.planes[primitive - scene.spheres.size()]);
}

bool shows_textures(const Scene& scene) {
    const auto has_texture = [&](const auto& it) {
        return it.material < scene.materials.size() && scene.materials[it.material].texture;
    };
    return !scene.coordinates.empty() || std::ranges::any_of(scene.spheres, has_texture) ||
           std::ranges::any_of(scene.planes, has_texture);
}

Bounds bounds(const Scene& scene) {
    if (primitive_count(scene) == 0)
        throw UserError(scene.name + ": there is nothing to see: no triangle, no sphere, no plane");
    Growing growing;
    for (const Triangle& triangle : scene.triangles)
        for (const std::uint32_t index : triangle.vertex)
            growing.add(scene.vertices[index], scene.vertices[index]);
    for (const Sphere& sphere : scene.spheres)
        growing.add(sphere.centre - sphere.radius, sphere.centre + sphere.radius);
    if (scene.triangles.empty() && scene.spheres.empty())
        for (const double s : {-5.0, 5.0})
            for (const double t : {-5.0, 5.0}) {
                const Plane& plane = scene.planes.front();
                const glm::dvec3 corner = plane.point + s * plane.u + t * plane.v;
                growing.add(corner, corner);
            }
    return growing.box;
}

void check_scene(const Scene& scene, const std::string& where) {
    const Judge judge{scene, where};
    judge.counts();
    judge.vertices();
    judge.triangles();
    judge.spheres();
    judge.planes();
    judge.extent();
    judge.materials();
    judge.textures();
    judge.lights();
    if (scene.camera) view_of(*scene.camera, where);
}

}   // namespace rayclock

// What every scene must fulfil, whoever made it. Comparisons are written so that NaN fails them.
#include "model/scene/scene.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>

#include "model/core/error.hpp"
#include "model/scene/hit.hpp"
#include "model/scene/view.hpp"

namespace rayclock {
namespace {

struct Judge {
    const Scene& scene;
    const std::string& where;

    [[noreturn]] void refuse(const std::string& sentence) const { throw UserError(where + ": " + sentence); }

    void vertices() const {
        for (std::size_t i = 0; i < scene.vertices.size(); ++i)
            if (!is_finite(scene.vertices[i]))
                refuse("vertex " + std::to_string(i) + " (counted from 0) is " + text_of(scene.vertices[i]) +
                       ", not a finite point");
        if (!scene.normals.empty() && scene.normals.size() != scene.vertices.size())
            refuse("there are " + std::to_string(scene.normals.size()) + " normals for " +
                   std::to_string(scene.vertices.size()) + " vertices");
    }

    void triangles() const {
        if (scene.triangles.empty()) refuse("there are no triangles");
        if (scene.triangles.size() >= no_primitive)
            refuse(std::to_string(scene.triangles.size()) + " triangles are too many; the most is " +
                   std::to_string(no_primitive - 1));
        if (scene.materials.empty()) refuse("there are no materials");
        for (std::size_t i = 0; i < scene.triangles.size(); ++i) {
            const Triangle& t = scene.triangles[i];
            for (const std::uint32_t vertex : t.vertex)
                if (vertex >= scene.vertices.size()) index(i, "vertex", vertex, scene.vertices.size());
            if (t.material >= scene.materials.size()) index(i, "material", t.material, scene.materials.size());
        }
    }

    [[noreturn]] void index(std::size_t triangle, const std::string& what, std::uint32_t used, std::size_t count) const {
        refuse("triangle " + std::to_string(triangle) + " uses " + what + " " + std::to_string(used) +
               " (counted from 0), and there are " + std::to_string(count));
    }

    void extent() const {
        const Bounds box = bounds(scene);
        if (!is_finite(box.hi - box.lo))
            refuse("the scene reaches from " + text_of(box.lo) + " to " + text_of(box.hi) + ", further than a double can tell");
    }

    void materials() const {
        for (std::size_t i = 0; i < scene.materials.size(); ++i) {
            const Material& m = scene.materials[i];
            const bool good = is_finite(m.colour) && is_finite({m.ambient, m.diffuse, m.highlight}) &&
                              is_finite({m.shine, m.mirror, m.transmit}) && std::isfinite(m.index);
            if (!good) refuse("material " + std::to_string(i) + " '" + m.name + "' has a value that is not a finite number");
        }
    }

    void lights() const {
        for (std::size_t i = 0; i < scene.lights.size(); ++i) {
            const Light& light = scene.lights[i];
            const std::string name = "light " + std::to_string(i) + " (counted from 0)";
            if (!is_finite(light.position)) refuse(name + " is at " + text_of(light.position) + ", not a finite point");
            if (!is_finite(light.colour)) refuse(name + " has the colour " + text_of(light.colour) + ", not finite numbers");
        }
        if (!is_finite(scene.background)) refuse("the background " + text_of(scene.background) + " is not a colour");
    }
};

} // namespace

Bounds bounds(const Scene& scene) {
    if (scene.triangles.empty()) throw UserError(scene.name + ": there are no triangles");
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Bounds box{glm::dvec3(infinity), glm::dvec3(-infinity)};
    for (const Triangle& triangle : scene.triangles)
        for (const std::uint32_t index : triangle.vertex) {
            box.lo = glm::min(box.lo, scene.vertices[index]);
            box.hi = glm::max(box.hi, scene.vertices[index]);
        }
    return box;
}

void check_scene(const Scene& scene, const std::string& where) {
    const Judge judge{scene, where};
    judge.vertices();
    judge.triangles();
    judge.extent();
    judge.materials();
    judge.lights();
    if (scene.camera) view_of(*scene.camera, where);
}

} // namespace rayclock

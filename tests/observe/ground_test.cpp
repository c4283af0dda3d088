// --ground: where the square lies, and what it hides.
#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "sim/judge/reference/reference.hpp"
#include "model/scene/builtin.hpp"
#include "sim/run/request/ground.hpp"

using namespace rayclock;

namespace {

constexpr FrameSize size{40, 30};

Scene scene_of(const char* name, Primitives primitives, const glm::dvec3& up) {
    Scene scene = make_builtin(name, primitives);
    scene.camera = fit_camera(scene, 4.0 / 3);
    scene.camera->up = up;
    return scene;
}

HitFrame seen(const Scene& scene) { return Reference(scene).frame(*scene.camera, size, 1); }

}   // namespace

TEST_CASE("a ground lies under all of a scene, touches nothing, and hides nothing that was seen from above") {
    const auto [name, primitives] =
        GENERATE(std::pair{"gears:1", Primitives::triangles}, std::pair{"balls:1", Primitives::native},
                 std::pair{"teapot:3", Primitives::triangles}, std::pair{"square", Primitives::triangles});
    const auto up = GENERATE(glm::dvec3{0, 1, 0}, glm::dvec3{0, 0, 1}, glm::dvec3{0.2, 2, -0.3});
    INFO(name << ", up " << up.x << " " << up.y << " " << up.z);
    const Scene own = scene_of(name, primitives, up);
    Scene scene = own;
    lay_ground(scene);
    check_scene(scene, name);
    REQUIRE(scene.triangles.size() == own.triangles.size() + 2);
    CHECK((scene.normals.empty() || scene.normals.size() == scene.vertices.size()));

    const double height = glm::dot(scene.vertices.back(), up);
    for (std::size_t v = own.vertices.size(); v < scene.vertices.size(); ++v)
        CHECK(glm::dot(scene.vertices[v], up) == Approx(height).margin(1e-9));
    for (const Triangle& triangle : own.triangles)
        for (const std::uint32_t v : triangle.vertex)
            if (!(glm::dot(own.vertices[v], up) > height)) FAIL("a corner lies below the ground");
    for (const Sphere& sphere : own.spheres)
        if (!(glm::dot(sphere.centre, up) - sphere.radius * glm::length(up) > height))
            FAIL("a sphere reaches through the ground");

    // From above: what was seen is seen. From below: only the ground, everywhere.
    const Bounds box = bounds(own);
    const glm::dvec3 middle = 0.5 * (box.lo + box.hi),
                     arm = glm::normalize(up) * glm::length(box.hi - box.lo);
    for (const double side : {2.0, -2.0}) {
        Scene without = own, with = scene;
        with.camera->eye = middle + side * arm + 0.1 * glm::dvec3{arm.y, arm.z, arm.x};
        with.camera->at = middle;
        with.camera->up = {arm.z, arm.x, arm.y};
        without.camera = with.camera;
        const HitFrame was = seen(without), is = seen(with);
        for (std::size_t i = 0; i < was.hits.size(); ++i) {
            const std::uint32_t prim = is.hits[i].primitive;
            const bool hits_ground = prim >= own.triangles.size() && prim < scene.triangles.size();
            if (side < 0 ? !hits_ground : was.hits[i].primitive != no_primitive && hits_ground)
                FAIL("pixel " << i << ", side " << side);
        }
    }
}

// The scene cube against the numbers of Vortex's test rt_raycast.
#include <catch2/catch.hpp>

#include <cmath>

#include <glm/geometric.hpp>

#include "model/scene/builtin.hpp"

using namespace rayclock;

TEST_CASE("the cube has 12 triangles that point outward, and the camera of rt_raycast", "[scene][builtin]") {
    const Scene scene = make_builtin("cube");
    REQUIRE(scene.triangles.size() == 12);
    double area = 0;
    for (const Triangle& triangle : scene.triangles) {
        const glm::dvec3 a = scene.vertices[triangle.vertex[0]], b = scene.vertices[triangle.vertex[1]],
                         c = scene.vertices[triangle.vertex[2]], n = glm::cross(b - a, c - a);
        CHECK(glm::dot(n, a + b + c) > 0);
        area += glm::length(n) / 2;
    }
    CHECK(area == Approx(6 * 2 * 2));
    REQUIRE(scene.camera);
    CHECK(glm::length(scene.camera->eye) == Approx(2.6 * std::sqrt(3.0)));
    CHECK(scene.camera->eye.x / scene.camera->eye.z == Approx(0.4));
    CHECK(scene.camera->eye.y / scene.camera->eye.z == Approx(0.35));
    CHECK(scene.camera->at == glm::dvec3(0));
    CHECK(scene.camera->fov_degrees == 50);
}

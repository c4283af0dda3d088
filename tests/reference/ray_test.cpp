// Rays that slab and edge tests often get wrong: zero and negative zero components, rays in the faces of
// boxes, origins on surfaces. Also the guarantees of trace() for depth, sides and directions.
#include <catch2/catch.hpp>

#include "sim/judge/reference/reference.hpp"
#include "tests/reference/meshes.hpp"

using namespace rayclock;

namespace {

/// Returns squares of two triangles each in the plane z = 0, over 0..n in x and y, with box faces at every
/// integer.
Scene checkerboard(int n) {
    Scene scene = empty_scene();
    for (int y = 0; y <= n; ++y)
        for (int x = 0; x <= n; ++x) scene.vertices.emplace_back(x, y, 0);
    const auto at = [n](int x, int y) { return static_cast<std::uint32_t>(y * (n + 1) + x); };
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x) {
            scene.triangles.push_back({{at(x, y), at(x + 1, y), at(x + 1, y + 1)}, 0});
            scene.triangles.push_back({{at(x, y), at(x + 1, y + 1), at(x, y + 1)}, 0});
        }
    return scene;
}

}   // namespace

TEST_CASE("axis-parallel rays hit, whatever the signs of their zeros", "[reference]") {
    const Scene scene = sphere(3, 1, {0.25, -0.5, 0.125});
    const Reference reference(scene);
    const glm::dvec3 centre(0.25, -0.5, 0.125);
    for (int axis = 0; axis < 3; ++axis)
        for (double sign : {1.0, -1.0})
            for (double zero1 : {0.0, -0.0})
                for (double zero2 : {0.0, -0.0})
                    for (double shift : {0.0, 0.25, 0.3, -0.5}) {
                        glm::dvec3 direction, origin = centre;
                        direction[axis] = sign;
                        direction[(axis + 1) % 3] = zero1;
                        direction[(axis + 2) % 3] = zero2;
                        origin[axis] -= 4 * sign;
                        origin[(axis + 1) % 3] += shift;
                        CAPTURE(axis, sign, zero1, zero2, shift);
                        const Hit hit = reference.trace(origin, direction);
                        REQUIRE(hit.primitive != no_primitive);
                        REQUIRE(hit.depth == Approx(4 - std::sqrt(1 - shift * shift)).margin(0.02));
                        REQUIRE(reference.trace(origin, -direction).primitive == no_primitive);
                    }
}

TEST_CASE("an axis-parallel ray exactly through a vertex meets that vertex, or something before it",
          "[reference]") {
    MeshRng rng(5);
    const Scene scene = soup(rng, 400, 0.1);
    const Reference reference(scene);
    for (const glm::dvec3& vertex : scene.vertices)
        for (int axis = 0; axis < 3; ++axis)
            for (double sign : {1.0, -1.0}) {
                glm::dvec3 origin = vertex, direction(0);
                origin[axis] -= 4 * sign;
                direction[axis] = sign;
                const Hit hit = reference.trace(origin, direction);
                CAPTURE(vertex.x, vertex.y, vertex.z, axis, sign);
                REQUIRE(hit.primitive != no_primitive);
                REQUIRE(hit.depth <= 4 + 1e-6f);
            }
}

TEST_CASE("rays along box faces, edges and corners of a grid hit its border", "[reference]") {
    const int n = 16;
    const Reference reference(checkerboard(n));
    for (double zero : {0.0, -0.0})
        for (int y = 0; y <= 2 * n; ++y)
            for (int x = 0; x <= 2 * n; ++x) {
                CAPTURE(x, y, zero);
                const Hit down = reference.trace({x / 2.0, y / 2.0, 3}, {zero, zero, -1});
                REQUIRE(down.primitive != no_primitive);
                REQUIRE(down.depth == 3);
                // Slanted within one plane, which contains the faces of many boxes.
                const Hit slanted = reference.trace({x / 2.0, y / 2.0 - 3, 3}, {zero, 1, -1});
                REQUIRE(slanted.primitive != no_primitive);
            }
    CHECK(reference.trace({-0.001, 4, 3}, {0, 0, -1}).primitive == no_primitive);
    CHECK(reference.trace({4, 16.001, 3}, {0, 0, -1}).primitive == no_primitive);
}

TEST_CASE("a ray within the plane of a triangle does not hit it", "[reference]") {
    const Reference reference(checkerboard(4));
    CHECK(reference.trace({-1, 1.5, 0}, {1, 0, 0}).primitive == no_primitive);
    CHECK(reference.trace({-1, -1, 0}, {1, 1, -0.0}).primitive == no_primitive);
}

TEST_CASE("rays in the faces of a box meet the sides across", "[reference]") {
    const Reference reference(box({-1, -2, -3}, {1, 2, 3}));
    for (double x : {-1.0, 1.0}) {
        const Hit along_y = reference.trace({x, -5, 0.5}, {0, 1, 0});
        REQUIRE(along_y.primitive != no_primitive);
        CHECK(along_y.depth == 3);
        const Hit along_edge = reference.trace({x, 2, -7}, {0, -0.0, 1});
        REQUIRE(along_edge.primitive != no_primitive);
        CHECK(along_edge.depth == 4);
    }
}

TEST_CASE("depth is measured along the unit direction, and only in front of the origin", "[reference]") {
    Scene scene = empty_scene();
    add_triangle(scene, {-1, -1, 0}, {1, -1, 0}, {0, 2, 0});
    const Reference reference(scene);
    for (double length : {1e-200, 1e-6, 1.0, 1e6, 1e200}) {
        CAPTURE(length);
        const Hit hit = reference.trace({0, 0, 5}, glm::dvec3(0, 0, -length));
        REQUIRE(hit.primitive == 0);
        CHECK(hit.depth == 5);
        CHECK(reference.trace({0, 0, 5}, glm::dvec3(0, 0, length)).primitive == no_primitive);
    }
    CHECK(reference.trace({0, 0, -5}, {0, 0, 1}).depth == 5);                 // also from behind
    CHECK(reference.trace({0, 0, 0}, {0, 0, 1}).primitive == no_primitive);   // depth 0 is not a hit
    CHECK(reference.trace({0, 0, 1e-12}, {0, 0, -1}).primitive == 0);
}

TEST_CASE("u and v weigh the second and third vertex", "[reference]") {
    Scene scene = empty_scene();
    add_triangle(scene, {0, 0, 0}, {4, 0, 0}, {0, 8, 0});
    const Reference reference(scene);
    for (double z : {1.0, -1.0}) {
        const Hit hit = reference.trace({1, 4, z}, {0, 0, -z});
        REQUIRE(hit.primitive == 0);
        CHECK(hit.u == 0.25f);
        CHECK(hit.v == 0.5f);
    }
}

TEST_CASE("rays without a direction and scenes without triangles give no hit", "[reference]") {
    const double nan = std::numeric_limits<double>::quiet_NaN(),
                 inf = std::numeric_limits<double>::infinity();
    const Reference reference(sphere(2));
    for (const glm::dvec3 direction : {glm::dvec3(0), glm::dvec3(nan, 0, 1), glm::dvec3(inf, 0, 0)})
        CHECK(reference.trace({0, 0, 0}, direction).primitive == no_primitive);
    CHECK(reference.trace({nan, 0, 0}, {0, 0, 1}).primitive == no_primitive);
    CHECK(reference.trace({1e300, 1e300, 1e300}, {1, 1, 1}).primitive == no_primitive);
    CHECK(reference.trace({-1e50, 0, 0}, {0, 0, 1}).primitive == no_primitive);
    CHECK(Reference(empty_scene()).trace({0, 0, 5}, {0, 0, -1}).primitive == no_primitive);
}

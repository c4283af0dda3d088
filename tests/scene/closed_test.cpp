// Meshes without a border: every directed edge has exactly one opposite edge, with positions compared bit by
// bit.
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include "model/scene/builtin.hpp"
#include "tests/scene/mesh_measures.hpp"

using namespace rayclock;

TEST_CASE("the icosphere is closed, shared, round and turned outward", "[scene][closed]") {
    const int size = GENERATE(1, 2, 4);
    const Scene scene = make_builtin("icosphere:" + std::to_string(size));
    CHECK(open_edges(scene, whole(scene)) == 0);
    CHECK(2 * scene.vertices.size() == scene.triangles.size() + 4);   // Euler
    // An inscribed polyhedron: its volume is below the ball's, and closer to it the finer it is.
    const double missing = 4 * std::numbers::pi / 3 - volume(scene, whole(scene));
    CHECK(missing > 0);
    CHECK(missing < 2.5 / std::pow(4, size));
    for (const glm::dvec3& p : scene.vertices) REQUIRE(std::abs(glm::length(p) - 1) < 1e-15 * 4);
    CHECK(scene.normals == scene.vertices);
}

TEST_CASE("a tessellated sphere is closed and turned outward", "[scene][closed]") {
    const Scene scene = make_builtin("balls:1");
    for (std::size_t ball = 0; ball < 10; ++ball) {
        const Range range{2 + 108 * ball, 2 + 108 * (ball + 1)};
        CAPTURE(ball);
        CHECK(open_edges(scene, range) == 0);
        const double radius = ball == 0 ? 0.5 : 0.5 / 3,
                     exact = 4 * std::numbers::pi / 3 * radius * radius * radius;
        CHECK(volume(scene, range) < exact);
        CHECK(volume(scene, range) > 0.85 * exact);
    }
}

TEST_CASE("every gear is closed and turned outward", "[scene][closed]") {
    const Scene scene = make_builtin("gears:2");
    for (std::size_t gear = 0; gear < 8; ++gear) {
        CAPTURE(gear);
        const Range range{2 + 572 * gear, 2 + 572 * (gear + 1)};
        CHECK(open_edges(scene, range) == 0);
        // A prism over the 144-gon. Its area is a sum over the triangles between its centre and its edges.
        const double rho = 1 / 1.95, outer = 0.995 * rho, inner = 0.9 * rho, tau = std::numbers::pi / 18;
        const double tooth = outer * outer * std::sin(0.38 * tau) + inner * inner * std::sin(0.4 * tau) +
                             2 * outer * inner * std::sin(0.11 * tau);
        CHECK(volume(scene, range) == Approx(36 * tooth / 2 * 0.1).epsilon(1e-12));
    }
}

TEST_CASE("a gear's face is cut along valid and well-shaped diagonals", "[scene][closed]") {
    const Scene scene = make_builtin("gears:1");
    // Top and bottom: all triangles are counter-clockwise, so areas that sum to the outline's do not overlap.
    for (const Range range : {Range{2, 2 + 142}, Range{2 + 142 + 288, 2 + 572}}) {
        const double up = range.begin == 2 ? 1 : -1;
        double area = 0;
        std::map<std::uint32_t, int> fan;
        for (std::size_t i = range.begin; i < range.end; ++i) {
            const glm::dvec3 normal = face_normal(scene, i);
            CHECK(normal.z * up > 0);
            area += normal.z * up / 2;
            for (const std::uint32_t v : scene.triangles[i].vertex) ++fan[v];
        }
        CHECK(fan.size() == 144);
        for (const auto& [vertex, triangles] : fan)
            CHECK(triangles <= 14);   // a fan has 70 or more at one corner
        const double tau = std::numbers::pi / 18;
        const double tooth = 0.995 * 0.995 * std::sin(0.38 * tau) + 0.81 * std::sin(0.4 * tau) +
                             2 * 0.995 * 0.9 * std::sin(0.11 * tau);
        CHECK(area == Approx(18 * tooth).epsilon(1e-12));
    }
}

TEST_CASE("little tetrahedra of tetra are closed and turned outward", "[scene][closed]") {
    const Scene scene = make_builtin("tetra:3");
    for (std::size_t i = 0; i < 16; ++i) {
        CHECK(open_edges(scene, {4 * i, 4 * i + 4}) == 0);
        CHECK(volume(scene, {4 * i, 4 * i + 4}) == Approx(8.0 / 3 / 64).epsilon(1e-12));
    }
}

TEST_CASE("the terrain is open at its border only", "[scene][closed]") {
    const Scene scene = make_builtin("mount:4");
    CHECK(open_edges(scene, {4 * 108, scene.triangles.size()}) == 4 * 16);
}

TEST_CASE("the teapot's body, bottom and lid are seamless across patches", "[scene][closed]") {
    const int n = GENERATE(3, 7, 12);
    const auto cells = static_cast<std::size_t>(n * n), c = static_cast<std::size_t>(n);
    Scene scene = make_builtin("teapot:" + std::to_string(n));
    const auto board = 2 * cells, patch = 2 * cells;
    CHECK(open_edges(scene, {0, board}) == 4 * c);
    // Rim and body are open at the rim's top and, without the bottom, at the foot: each a circle of four
    // patches.
    CHECK(open_edges(scene, {board, board + 12 * patch}) == 2 * 4 * c);
    // Lid and bottom are open only at their outer circle, not at the cusp.
    const std::size_t lid = board + 20 * patch, bottom = lid + 8 * patch - 4 * c;
    CHECK(open_edges(scene, {lid, bottom}) == 4 * c);
    CHECK(open_edges(scene, {bottom, scene.triangles.size()}) == 4 * c);
    // With the bottom the body is open only at the rim, although the bottom has the opposite direction.
    scene.triangles.erase(scene.triangles.begin() + static_cast<std::ptrdiff_t>(board + 12 * patch),
                          scene.triangles.begin() + static_cast<std::ptrdiff_t>(bottom));
    CHECK(open_edges(scene, {board, scene.triangles.size()}) == 4 * c);
}

TEST_CASE("the Cornell box is open towards the camera only", "[scene][closed]") {
    const Scene scene = make_builtin("cornell");
    // Blocks stand on the floor without a bottom: four edges each. The room lacks its front: four edges.
    CHECK(open_edges(scene, whole(scene)) == 3 * 4);
    // From inside, every face of the room faces the middle.
    const glm::dvec3 middle(278, 274, 280);
    std::size_t facing_away = 0;
    for (std::size_t i = 0; i < scene.triangles.size(); ++i) {
        const bool is_block = i >= 12 && i < 32;
        const glm::dvec3& corner = scene.vertices[scene.triangles[i].vertex[0]];
        facing_away += !is_block && !(glm::dot(face_normal(scene, i), middle - corner) > 0);
    }
    CHECK(facing_away == 0);
}

// Coincident primitives: the reference keeps the one with the lowest number, as the machine does.
#include <catch2/catch.hpp>

#include "sim/judge/reference/distinct.hpp"
#include "sim/judge/reference/reference.hpp"
#include "model/scene/builtin.hpp"
#include "model/scene/camera.hpp"
#include "tests/support/cases/coincident.hpp"

using namespace rayclock;
using namespace rayclock::test;

TEST_CASE("of equal primitives the first is kept, whatever the order of their corners") {
    Scene scene;
    scene.materials.resize(2);
    scene.materials[1].transmit = 0.5;
    scene.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.0, 1, -0.0}, {0, 0, 1}, {1, 0, 0}};
    const std::array<std::array<std::uint32_t, 3>, 8> triangles{
        {{0, 1, 2}, {1, 2, 0}, {2, 1, 0}, {0, 5, 3}, {0, 1, 4}, {4, 5, 0}, {0, 1, 1}, {0, 0, 1}}};
    for (const auto& t : triangles) scene.triangles.push_back({t, 0});
    CHECK(distinct_triangles(scene) == std::vector<std::uint32_t>{0, 4, 6, 7});
    scene.spheres = {{{0, 0, 0}, 1, 0}, {{0, 0, 0}, 2, 0}, {{0, -0.0, 0}, 1, 0},
                     {{0, 0, 0}, 1, 1}, {{1, 0, 0}, 1, 0}, {{1, 0, 0}, 1, 0}};
    CHECK(distinct_spheres(scene) == std::vector<std::uint32_t>{0, 1, 4});
    scene.planes = {{{0, 0, 0}, {1, 0, 0}, {0, 0, -1}, 0},
                    {{0, 0, 0}, {1, 0, 0}, {0, 0, -1}, 1},
                    {{0, 0, 0}, {2, 0, 0}, {0, 0, -1}, 0}};
    CHECK(distinct_planes(scene) == std::vector<std::uint32_t>{0, 2});
}

TEST_CASE(
    "a scene of tripled triangles shows in every pixel the lowest number of those that the plain one shows") {
    const FrameSize size{80, 60};
    for (const char* name : {"gears:1", "teapot:4", "rings:1"}) {
        Scene plain = make_builtin(name);
        if (!plain.camera) plain.camera = fit_camera(plain, 4.0 / 3);
        std::vector<std::uint32_t> original;
        const Scene more = tripled(plain, 7, original);
        // Where triangles of the plain scene coincide, its number is ambiguous.
        if (distinct_triangles(plain).size() != plain.triangles.size()) continue;
        const HitFrame one = Reference(plain).frame(*plain.camera, size),
                       three = Reference(more).frame(*plain.camera, size);
        std::size_t hits = 0, wrong = 0;
        for (std::size_t i = 0; i < one.hits.size(); ++i) {
            const std::uint32_t a = one.hits[i].primitive, b = three.hits[i].primitive;
            hits += a != no_primitive;
            if (a == no_primitive || b == no_primitive)
                wrong += a != b;
            else
                wrong += b != lowest(original, b) ||
                         (original[b] != a && one.hits[i].depth != three.hits[i].depth);
        }
        INFO(name);
        CHECK(hits > one.hits.size() / 20);
        CHECK(wrong == 0);
    }
}

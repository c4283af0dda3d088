// Compares whole pictures in two levels with the same scene in one level.
#include <catch2/catch.hpp>

#include "model/compile/levels/levels.hpp"
#include "model/compile/compile.hpp"
#include "model/compile/frame.hpp"
#include "model/base/error.hpp"
#include "model/trace/trace.hpp"
#include "tests/support/levels/picture.hpp"
#include "tests/support/levels/closed_instances.hpp"

using namespace rayclock;

namespace {

constexpr FrameSize size{64, 48};

/// Returns a primitive's number if the instances are in reverse order.
std::uint32_t same_in_reverse(const PlacedScene& scene, std::uint32_t prim) {
    const auto count = [&](std::size_t i) {
        return std::uint32_t(scene.meshes[scene.instances[i].mesh].triangles.size());
    };
    std::size_t instance = 0;
    for (; instance < scene.instances.size() && prim >= count(instance); ++instance) prim -= count(instance);
    for (std::size_t i = instance + 1; i < scene.instances.size(); ++i) prim += count(i);
    return prim;
}

}   // namespace

TEST_CASE("with maps that are exact on the lattice, two levels equal one level bit for bit", "[levels]") {
    const Config config = of_structure(format(18, 20), GENERATE(from_range(tree_structures())));
    const glm::dmat4 swapped(glm::dvec4(0, 1, 0, 0), glm::dvec4(0, 0, 1, 0), glm::dvec4(1, 0, 0, 0),
                             glm::dvec4(0, 0, 0, 1));
    for (const glm::dmat4& place :
         {glm::dmat4(1), swapped, glm::scale(glm::dmat4(1), glm::dvec3(-1, 1, 1)),
          glm::scale(swapped, glm::dvec3(1, -1, -1)), glm::scale(glm::dmat4(1), glm::dvec3(-1))}) {
        PlacedScene scene;
        scene.own.name = "soup";
        scene.own.materials.emplace_back();
        Scene mesh = soup(300, 0.2, 5);
        scene.meshes.push_back({"soup", mesh.vertices, {}, mesh.triangles});
        scene.instances.push_back({"soup", 0, place, {}});
        const Scene flat = flattened(scene);
        const Camera camera{{2.5, 1.5, 2}, {0, 0, 0}, {0, 1, 0}, 40};
        const MemoryImage image = compile_scene(flat, camera.eye, config);
        const LevelsImage levels = compile_levels(scene, camera.eye, config);
        REQUIRE(levels.maps.instances.size() == 1);
        CHECK(levels.maps.instances[0].is_whole);
        CHECK(levels.image.lattice.centre == image.lattice.centre);
        CHECK(levels.image.lattice.pitch == image.lattice.pitch);
        const Frame frame = make_frame(camera, size, image, config);
        const Trace trace = record_trace(image, frame, config, 1);
        const std::vector<Closest> hits = trace_levels(levels, camera, size, config, 1).answers;
        std::size_t wrong = 0, found = 0;
        for (std::size_t i = 0; i < hits.size(); ++i) {
            const Closest &a = hits[i], &b = trace.hits[i];
            // In a mirror image the second and the third corner are exchanged.
            const bool is_same = (a.u == b.u && a.v == b.v) || (a.u == b.v && a.v == b.u);
            wrong += a.found != b.found || a.prim != b.prim || a.t != b.t || !is_same;
            found += a.found;
        }
        CHECK(wrong == 0);
        CHECK(found > 500);
    }
}

TEST_CASE("the gearbox in two levels is small, and has the hits of the gears", "[levels]") {
    Config config = format(18, 20);
    const PlacedScene scene = make_placed("gearbox:8");
    const LevelsImage levels = compile_levels(scene, scene.own.camera->eye, config);
    CHECK(levels.maps.classes.size() == 2);   // the ground, the gear
    const Scene gears = make_builtin("gears:8");
    const MemoryImage image = compile_scene(gears, gears.camera->eye, config);
    CHECK(levels.image.words.size() * 20 <= image.words.size());

    const Trace trace = record_trace(image, make_frame(*gears.camera, size, image, config), config, 1);
    const LevelsPicture picture = trace_levels(levels, *gears.camera, size, config, 1);
    const std::vector<Closest>& hits = picture.answers;
    const LevelCounts& counts = picture.counts;
    std::size_t other = 0, found = 0;
    std::int64_t off = 0;
    for (std::size_t i = 0; i < hits.size(); ++i) {
        found += hits[i].found;
        other += hits[i].found != trace.hits[i].found || hits[i].prim != trace.hits[i].prim;
        if (hits[i].prim == trace.hits[i].prim && hits[i].found)
            off = std::max(off, std::abs(std::int64_t(hits[i].t) - std::int64_t(trace.hits[i].t)));
    }
    CAPTURE(counts.visits, counts.changes, counts.tests, trace.visits, trace.triangle_tests, off);
    CHECK(found > hits.size() / 2);
    CHECK(other <= hits.size() / 200);
}

TEST_CASE("the order of instances does not change what is hit", "[levels]") {
    const Config config = of_structure(format(16, 18), GENERATE(from_range(tree_structures())));
    PlacedScene scene = solids(20, 11, 0.5, 0.5, 0);
    const Camera camera{{9, 7, 8}, {0, 0, 0}, {0, 1, 0}, 60};
    const auto answers = [&](int threads) {
        return trace_levels(compile_levels(scene, camera.eye, config), camera, size, config, threads).answers;
    };
    const std::vector<Closest> before = answers(1);
    std::reverse(scene.instances.begin(), scene.instances.end());
    const std::vector<Closest> after = answers(2);
    std::size_t wrong = 0, found = 0;
    for (std::size_t i = 0; i < before.size(); ++i) {
        const std::uint32_t turned = same_in_reverse(scene, after[i].prim);
        wrong += before[i].found != after[i].found || before[i].t != after[i].t ||
                 (before[i].found && before[i].prim != turned);
        found += before[i].found;
    }
    CHECK(wrong == 0);
    CHECK(found > 100);
}

TEST_CASE("two levels refuse scenes and configurations that they cannot compile", "[levels]") {
    const PlacedScene scene = solids(2, 1, 1, 1, 0);
    const auto refused = [&](Config config, const PlacedScene& placed) {
        try {
            compile_levels(placed, {9, 7, 8}, config);
        } catch (const UserError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    Config config = format(18, 20);
    CHECK(refused(config, scene).empty());
    config.primitive_test = PrimitiveTest::sheared;
    CHECK(refused(config, scene).find("levels=2 needs") != std::string::npos);
    config = format(18, 20);
    config.structure = Structure::none;
    CHECK(refused(config, scene).find("levels=2 needs") != std::string::npos);
    config = format(20, 18);
    config.structure = Structure::bsp;
    CHECK(refused(config, scene).find("leaves 0 of 512: coord_bits") != std::string::npos);
    config = format(18, 20);
    PlacedScene round = scene;
    round.own.spheres.emplace_back();
    CHECK(refused(config, round).find("spheres is 0") != std::string::npos);
    config.prim_bits = 5;
    CHECK(refused(config, scene).find("prim_bits is 5") != std::string::npos);
    PlacedScene small = scene;

    small.instances[0].place = glm::scale(glm::dmat4(1), glm::dvec3(1e-7));
    small.instances.pop_back();
    small.own.triangles = {{{0, 1, 2}, 0}};
    small.own.vertices = {{0, 0, 0}, {1e-9, 0, 0}, {0, 1e-9, 0}};
    CHECK(refused(format(18, 20), small).find("vanish") != std::string::npos);
}

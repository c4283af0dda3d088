// Built-in scenes with mirrors or glass send rays to the expected depth, counted by depth.
#include <catch2/catch.hpp>

#include "sim/judge/reference/reference.hpp"
#include "model/scene/builtin.hpp"

using namespace rayclock;

namespace {

/// Returns the reflected and refracted rays of each depth, from 1.
std::vector<std::uint64_t> bounces_by_depth(const Scene& scene, int most) {
    const Reference reference(scene);
    std::vector<std::uint64_t> rays;
    std::uint64_t before = 0;
    for (int depth = 1; depth <= most; ++depth) {
        const RayCounts counts = reference.whitted(*scene.camera, {48, 36}, {.depth = depth}).rays;
        const std::uint64_t all = counts.reflection + counts.refraction;
        rays.push_back(all - before);
        before = all;
    }
    return rays;
}

}   // namespace

TEST_CASE("scenes with mirrors and glass go on bouncing, those without do not begin",
          "[reference][bounces]") {
    const auto [name, least] =
        GENERATE(table<std::string, std::vector<std::uint64_t>>({{"balls:2", {300, 100, 40, 15, 5}},
                                                                 {"gears:2", {1000, 600, 700, 800, 800}},
                                                                 {"mount:4", {600, 700, 800, 900, 1000}},
                                                                 {"rings:2", {300, 100, 50, 25, 10}},
                                                                 {"teapot:6", {700, 150, 60, 15, 5}},
                                                                 {"spheres", {1200, 800, 700, 600, 600}}}));
    CAPTURE(name);
    const std::vector<std::uint64_t> rays =
        bounces_by_depth(make_builtin(name, Primitives::native), int(least.size()));
    CAPTURE(rays);
    for (std::size_t i = 0; i < least.size(); ++i) CHECK(rays[i] >= least[i]);
}

TEST_CASE("between the mirrors rays go on for as many bounces as they may", "[reference][bounces]") {
    const std::vector<std::uint64_t> rays = bounces_by_depth(make_builtin("mirrors"), max_depth);
    CAPTURE(rays);
    CHECK(rays[0] > 1000);
    for (std::size_t i = 1; i < rays.size(); ++i) CHECK(rays[i] > rays[i - 1] / 2);
    CHECK(rays.back() > 50);
}

TEST_CASE("scenes that neither mirror nor transmit send shadow rays alone", "[reference][bounces]") {
    const std::string name = GENERATE("tetra:3", "tree:3", "cornell", "icosphere:2", "plane", "square");
    for (const std::uint64_t rays : bounces_by_depth(make_builtin(name, Primitives::native), 2))
        CHECK(rays == 0);
}

// Cut-offs of textures in memory: rounded to 8 bits, and 0 only where the material has no holes.
#include <catch2/catch.hpp>

#include "model/compile/textures.hpp"
#include "tests/support/cases/tex_cases.hpp"

namespace rayclock::test::cutoffs_test {

using namespace rayclock;
using namespace rayclock::test;

TEST_CASE("a cut-off is rounded to 255ths, and is 0 only where a material has no holes", "[textures]") {
    Scene scene;
    scene.textures = {
        {.name = "white",
         .pyramid = std::make_shared<const Pyramid>(make_pyramid({1, 1, {{255, 255, 255, 255}}}))}};
    scene.materials.emplace_back();
    scene.materials[0].texture = 0;
    scene.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    scene.triangles = {{{0, 1, 2}, 0}};
    scene.coordinates = {{{{0, 0}, {1, 0}, {0, 1}}}};
    const Lattice lattice{glm::dvec3(0), glm::dvec3(1), 16};
    const auto stored = [&](double cutoff) {
        scene.materials[0].cutoff = cutoff;
        return record_of(scene, lattice, tex_config("rgb888"), 0, 0).cutoff;
    };
    CHECK(stored(0) == 0);
    CHECK(stored(1e-9) == 1);
    CHECK(stored(0.4 / 255) == 1);
    CHECK(stored(1.4 / 255) == 1);
    CHECK(stored(1.6 / 255) == 2);
    CHECK(stored(0.5) == 128);
    CHECK(stored(254.4 / 255) == 254);
    CHECK(stored(1) == 255);
}

}   // namespace rayclock::test::cutoffs_test

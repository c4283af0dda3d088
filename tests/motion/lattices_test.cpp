// The lattices of a film are chosen once, and must contain every frame.
#include <catch2/catch.hpp>

#include "model/compile/levels/moving.hpp"
#include "tests/support/machine/frames.hpp"

using namespace rayclock;
using namespace rayclock::test;

TEST_CASE("lattices serve the places and the eyes of all frames, and not of the first one alone",
          "[motion][film]") {
    const Config config = with(named_config("default"), {{"levels", 2}});
    PlacedScene scene;
    scene.own.materials.emplace_back();
    scene.meshes.push_back(own_mesh(make_placed("icosphere:2")));
    for (int i = 0; i < 2; ++i) scene.instances.push_back({"ball", 0, glm::dmat4(1), {}});
    glm::dmat4 far(1), small(0.5);
    far[3] = {40, -3, 7, 1}, small[3] = {-2, 25, 1, 1};
    const std::vector<InstancePlaces> times{{glm::dmat4(1), glm::dmat4(1)}, {far, small}, {small, far}};
    const std::vector<glm::dvec3> eyes{{0, 0, 5}, {3, 2, 60}, {-50, 2, 6}};
    const auto levels = MovingLevels::make(scene, times, eyes, 1, config);
    REQUIRE(levels);
    const LevelMaps& maps = levels->levels().maps;
    const double end = (1 << (config.coord_bits - 1)) - 1;
    const auto holds = [&](const Lattice& lattice, const glm::dvec3& point) {
        const glm::dvec3 at = glm::abs((point - lattice.centre) / lattice.pitch);
        return std::max({at.x, at.y, at.z}) <= end + 0.5 + 1e-6;
    };
    for (std::size_t f = 0; f < times.size(); ++f) {
        INFO("frame " << f);
        levels->next(times[f]);
        CHECK(holds(maps.lattice, eyes[f]));
        for (std::size_t i = 0; i < times[f].size(); ++i) {
            const InstanceMap& map = maps.instances[i];
            const MeshClass& made = maps.classes[map.mesh_class];
            for (const glm::dvec3& v : scene.meshes[0].vertices) {
                REQUIRE(holds(maps.lattice, glm::dvec3(times[f][i] * glm::dvec4(v, 1))));
                REQUIRE(holds(made.lattice, v));
            }
            // The mesh's lattice contains everything that the scene's lattice contains.
            for (std::size_t row = 0; row < 3; ++row) {
                double most = std::abs(double(map.b[row]));
                for (std::size_t k = 0; k < 3; ++k) most += std::abs(double(map.a[3 * row + k])) * end;
                CHECK(std::ldexp(most, -config.map_frac()) <= end + 0.25);
            }
            for (std::size_t k = 0; k < 3; ++k) {   // and a node can represent the box
                CHECK(map.box.lo[k] >= -end - 1);
                CHECK(map.box.hi[k] <= end + 1);
            }
        }
    }
}

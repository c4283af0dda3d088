// The scene WKND against a list of spheres from an independent program: the published generator in NumPy,
// with numpy.random.RandomState(42) and float32.
#include <catch2/catch.hpp>

#include "model/scene/builtin.hpp"

using namespace rayclock;

namespace {

struct Expected {
    std::size_t number;   // among the small spheres
    double x, z;
    const char* kind;
    double r, g, b;
};
constexpr Expected expected[]{{0, -10.144356727600098, -10.283111572265625, "matt", 0.09311975538730621,
                               0.46676862239837646, 0.13427314162254333},
                              {1, -10.910022735595703, -9.859604835510254, "matt", 0.085879385471344,
                               0.289050430059433, 0.02667483501136303},
                              {5, -10.790505409240723, -5.670274257659912, "glass", 1, 1, 1},
                              {8, -10.13093090057373, -2.1520185470581055, "metal", 0.6523069143295288,
                               0.6927082538604736, 0.9041986465454102},
                              {100, -6.3228631019592285, 1.1914551258087158, "matt", 0.010348663665354252,
                               0.6169255375862122, 0.7489877939224243},
                              {250, 0.6904694437980652, -2.9525845050811768, "matt", 0.3010654151439667,
                               0.01804177649319172, 0.0355883352458477},
                              {482, 10.652640342712402, 10.588757514953613, "matt", 0.1432153731584549,
                               0.19123037159442902, 0.03787442669272423}};

std::string kind_of(const Material& m) { return m.transmit > 0 ? "glass" : m.mirror > 0 ? "metal" : "matt"; }

}   // namespace

TEST_CASE("WKND has the spheres of the published generator", "[scene][builtin]") {
    const Scene scene = make_builtin("wknd", Primitives::native);
    REQUIRE(scene.spheres.size() == 487);
    REQUIRE(scene.materials.size() == 487);
    CHECK(scene.triangles.empty());
    CHECK(scene.spheres[0].centre == glm::dvec3(0, -1000, 0));
    CHECK(scene.spheres[0].radius == 1000);
    std::map<std::string, int> kinds;
    double x = 0, z = 0, colours = 0;
    for (std::size_t i = 1; i < 484; ++i) {
        const Sphere& sphere = scene.spheres[i];
        const Material& material = scene.materials[sphere.material];
        REQUIRE(sphere.radius == double(0.2f));
        REQUIRE(sphere.centre.y == double(0.2f));
        ++kinds[kind_of(material)];
        x += sphere.centre.x, z += sphere.centre.z;
        if (kind_of(material) != "glass")
            colours += material.colour.r + material.colour.g + material.colour.b;
    }
    CHECK(kinds == std::map<std::string, int>{{"glass", 26}, {"matt", 393}, {"metal", 64}});
    CHECK(x == Approx(-20.713759250938892).epsilon(1e-14));
    CHECK(z == Approx(-27.819555785506964).epsilon(1e-14));
    CHECK(colours == Approx(436.5389265064514).epsilon(1e-14));
    for (const Expected& e : expected) {
        INFO(e.number);
        const Sphere& sphere = scene.spheres[1 + e.number];
        const Material& material = scene.materials[sphere.material];
        CHECK(sphere.centre == glm::dvec3(e.x, 0.2f, e.z));
        CHECK(kind_of(material) == e.kind);
        CHECK(material.colour == glm::dvec3(e.r, e.g, e.b));
    }
    const glm::dvec3 large[]{{0, 1, 0}, {-4, 1, 0}, {4, 1, 0}};
    for (std::size_t k = 0; k < 3; ++k) {
        CHECK(scene.spheres[484 + k].centre == large[k]);
        CHECK(scene.spheres[484 + k].radius == 1);
    }
    REQUIRE(scene.camera);
    CHECK(scene.camera->eye == glm::dvec3(13, 2, 3));
    CHECK(scene.camera->fov_degrees == 20);
}

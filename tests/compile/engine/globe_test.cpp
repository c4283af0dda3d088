// Globes: the smallest around given points or spheres, outward rounding, and whole images of them.
#include <catch2/catch.hpp>

#include <cmath>

#include <glm/geometric.hpp>

#include "tests/support/check/globe_check.hpp"
#include "model/compile/compile.hpp"
#include "model/engine/spheres/encode.hpp"
#include "model/scene/builtin.hpp"
#include "sim/load/load.hpp"
#include "tests/support/cases/draw.hpp"

namespace rayclock::test::globe_test {

using namespace rayclock;
using test::Draw;

namespace {

Config globes(int width = 8) {
    Config config;
    config.structure = Structure::spheres;
    config.node_width = width;
    config.stack_depth = 64;
    return config;
}

/// Returns the largest excess beyond a ball.
double beyond(const std::vector<spheres::Bead>& beads, const glm::dvec3& centre, double radius) {
    double most = -1e30;
    for (const spheres::Bead& b : beads)
        most = std::max(most, glm::length(b.centre - centre) + b.radius - radius);
    return most;
}

/// Moves by shrinking steps towards the farthest bead (Badoiu and Clarkson). Slow, and unlike Gaertner's
/// pivots.
double least_radius(const std::vector<spheres::Bead>& beads) {
    glm::dvec3 at = beads[0].centre;
    double least = 1e30;
    for (int i = 1; i < 200000; ++i) {
        const spheres::Bead* far = &beads[0];
        double most = -1;
        for (const spheres::Bead& b : beads)
            if (const double d = glm::length(b.centre - at) + b.radius; d > most) most = d, far = &b;
        least = std::min(least, most);
        const double length = glm::length(far->centre - at);
        if (length > 0) at += (far->centre - at) * ((length + far->radius) / length) / double(i + 1);
    }
    return least;
}

MemoryImage image_of(const std::string& name, const Config& config, Primitives primitives) {
    Scene scene = load_scene(name, {}, primitives);
    if (!scene.camera) scene.camera = fit_camera(scene, 4.0 / 3);
    return compile_scene(scene, scene.camera->eye, config);
}

}   // namespace

TEST_CASE("a globe around corners is the smallest", "[globe]") {
    Draw draw{3};
    for (int i = 0; i < 12; ++i) {
        std::vector<spheres::Bead> beads;
        const int flat = draw.below(3);   // nothing, a plane, a line
        for (int n = draw.between(2, 60); n-- > 0;) {
            const int x = draw.between(-5000, 5000), y = draw.between(-5000, 5000), z = draw.between(-50, 50);
            beads.push_back({{x, flat == 2 ? x : y, flat == 0 ? z : x}, 0});
        }
        const spheres::Globe globe = spheres::enclose(beads);
        CAPTURE(i, beads.size(), flat);
        CHECK(beyond(beads, globe.centre, globe.radius) <= 0);
        CHECK(globe.radius <= least_radius(beads) * (1 + 1e-6));
    }
}

TEST_CASE("a globe around spheres is the smallest, and its radius never grows", "[globe]") {
    Draw draw{4};
    for (int i = 0; i < 8; ++i) {
        std::vector<spheres::Bead> beads;
        for (int n = draw.between(2, 30); n-- > 0;)
            beads.push_back({{draw.between(-500, 500), draw.between(-500, 500), draw.between(-500, 500)},
                             double(draw.below(300))});
        const spheres::Globe globe = spheres::enclose(beads);
        CAPTURE(i, beads.size());
        CHECK(beyond(beads, globe.centre, globe.radius) <= 0);
        CHECK(globe.radius <= least_radius(beads) * (1 + 1.0 / 1024));
    }
    const std::vector<spheres::Bead> one{{{7, -8, 9}, 100}}, same(5, spheres::Bead{{1, 2, 3}, 0});
    CHECK(spheres::enclose(one).centre == glm::dvec3(7, -8, 9));
    CHECK(spheres::enclose(one).radius == Approx(100).epsilon(1e-6));
    CHECK(spheres::enclose(same).radius < 1e-5);
}

TEST_CASE("globes are written outward, with the least step", "[globe]") {
    Draw draw{5};
    const Config config = globes();
    for (int i = 0; i < 2000; ++i) {
        std::vector<spheres::GlobeChild> children;
        const int spread = 1 << draw.between(0, 16), size = 1 << draw.between(0, 16);
        for (int n = draw.between(1, 8); n-- > 0;) {
            spheres::GlobeChild child{{}, 1};
            for (int k = 0; k < 3; ++k)
                child.globe.centre[k] = draw.between(-spread, spread) + draw.below(8) / 8.;
            child.globe.radius = draw.below(size) + draw.below(8) / 8.;
            children.push_back(child);
        }
        const GlobeNode node = spheres::encode_globes(children, 5, config);
        const double step = std::ldexp(1, int(node.exp));
        double largest = 0;
        for (std::size_t n = 0; n < children.size(); ++n) {
            glm::dvec3 centre;
            for (std::size_t k = 0; k < 3; ++k) {
                centre[int(k)] = node.org[k] + node.centre[3 * n + k] * step;
                largest = std::max(largest, double(node.centre[3 * n + k]));
            }
            const double radius = node.radius[n] * step, real = children[n].globe.radius;
            largest = std::max(largest, double(node.radius[n]));
            CHECK(glm::length(centre - children[n].globe.centre) + real <= radius * (1 + 1e-12));
            CHECK(radius <= real + 2 * step);
        }
        CHECK(largest < 1 << globe_bits);
        if (node.exp > 0) CHECK(largest >= (1 << (globe_bits - 1)) - 2);
        CHECK(node.base == 5);
    }
}

TEST_CASE("an image of globes holds every primitive in its globes", "[globe]") {
    const int width = GENERATE(8, 4, 2);
    for (const char* name : {"gears:1", "balls:2", "rings:1", "mount:4", "teapot:4"}) {
        INFO(name << ", " << width);
        const Config config = globes(width);
        const MemoryImage image = image_of(name, config, Primitives::triangles);
        CHECK(check_globes(image, config) == std::vector<std::string>{});
        const GlobeSizes sizes = globe_sizes(image, config);
        CAPTURE(sizes.globes, sizes.mean, sizes.most);
        CHECK(sizes.mean < 1.02);
    }
}

TEST_CASE("an image of globes holds spheres, planes and the sheared test's margin", "[globe]") {
    Config config = globes();
    config.shading = config.spheres = config.planes = config.refraction = config.smooth = 1;
    for (const char* name : {"spheres", "balls:1", "plane"})
        CHECK(check_globes(image_of(name, config, Primitives::native), config) == std::vector<std::string>{});
    Config sheared = globes();
    sheared.coord_bits = 16, sheared.dir_bits = 20, sheared.primitive_test = PrimitiveTest::sheared;
    CHECK(check_globes(image_of("gears:1", sheared, Primitives::triangles), sheared) ==
          std::vector<std::string>{});
}

TEST_CASE("a damaged image of globes is noticed", "[globe]") {
    const Config config = globes();
    const MemoryImage sound = image_of("tetra:3", config, Primitives::triangles);
    const auto changed = [&](auto change) {
        MemoryImage image = sound;
        auto node = unpack<GlobeNode>(image.line(0), config);
        change(node, image);
        Words words = pack(node, config);
        std::copy(words.begin(), words.end(), image.words.begin());
        return check_globes(image, config).size();
    };
    CHECK(changed([](GlobeNode&, MemoryImage&) {}) == 0);
    CHECK(changed([](GlobeNode& node, MemoryImage&) { node.radius[0] -= 2; }) > 0);
    CHECK(changed([](GlobeNode& node, MemoryImage&) { node.centre[1] += 3; }) > 0);
    CHECK(changed([](GlobeNode& node, MemoryImage&) { node.base = 0; }) > 0);
    CHECK(changed([](GlobeNode& node, MemoryImage&) { node.base = 0xffffff; }) > 0);
    CHECK(changed([](GlobeNode& node, MemoryImage&) { node.kind[0] = 0; }) > 0);
    CHECK(changed([](GlobeNode&, MemoryImage& image) { ++image.report.nodes; }) > 0);
}

}   // namespace rayclock::test::globe_test

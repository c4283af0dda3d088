// Planes in any direction: the planes that the compiler proposes, its placement of primitives, and its
// treatment of hopeless scenes.
#include <catch2/catch.hpp>

#include <functional>

#include <glm/geometric.hpp>

#include "tests/support/check/bsp_check.hpp"
#include "model/engine/bsp/facets.hpp"
#include "model/engine/bsp/slant.hpp"
#include "model/core/layout.hpp"
#include "tests/compile/listed.hpp"
#include "tests/support/cases/draw.hpp"

using namespace rayclock;

namespace {

Config bsp_of(int width = 8, Straddlers straddlers = Straddlers::leaves) {
    Config config;
    config.structure = Structure::bsp;
    config.straddlers = straddlers;
    config.node_width = width;
    config.stack_depth = 64;
    return config;
}

/// Returns the faults of the compiled image of these primitives.
std::vector<std::string> complaints(const std::vector<PrimData>& prims, const Config& config) {
    return check_slants(compile_triangles(prims, config, "the case"), prims, config);
}
const std::vector<std::string> none;

PrimData triangle(const Vec3i& a, const Vec3i& b, const Vec3i& c, std::uint32_t number) {
    return {a, b, c, number};
}

/// Returns triangles in all directions. Many share corners, edges and planes.
std::vector<PrimData> tangle(unsigned seed, int count, int extent) {
    test::Draw draw{seed};
    std::vector<Vec3i> corners;
    for (int i = 0; i < count; ++i)
        corners.push_back(
            {draw.between(-extent, extent), draw.between(-extent, extent), draw.between(-extent, extent)});
    std::vector<PrimData> prims;
    const auto any = [&] { return corners[std::size_t(draw.below(count))]; };
    while (int(prims.size()) < count) {
        const PrimData t = triangle(any(), any(), any(), std::uint32_t(prims.size()));
        if (counts(t, Config{})) prims.push_back(t);
    }
    return prims;
}

void check_scenes(int width, Straddlers rule) {
    const Config config = bsp_of(width, rule);
    for (const char* name : {"gears:1", "balls:1", "rings:1", "mount:4", "teapot:2"}) {
        INFO(name << ", " << width);
        const std::vector<PrimData> prims = test::prims_of(name, config, Primitives::triangles);
        const MemoryImage image = compile_triangles(prims, config, name);
        CHECK(check_slants(image, prims, config) == none);
        CHECK(image.report.references <= 8 * prims.size());
        if (rule == Straddlers::stop) CHECK(image.report.references == prims.size());
    }
}

}   // namespace

TEST_CASE("a normal is rounded to the nearest with its number of bits", "[slant]") {
    CHECK(bsp::nearest_normal({0, 0, 0}) == Vec3i{});
    CHECK(bsp::nearest_normal({0, -7e5, 0}) == Vec3i{0, -1, 0});
    CHECK(bsp::nearest_normal({-4e9, 4e9, 2e9}) == Vec3i{-2, 2, 1});
    CHECK(bsp::nearest_normal({62, 61, -63}) == Vec3i{62, 61, -63});
    test::Draw draw{3};
    for (int i = 0; i < 2000; ++i) {
        const glm::dvec3 d(draw.between(-1000, 1000), draw.between(-1000, 1000), draw.between(1, 1000));
        const Vec3i n = bsp::nearest_normal(d);
        for (const int x : n) REQUIRE(std::abs(x) < 1 << (normal_step_bits - 1));
        const glm::dvec3 m(n[0], n[1], n[2]);
        REQUIRE(glm::dot(m, d) > 0);
        // sqrt 2 / 2 / 63
        REQUIRE(glm::length(glm::cross(m, d)) <= glm::length(m) * glm::length(d) * 0.0113);
    }
}

TEST_CASE("halves of a solid have their surfaces", "[slant]") {
    bsp::Solid solid(LatticeBox{{0, 0, 0}, {2, 4, 6}});
    CHECK(solid.area() == Approx(88));
    const auto across = solid.halves({1, 0, 0}, 0.5);
    CHECK(across.lower == Approx(48 + 0.5 * 20));
    CHECK(across.upper == Approx(48 + 1.5 * 20));
    const double lid = std::sqrt(8.) * 6;   // x + y = 2
    const auto slanted = solid.halves({1, 1, 0}, 2);
    CHECK(slanted.lower == Approx(4 + 24 + lid));
    CHECK(slanted.upper == Approx(88 - 28 + lid));
    solid.cut({1, 1, 0}, 2, false);
    CHECK(solid.area() == Approx(28 + lid));
    solid.cut({0, 0, 1}, 3, true);
    CHECK(solid.area() == Approx((28 + lid - 4) / 2 + 4));
}

TEST_CASE("an image of planes in any direction holds every primitive in its cells", "[slant][long]") {
    check_scenes(8, Straddlers::leaves);
    check_scenes(2, Straddlers::stop);
}

TEST_CASE("an image of planes in any direction holds every primitive, other widths", "[slant][slow]") {
    check_scenes(8, Straddlers::stop);
    check_scenes(4, Straddlers::leaves);
    check_scenes(4, Straddlers::stop);
    check_scenes(2, Straddlers::leaves);
}

TEST_CASE("tangled triangles are in every leaf that they reach into", "[slant]") {
    for (unsigned seed = 1; seed <= 30; ++seed)
        for (const int bits : {12, 20}) {
            INFO(seed << " " << bits);
            Config config = bsp_of(seed % 2 ? 8 : 2);
            config.coord_bits = bits;
            CHECK(complaints(tangle(seed, 40, (1 << (seed % 2 ? bits - 1 : 4)) - 1), config) == none);
        }
}

TEST_CASE("some planes of real scenes lie across no axis", "[slant]") {
    const Config config = bsp_of();
    const std::vector<PrimData> prims = test::prims_of("balls:1", config, Primitives::triangles);
    const MemoryImage image = compile_triangles(prims, config, "balls");
    int planes = 0, oblique = 0;
    const std::function<void(std::uint32_t)> count = [&](std::uint32_t line) {
        const WideSlant slant = widen(unpack<Slant>(image.line(line), config), config.node_width);
        for (const Vec3i& n : slant.normal) {
            const int there = (n[0] != 0) + (n[1] != 0) + (n[2] != 0);
            planes += there > 0, oblique += there > 1;
        }
        for (std::uint32_t i = 0; i < slant.exits.children; ++i)
            if (slant.exits.inner_mask >> i & 1) count(slant.exits.base + slant.exits.offset[i] / 2u);
    };
    count(0);
    CAPTURE(planes, oblique);
    CHECK(oblique > planes / 10);
    CHECK(oblique < planes);
}

TEST_CASE("a scene that no plane divides becomes a leaf", "[slant]") {
    const Straddlers rule = GENERATE(Straddlers::leaves, Straddlers::stop);
    const Config config = bsp_of(8, rule);
    std::vector<PrimData> same, flat;
    for (std::uint32_t i = 0; i < 300; ++i) {
        same.push_back(triangle({-50, 3, 9}, {40, 80, -7}, {12, -33, 21}, i));
        const int x = int(i % 17) * 9, y = int(i / 17) * 7;
        flat.push_back(triangle({x, y, x + y}, {x + 9, y, x + 9 + y}, {x, y + 7, x + y + 7}, i));
    }
    const MemoryImage image = compile_triangles(same, config, "the same");
    CHECK(check_slants(image, same, config) == none);
    CHECK(image.report.references == same.size());
    CHECK(complaints(flat, config) == none);
    CHECK(complaints({same[0]}, config) == none);
}

TEST_CASE("an image of planes in any direction holds spheres, planes and the sheared test's margin",
          "[slant]") {
    Config config = bsp_of();
    config.shading = config.spheres = config.planes = config.refraction = config.smooth = 1;
    for (const char* name : {"spheres", "balls:1", "plane"})
        CHECK(complaints(test::prims_of(name, config, Primitives::native), config) == none);
    Config sheared = bsp_of();
    sheared.coord_bits = 16, sheared.dir_bits = 20, sheared.primitive_test = PrimitiveTest::sheared;
    CHECK(complaints(test::prims_of("gears:1", sheared, Primitives::triangles), sheared) == none);
}

TEST_CASE("a damaged image of planes in any direction is noticed", "[slant]") {
    const Config config = bsp_of();
    const std::vector<PrimData> prims = test::prims_of("balls:1", config, Primitives::triangles);
    const MemoryImage sound = compile_triangles(prims, config, "balls");
    const auto changed = [&](auto change) {
        MemoryImage image = sound;
        auto slant = unpack<Slant>(image.line(0), config);
        change(slant, image);
        Words words = pack(slant, config);
        std::copy(words.begin(), words.end(), image.words.begin());
        return check_slants(image, prims, config).size();
    };
    CHECK(changed([](Slant&, MemoryImage&) {}) == 0);
    CHECK(changed([](Slant& slant, MemoryImage&) { ++slant.lo[0]; }) > 0);
    // One side may be empty, and loses nothing when the other one shrinks.
    CHECK(changed([](Slant& slant, MemoryImage&) { slant.at[0] += 20000; }) +
              changed([](Slant& slant, MemoryImage&) { slant.at[0] -= 20000; }) >
          0);
    CHECK(changed([](Slant& slant, MemoryImage&) { slant.normal[0] = -slant.normal[0] - 1; }) > 0);
    CHECK(changed([](Slant& slant, MemoryImage&) { slant.base = 0; }) > 0);
    CHECK(changed([](Slant& slant, MemoryImage&) { slant.base = 0xffffff; }) > 0);
    CHECK(changed([](Slant&, MemoryImage& image) { ++image.report.nodes; }) > 0);
}

TEST_CASE("a slant fits its line with every configuration", "[slant]") {
    Config config = bsp_of();
    CHECK(bits_of<Slant>(config) < line_bits);
    config.coord_bits = 20;
    CHECK(bits_of<Slant>(config) == line_bits);
}

// Memory images: valid for every scene and format, equal for every number of threads, and refused scenes.
#include <catch2/catch.hpp>

#include <tbb/global_control.h>

#include "tests/support/check/image_check.hpp"
#include "model/engine/check.hpp"
#include "model/compile/emit.hpp"
#include "model/compile/compile.hpp"
#include "model/engine/bvh/encode.hpp"
#include "model/base/error.hpp"
#include "tests/support/scenes/hard_meshes.hpp"

using namespace rayclock;

namespace {

const glm::dvec3 eye{2, 3, 9};

Config shape(int bits, int width, int leaf) {
    Config config;
    config.coord_bits = bits;
    config.dir_bits = 62 - 2 * bits > 20 ? 20 : 62 - 2 * bits;
    config.node_width = width;
    config.leaf_size = leaf;
    config.stack_depth = 64;
    check_config(config, "test");
    return config;
}

std::string all_of(const std::vector<std::string>& complaints) {
    std::string text;
    for (const std::string& c : complaints) text += c + "\n";
    return text;
}

std::string error_of(const Scene& scene, const Config& config) {
    try {
        compile_scene(scene, eye, config);
    } catch (const UserError& e) {
        return e.what();
    }
    return "";
}

}   // namespace

TEST_CASE("a compiled image holds every primitive and passes the validator") {
    const int bits = GENERATE(12, 16, 18, 20), width = GENERATE(2, 4, 8), leaf = GENERATE(1, 2, 4, 6);
    const Config config = shape(bits, width, leaf);
    for (const Scene& scene :
         {soup(1, 0.5, 1), soup(2, 0.5, 2), soup(9, 0.5, 3), soup(1000, 0.1, 4), soup(300, 3, 5), sheet(20),
          single(), coincident(1000), needles(400, 6), extremes(), vanishing(60)}) {
        const MemoryImage image = compile_scene(scene, eye, config);
        INFO(scene.name << " of " << scene.triangles.size() << ", " << bits << " bits, width " << width
                        << ", leaf " << leaf);
        CHECK(all_of(check_image(image, config, &scene)) == "");
        std::uint64_t found = 0;
        bvh::for_each_primitive(image, config, [&](const PrimData&) { ++found; });
        CHECK(found == image.report.triangles - image.report.collapsed);
        CHECK(image.report.pitch == image.lattice.pitch);
    }
}

TEST_CASE("one triangle is a root with one leaf") {
    const MemoryImage image = compile_scene(single(), eye, Config{});
    CHECK(image.lines() == 2);
    const Node root = bvh::read_node(image, 0, Config{});
    CHECK(root.base == 1);
    CHECK(root.kind == std::array<std::uint32_t, max_width>{2});
    CHECK(read_primitive(image, 2, Config{}).prim == 0);
    CHECK(image.report.nodes == 1);
    CHECK(image.report.leaves == 1);
    CHECK(image.report.depth == 1);
    CHECK(image.report.stack_need == 0);
}

TEST_CASE("boxes are as tight as the format allows") {
    const Config config = shape(18, 8, 1);
    const std::array<bvh::NodeChild, 2> children{bvh::NodeChild{{{-5, 0, 7}, {250, 0, 300}}, 1},
                                                 bvh::NodeChild{{{-4, 0, 7}, {10, 0, 8}}, 2}};
    const Node node = bvh::encode_node(children, 77, config);
    CHECK(node.org == Vec3i{-5, 0, 7});
    CHECK(node.exp == std::array<std::uint32_t, 3>{0, 0, 1});
    CHECK(node.base == 77);
    CHECK(node.kind == std::array<std::uint32_t, max_width>{2, 3});
    CHECK(std::vector<std::uint32_t>(node.lo.begin(), node.lo.begin() + 6) ==
          std::vector<std::uint32_t>{0, 0, 0, 1, 0, 0});
    CHECK(std::vector<std::uint32_t>(node.hi.begin(), node.hi.begin() + 6) ==
          std::vector<std::uint32_t>{255, 0, 147, 15, 0, 1});
    const std::array<bvh::NodeChild, 1> wider{bvh::NodeChild{{{0, 0, 0}, {256, 510, 511}}, 1}};
    CHECK(bvh::encode_node(wider, 0, config).exp == std::array<std::uint32_t, 3>{1, 1, 2});
}

TEST_CASE("an image has the same bytes for every number of threads") {
    const Scene scene = soup(30000, 0.02, 11);
    for (const int leaf : {1, 4}) {
        const Config config = shape(18, 8, leaf);
        const MemoryImage image = compile_scene(scene, eye, config);
        for (const std::size_t threads : {1, 2, 3, 8}) {
            tbb::global_control limit{tbb::global_control::max_allowed_parallelism, threads};
            CHECK(compile_scene(scene, eye, config).words == image.words);
        }
    }
}

TEST_CASE("triangles without area on the lattice are left out and counted") {
    const Config config = shape(12, 8, 1);
    Scene scene = soup(50, 0.5, 12);
    add(scene, {0, 0, 0}, {1, 0, 0}, {0.3, 0, 0});       // collinear
    add(scene, {0, 0, 0}, {1e-6, 0, 0}, {0, 1e-6, 0});   // smaller than a step
    add(scene, {0, 0, 0}, {0, 0, 0}, {1, 0, 0});         // two equal corners
    add(scene, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    const MemoryImage image = compile_scene(scene, eye, config);
    CHECK(image.report.triangles == 54);
    CHECK(image.report.collapsed == 3);
    CHECK(all_of(check_image(image, config, &scene)) == "");
}

TEST_CASE("what cannot be compiled is refused in one sentence") {
    Scene dust = named("dust");
    for (int i = 0; i < 3; ++i) add(dust, {0, 0, 0}, {1e-6, 0, 0}, {0, 1e-6, 0});
    CHECK_THAT(error_of(dust, shape(12, 8, 1)),
               Catch::Contains("dust: all 3 triangles vanish on a lattice of 12 bits"));

    Scene nothing = named("nothing");   // no area as given, so no lattice can help
    add(nothing, {0, 0, 0}, {1, 2, 3}, {1, 2, 3});
    for (const int levels : {1, 2}) {
        Config config = shape(12, 8, 1);
        config.levels = levels;
        CHECK_THAT(error_of(nothing, config), Catch::Contains("nothing: every surface is invisible"));
    }

    Config shallow = shape(18, 2, 1);
    shallow.stack_depth = 2;
    CHECK_THAT(error_of(soup(1000, 0.1, 4), shallow),
               Catch::Contains("soup: ") && Catch::Contains("--set stack_depth=16"));
    CHECK(error_of(soup(1000, 0.1, 4), shape(18, 2, 1)) == "");

    CHECK_NOTHROW(check_lines(1 << 24, Config{}, "vast"));
    CHECK_THROWS_WITH(check_lines((1 << 24) + 1, Config{}, "vast"),
                      Catch::StartsWith("vast: ") && Catch::Contains("2^24 lines"));
}

TEST_CASE("progress reaches its end") {
    std::uint64_t last = 0, of = 0;
    compile_scene(single(), eye, Config{}, [&](std::string_view, std::uint64_t done, std::uint64_t total) {
        CHECK(done >= last);
        last = done;
        of = total;
    });
    CHECK(of > 0);
    CHECK(last == of);
}

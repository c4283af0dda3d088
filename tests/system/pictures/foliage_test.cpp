// Light that passes through the holes of leaves: the judge accepts every ray and colour, and every pixel that
// differs from the reference has a cause.
#include <catch2/catch.hpp>

#include "sim/judge/reference/holes.hpp"
#include "sim/load/load.hpp"
#include "tests/support/machine/textured_pictures.hpp"
#include "tests/support/scenes/foliage.hpp"

namespace rayclock::test::foliage_test {

using namespace rayclock;
using namespace rayclock::test;

TEST_CASE("light passes through the holes of leaves in every structure", "[textures][hole][foliage]") {
    std::vector<Structure> structures = tree_structures();
    structures.push_back(Structure::none);
    const Structure structure = GENERATE_REF(from_range(structures));
    for (unsigned seed = 1; seed <= 3; ++seed) {
        INFO(name_of(structure) << ", seed " << seed);
        Foliage foliage(seed);
        const Scene scene = load_scene(foliage.file(12, seed != 2, false));
        const Whitted settings{.depth = 1};
        check_picture(scene, {40, 30}, settings,
                      fitted_chip(scene, settings, 1, seed == 3 ? TexelFormat::rgb565 : TexelFormat::rgb888,
                                  structure));
    }
}

TEST_CASE("light passes through the holes of leaves that are instances",
          "[textures][hole][foliage][levels]") {
    const Structure structure = GENERATE(Structure::bvh, Structure::kd);
    for (unsigned seed = 1; seed <= 4; ++seed) {
        INFO(name_of(structure) << ", seed " << seed);
        Foliage foliage(seed);
        const Scene scene = load_scene(foliage.file(14, false, true));
        const Whitted settings{.depth = 2, .aa = seed == 4 ? 2 : 1};
        check_picture(scene, {40, 30}, settings,
                      fitted_chip(scene, settings, 2, seed == 3 ? TexelFormat::rgb565 : TexelFormat::rgb888,
                                  structure));
    }
}

TEST_CASE("light passes through the holes of random leaves", "[textures][hole][foliage][slow]") {
    for (unsigned seed = 100; seed < 400; ++seed) {
        INFO("seed " << seed);
        Foliage foliage(seed);
        const bool has_levels = seed % 2 != 0;
        const Scene scene = load_scene(foliage.file(4 + int(seed % 20), !has_levels, has_levels));
        const Whitted settings{.depth = 1};
        check_picture(scene, {40, 30}, settings,
                      fitted_chip(scene, settings, has_levels ? 2 : 1,
                                  seed % 3 == 0 ? TexelFormat::rgb565 : TexelFormat::rgb888));
    }
}

TEST_CASE("a row of leaves hides the light only after 63 holes", "[textures][hole][foliage]") {
    const SceneFolder folder;
    folder.write("hole.png", SmallPng(1, 1, {{{255, 255, 255, 0}}}).bytes());
    const int leaves = GENERATE(1, 63, 64);
    std::ostringstream out;
    out << R"({"camera": {"eye": [0, 4, 0.1], "at": [0, 0, 0], "fov_degrees": 8},
        "lights": [{"position": [0, 0.5, 8], "colour": [1, 1, 1]}],
        "materials": {"floor": {"colour": [1, 1, 1], "ambient": 0},
                      "hole": {"colour": [1, 1, 1], "texture": "hole.png", "cutoff": 0.5}},
        "meshes": {"leaf": {"vertices": [[-1, -1, 0], [1, -1, 0], [0, 2, 0]], "triangles": [[0, 1, 2]],
                            "coordinates": [[[0, 0], [1, 0], [0, 1]]]},
                   "floor": {"vertices": [[-9, 0, -9], [9, 0, -9], [9, 0, 9], [-9, 0, 9]],
                             "triangles": [[0, 2, 1], [0, 3, 2]]}},
        "objects": [{"mesh": "floor", "material": "floor"}, {"mesh": "leaf", "material": "hole", "instances": [)";
    for (int i = 0; i < leaves; ++i)
        out << (i > 0 ? ", " : "") << R"({"translate": [0, 0, )" << 1 + 0.1 * i << "]}";
    out << "]}]}";
    const Scene scene = load_scene(folder.write("row.json", out.str()));
    const Whitted settings{.depth = 0};
    for (const int levels : {1, 2}) {
        INFO(leaves << " leaves, levels " << levels);
        const Config config = fitted_chip(scene, settings, levels, TexelFormat::rgb888);
        const FrameSize size{8, 6};
        const Trace trace = check_picture(scene, size, settings, config);
        const std::size_t middle = std::size_t(size.width * (size.height / 2) + size.width / 2);
        CHECK((trace.colours[middle][0] > 0) == (leaves < 64));
        CHECK(trace.counts.shadow >= std::uint64_t(std::min(leaves + 1, 64) * size.width * size.height / 2));
    }
}

TEST_CASE("a hole between a light and a point does not hide the light", "[textures][hole][reference]") {
    // The square's upper half is a hole, its lower half is not.
    Scene scene;
    scene.vertices = {{-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}};
    Triangle first, second;
    first.vertex = {0, 1, 2}, second.vertex = {0, 2, 3};
    scene.triangles = {first, second};
    scene.coordinates = {{glm::dvec2(0, 1), glm::dvec2(1, 1), glm::dvec2(1, 0)},
                         {glm::dvec2(0, 1), glm::dvec2(1, 0), glm::dvec2(0, 0)}};
    Texture texture;
    TexelLevel picture;
    picture.width = 1, picture.height = 2;
    picture.texels = {{255, 255, 255, 0}, {255, 255, 255, 255}};
    texture.pyramid = std::make_shared<const Pyramid>(make_pyramid(picture));
    texture.nearest = true;
    texture.wrap_s = texture.wrap_t = Wrap::clamp;
    scene.textures = {texture};
    Material material;
    material.texture = 0, material.cutoff = 0.5;
    scene.materials = {material};
    const Reference reference(scene);
    const RefGeometry& geometry = reference.geometry();
    const auto hidden = [&](double y, double distance) {
        RefPath path;
        path.from = geometry.space()(glm::dvec3(0, y, 0));
        return hidden_at(geometry, scene, path, distance * geometry.space().scale, 0.001);
    };
    CHECK(hidden(-0.5, 2).surely);
    CHECK_FALSE(hidden(0.5, 2).possibly);
    CHECK_FALSE(hidden(-0.5, 0.5).possibly);   // the square lies behind the light
    scene.materials[0].cutoff = 0;
    CHECK(hidden(0.5, 2).surely);
}

}   // namespace rayclock::test::foliage_test

// Light that passes through the holes of leaves: the judge accepts every ray and colour, and every pixel that
// differs from the reference has a cause.
#include <catch2/catch.hpp>

#include "model/engine/check.hpp"
#include "model/machine/machine.hpp"
#include "sim/judge/cause/finished.hpp"
#include "sim/judge/reference/holes.hpp"
#include "sim/load/load.hpp"
#include "tests/support/machine/frames.hpp"
#include "tests/support/scenes/foliage.hpp"

namespace rayclock::test::foliage_test {

using namespace rayclock;
using namespace rayclock::test;

namespace {

Config fitted(const Scene& scene, const Whitted& settings, const std::string& structure, int levels,
              TexelFormat texels) {
    Config c = named_config("default");
    set_parameter(c, "structure", structure, "test");
    c.levels = levels, c.texels = texels, c.stack_depth = 64;
    c = fitted_config(scene, settings, c);
    check_config(c, "test");
    return c;
}

/// Judges a picture of the model, and replays it. Returns its trace.
Trace check_picture(const Scene& scene, FrameSize size, const Whitted& settings, const Config& config) {
    REQUIRE(config.has_textures());
    const Job job = make_job(scene, *scene.camera, size, config, {}, settings);
    RecordedFrame made = record_frame(job, job.frame);
    const WhittedFrame reference = Reference(scene).whitted(*scene.camera, size, settings);
    const MachineOutput given{made.trace.hits, made.trace.colours, made.trace.signatures};
    const Judgement j =
        judge_finished({scene, *scene.camera, made.frame, job.image.lattice, job.config}, job.image, settings,
                       {reference, picture_from_colours(size, made.trace.colours), given},
                       scaled(job, job.frame, made.trace.hits));
    for (const PictureFault& f : j.faults) FAIL_CHECK("pixel (" << f.x << ", " << f.y << "): " << f.what);
    CHECK(j.wrong == 0);
    CHECK(j.bugs() == 0);
    CHECK(j.colours == std::uint64_t(size.width * size.height));
    CHECK(j.rays.shadow > std::uint64_t(size.width * size.height / 3));
    std::vector<RecordedFrame> frames;
    frames.push_back(std::move(made));
    Machine machine(job.config, job.khz, {});
    prepare_frame(machine, 0, std::span(std::as_const(frames)));
    machine.start(frames[0].frame, frames[0].trace);
    std::uint64_t cycles = 0;
    while (!machine.done() && ++cycles < 4'000'000) machine.step();
    CHECK(machine.done());
    return std::move(frames[0].trace);
}

}   // namespace

TEST_CASE("light passes through the holes of leaves in every structure", "[textures][hole][foliage]") {
    const std::string structure = GENERATE("bvh", "kd", "bsp", "octree", "bih", "spheres", "none");
    for (unsigned seed = 1; seed <= 3; ++seed) {
        INFO(structure << ", seed " << seed);
        Foliage foliage(seed);
        const Scene scene = load_scene(foliage.file(12, seed != 2, false));
        const Whitted settings{.depth = 1};
        check_picture(
            scene, {40, 30}, settings,
            fitted(scene, settings, structure, 1, seed == 3 ? TexelFormat::rgb565 : TexelFormat::rgb888));
    }
}

TEST_CASE("light passes through the holes of leaves that are instances",
          "[textures][hole][foliage][levels]") {
    const std::string structure = GENERATE("bvh", "kd");
    for (unsigned seed = 1; seed <= 4; ++seed) {
        INFO(structure << ", seed " << seed);
        Foliage foliage(seed);
        const Scene scene = load_scene(foliage.file(14, false, true));
        const Whitted settings{.depth = 2, .aa = seed == 4 ? 2 : 1};
        check_picture(
            scene, {40, 30}, settings,
            fitted(scene, settings, structure, 2, seed == 3 ? TexelFormat::rgb565 : TexelFormat::rgb888));
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
                      fitted(scene, settings, "bvh", has_levels ? 2 : 1,
                             seed % 3 == 0 ? TexelFormat::rgb565 : TexelFormat::rgb888));
    }
}

TEST_CASE("a row of leaves hides the light only after 63 holes", "[textures][hole][foliage]") {
    const Folder folder;
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
        const Config config = fitted(scene, settings, "bvh", levels, TexelFormat::rgb888);
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
        return hidden_at(geometry, scene, path, distance * geometry.space().scale);
    };
    CHECK(hidden(-0.5, 2).surely);
    CHECK_FALSE(hidden(0.5, 2).possibly);
    CHECK_FALSE(hidden(-0.5, 0.5).possibly);   // the square lies behind the light
    scene.materials[0].cutoff = 0;
    CHECK(hidden(0.5, 2).surely);
}

}   // namespace rayclock::test::foliage_test

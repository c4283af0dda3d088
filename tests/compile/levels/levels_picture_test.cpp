// Compares finished pictures of instances with the reference, and with the same scene in one level.
#include <cmath>

#include <catch2/catch.hpp>

#include "sim/judge/reference/reference.hpp"
#include "model/compile/compile.hpp"
#include "model/compile/frame.hpp"
#include "model/compile/surfaces.hpp"
#include "model/engine/check.hpp"
#include "model/scene/hit_shading.hpp"
#include "model/trace/trace.hpp"
#include "tests/support/levels/finished_instances.hpp"
#include "tests/support/levels/closed_instances.hpp"

using namespace rayclock;

namespace {

struct Drawn {
    Trace trace;
    Picture picture;
};

Drawn drawn(const Scene& scene, FrameSize size, const Whitted& settings, Config config, int levels) {
    config = fitted_config(scene, settings, config);
    config.levels = levels;
    check_config(config, "the test");
    const MemoryImage image = compile_scene(scene, scene.camera->eye, config);
    Frame frame = make_frame(*scene.camera, size, image, config);
    frame.shade = make_shade_frame(scene, settings, image, frame.height, config);
    Drawn made{record_trace(image, frame, config, 1), {size, {}}};
    for (const auto& c : made.trace.colours)
        made.picture.pixels.push_back(glm::vec3(c[0], c[1], c[2]) / 65536.0f);
    return made;
}

double psnr(const Picture& picture, const std::vector<glm::dvec3>& reference) {
    double sum = 0;
    const auto level = [](double x) { return 255 * std::pow(std::clamp(x, 0.0, 1.0), 1 / 2.2); };
    for (std::size_t i = 0; i < reference.size(); ++i)
        for (int k = 0; k < 3; ++k) {
            const double d = level(double(picture.pixels[i][k])) - level(reference[i][k]);
            sum += d * d;
        }
    return 10 * std::log10(255.0 * 255 * 3 * double(reference.size()) / sum);
}

}   // namespace

TEST_CASE("finished pictures of instances are the reference's", "[levels][secondary]") {
    const bool is_smooth = GENERATE(false, true);
    const auto [coord_bits, dir_bits] = GENERATE(values<std::pair<int, int>>({{18, 20}, {20, 18}, {16, 20}}));
    CAPTURE(is_smooth, coord_bits, dir_bits);
    const Scene scene = flattened(mixed(is_smooth));
    constexpr FrameSize size{64, 48};
    Whitted settings;
    settings.depth = 4;
    const Config config = format(coord_bits, dir_bits);
    const WhittedFrame right = Reference(scene).whitted(*scene.camera, size, settings, 1);
    const Drawn two = drawn(scene, size, settings, config, 2), one = drawn(scene, size, settings, config, 1);
    const double with_two = psnr(two.picture, right.pixels), with_one = psnr(one.picture, right.pixels);
    CAPTURE(with_two, with_one, two.trace.counts.all(), one.trace.counts.all());
    CHECK(with_two >= 45);
    // The rays are nearly the same as in a flat scene.
    CHECK(std::abs(double(two.trace.counts.all()) - double(one.trace.counts.all())) <=
          0.005 * double(one.trace.counts.all()));
    CHECK(two.trace.counts.reflection > 500);
    CHECK(two.trace.counts.refraction > 100);
}

TEST_CASE("planes and true spheres next to instances match the reference, in every structure",
          "[levels][secondary]") {
    const bool is_smooth = GENERATE(false, true);
    const Scene scene = flattened(mixed_with_round(is_smooth));
    constexpr FrameSize size{64, 48};
    Whitted settings;
    settings.depth = 4;
    const WhittedFrame right = Reference(scene).whitted(*scene.camera, size, settings, 1);
    std::vector<std::array<std::uint32_t, 3>> first;
    for (const Structure structure : tree_structures()) {
        const Drawn two = drawn(scene, size, settings, of_structure(format(18, 20), structure), 2);
        INFO(name_of(structure));
        const double with_two = psnr(two.picture, right.pixels);
        CAPTURE(with_two);
        CHECK(with_two >= 40);
        const auto& colours = two.trace.colours;
        if (first.empty()) first.assign(colours.begin(), colours.end());
        CHECK(std::equal(colours.begin(), colours.end(), first.begin(), first.end()));
        CHECK(two.trace.counts.reflection > 500);
        CHECK(two.trace.counts.refraction > 100);
    }
}

TEST_CASE("two levels draw a scene without instances as one level does, bit for bit", "[levels][secondary]") {
    const Structure structure = GENERATE(from_range(tree_structures()));
    const std::string name = GENERATE("spheres", "plane", "mirrors", "balls:1", "gears:1");
    CAPTURE(name, name_of(structure));
    const Scene scene = make_builtin(name, Primitives::native);
    constexpr FrameSize size{40, 30};
    Whitted settings;
    settings.depth = 3;
    const Config config = of_structure(format(18, 20), structure);
    const Drawn two = drawn(scene, size, settings, config, 2), one = drawn(scene, size, settings, config, 1);
    const std::vector<Closest>&a = two.trace.hits, &b = one.trace.hits;
    REQUIRE(a.size() == b.size());
    std::size_t wrong = 0, found = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        wrong += a[i].found != b[i].found || a[i].prim != b[i].prim || a[i].t != b[i].t ||
                 two.trace.colours[i] != one.trace.colours[i];
        found += a[i].found;
    }
    CHECK(wrong == 0);
    CHECK(found > 100);
    CHECK(two.trace.counts.all() == one.trace.counts.all());
}

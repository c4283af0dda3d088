// Traces of a shading chip come from a lean form of the walk, which must equal Walk and Shader ray by ray.
#include <catch2/catch.hpp>

#include "model/compile/compile.hpp"
#include "model/compile/frame.hpp"
#include "model/compile/surfaces.hpp"
#include "model/unit/raygen/raygen.hpp"
#include "model/engine/check.hpp"
#include "model/scene/builtin.hpp"
#include "model/unit/shade/shader.hpp"
#include "model/trace/record.hpp"
#include "model/trace/record_shaded.hpp"
#include "model/trace/trace.hpp"
#include "model/trace/walk.hpp"
#include "tests/support/machine/walked.hpp"

namespace rayclock::test::shaded_test {

using namespace rayclock;
using namespace rayclock::test;

namespace {

/// Appends a ray's words, and returns its answer.
Closest walked(Walk& walk, const Ray& ray, std::vector<std::uint32_t>& words) {
    walk.start_at(ray);
    append_walk(walk, words);
    return walk.closest();
}

bool same(const Closest& a, const Closest& b) {
    return a.found == b.found && a.prim == b.prim && a.t == b.t && a.u == b.u && a.v == b.v &&
           a.back == b.back;
}

struct Picture {
    Config config;
    MemoryImage image;
    Frame frame;
};
Picture compiled_picture(const char* scene_name, const Whitted& settings,
                         std::initializer_list<std::pair<const char*, const char*>> values) {
    const Scene scene = make_builtin(scene_name, Primitives::native);
    Config config = fitted_config(scene, settings, named_config("default"));
    for (const auto& [key, value] : values) set_parameter(config, key, value, "test");
    check_config(config, "test");
    Picture p{config, compile_scene(scene, scene.camera->eye, config), {}};
    p.frame = make_frame(*scene.camera, {20, 14}, p.image.lattice, config);
    p.frame.shade = make_shade_frame(scene, settings, p.image, p.frame.height, config);
    return p;
}

/// Compares all pixels with Walk and Shader, and every ray also with `record`.
void require_recorded_as_walked(const Picture& p, RecordRayFunction* record, const Trace& trace) {
    const Decoder decoder(p.image, p.config);
    Walk walk(p.frame, p.config, decoder);
    Shader shader(p.frame, p.config, p.image);
    RecordScratch scratch(p.config);
    RecordTotals totals;
    std::uint64_t kinds[4]{};
    for (std::uint32_t y = 0; y < p.frame.height; ++y)
        for (std::uint32_t x = 0; x < p.frame.width; ++x) {
            std::vector<std::uint32_t> pixel;
            shader.start({0, x, y});
            Spawn spawn = first_spawn({0, x, y});
            do {
                const Ray ray = spawn_ray(spawn, p.frame, p.config);
                ++kinds[std::size_t(ray.kind)];
                shader.sent(ray);
                std::vector<std::uint32_t> words;
                const Closest hit = walked(walk, ray, words);
                Closest recorded;
                const std::size_t end =
                    record(decoder, p.config, p.frame.root, ray, 0, scratch, totals, recorded);
                INFO("pixel " << x << " " << y << ", ray of kind " << int(ray.kind));
                REQUIRE(std::vector<std::uint32_t>(scratch.words.begin(),
                                                   scratch.words.begin() + std::ptrdiff_t(end)) == words);
                REQUIRE(same(recorded, hit));
                pixel.insert(pixel.end(), words.begin(), words.end());
                shader.arrived(hit);
                const std::uint32_t line =
                    shader.wants_surface() ? shader.surface_line() | EndWord::line_flag : 0;
                const int passes = shader.run();
                pixel.push_back(line | (shader.is_finished() ? EndWord::pixel_flag : purpose_word(shader)));
                pixel.push_back(std::uint32_t(passes));
                spawn = shader.spawn();
            } while (!shader.is_finished());
            const std::size_t at = std::size_t(y) * p.frame.width + x;
            REQUIRE(std::equal(pixel.begin(), pixel.end(), trace.rays[at]));
            REQUIRE(trace.colours[at] == shader.pixel().colour);
            REQUIRE(same(trace.hits[at], shader.pixel().first));
        }
    REQUIRE((trace.counts == shader.counts() && trace.visits == totals.visits &&
             trace.triangle_tests == totals.triangle_tests));
    REQUIRE((trace.box_tests == totals.box_tests && trace.dropped_groups == totals.dropped_groups));
    CHECK(kinds[0] > 0);
}

}   // namespace

TEST_CASE("all rays of a chip that shades are recorded as they are walked", "[trace][shading]") {
    const Whitted deep{.depth = 6}, fine{.depth = 2, .aa = 3, .jitter = true, .contrast = 0.1};
    const Picture pictures[] = {
        compiled_picture("spheres", deep, {}),
        compiled_picture("balls:3", deep, {{"node_width", "2"}, {"stack_depth", "64"}}),
        compiled_picture("gears:1", deep, {{"leaf_size", "6"}}),
        compiled_picture("mount:4", fine, {{"node_width", "4"}, {"leaf_size", "3"}, {"stack_depth", "64"}}),
        compiled_picture("teapot:4", deep, {{"coord_bits", "14"}, {"dir_bits", "16"}}),
        compiled_picture("mirrors", fine, {{"box_bits", "5"}}),
    };
    for (const Picture& p : pictures) {
        const Trace trace = record_trace(p.image, p.frame, p.config, 2);
        for (RecordRayFunction* record : {record_any(), static_cast<RecordRayFunction*>(record_any_plain)})
            require_recorded_as_walked(p, record, trace);
    }
}

}   // namespace rayclock::test::shaded_test

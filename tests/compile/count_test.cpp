// Counts visits and tests of the machine's walk, and compares its hits with a search through all triangles.
#include <catch2/catch.hpp>

#include "model/compile/compile.hpp"
#include "model/compile/frame.hpp"
#include "model/engine/bvh/decode.hpp"
#include "model/unit/tri/tri.hpp"
#include "model/unit/raygen/raygen.hpp"
#include "model/scene/builtin.hpp"
#include "model/trace/walk.hpp"
#include "tests/support/scenes/hard_meshes.hpp"

using namespace rayclock;

namespace {

struct Walked {
    std::uint64_t rays = 0, hits = 0, visits = 0, tests = 0;
    int stack = 0;   ///< largest number of groups that a ray kept
};

/// Walks every `step`-th pixel across and down like the machine.
Walked walked(const MemoryImage& image, const Frame& frame, const Config& config, std::uint32_t step = 1) {
    const Decoder decoder(image, config);
    Walk walk(frame, config, decoder);
    Walked all;
    for (std::uint32_t y = step / 2; y < frame.height; y += step)
        for (std::uint32_t x = step / 2; x < frame.width; x += step, ++all.rays) {
            walk.start({0, x, y});
            for (bool done = false; !done; walk.decide(done), ++all.visits) {
                all.stack = std::max(all.stack, walk.stack_height());
                for (bool left = walk.visit_node(); left; left = walk.advance(), ++all.tests)
                    walk.test_triangle();
            }
            all.hits += walk.closest().found;
        }
    return all;
}

}   // namespace

TEST_CASE("the walk finds what a search through all triangles finds") {
    const Scene scene = GENERATE(soup(300, 0.4, 31), needles(200, 32), sheet(8));
    Config config;
    config.node_width = GENERATE(2, 8);
    config.leaf_size = GENERATE(1, 4);
    const Camera camera = fit_camera(scene, 1);
    const MemoryImage image = compile_scene(scene, camera.eye, config);
    const Frame frame = make_frame(camera, {32, 32}, image.lattice, config);
    const Walked count = walked(image, frame, config);
    std::vector<PrimData> triangles;
    bvh::for_each_primitive(image, config, [&](const PrimData& t) { triangles.push_back(t); });
    std::uint64_t hits = 0;
    for (std::uint32_t i = 0; i < 32 * 32; ++i) {
        const Ray ray = raygen({0, i % 32, i / 32}, frame, config);
        TriRsp rsp;
        bool hit = false;
        for (const PrimData& t : triangles) {
            tri_test(ray.o, ray.d, t, {}, config, rsp);
            hit = hit || rsp.closer;
        }
        hits += hit;
    }
    CHECK(count.rays == 32 * 32);
    CHECK(count.hits == hits);
    CHECK(hits > 0);
    CHECK(count.visits >= count.rays);
    CHECK(count.tests < count.rays * triangles.size() / 4);
    CHECK(count.stack <= image.report.stack_need);
}

TEST_CASE("visits per camera ray stay within 5 % of the recorded counts") {
    // 512 x 384, every fourth pixel across and down, width 8, one triangle per leaf, with 5 % of tolerance.
    const auto [spec, visits, tests] = GENERATE(table<const char*, double, double>({{"gears:8", 4.58, 3.67},
                                                                                    {"balls:3", 3.74, 2.98},
                                                                                    {"rings:3", 8.13, 22.2},
                                                                                    {"mount:8", 4.23, 1.63},
                                                                                    {"tetra:8", 2.63, 1.01},
                                                                                    {"teapot:12", 3.14, 1.3},
                                                                                    {"tree:6", 2.12, 2.45}}));
    const Scene scene = make_builtin(spec);
    const Config config;
    const MemoryImage image = compile_scene(scene, scene.camera->eye, config);
    const Frame frame = make_frame(*scene.camera, {512, 384}, image.lattice, config);
    const Walked count = walked(image, frame, config, 4);
    INFO(spec);
    CHECK(double(count.visits) / double(count.rays) < 1.05 * visits);
    CHECK(double(count.tests) / double(count.rays) < 1.05 * tests);
    CHECK(count.stack <= image.report.stack_need);
}

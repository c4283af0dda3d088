#include <catch2/catch.hpp>

#include "model/accel/count.hpp"
#include "model/accel/decode.hpp"
#include "model/isect/tri.hpp"
#include "model/raygen/raygen.hpp"
#include "tests/accel/meshes.hpp"

using namespace rayclock;

TEST_CASE("the walk finds what a search through all triangles finds") {
    const Scene scene = GENERATE(soup(300, 0.4, 31), needles(200, 32), sheet(8));
    Config config;
    config.node_width = GENERATE(2, 8);
    config.leaf_size = GENERATE(1, 4);
    const Camera camera = fit_camera(scene, 1);
    const MemoryImage image = compile_scene(scene, camera.eye, config);
    const Frame frame = make_frame(camera, {32, 32}, image.lattice, config);
    const WorkCount count = count_work(image, frame, config);
    std::vector<PrimData> triangles;
    for_each_triangle(image, config, [&](const PrimData& t) { triangles.push_back(t); });
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
    CHECK(count.nodes >= count.rays);
    CHECK(count.triangles < count.rays * triangles.size() / 8);
    CHECK(count.stack <= std::size_t(image.report.stack_need));
}

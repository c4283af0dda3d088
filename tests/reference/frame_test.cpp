// Reference::frame(): the result does not depend on the number of threads, and each pixel equals trace().
// Also the hierarchy below it.
#include <algorithm>
#include <atomic>
#include <cstring>

#include <catch2/catch.hpp>
#include <tbb/task_arena.h>

#include "model/base/error.hpp"
#include "sim/judge/reference/hierarchy.hpp"
#include "sim/judge/reference/reference.hpp"
#include "tests/reference/meshes.hpp"

using namespace rayclock;

namespace {

const Camera camera{{0.5, -3, 1}, {0, 0, 0}, {0, 0, 1}, 45};

/// Returns the number of inner nodes on the longest path.
int depth_below(const RefHierarchy& hierarchy, std::uint32_t at) {
    int depth = 0;
    for (int i = 0; i < 4; ++i)
        if (hierarchy.nodes[at].blocks[i] == 0)
            depth = std::max(depth, depth_below(hierarchy, hierarchy.nodes[at].child[i]));
    return depth + 1;
}

}   // namespace

TEST_CASE("a frame does not depend on the number of threads", "[reference]") {
    MeshRng rng(3);
    const Scene scene = soup(rng, 20000, 0.05);
    const HitFrame one = Reference(scene).frame(camera, {150, 70}, 1);
    CHECK(one.hits.size() == 150 * 70);
    for (int threads : {2, 3, 0}) {
        CAPTURE(threads);
        CHECK(Reference(scene).frame(camera, {150, 70}, threads).hits == one.hits);
    }
}

TEST_CASE("the hierarchy does not depend on the number of threads that build it", "[reference]") {
    MeshRng rng(8);
    std::vector<RefBox> boxes(50000);
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
        const glm::dvec3 lo = random_point(rng), hi = lo + (random_point(rng) + 1.0) * 0.01;
        boxes[i] = {{static_cast<float>(lo.x), static_cast<float>(lo.y), static_cast<float>(lo.z)},
                    {static_cast<float>(hi.x), static_cast<float>(hi.y), static_cast<float>(hi.z)},
                    i};
    }
    std::vector<RefBox> copy = boxes;
    const RefHierarchy many = build_hierarchy(boxes);
    RefHierarchy one;
    tbb::task_arena(1).execute([&] { one = build_hierarchy(copy); });
    CHECK(one.order == many.order);
    REQUIRE(one.nodes.size() == many.nodes.size());
    CHECK(std::memcmp(one.nodes.data(), many.nodes.data(), one.nodes.size() * sizeof(RefNode)) == 0);
}

TEST_CASE("a hierarchy over coinciding and nested boxes holds them all and keeps to its depth",
          "[reference]") {
    // Each box is a tenth smaller than the previous one, so no cut by area halves them.
    std::vector<RefBox> boxes;
    for (std::uint32_t i = 0; i < 800; ++i) {
        const float side = std::pow(0.9f, static_cast<float>(i));
        boxes.push_back({{0, 0, 0}, {side, side, side}, i});
    }
    for (std::uint32_t i = 0; i < 5000; ++i) boxes.push_back({{0, 0, 0}, {1, 1, 1}, 800 + i});
    const std::size_t count = boxes.size();
    const RefHierarchy hierarchy = build_hierarchy(boxes);
    std::vector<bool> seen(count);
    for (const std::uint32_t primitive : hierarchy.order) seen[primitive] = true;
    CHECK(std::count(seen.begin(), seen.end(), true) == static_cast<std::ptrdiff_t>(count));
    CHECK(depth_below(hierarchy, 0) <= ref_max_depth);
}

TEST_CASE("a frame's pixels are the rays of the camera's definition, row by row", "[reference]") {
    const FrameSize size{37, 23};
    const Reference reference(sphere(3));
    const HitFrame frame = reference.frame(camera, size);
    const PixelRays rays = pixel_rays(camera, size);
    CHECK(frame.size == size);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
            REQUIRE(frame.hits[y * size.width + x] == reference.trace(rays.eye, rays.direction(x, y)));
    CHECK(frame.hits[11 * 37 + 18].primitive != no_primitive);
    CHECK(frame.hits[0].primitive == no_primitive);
}

TEST_CASE("one thread at a time reports progress, which grows and ends at the total", "[reference]") {
    std::atomic<int> inside = 0;
    std::uint64_t last = 0;
    bool alone = true, grows = true;
    const auto progress = [&](std::string_view, std::uint64_t done, std::uint64_t total) {
        alone = alone && ++inside == 1;
        grows = grows && done > last && total == 200 * 100;
        last = done;
        --inside;
    };
    Reference(sphere(3)).frame(camera, {200, 100}, 0, progress);
    CHECK(alone);
    CHECK(grows);
    CHECK(last == 200 * 100);
}

TEST_CASE("a frame of an impossible size is refused", "[reference]") {
    CHECK_THROWS_AS(Reference(sphere(0)).frame(camera, {0, 10}), UserError);
    CHECK_THROWS_AS(Reference(sphere(0)).frame(camera, {10, max_frame_side + 1}), UserError);
}

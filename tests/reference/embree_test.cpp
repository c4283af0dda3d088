// Embree 3.13 as a second opinion on the built-in scenes. It computes in single precision, so its rounding
// must explain every pixel where it disagrees.
#include <catch2/catch.hpp>

#include "sim/judge/reference/instances.hpp"
#include "sim/judge/reference/reference.hpp"
#include "model/scene/builtin.hpp"
#include "tests/reference/embree_judge.hpp"
#include "tests/support/scenes/embree_scene.hpp"

using namespace rayclock;

namespace {

const FrameSize size{256, 192};

struct Counts {
    int disputed = 0;      ///< another primitive, explained
    int unexplained = 0;   ///< another primitive, not explained
    int wrong_depth = 0;   ///< same primitive, depth beyond the bound
    int hits = 0;
};

/// `scene` is flat; `ours` and `theirs` use the numbers of its primitives.
template <class Ours, class Theirs>
Counts compare_with_embree(const Scene& scene, const Ours& ours_of, const Theirs& embree) {
    const Camera camera = scene.camera ? *scene.camera : fit_camera(scene, 256.0 / 192.0);
    const PixelRays rays = pixel_rays(camera, size);
    Counts counts;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const EmbreeJudge judge{scene, rays.eye, glm::normalize(rays.direction(x, y))};
            const Hit ours = ours_of.trace(judge.origin, judge.direction);
            const Hit theirs = embree.trace(judge.origin, judge.direction);
            counts.hits += ours.primitive != no_primitive;
            if (ours.primitive != theirs.primitive) {
                const bool explained = judge.explains(ours.primitive, theirs.primitive);
                ++(explained ? counts.disputed : counts.unexplained);
                if (!explained)
                    UNSCOPED_INFO("pixel " << x << ", " << y << ": " << ours.primitive << " at " << ours.depth
                                           << ", embree " << theirs.primitive << " at " << theirs.depth);
            } else if (ours.primitive != no_primitive) {
                const long double bound = judge.depth_error(ours.primitive);
                counts.wrong_depth += std::abs(static_cast<long double>(ours.depth) - theirs.depth) > bound;
            }
        }
    return counts;
}

void check(const std::string& spec, const Counts& counts) {
    WARN(spec << ": " << counts.hits << " of " << size.width * size.height << " pixels hit, "
              << counts.disputed << " disputed at edges or equal depth");
    CHECK(counts.unexplained == 0);
    CHECK(counts.wrong_depth == 0);
    CHECK(counts.hits > size.width * size.height / 20);
    // An explanation of many pixels would explain nothing: rounding is 1e-6, a pixel 1e-2 of the picture.
    CHECK(counts.disputed <= size.width * size.height / 500);
}

}   // namespace

TEST_CASE("Embree finds the same primitives, except for its rounding", "[reference][embree]") {
    const auto spec = GENERATE(as<std::string>{}, "tetra:6", "mount:6", "gears:2", "balls:2", "teapot:6",
                               "rings:2", "tree:4", "icosphere:4", "cornell");
    const Scene scene = make_builtin(spec);
    check(spec, compare_with_embree(scene, Reference(scene), EmbreeScene(scene, RTC_SCENE_FLAG_ROBUST)));
}

// Embree transforms origin and direction into an instance's space in single precision. The bound above has
// room for these few roundings.
TEST_CASE("Embree's instances are hit as ours are, except for its rounding", "[reference][embree][placed]") {
    const auto spec = GENERATE(as<std::string>{}, "gearbox:2", "flake:2", "boughs:4", "clockwork:4",
                               "crowd:3", "flight:20");
    PlacedScene placed = make_placed(spec);
    if (!placed.motion.empty()) pose(placed, 0.7);
    const Scene flat = flat_copy(placed);
    check(spec, compare_with_embree(flat, RefInstances(placed), EmbreeInstances(placed)));
}

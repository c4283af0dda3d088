// Coincident primitives: model and reference keep the one with the lowest number, so none counts as "another
// primitive".
#include <catch2/catch.hpp>

#include "model/compile/surfaces.hpp"
#include "sim/judge/reference/reference.hpp"
#include "sim/view/report/json.hpp"
#include "tests/support/cases/coincident.hpp"
#include "tests/support/machine/frames.hpp"

namespace rayclock::test::coincident_test {

using namespace rayclock;
using namespace rayclock::test;

namespace {

constexpr FrameSize size{96, 72};

HitFrame model_frame(const Scene& scene, const Whitted& settings) {
    Config config = scene.spheres.empty() && scene.planes.empty()
                        ? named_config("default")
                        : fitted_config(scene, settings, named_config("default"));
    config.stack_depth = 64;
    const Job job = make_job(scene, *scene.camera, size, config, {}, settings);
    return hits_of(job, record_frame(job, job.frame));
}

/// Returns the scene with every sphere and plane twice, the second time in reverse order.
Scene doubled(Scene scene) {
    const std::vector<Sphere> spheres = scene.spheres;
    const std::vector<Plane> planes = scene.planes;
    scene.spheres.insert(scene.spheres.end(), spheres.rbegin(), spheres.rend());
    scene.planes.insert(scene.planes.end(), planes.rbegin(), planes.rend());
    return scene;
}

std::uint64_t others(const Scene& scene, const HitFrame& model) {
    return frame_error(scene, model, Reference(scene).frame(*scene.camera, size)).pixels_other_primitive;
}

}   // namespace

TEST_CASE("triangles that are there three times, their corners turned, are no other primitives") {
    for (const char* name : {"gears:1", "teapot:4", "balls:1"}) {
        Scene plain = make_builtin(name);
        if (!plain.camera) plain.camera = fit_camera(plain, 4.0 / 3);
        std::vector<std::uint32_t> original;
        const Scene more = tripled(plain, 3, original);
        const HitFrame one = model_frame(plain, {}), three = model_frame(more, {});
        std::size_t wrong = 0;
        for (std::size_t i = 0; i < one.hits.size(); ++i) {
            const std::uint32_t a = one.hits[i].primitive, b = three.hits[i].primitive;
            wrong += a == no_primitive ? b != no_primitive
                                       : b == no_primitive || original[b] != a || lowest(original, b) != b;
        }
        INFO(name);
        CHECK(wrong == 0);
        CHECK(others(more, three) == others(plain, one));
    }
}

TEST_CASE("spheres and planes that are there twice are no other primitives") {
    for (const char* name : {"spheres", "balls:2", "plane"}) {
        Scene plain = make_builtin(name, Primitives::native);
        if (!plain.camera) plain.camera = fit_camera(plain, 4.0 / 3);
        const Scene more = doubled(plain);
        const HitFrame one = model_frame(plain, {0}), two = model_frame(more, {0});
        const std::size_t first_plane = plain.triangles.size() + plain.spheres.size();
        std::size_t wrong = 0;
        for (std::size_t i = 0; i < one.hits.size(); ++i) {
            // The first copies keep their numbers, but planes follow twice as many spheres.
            std::uint32_t a = one.hits[i].primitive;
            if (a != no_primitive && a >= first_plane) a += std::uint32_t(plain.spheres.size());
            wrong += two.hits[i].primitive != a;
        }
        INFO(name);
        CHECK(wrong == 0);
        CHECK(others(more, two) == others(plain, one));
    }
}

}   // namespace rayclock::test::coincident_test

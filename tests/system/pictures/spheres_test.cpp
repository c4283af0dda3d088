// Opaque, clear and mirror spheres, nested and adjacent, with eyes and lights on both sides. The model
// renders what the reference renders by its own rules, and the judge finds no fault.
#include <catch2/catch.hpp>

#include "model/compile/surfaces.hpp"
#include "sim/judge/reference/reference.hpp"
#include "sim/judge/paths/judge_picture.hpp"
#include "sim/view/report/json.hpp"
#include "tests/support/machine/frames.hpp"

namespace rayclock::test::spheres_test {

using namespace rayclock;
using namespace rayclock::test;

namespace {

enum Look : std::uint32_t { clay, glass, mirror, floor_tiles };

struct Ball {
    glm::dvec3 centre;
    double radius;
    Look look;
};

struct Setting {
    const char* what;
    glm::dvec3 eye, at;
    std::vector<glm::dvec3> lights;
    std::vector<Ball> balls;
    bool has_floor = false;   ///< infinite, at height -2
    bool is_dark = false;     ///< the floor has only its ambient light
};

const glm::dvec3 above{3, 6, 5};

const std::vector<Setting> settings{
    {"the eye inside an opaque sphere sees out",
     {0, 0, 0},
     {0, 0, -1},
     {{0, 3, 3}},
     {{{0, 0, 0}, 1, clay}, {{0, 0, -4}, 0.7, clay}}},
    {"the eye inside a mirror sees out",
     {0, 0, 0},
     {0, 0, -1},
     {above},
     {{{0, 0, 0}, 1, mirror}, {{0, 0, -4}, 1, mirror}, {{1, 1, -3}, 0.5, clay}},
     true},
    {"the eye inside glass sees its far side",
     {0, 0, 0},
     {0, 0, -1},
     {above},
     {{{0, 0, 0}, 1, glass}, {{0, 0, -4}, 1, clay}},
     true},
    {"an opaque sphere hides the light inside it, also from points beyond the lattice",
     {0, 3, 12},
     {0, 0, 0},
     {{0, 0, 0}},
     {{{0, 0, 0}, 1, clay}, {{3, 0, 0}, 1, mirror}},
     true,
     true},
    {"glass hides the light inside it as well",
     {0, 3, 12},
     {0, 0, 0},
     {{0, 0, 0}},
     {{{0, 0, 0}, 1, glass}, {{3, 0, 0}, 1, clay}},
     true},
    {"what an opaque sphere holds is lit from outside",
     {0, 1, 4},
     {0, 0, 0},
     {above},
     {{{0, 0, 0}, 6, clay}, {{0, 0, 0}, 1, clay}, {{2, 0, 0}, 0.5, glass}}},
    {"an opaque sphere inside glass",
     {0, 1, 8},
     {0, 0, 0},
     {above},
     {{{0, 0, 0}, 2, glass}, {{0, 0, 0}, 1, clay}},
     true},
    {"glass inside an opaque sphere is hidden",
     {0, 1, 8},
     {0, 0, 0},
     {above},
     {{{0, 0, 0}, 2, clay}, {{0, 0, 0}, 1, glass}},
     true},
    {"the eye in glass around an opaque sphere around a light",
     {0, 0, 3},
     {0, 0, 0},
     {{0, 0, 0}, above},
     {{{0, 0, 0}, 4, glass}, {{0, 0, 0}, 1, clay}, {{2, 0, 0}, 0.5, mirror}}},
    {"spheres that touch",
     {0, 1, 8},
     {0, 0, 0},
     {above},
     {{{-1, 0, 0}, 1, clay}, {{1, 0, 0}, 1, glass}, {{3, 0, 0}, 1, mirror}, {{0, -1, 0}, 1, clay}},
     true},
    {"an opaque sphere reaches into glass",
     {0, 1, 8},
     {0, 0, 0},
     {above},
     {{{-1, 0, 0}, 2, glass}, {{1, 0, 0}, 1.5, clay}},
     true},
    {"a mirror around half of everything",
     {0, 0, 8},
     {0, 0, 0},
     {above, {0, 1, 0}},
     {{{0, 0, 0}, 5, mirror}, {{0, 0, 4}, 2, glass}, {{2, 1, 5}, 0.5, clay}}},
};

Scene scene_of(const Setting& s) {
    Scene scene;
    scene.name = s.what;
    scene.materials.resize(4);
    for (Material& m : scene.materials) m.colour = {0.8, 0.7, 0.6}, m.ambient = 0.1, m.diffuse = 0.9;
    scene.materials[glass].diffuse = 0.2, scene.materials[glass].transmit = 0.8;
    scene.materials[glass].index = 1.25;
    scene.materials[mirror].diffuse = 0.3, scene.materials[mirror].mirror = 0.7;
    for (const Ball& b : s.balls) scene.spheres.push_back({b.centre, b.radius, b.look});
    if (s.has_floor) scene.planes.push_back({{0, -2, 0}, {1, 0, 0}, {0, 0, -1}, floor_tiles});
    for (const glm::dvec3& at : s.lights) scene.lights.push_back({at, {0.9, 0.9, 0.9}});
    Camera camera;
    camera.eye = s.eye, camera.at = s.at, camera.fov_degrees = 60;
    scene.camera = camera;
    return scene;
}

}   // namespace

TEST_CASE("spheres seen from both sides are drawn as the reference draws them", "[judge][spheres]") {
    const Setting setting = GENERATE(from_range(settings));
    const std::string name = GENERATE("default", "small");
    const int levels = GENERATE(1, 2);
    CAPTURE(setting.what, name, levels);
    const Scene scene = scene_of(setting);
    const FrameSize size{64, 48};
    const Whitted whitted{3};
    Config config = fitted_config(scene, whitted, named_config(name));
    config.stack_depth = 64, config.levels = levels;
    const Job job = make_job(scene, *scene.camera, size, config, {}, whitted);
    const RecordedFrame made = record_frame(job, job.frame);
    const WhittedFrame right = Reference(scene).whitted(*scene.camera, size, whitted, 1);

    const PictureJudgement judged =
        judge_picture({scene, *scene.camera, made.frame, job.image.lattice, job.config}, job.image, whitted,
                      {made.trace.hits, made.trace.colours, made.trace.signatures});
    for (const PictureFault& f : judged.faults)
        FAIL_CHECK("pixel (" << f.x << ", " << f.y << "), after ray " << f.ray << ": " << f.what);
    const FrameResult run = run_model(job);
    const FrameError error = frame_error(run.hits, picture_from_colours(size, run.colours), right.hits,
                                         picture_from_reference(right));
    CAPTURE(error.pixels_other_primitive, error.psnr_db);
    // Only pixels at the outline of a ball may show the neighbouring primitive.
    CHECK(error.pixels_other_primitive <= error.pixels / 200);
    CHECK(error.psnr_db >= 38);
    if (setting.is_dark) {
        const glm::dvec3 ambient = 0.1 * glm::dvec3(0.8, 0.7, 0.6);
        std::size_t floor = 0, lit = 0;
        for (std::size_t i = 0; i < run.hits.hits.size(); ++i) {
            if (run.hits.hits[i].primitive != scene.spheres.size()) continue;
            ++floor;
            for (std::size_t k = 0; k < 3; ++k)
                lit += std::abs(run.colours[i][k] / 65536.0 - ambient[int(k)]) > 1e-3;
        }
        CHECK(floor > 1000);
        CHECK(lit == 0);
    }
}

}   // namespace rayclock::test::spheres_test

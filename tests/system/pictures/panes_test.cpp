// Planes that transmit or mirror, with eye and lights on all sides, up to the horizon: the model renders what
// the reference renders by its own rules.
#include <catch2/catch.hpp>

#include "model/compile/surfaces.hpp"
#include "sim/judge/reference/reference.hpp"
#include "sim/judge/cause/finished.hpp"
#include "sim/files/image/image.hpp"
#include "tests/support/machine/frames.hpp"

using namespace rayclock;
using namespace rayclock::test;

namespace {

enum Look : std::uint32_t { clay, glass, water, mirror };

/// A plane at a height, or upright; `across` is the axis that it crosses.
struct Wall {
    int across;
    double at;
    Look look;
};

struct Setting {
    const char* what;
    glm::dvec3 eye;
    std::vector<glm::dvec3> lights;
    std::vector<Wall> walls;
    std::vector<glm::dvec3> balls{{0, 1, 0}};   ///< radius 0.5
};

const glm::dvec3 sun{4000, 9000, 3000};   ///< beyond the lattice

const std::vector<Setting> settings{
    {"a floor in the shadow of a pane", {0, 3, 8}, {{0, 2.5, 2}}, {{1, 0, glass}, {1, -2, clay}}},
    {"a light between a pane and the floor", {0, 3, 8}, {{0, -1, 2}}, {{1, 0, glass}, {1, -2, clay}}},
    {"the eye below a pane, and lights on both sides",
     {0, -1, 8},
     {{0, 2.5, 2}, {1, -1, 3}},
     {{1, 0, glass}, {1, -2, clay}, {1, 5, clay}}},
    {"a pond in the sun",
     {0, 3, 8},
     {sun},
     {{1, 0, water}, {1, -2, clay}},
     {{0, 1, 0}, {1, 0, 1}, {-1, -1, 0}}},
    {"a pond in the sun, from below",
     {0, -1, 8},
     {sun},
     {{1, 0, water}, {1, -2, clay}},
     {{0, 1, 0}, {1, -1, 1}}},
    {"a lamp in the pond",
     {0, 3, 8},
     {{0, -1, 0}, sun},
     {{1, 0, water}, {1, -2, clay}},
     {{1, 0, 1}, {-1, -1, 0}}},
    {"two panes above a floor, with a light between them",
     {0, 3, 8},
     {{0, 0.5, 2}, {0, -1, 2}},
     {{1, 1, glass}, {1, 0, glass}, {1, -2, clay}}},
    {"two panes that cross",
     {3, 3, 8},
     {{2, 2.5, 2}, {-3, -1, 2}},
     {{1, 0, glass}, {0, 0.25, glass}, {1, -2, clay}}},
    {"a pane that is there twice",
     {0, 3, 8},
     {{0, -1, 2}},
     {{1, 0, glass}, {1, 0, glass}, {1, 0, clay}, {1, -2, clay}}},
    {"a mirror below a pane",
     {0, 3, 8},
     {{0, 2.5, 2}, {0, -1, 1}},
     {{1, 0, glass}, {1, -2, mirror}, {1, 9, clay}}},
    {"a floor and a ceiling that mirror", {0, 0, 8}, {{0, 0, 2}}, {{1, -2, mirror}, {1, 3, mirror}}},
    {"one pane alone", {0, 3, 8}, {{0, -1, 2}, sun}, {{1, 0, glass}}, {{0, 1, 0}, {0, -1, 0}}},
};

Scene scene_of(const Setting& s) {
    Scene scene;
    scene.name = s.what;
    scene.materials.resize(4);
    for (Material& m : scene.materials) m.colour = {0.8, 0.7, 0.6}, m.ambient = 0.1, m.diffuse = 0.9;
    for (const Look look : {glass, water}) {
        scene.materials[look].diffuse = 0.1, scene.materials[look].ambient = 0;
        scene.materials[look].transmit = 0.9;
    }
    scene.materials[glass].index = 1, scene.materials[water].index = 1.33,
    scene.materials[water].mirror = 0.1;
    scene.materials[mirror].diffuse = 0.3, scene.materials[mirror].mirror = 0.7;
    for (const glm::dvec3& at : s.balls) scene.spheres.push_back({at, 0.5, clay});
    for (const Wall& w : s.walls) {
        glm::dvec3 point(0), u(0), v(0);
        point[w.across] = w.at, u[(w.across + 1) % 3] = 1, v[(w.across + 2) % 3] = 1;
        scene.planes.push_back({point, u, v, w.look});
    }
    for (const glm::dvec3& at : s.lights) scene.lights.push_back({at, {0.9, 0.9, 0.9}});
    Camera camera;
    camera.eye = s.eye, camera.at = {0, 0, 0}, camera.fov_degrees = 45;
    scene.camera = camera;
    return scene;
}

}   // namespace

TEST_CASE("planes that transmit or mirror are drawn up to the horizon as the reference draws them",
          "[stages][panes]") {
    const Setting setting = GENERATE(from_range(settings));
    const int levels = GENERATE(1, 2);
    CAPTURE(setting.what, levels);
    const Scene scene = scene_of(setting);
    const FrameSize size{80, 60};
    const Whitted whitted{3};
    Config config = named_config("default");
    config.levels = levels, config.stack_depth = 64;
    config = fitted_config(scene, whitted, config);
    const Job job = make_job(scene, *scene.camera, size, config, {}, whitted);
    const RecordedFrame made = record_frame(job, job.frame);
    const WhittedFrame right = Reference(scene).whitted(*scene.camera, size, whitted, 1);
    const Picture picture = picture_from_colours(size, made.trace.colours);
    const Judgement judged =
        judge_finished({scene, *scene.camera, made.frame, job.image.lattice, job.config}, job.image, whitted,
                       {right, picture, {made.trace.hits, made.trace.colours, made.trace.signatures}},
                       scaled(job, job.frame, made.trace.hits));
    for (const PictureFault& f : judged.faults)
        FAIL_CHECK("pixel (" << f.x << ", " << f.y << "): " << f.what);
    CHECK(judged.bugs() == 0);
    CHECK(judged.causes[std::size_t(PixelCause::horizon)] == 0);
    CHECK(compare(picture, picture_from_reference(right)).psnr_db >= 40);
}

// Two sets of rules in one frame: the machine's, which its judge follows, and the reference's. In random
// scenes they must agree in every pixel.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

#include "model/compile/surfaces.hpp"
#include "model/trace/hits.hpp"
#include "sim/judge/reference/reference.hpp"
#include "sim/judge/cause/finished.hpp"
#include "sim/run/engine/engine.hpp"
#include "tests/support/scenes/random_scene.hpp"

using namespace rayclock;
using namespace rayclock::test;

namespace {

Judgement judged(const Scene& scene, const Whitted& settings, const Config& wanted, FrameSize size) {
    check_scene(scene, "the scene");
    const Config config = fitted_config(scene, settings, wanted);
    const Job job = make_job(scene, *scene.camera, size, config, {}, settings);
    const FrameTrace trace = record_frame(job, job.frame);
    const WhittedFrame reference = Reference(scene).whitted(*scene.camera, size, settings);
    const Picture picture = picture_of(size, trace.trace.colours);
    const Given given{trace.trace.hits, trace.trace.colours, trace.trace.signatures};
    return judge_finished({scene, *scene.camera, trace.frame, job.image.lattice, job.config}, job.image,
                          settings, {reference, picture, given}, scaled(job, job.frame, trace.trace.hits));
}

/// Returns a scene on infinite grey tiles with sides u and v.
Scene tiles(const glm::dvec3& u, const glm::dvec3& v) {
    Scene scene;
    Material tiles;
    tiles.checkered = true, tiles.other = {0.1, 0.1, 0.1};
    scene.materials = {tiles};
    scene.planes = {{{0.3, 0, 0.2}, u, v, 0}};
    scene.lights = {{{3, 6, 5}, glm::dvec3(0.9)}};
    scene.camera = Camera{{0.5, 2, 6}, {0, 0.5, 0}, {0, 1, 0}, 50};
    return scene;
}

/// Requires that every cause occurs. A seam occurs only in some of thousands.
void check_scenes(std::uint64_t first, std::uint64_t count) {
    PixelCauses causes{};
    for (std::uint64_t seed = first; seed < first + count; ++seed) {
        INFO("seed " << seed);
        const RandomScene drawn = random_scene(seed);
        const Judgement j = judged(flattened(drawn.placed), drawn.settings, drawn.config, {20, 15});
        for (const PictureFault& f : j.faults) FAIL_CHECK("pixel (" << f.x << ", " << f.y << "): " << f.what);
        CHECK(j.wrong == 0);
        CHECK(j.bugs() == 0);
        for (std::size_t k = 0; k < causes.size(); ++k) causes[k] += j.causes[k];
    }
    for (const PixelCause cause :
         {PixelCause::snapping, PixelCause::ray_quantisation, PixelCause::seam, PixelCause::shading})
        CHECK((causes[std::size_t(cause)] > 0 || (cause == PixelCause::seam && count < 1000)));
}

}   // namespace

TEST_CASE("the reference's rules hold in 200 random scenes as the machine draws them", "[ladder]") {
    check_scenes(0, 200);
}

TEST_CASE("the reference's rules hold in 10,000 random scenes as the machine draws them", "[ladder][slow]") {
    check_scenes(200, 9800);
}

TEST_CASE("two spheres at one place are told wherever one of them is met from the other", "[ladder]") {
    Scene scene = tiles({1, 0, 0}, {0, 0, 1});
    Material glass, tinted;
    glass.transmit = 0.9, glass.mirror = 0.1, glass.index = 1.5;
    tinted = glass, tinted.colour = {0.9, 0.2, 0.1};
    scene.materials.insert(scene.materials.end(), {glass, tinted, Material{}});
    const Whitted settings{.depth = 3};
    const Config config = named_config("default");
    scene.spheres = {{{0, 1.2, 0}, 1, 1}};
    CHECK(judged(scene, settings, config, {48, 36}).wrong == 0);
    const std::uint32_t second = GENERATE(1u, 2u, 3u);   // the last is opaque
    scene.spheres.push_back({{0, 1.2, 0}, 1, second});
    const Judgement j = judged(scene, settings, config, {48, 36});
    CHECK(j.bugs() > 0);
    CHECK(j.bugs() == j.wrong);
    REQUIRE(!j.faults.empty());
    for (const PictureFault& f : j.faults) {
        INFO(f.what);
        CHECK(f.what.find("second one at the same place") != std::string::npos);
    }
}

TEST_CASE("the more a plane's sides lean towards each other, the more it may turn", "[ladder]") {
    const double degrees = GENERATE(90, 30, 5, 1);
    const double angle = degrees * 0.017453292519943295;
    const Judgement j = judged(tiles({0.7, 0.1, 0}, {0.7 * std::cos(angle), 0.1, 0.7 * std::sin(angle)}),
                               {.depth = 1}, named_config("default"), {48, 36});
    INFO(degrees);
    for (const PictureFault& f : j.faults) UNSCOPED_INFO(f.what);
    CHECK(j.wrong == 0);
}

// The judge of finished pictures: it accepts correct ones, counts every ray, and detects any modification.
#include <catch2/catch.hpp>

#include "model/compile/surfaces.hpp"
#include "sim/judge/reference/reference.hpp"
#include "sim/judge/paths/judge_picture.hpp"
#include "sim/load/load.hpp"
#include "tests/support/machine/frames.hpp"

using namespace rayclock;
using namespace rayclock::test;

namespace {

/// A finished picture of the model, for modification.
struct Case {
    Scene scene;
    Whitted settings;
    Job job;
    RecordedFrame trace;

    Case(const std::string& name, const Whitted& given, const Config& config, FrameSize size = {48, 36})
        : scene(load_scene(name, {}, Primitives::native)), settings(given) {
        if (!scene.camera) scene.camera = fit_camera(scene, double(size.width) / size.height);
        Config units = fitted_config(scene, settings, config);
        units.stack_depth = 64;
        job = make_job(scene, *scene.camera, size, units, {}, settings);
        trace = record_frame(job, job.frame);
    }
    PictureJudgement judged() const {
        const FrameInputs inputs{scene, *scene.camera, trace.frame, job.image.lattice, job.config};
        return judge_picture(inputs, job.image, settings,
                             {trace.trace.hits, trace.trace.colours, trace.trace.signatures});
    }
};

}   // namespace

TEST_CASE("every ray and colour of a sound picture is right, and all are judged", "[judge]") {
    const auto [name, settings] = GENERATE(table<std::string, Whitted>({{"spheres", {5}},
                                                                        {"balls:2", {4}},
                                                                        {"gears:2", {4}},
                                                                        {"mount:3", {4}},
                                                                        {"rings:1", {4}},
                                                                        {"teapot:4", {4}},
                                                                        {"mirrors", {6}},
                                                                        {"tree:3", {2}},
                                                                        {"plane", {1}},
                                                                        {"spheres", {15, 0.02}},
                                                                        {"spheres", {3, 0, 3, true, 0.05, 3}},
                                                                        {"square", {1, 0, 3, false, 1}},
                                                                        {"cornell", {2, 0, 2}}}));
    const std::string config = GENERATE("default", "small");
    INFO(name << " depth " << settings.depth << " aa " << settings.aa << " configuration " << config);
    const Case made(name, settings, named_config(config));
    const PictureJudgement j = made.judged();
    for (const PictureFault& f : j.faults)
        FAIL_CHECK("pixel (" << f.x << ", " << f.y << "), after ray " << f.ray << ": " << f.what);
    CHECK(j.wrong == 0);
    CHECK(j.colours == made.trace.trace.colours.size());
    const RayCounts& sent = made.trace.trace.counts;
    CHECK(j.rays.primary == sent.primary);
    CHECK(j.rays.shadow == sent.shadow);
    CHECK(j.rays.reflection == sent.reflection);
    CHECK(j.rays.refraction <= sent.refraction);   // a total reflection counts as one, and sends none
    CHECK(j.widest < 0.1 * (1 << unit_bits));
}

TEST_CASE("the judge sees a pixel, a hit, a path and a register that are not the frame's", "[judge]") {
    Case made("spheres", {3}, named_config("default"));
    REQUIRE(made.judged().wrong == 0);
    const std::size_t at = 20 * 48 + 24;
    const auto one_wrong = [&] {
        const PictureJudgement j = made.judged();
        CHECK(j.wrong == 1);
        REQUIRE(j.faults.size() == 1);
    };
    SECTION("a colour") {
        ++made.trace.trace.colours[at][1];
        one_wrong();
        CHECK(made.judged().pixels[at]);
    }
    SECTION("a hit") {
        made.trace.trace.hits[at].t += 1;
        one_wrong();
    }
    SECTION("a path") {
        made.trace.trace.signatures[at] ^= 1;
        one_wrong();
    }
    SECTION("a light's place") {
        made.trace.frame.shade.place[0] += 2;
        const PictureJudgement j = made.judged();
        CHECK(j.faults[0].what == "light 0 is not the scene's");
    }
    SECTION("the depth") {
        made.settings.depth = 2;
        CHECK(made.judged().wrong > 1);
    }
    SECTION("the threshold") {
        made.settings.threshold = 0.3;
        CHECK(made.judged().wrong > 1);
    }
    SECTION("a material") {
        made.scene.materials[made.scene.spheres[0].material].diffuse += 0.001;
        const PictureJudgement j = made.judged();
        CHECK(j.wrong > 10);
        CHECK(j.faults[0].what == "memory does not hold the surface that was hit");
    }
}

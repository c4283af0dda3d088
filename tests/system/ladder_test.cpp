// Two sets of rules in one frame: the machine's, which its judge follows, and the reference's. In scenes that
// are drawn at random they must agree in every pixel.
#include <catch2/catch.hpp>

#include "model/accel/surfaces.hpp"
#include "model/hits.hpp"
#include "model/reference/reference.hpp"
#include "sim/cause/finished.hpp"
#include "sim/engine/engine.hpp"
#include "tests/support/scenes/random_scene.hpp"

using namespace rayclock;
using namespace rayclock::test;

namespace {

Judgement judged(const RandomScene& drawn, FrameSize size) {
    const Scene scene = flattened(drawn.placed);
    check_scene(scene, "a random scene");
    const Config config = fitted_config(scene, drawn.settings, drawn.config);
    const Job job = make_job(scene, *scene.camera, size, config, {}, drawn.settings);
    const FrameTrace trace = record_frame(job, job.frame);
    const WhittedFrame reference = Reference(scene).whitted(*scene.camera, size, drawn.settings);
    const Picture picture = picture_of(size, trace.trace.colours);
    const Given given{trace.trace.hits, trace.trace.colours, trace.trace.signatures};
    return judge_finished({scene, *scene.camera, trace.frame, job.image.lattice, job.config}, job.image,
                          drawn.settings, {reference, picture, given},
                          scaled(job, job.frame, trace.trace.hits));
}

void check_scenes(std::uint64_t first, std::uint64_t count) {
    PixelCauses causes{};
    for (std::uint64_t seed = first; seed < first + count; ++seed) {
        INFO("seed " << seed);
        const Judgement j = judged(random_scene(seed), {20, 15});
        for (const PictureFault& f : j.faults) FAIL_CHECK("pixel (" << f.x << ", " << f.y << "): " << f.what);
        CHECK(j.wrong == 0);
        CHECK(j.bugs() == 0);
        for (std::size_t k = 0; k < causes.size(); ++k) causes[k] += j.causes[k];
    }
    for (const PixelCause cause :
         {PixelCause::snapping, PixelCause::ray_quantisation, PixelCause::seam, PixelCause::shading})
        CHECK(causes[std::size_t(cause)] > 0);
}

}   // namespace

TEST_CASE("the reference's rules hold in 200 random scenes as the machine draws them", "[ladder]") {
    check_scenes(0, 200);
}

TEST_CASE("the reference's rules hold in 10,000 random scenes as the machine draws them", "[ladder][slow]") {
    check_scenes(200, 9800);
}

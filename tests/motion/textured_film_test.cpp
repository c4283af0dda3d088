// A film with a turning textured instance: its texture turns with it, and the judge accepts every frame.
#include <catch2/catch.hpp>

#include "sim/judge/paths/picture.hpp"
#include "tests/motion/films.hpp"
#include "tests/support/scenes/textured_cubes.hpp"

namespace rayclock::test::textured_film_test {

using namespace rayclock;
using namespace rayclock::test;

TEST_CASE("four frames of a turning textured instance are right, and differ", "[motion][film][textures]") {
    const TexturedCubes cubes;
    const int levels = GENERATE(1, 2);
    INFO("levels " << levels);
    Request request;
    request.scene = load_scene(cubes.turning());
    request.settings.depth = 1;
    request.finished = true;
    Config config = named_config("default");
    config.levels = levels, config.stack_depth = 64;
    request.config = fitted_config(request.scene, request.settings, config);
    REQUIRE(request.config.has_textures());
    const Whitted settings = request.settings;
    Film film(std::move(request), frames_of(4, 4), false, {40, 30});
    REQUIRE(film.frames() == 4);
    std::vector<Colours> pictures;
    for (std::size_t f = 0; f < film.frames(); ++f) {
        INFO("frame " << f);
        film.next();
        const RecordedFrame made = film.record(1, {});
        const Job& job = film.job();
        const Scene& scene = film.request().scene;
        const PictureJudgement j =
            judge_picture({scene, film.camera(), made.frame, job.image.lattice, job.config}, job.image,
                          settings, {made.trace.hits, made.trace.colours, made.trace.signatures});
        for (const PictureFault& fault : j.faults)
            FAIL_CHECK("pixel (" << fault.x << ", " << fault.y << "): " << fault.what);
        CHECK(j.wrong == 0);
        CHECK(j.colours == 40 * 30);
        for (const Colours& earlier : pictures) CHECK(earlier != made.trace.colours);
        pictures.push_back(made.trace.colours);
    }
}

}   // namespace rayclock::test::textured_film_test

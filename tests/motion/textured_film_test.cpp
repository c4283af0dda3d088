// Films with textures that turn and stretch: judge and reference accept every frame.
#include <set>

#include <catch2/catch.hpp>

#include "sim/files/image/image.hpp"
#include "sim/judge/paths/judge_picture.hpp"
#include "sim/judge/reference/reference.hpp"
#include "tests/motion/films.hpp"
#include "tests/support/scenes/deforming_files.hpp"
#include "tests/support/scenes/textured_cubes.hpp"

namespace rayclock::test::textured_film_test {

using namespace rayclock;
using namespace rayclock::test;

namespace {

/// Draws four frames of a scene, and requires:
/// - judge and reference accept each of them,
/// - the host's writes give the memory that each frame reads,
/// - no two frames are equal.
void check_film(const std::string& path, int levels, const std::string& uploads) {
    INFO("levels " << levels << ", uploads " << uploads);
    constexpr FrameSize size{40, 30};
    Request request;
    request.scene = load_scene(path);
    request.settings.depth = 1;
    request.finished = true;
    Config config = named_config("default");
    config.levels = levels, config.stack_depth = 64;
    request.config = fitted_config(request.scene, request.settings, config);
    REQUIRE(request.config.has_textures());
    const Whitted settings = request.settings;
    Film film(std::move(request), frames_of(4, 4, uploads), false, size);
    MemoryImage memory;   // of the chip: its initial content and the host's writes
    REQUIRE(film.frames() == 4);
    std::vector<Colours> pictures;
    for (std::size_t f = 0; f < film.frames(); ++f) {
        INFO("frame " << f);
        film.next();
        const RecordedFrame made = film.record(1, {});
        const Job& job = film.job();
        if (f == 0) memory = job.image;
        apply(made.upload, memory);
        CHECK(record_trace(memory, made.frame, job.config, 1).colours == made.trace.colours);
        const Scene& scene = film.request().scene;
        const PictureJudgement j =
            judge_picture({scene, film.camera(), made.frame, job.image.lattice, job.config}, job.image,
                          settings, {made.trace.hits, made.trace.colours, made.trace.signatures});
        for (const PictureFault& fault : j.faults)
            FAIL_CHECK("pixel (" << fault.x << ", " << fault.y << "): " << fault.what);
        CHECK(j.wrong == 0);
        CHECK(j.colours == 40 * 30);
        const WhittedFrame right = Reference(scene).whitted(film.camera(), size, settings, 1);
        Picture own{size, {}}, other{size, {}};
        for (const std::array<std::uint32_t, 3>& c : made.trace.colours)
            own.pixels.push_back(glm::vec3(c[0], c[1], c[2]) / 65536.0f);
        for (const glm::dvec3& pixel : right.pixels) other.pixels.push_back(glm::vec3(pixel));
        CHECK(compare(own, other).psnr_db >= 30);
        for (const Colours& earlier : pictures) CHECK(earlier != made.trace.colours);
        pictures.push_back(made.trace.colours);
    }
}

}   // namespace

TEST_CASE("four frames of a turning textured instance are correct, and differ", "[motion][film][textures]") {
    const TexturedCubes cubes;
    check_film(cubes.turning(), GENERATE(1, 2), "between");
}

TEST_CASE("four frames of a textured mesh that deforms are correct, and differ",
          "[motion][deform][textures]") {
    const bool instance_paints = GENERATE(false, true);
    INFO("instance_paints " << instance_paints);
    const TexturedCubes cubes;
    const auto [levels, uploads] =
        GENERATE(std::pair(1, "between"), std::pair(2, "between"), std::pair(2, "double"));
    check_film(cubes.waving(instance_paints), levels, uploads);
}

// Otherwise a cache could keep old lines of the other buffer after the host's writes.
TEST_CASE("no line of a cache holds lines of two buffers", "[motion][deform][textures]") {
    constexpr int cache_line = 256, lines = cache_line / int(line_bytes);
    const TexturedCubes cubes;
    const SceneFolder folder;
    const bool has_textures = GENERATE(false, true);
    INFO("has_textures " << has_textures);
    Request request;
    request.scene = load_scene(has_textures ? cubes.waving(true) : sheet_film(folder, 9));
    request.settings.depth = 1;
    request.finished = true;
    const Config config = with(named_config("default"), {{"levels", 2},
                                                         {"stack_depth", 64},
                                                         {"surf_line", cache_line},
                                                         {"tex_line", has_textures ? cache_line : 64}});
    request.config = fitted_config(request.scene, request.settings, config);
    Film film(std::move(request), frames_of(2, 4, "double"), false, {16, 12});
    std::set<std::uint32_t> written[2];
    for (auto& blocks : written) {
        film.next();
        for (const std::uint32_t line : film.record(1, {}).upload.lines) blocks.insert(line / lines);
    }
    CHECK(written[0].size() > 10);
    for (const std::uint32_t block : written[0]) CHECK(written[1].count(block) == 0);
}

}   // namespace rayclock::test::textured_film_test

// Films of deforming meshes: the host's writes give every frame's memory, each frame has the hits of its own
// scene after any refits, and model and RTL are equal.
#include <catch2/catch.hpp>

#include "model/engine/engines.hpp"
#include "sim/judge/reference/reference.hpp"
#include "sim/files/image/image.hpp"
#include "tests/motion/films.hpp"
#include "tests/support/scenes/deforming_files.hpp"

using namespace rayclock;
using namespace rayclock::test;

namespace {

constexpr FrameSize small{24, 18};

FramesOptions options(const std::string& uploads, double rebuild, int frames = 6) {
    FramesOptions o = frames_of(frames, 2, uploads);
    o.rebuild = rebuild;
    return o;
}

/// One level or two, with uploads between frames or double-buffered.
struct Way {
    int levels;
    const char* uploads;
};
Way any_way() { return GENERATE(Way{1, "between"}, Way{2, "between"}, Way{2, "double"}); }
Config config_of(const Way& way, const char* name = "default") {
    return way.levels == 2 ? two(name, 2) : quick_config(name);
}

}   // namespace

TEST_CASE("uploads of a mesh that deforms give every frame the memory that it reads", "[motion][deform]") {
    const Way way = any_way();
    INFO("levels " << way.levels << ", " << way.uploads);
    const SceneFolder folder;
    Film film = film_of(sheet_film(folder, 9), config_of(way), small, options(way.uploads, 1e9));
    const Recorded made = recorded(film);
    // Where their trees will be, frames may find any content: the last frame's, or nonsense.
    MemoryImage image = made.job.image;
    if (way.levels == 1) std::fill(image.words.begin(), image.words.end(), 0x5a5a5a5au);
    for (const RecordedFrame& trace : made.traces)
        for (const std::uint32_t line : trace.upload.lines)
            std::fill_n(&image.words[std::size_t(line) * 16], 16, 0x5a5a5a5au);
    for (std::size_t f = 0; f < made.traces.size(); ++f) {
        INFO("frame " << f);
        const Upload& upload = made.traces[f].upload;
        CHECK_FALSE(upload.is_whole);
        CHECK(std::is_sorted(upload.lines.begin(), upload.lines.end()));
        CHECK(upload.rebuilt == (f == 0 ? std::size_t(way.levels) : 0));   // two levels: in two classes
        CHECK(upload.refitted == (f == 0 ? 0 : std::size_t(way.levels)));
        CHECK(upload.resets == (std::string(way.uploads) == "double" ? f > 0 && f % 2 == 0 : f > 0));
        // In two levels both instances of the sheet have new boxes, even the one that does not move.
        CHECK(upload.instances == 2);
        apply(upload, image);
        CHECK(same(record_trace(image, made.traces[f].frame, made.job.config, 1).hits,
                   made.traces[f].trace.hits));
        if (f > 0) CHECK_FALSE(same(made.traces[f].trace.hits, made.traces[f - 1].trace.hits));
    }
}

TEST_CASE("a film has the same hits whether trees are refitted or rebuilt", "[motion][deform]") {
    const Way way = any_way();
    INFO("levels " << way.levels << ", " << way.uploads);
    const SceneFolder folder;
    const std::string path = sheet_film(folder, 12, true);
    std::vector<Recorded> made;
    for (const double rebuild : {0.0, 1e9, 1.5}) {
        Film film = film_of(path, config_of(way), small, options(way.uploads, rebuild));
        made.push_back(recorded(film));
    }
    std::size_t refitted = 0, rebuilt = 0;
    for (std::size_t f = 0; f < made[0].traces.size(); ++f) {
        INFO("frame " << f);
        CHECK(same(made[0].traces[f].trace.hits, made[1].traces[f].trace.hits));
        CHECK(same(made[0].traces[f].trace.hits, made[2].traces[f].trace.hits));
        CHECK(made[0].traces[f].upload.refitted == 0);
        CHECK(made[0].traces[f].upload.cost == 1);
        CHECK(made[1].traces[f].upload.rebuilt == (f == 0 ? std::size_t(way.levels) : 0));
        if (f == 0) continue;
        refitted += made[2].traces[f].upload.refitted;
        rebuilt += made[2].traces[f].upload.rebuilt;
        CHECK(made[2].traces[f].upload.cost <= 1.5);
    }
    CHECK(made[1].traces.back().upload.cost > 1.5);
    CHECK(refitted > 0);                                                              // while it waves
    CHECK(rebuilt > 0);                                                               // when it crumples
    CHECK(made[1].traces.back().trace.visits > made[0].traces.back().trace.visits);   // a degraded tree
}

TEST_CASE("a sheet that begins as a line is drawn once it opens", "[motion][deform]") {
    constexpr FrameSize size{64, 48};
    const Way way = any_way();
    INFO("levels " << way.levels << ", " << way.uploads);
    const SceneFolder folder;
    const std::string path = sheet_film(folder, 8);
    folder.write("a.obj", sheet_obj(8, [](double, double z) { return glm::dvec3(0, 0, z); }));
    Film film = film_of(path, config_of(way), size, options(way.uploads, 1e9, 3));
    std::ptrdiff_t first = 0;
    for (std::size_t f = 0; f < film.frames(); ++f) {
        film.next();
        const RecordedFrame trace = film.record(1, {});
        const Scene& scene = film.request().scene;
        CHECK(compare(shade(scene, hits_of(film.job(), trace)),
                      shade(scene, Reference(scene).frame(film.camera(), size, 1)))
                  .psnr_db >= 40);
        const auto seen = std::count_if(trace.trace.hits.begin(), trace.trace.hits.end(),
                                        [](const Closest& c) { return c.found; });
        if (f == 0) first = seen;   // the ball alone
        if (f > 0) CHECK(seen > first + 100);
    }
}

TEST_CASE("every frame of a mesh that deforms looks as the reference says that its scene looks",
          "[motion][deform]") {
    constexpr FrameSize size{96, 72};
    const Way way = any_way();
    INFO("levels " << way.levels << ", " << way.uploads);
    const SceneFolder folder;
    Film film = film_of(sheet_film(folder, 12), config_of(way), size, options(way.uploads, 1.5, 4));
    for (std::size_t f = 0; f < film.frames(); ++f) {
        film.next();
        const RecordedFrame trace = film.record(1, {});
        const Scene& scene = film.request().scene;
        CHECK(compare(shade(scene, hits_of(film.job(), trace)),
                      shade(scene, Reference(scene).frame(film.camera(), size, 1)))
                  .psnr_db >= 40);
    }
}

TEST_CASE("a mesh that deforms has finished pictures: its surfaces follow it", "[motion][deform]") {
    constexpr FrameSize size{64, 48};
    const Way way = any_way();
    INFO("levels " << way.levels << ", " << way.uploads);
    const SceneFolder folder;
    Request request;
    request.scene = load_scene(sheet_film(folder, 8));
    request.settings.depth = 2;
    request.config = fitted_config(request.scene, request.settings,
                                   with(named_config("default"), {{"levels", way.levels}}));
    request.finished = true;
    Film film(request, options(way.uploads, 1.5, 4), false, size);
    MemoryImage memory;   // of the chip: its initial content and the host's writes
    for (std::size_t f = 0; f < film.frames(); ++f) {
        film.next();
        const RecordedFrame trace = film.record(1, {});
        if (f == 0) memory = film.job().image;
        apply(trace.upload, memory);
        CHECK(record_trace(memory, trace.frame, film.job().config, 1).colours == trace.trace.colours);
        const WhittedFrame right =
            Reference(film.request().scene).whitted(film.camera(), size, request.settings, 1);
        Picture own{size, {}}, other{size, {}};
        for (const std::array<std::uint32_t, 3>& c : trace.trace.colours)
            own.pixels.push_back(glm::vec3(c[0], c[1], c[2]) / 65536.0f);
        for (const glm::dvec3& pixel : right.pixels) other.pixels.push_back(glm::vec3(pixel));
        CHECK(compare(own, other).psnr_db >= 40);
    }
}

TEST_CASE("machines without a tree that can be refitted make all of it anew, and say so",
          "[motion][deform]") {
    const SceneFolder folder;
    Config list = quick_config("default");
    list.structure = Structure::kd;
    Film film = film_of(sheet_film(folder, 6), list, small, options("between", 1.5, 3));
    const Recorded made = recorded(film);
    for (const RecordedFrame& trace : made.traces) {
        CHECK(trace.upload.is_whole);
        CHECK(trace.upload.rebuilt == 1);
        CHECK(trace.upload.refitted == 0);
    }
    CHECK_THROWS_WITH(film_of(sheet_film(folder, 6), quick_config("default"), small, options("double", 1.5)),
                      Catch::Contains("--uploads double"));
    for (const double nonsense : {-1.0, std::nan("")})
        CHECK_THROWS_WITH(
            film_of(sheet_film(folder, 6), quick_config("default"), small, options("between", nonsense)),
            Catch::Contains("--rebuild must be 0 or more"));
}

TEST_CASE("model and RTL draw the same film of a mesh that deforms", "[motion][deform_rtl]") {
    std::vector<Config> all = chips();
    std::erase_if(all, [](const Config& c) { return has_cells(c); });   // compiled again
    all.push_back(quick_config("default"));
    all.push_back(quick_config("narrow"));
    const Config config = GENERATE_COPY(from_range(all));
    for (const char* uploads : {"between", "double"}) {
        if (config.levels == 1 && std::string(uploads) == "double") continue;
        INFO(config.name << ", levels " << config.levels << ", " << uploads);
        const SceneFolder folder;
        Film film = film_of(sheet_film(folder, 5, true), config, {16, 12}, options(uploads, 1.5, 5));
        const Recorded made = recorded(film);
        std::size_t refitted = 0, rebuilt = 0;
        for (std::size_t f = 1; f < made.traces.size(); ++f) {
            refitted += made.traces[f].upload.refitted;
            rebuilt += made.traces[f].upload.rebuilt;
        }
        CHECK(refitted > 0);
        CHECK(rebuilt > 0);
        check_lockstep(made.job, made.traces);
        check_lockstep(made.job, made.traces, {9, 30, 77}, 77);
    }
}

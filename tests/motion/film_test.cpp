// Films: every frame rebuilds only the upper structure, and has the hits of its own scene. Model and RTL
// agree, with the host's writes in between.
#include <algorithm>

#include <catch2/catch.hpp>

#include <glm/geometric.hpp>

#include "model/compile/frame.hpp"
#include "model/base/rng.hpp"
#include "sim/judge/reference/reference.hpp"
#include "sim/run/film/film.hpp"
#include "sim/files/image/image.hpp"
#include "sim/run/lockstep/lockstep.hpp"
#include "tests/support/machine/structures.hpp"
#include "tests/support/scenes/scene_files.hpp"
#include "tests/motion/films.hpp"
#include "tests/support/machine/build_all.hpp"
#include "tests/support/machine/frames.hpp"

using namespace rayclock;
using namespace rayclock::test;

TEST_CASE("the RTL that draws films builds", "[.build]") {
    std::vector<RtlJob> jobs;
    for (Config config : chips()) {
        jobs.push_back({"rc_chip", config.name + ", films", config});
    }
    jobs.push_back({"rc_chip", "small, finished films", finished_request("flight:3").config});
    for (const char* name : {"default", "narrow"})   // of one level, for deforming meshes
        jobs.push_back({"rc_chip", std::string(name) + ", films of one level", quick_config(name)});
    REQUIRE_NOTHROW(build_all(jobs));
}

TEST_CASE("frames of a film write the scene's tree alone, and the uploads in turn give every frame's memory",
          "[motion][film]") {
    // Trees of cells have no bound on their lines, so there is room for the largest of the film.
    const Structure structure = GENERATE(from_range(engines()));
    for (const char* uploads : {"between", "double"}) {
        INFO(name_of(structure) << ", " << uploads);
        Film film = film_of("crowd:3", two("default", 2, {{"structure", int(structure)}}), {32, 24},
                            frames_of(6, 8, uploads));
        const Recorded made = recorded(film);
        const bool is_double = std::string(uploads) == "double";
        // A memory with nonsense where the scene's trees will be.
        MemoryImage image = made.job.image;
        std::uint32_t most = 0;
        for (const RecordedFrame& trace : made.traces) most = std::max(most, trace.upload.lines.back());
        std::fill_n(image.words.begin(), std::size_t(most + 1) * 16, 0x5a5a5a5au);
        const std::vector<std::uint32_t> lower(image.words.begin() + std::ptrdiff_t(most + 1) * 16,
                                               image.words.end());
        CHECK(lower.size() > 3 * 16);
        for (std::size_t f = 0; f < made.traces.size(); ++f) {
            const Upload& upload = made.traces[f].upload;
            INFO("frame " << f);
            CHECK(upload.instances == (f == 0 ? 0 : 45));
            CHECK_FALSE(upload.is_whole);
            CHECK(upload.overlaps_previous_frame == (is_double && f > 0));
            // Between frames every tree is where the last one was read. With two buffers each is read every
            // second frame, and one reset empties the caches of both.
            CHECK(upload.resets == (is_double ? f > 0 && f % 2 == 0 : f > 0));
            CHECK(made.traces[f].frame.root == (is_double && f % 2 ? made.traces[1].frame.root : 0));
            apply(upload, image);
            const Trace again = record_trace(image, made.traces[f].frame, made.job.config, 1);
            CHECK(same(again.hits, made.traces[f].trace.hits));
        }
        CHECK(std::equal(lower.begin(), lower.end(), image.words.begin() + std::ptrdiff_t(most + 1) * 16));
    }
}

TEST_CASE("a frame does not depend on the frames before it", "[motion][film]") {
    const Config config = two("default", 2);
    Film film = film_of("crowd:2", config, {32, 24}, frames_of(5, 6));
    const Recorded made = recorded(film);
    PlacedScene scene = make_placed("crowd:2");
    std::vector<InstancePlaces> times;
    std::vector<glm::dvec3> eyes;
    for (int f = 0; f < 5; ++f) {
        pose(scene, f / 6.0);
        times.push_back(places_of(scene));
        eyes.push_back(scene.own.camera->eye);
    }
    for (const std::size_t f : {1, 4}) {
        const auto alone = MovingLevels::make(scene, times, eyes, 1, config);
        REQUIRE(alone);
        alone->next(times[f]);
        CHECK(same(record_trace(alone->image(), made.traces[f].frame, made.job.config, 1).hits,
                   made.traces[f].trace.hits));
    }
}

TEST_CASE("the solids around a mesh's corners hold them, whichever way it is turned", "[motion][film]") {
    for (const char* spec : {"clockwork:1", "flight:1", "crowd:1"}) {
        PlacedScene scene = make_placed(spec);
        const InstancePlaces places = places_of(scene);
        const glm::dvec3 eye = scene.own.camera->eye;
        const auto levels =
            MovingLevels::make(scene, std::span(&places, 1), std::span(&eye, 1), 1, two("default", 2));
        REQUIRE(levels);
        Rng rng{5};
        double loosest = 0;
        for (const MeshClass& made : levels->levels().maps.classes) {
            if (made.points.size() < 8) continue;
            for (int i = 0; i < 500; ++i) {
                const glm::dvec3 d(rng.below(2001) - 1000.0, rng.below(2001) - 1000.0,
                                   rng.below(2001) - 1000.0);
                double most = -1e300;
                for (const Vec3i& p : made.points)
                    most = std::max(most, glm::dot(d, glm::dvec3(p[0], p[1], p[2]) * made.lattice.pitch -
                                                          made.reach.middle));
                const double said = made.reach.along(d);
                REQUIRE(most <= said * (1 + 1e-12));
                loosest = std::max(loosest, said / most);
            }
        }
        CHECK(loosest < 1.6);   // and contain little else
    }
}

TEST_CASE("the order of instances changes no hit", "[motion][film]") {
    const Config config = two("default", 2);
    PlacedScene scene = make_placed("flight:60"), turned = scene;
    std::reverse(turned.instances.begin(), turned.instances.end());
    for (AttachedInstance& attached : turned.motion.attached) attached.instance = 59 - attached.instance;
    const FrameSize size{48, 36};
    std::vector<std::vector<Closest>> hits;
    for (PlacedScene* one : {&scene, &turned}) {
        pose(*one, 1.3);
        const InstancePlaces places = places_of(*one);
        const glm::dvec3 eye = one->own.camera->eye;
        const auto levels = MovingLevels::make(*one, std::span(&places, 1), std::span(&eye, 1), 1, config);
        REQUIRE(levels);
        levels->next(places);
        hits.push_back(record_trace(levels->image(),
                                    make_frame(*one->own.camera, size, levels->image(), config), config, 1)
                           .hits);
    }
    std::size_t found = 0;
    for (std::size_t i = 0; i < hits[0].size(); ++i) {
        const Closest &a = hits[0][i], &b = hits[1][i];
        REQUIRE(a.found == b.found);
        if (!a.found) continue;
        CHECK((a.t == b.t && a.u == b.u && a.v == b.v));
        // 2 triangles of the ground, then 320 for each ball.
        const auto number = [](std::uint32_t prim, bool is_turned) {
            if (prim < 2) return prim;
            const std::uint32_t ball = (prim - 2) / 320;
            return 2 + (is_turned ? 59 - ball : ball) * 320 + (prim - 2) % 320;
        };
        CHECK(number(a.prim, false) == number(b.prim, true));
        found += a.prim >= 2;
    }
    CHECK(found > 100);
}

TEST_CASE("every frame looks as the reference says that its scene looks", "[motion][film]") {
    for (const char* spec : {"clockwork:4", "crowd:4", "flight:40"})
        for (const int levels : {1, 2}) {
            INFO(spec << ", levels " << levels);
            Film film = film_of(spec, levels == 2 ? two("default", 2) : named_config("default"), {96, 72},
                                frames_of(4, 7));
            Picture before;
            for (std::size_t f = 0; f < film.frames(); ++f) {
                film.next();
                const RecordedFrame trace = film.record(1, {});
                const Scene& scene = film.request().scene;
                const Picture own = shade(scene, hits_of(film.job(), trace)),
                              other = shade(scene, Reference(scene).frame(film.camera(), {96, 72}, 1));
                CHECK(compare(own, other).psnr_db >= 40);
                if (f > 0) CHECK(compare(own, before).psnr_db < 40);   // something has moved
                before = own;
                CHECK(trace.upload.is_whole == (levels == 1));
            }
        }
}

TEST_CASE("a mirrored, sheared and scaled instance moves as its triangles do", "[motion][film]") {
    const SceneFolder folder;
    const std::string path = folder.write("odd.json", R"({
      "camera": {"eye": [0, 1, 9], "at": [0, 0, 0]}, "lights": [{"position": [3, 5, 9]}],
      "meshes": {"b": {"builtin": "icosphere:2"}, "g": {"builtin": "gears:1"}},
      "objects": [{"mesh": "b", "keyframes": [{"time": 0, "scale": [-1, 0.4, 1.5]}, {"time": 1, "scale": [-0.5, 1, 1]}],
                   "instances": [{"translate": [1, 1, 0]}, {"matrix": [1, 0.7, 0, -2,  0, 1, 0, -1,  0, 0.3, 1, 0,  0, 0, 0, 1]}]},
                  {"mesh": "g", "keyframes": [{"time": 0, "matrix": [1,0,0,0, 0,1,0,0, 0,0,-1,0, 0,0,0,1]},
                                              {"time": 1, "matrix": [1,0.5,0,1, 0,1,0,0, 0,0,-1,0, 0,0,0,1]}]}]})");
    Film film = film_of(path, two("default", 2), {96, 72}, frames_of(3, 3));
    for (std::size_t f = 0; f < film.frames(); ++f) {
        film.next();
        const RecordedFrame trace = film.record(1, {});
        CHECK_FALSE(trace.upload.is_whole);
        const Scene& scene = film.request().scene;
        CHECK(compare(shade(scene, hits_of(film.job(), trace)),
                      shade(scene, Reference(scene).frame(film.camera(), {96, 72}, 1)))
                  .psnr_db >= 40);
    }
}

TEST_CASE("a frame whose instances become too flat is compiled anew and correct", "[motion][film]") {
    const SceneFolder folder;
    const std::string path = folder.write("flat.json", R"({
      "camera": {"eye": [0, 1, 9], "at": [0, 0, 0]}, "lights": [{"position": [3, 5, 9]}],
      "meshes": {"b": {"builtin": "icosphere:2"}},
      "objects": [{"mesh": "b", "keyframes": [{"time": 0, "matrix": [1.01, -1, 0, -2,  -1, 1, 0, 0,  0, 0, 1, 0,  0, 0, 0, 1]},
                                              {"time": 1, "matrix": [1.01, -1, 0, 2,  -1, 1, 0, 0,  0, 0, 1, 0,  0, 0, 0, 1]}]}]})");
    Film film = film_of(path, two("default", 2), {64, 48}, frames_of(3, 3));
    for (std::size_t f = 0; f < film.frames(); ++f) {
        film.next();
        const RecordedFrame trace = film.record(1, {});
        CHECK(trace.upload.is_whole);
        const Scene& scene = film.request().scene;
        CHECK(compare(shade(scene, hits_of(film.job(), trace)),
                      shade(scene, Reference(scene).frame(film.camera(), {64, 48}, 1)))
                  .psnr_db >= 40);
    }
    CHECK_THROWS_WITH(film_of(path, two("default", 2), {64, 48}, frames_of(3, 3, "double")),
                      Catch::Contains("--uploads double"));
}

TEST_CASE("model and RTL draw the same film with the writes of the host in between", "[motion][film]") {
    const Config config = GENERATE(from_range(chips()));
    for (const char* uploads : {"between", "double"}) {
        INFO(config.name << ", " << uploads);
        Film film = film_of("crowd:1", config, {16, 12}, frames_of(4, 4, uploads));
        const Recorded made = recorded(film);
        REQUIRE(made.traces[1].upload.lines.size() > 2);
        CHECK_FALSE(same(made.traces[0].trace.hits, made.traces[1].trace.hits));
        check_lockstep(made.job, made.traces);
        check_lockstep(made.job, made.traces, {9, 30, 77}, 77);
        const std::vector<FrameResult> runs = run_rtl(made.job, made.job.khz, made.traces);
        const std::vector<FrameTiming> timings = replay(made.job.config, made.job.khz, made.traces);
        REQUIRE(runs.size() == 4);
        for (std::size_t f = 0; f < runs.size(); ++f) {
            CHECK(runs[f].cycles == timings[f].cycles);
            CHECK(runs[f].upload.cycles == timings[f].upload.cycles);
            CHECK(runs[f].upload.reset == timings[f].upload.reset);
            CHECK(runs[f].upload.lines == made.traces[f].upload.lines.size());
            CHECK(same(runs[f].answers, made.traces[f].trace.hits));
            CHECK((runs[f].upload.reset > 0) == made.traces[f].upload.resets);
            if (std::string(uploads) == "between")
                CHECK(runs[f].upload.cycles >= made.traces[f].upload.lines.size());
        }
    }
}

TEST_CASE("model and RTL draw the same finished film, and a reset empties the largest cache",
          "[motion][film]") {
    const Request request = finished_request("flight:3");
    REQUIRE(request.config.surf_sets > std::max(request.config.node_sets, request.config.prim_sets));
    Film film(request, frames_of(3, 4), false, {24, 18});
    const Recorded made = recorded(film);
    REQUIRE(made.traces[1].upload.resets);
    CHECK(made.traces[0].trace.colours != made.traces[1].trace.colours);
    check_lockstep(made.job, made.traces);
    check_lockstep(made.job, made.traces, {9, 30, 77}, 77);
}

TEST_CASE("a scene of one level that moves is made anew for every frame, shadows and mirrors with it",
          "[motion][film]") {
    Request request;
    request.scene = load_scene("flight:3");
    request.settings = {};
    request.settings.depth = 2;
    request.config = fitted_config(request.scene, request.settings, named_config("default"));
    request.finished = true;
    Film film(request, frames_of(2, 2), false, {16, 12});
    const Recorded made = recorded(film);
    CHECK(made.traces[1].upload.is_whole);
    CHECK(made.traces[1].upload.resets);
    CHECK(made.traces[0].trace.colours != made.traces[1].trace.colours);
    // The first frame uploads the whole image, for any content of the memory.
    CHECK(made.traces[0].upload.lines.size() == made.traces[0].upload.image_lines);
}

TEST_CASE("a film of two levels has finished pictures, and its light moves", "[motion][film]") {
    constexpr FrameSize size{64, 48};
    Request request;
    request.scene = load_scene("flight:20");
    request.settings.depth = 2;
    request.config =
        fitted_config(request.scene, request.settings, with(named_config("default"), {{"levels", 2}}));
    request.finished = true;
    Film film(request, frames_of(3, 1.5), false, size);
    for (std::size_t f = 0; f < film.frames(); ++f) {
        film.next();
        const RecordedFrame trace = film.record(1, {});
        CHECK_FALSE(trace.upload.is_whole);
        const WhittedFrame right =
            Reference(film.request().scene).whitted(film.camera(), size, request.settings, 1);
        CHECK(right.rays.shadow > 1000);
        Picture own{size, {}}, other{size, {}};
        for (const std::array<std::uint32_t, 3>& c : trace.trace.colours)
            own.pixels.push_back(glm::vec3(c[0], c[1], c[2]) / 65536.0f);
        for (const glm::dvec3& pixel : right.pixels) other.pixels.push_back(glm::vec3(pixel));
        CHECK(compare(own, other).psnr_db >= 40);
    }
}

TEST_CASE("the times of frames are the requested ones", "[motion][film]") {
    FramesOptions o;
    CHECK(frame_times(o, true).times == std::vector<double>{0});
    o.frames = 3;
    CHECK(frame_times(o, true).times == std::vector<double>{0, 0.04, 0.08});
    o.fps = 2;
    CHECK(frame_times(o, true).times == std::vector<double>{0, 0.5, 1});
    o.time = "1.5";
    CHECK(frame_times(o, true).times == std::vector<double>{1.5, 2, 2.5});
    o.fps.reset();
    o.time = "1:4";
    CHECK(frame_times(o, true).times == std::vector<double>{1, 2, 3});
    o.frames = 1, o.fps = 2;
    CHECK(frame_times(o, true).times == std::vector<double>{1, 1.5, 2, 2.5, 3, 3.5});
    const auto refused = [](int frames, std::optional<double> fps, const std::string& time,
                            const std::string& part) {
        FramesOptions bad;
        bad.frames = frames, bad.fps = fps, bad.time = time;
        CHECK_THROWS_WITH(frame_times(bad, true), Catch::Contains(part));
    };
    refused(0, {}, "", "--frames must lie in 1..1000, not 0");
    refused(1, 0.0, "", "--fps must lie in");
    refused(1, {}, "2:2", "length 0");
    refused(1, {}, "3:2", "ends before");
    refused(1, {}, "x", "is not a time");
    refused(1, {}, "-1", "is not a time");
    refused(1, {}, "nan", "is not a time");
    refused(2, 4.0, "0:1", "say the same twice");
    refused(1, 1000.0, "0:2", "2000 frames");
}

// A part of a picture (--pixels): its pixels are those of the whole, and model and RTL agree on it.
#include <catch2/catch.hpp>

#include "sim/load/load.hpp"
#include "tests/support/machine/frames.hpp"

namespace rayclock::test::window_test {

using namespace rayclock;

namespace {

constexpr FrameSize whole{41, 30}, part{13, 9};
constexpr PictureWindow window{20, 11, whole.width, whole.height};

Job job_of(Scene scene, FrameSize size, const Config& config, const std::optional<PictureWindow>& of) {
    scene.camera->window = of;
    return make_job(scene, *scene.camera, size, config);
}
Trace traced(const Scene& scene, FrameSize size, const Config& config,
             const std::optional<PictureWindow>& of) {
    const Job job = job_of(scene, size, config, of);
    return record_frame(job, job.frame).trace;
}

std::size_t place_in_whole(int x, int y) { return std::size_t((y + window.y) * whole.width + x + window.x); }

}   // namespace

TEST_CASE("the hits of a part are those of the whole picture", "[window]") {
    for (const char* name : {"gears:1", "tree:2"}) {
        INFO(name);
        const Scene scene = load_scene(name);
        const Config config = named_config("default");
        const Trace all = traced(scene, whole, config, {}), some = traced(scene, part, config, window);
        std::size_t found = 0, different = 0;
        for (int y = 0; y < part.height; ++y)
            for (int x = 0; x < part.width; ++x) {
                const Closest &a = all.hits[place_in_whole(x, y)],
                              &b = some.hits[std::size_t(y * part.width + x)];
                found += b.found;
                different += a.found != b.found || (a.found && (a.prim != b.prim || a.t != b.t));
            }
        CHECK(found > 20);
        CHECK(different == 0);
    }
}

TEST_CASE("the colours of a part are those of the whole picture, textures included", "[window]") {
    const Scene scene = load_scene("room");
    const Config config = with(named_config("default"), {{"shading", 1}, {"textures", 1}, {"smooth", 1}});
    const Trace all = traced(scene, whole, config, {}), some = traced(scene, part, config, window);
    std::size_t different = 0;
    for (int y = 0; y < part.height; ++y)
        for (int x = 0; x < part.width; ++x)
            different += all.colours[place_in_whole(x, y)] != some.colours[std::size_t(y * part.width + x)];
    CHECK(different == 0);
}

TEST_CASE("model and RTL agree on a part of a picture", "[window]") {
    check_lockstep(job_of(load_scene("gears:1"), part, quick_config("small"), window));
}

}   // namespace rayclock::test::window_test

// A pixel's story is exact to the cycle.
#include <map>

#include "tests/observe/watched.hpp"

using namespace rayclock;
using namespace rayclock::test;

namespace {

PixelStory story_of(const Watching& made, const Watched& w, std::uint32_t pixel) {
    PixelEvents in_frame(pixel), alone(0);
    const FrameCosts costs = observe(made.job.config, 66000, made.traces, w.disturbance, 0, &in_frame);
    observe_alone(made.job.config, 66000, made.traces.back(), pixel, &alone);
    return make_story(made.job, made.traces.back(), costs, in_frame, alone);
}

/// A list's pages are visited without a request.
bool is_list(const RayStory& ray) {
    for (const Stay& stay : ray.stays)
        if (stay.by == Link::node_req) return false;
    return true;
}

void check_story(const PixelStory& story) {
    std::uint64_t cycles = 0, visits = 0, tests = 0, misses = 0, at = story.cost.first;
    for (const RayStory& ray : story.rays) {
        CHECK(ray.first == at);
        std::size_t seen_visits = 0, seen_tests = 0;
        for (const Stay& stay : ray.stays) {
            CHECK(stay.first == at);
            at += stay.cycles;
            std::uint64_t sum = stay.work;
            for (const Stay::Wait& wait : stay.waits) sum += wait.cycles;
            CHECK(sum == stay.cycles);
            seen_visits += stay.by == Link::leaves && is_list(ray);
            if (stay.by == Link::node_req) CHECK(stay.addr == ray.values.visits.at(seen_visits++).line);
            seen_tests += stay.by == Link::prim_req;
        }
        CHECK(ray.first + ray.cycles == at);
        CHECK(seen_visits == ray.values.visits.size());
        std::size_t told = 0;
        for (const VisitValues& visit : ray.values.visits) told += visit.tests.size();
        CHECK(told == seen_tests);
        cycles += ray.cycles, visits += seen_visits, tests += seen_tests, misses += ray.misses + ray.merges;
    }
    CHECK(cycles == story.cost.cycles);
    CHECK(visits == story.cost.visits);
    CHECK(tests == story.cost.tests);
    CHECK(misses == story.cost.misses);
    CHECK(story.rays.size() == story.cost.rays);
    std::uint64_t by_cause = 0, work = 0;
    for (const Stay::Wait& cause : story.causes()) {
        by_cause += cause.cycles;
        if (cause.cause == "work") work = cause.cycles;
    }
    CHECK(by_cause == cycles);
    CHECK(work <= story.alone);   // which may wait for the memory, if its lines do not fit the caches
}

}   // namespace

TEST_CASE("a pixel's stays follow each other without a gap and sum to its cycles") {
    for (const Watched& w : watched_machines()) {
        const Watching made = watching(w);
        for (const std::uint32_t pixel : {0u, 14u * 37 + 18, 29u * 37 - 1}) {
            INFO(w.scene << ", case " << (&w - watched_machines().data()) << ", pixel " << pixel);
            check_story(story_of(made, w, pixel));
        }
    }
}

TEST_CASE("a pixel that is alone on the chip waits for nobody but the memory") {
    for (const Watched& w : watched_machines()) {
        if (!w.disturbance.none()) continue;
        const Watching made = watching(w, {1, 1});
        const PixelStory story = story_of(made, w, 0);
        check_story(story);
        for (const Stay::Wait& cause : story.causes()) {
            INFO(w.scene << ": " << cause.cause);
            CHECK((cause.cause == "work" || cause.cause == "the memory"));
        }
    }
}

TEST_CASE("a pixel that waits has a cause for every wait") {
    const Watched narrow{"mount:4",
                         {{"node_sets", "1"}, {"node_ways", "2"}, {"node_mshrs", "1"}, {"prim_sets", "1"}}};
    const Watching made = watching(narrow, {16, 12});
    std::map<std::string, std::uint64_t> causes;
    for (std::uint32_t pixel = 0; pixel < 192; pixel += 11)
        for (const Stay::Wait& cause : story_of(made, narrow, pixel).causes())
            causes[cause.cause] += cause.cycles;
    for (const char* cause :
         {"the memory", "node_cache: too many lines are on their way",
          "node_cache: rays that waited for a line are answered", "node_cache accepts nothing",
          "trav accepts nothing", "node_cache: other rays are looked up first"}) {
        INFO(cause);
        CHECK(causes[cause] > 0);
    }
}

TEST_CASE("each ray of a pixel has its purpose and its parent") {
    const Watched& w = watched_machines()[4];
    const Watching made = watching(w);
    const std::vector<RayValues> rays =
        rays_of_pixel(made.job.image, made.traces[0].frame, made.job.config, 18, 14);
    REQUIRE(rays.size() > 3);
    CHECK(rays[0].purpose == RayPurpose::camera);
    CHECK(rays[0].parent == -1);
    for (std::size_t i = 1; i < rays.size(); ++i) {
        REQUIRE(rays[i].parent >= 0);
        REQUIRE(std::size_t(rays[i].parent) < i);
        const RayValues& parent = rays[std::size_t(rays[i].parent)];
        CHECK(parent.hit.found);
        CHECK(parent.purpose != RayPurpose::shadow);
        CHECK(rays[i].depth == parent.depth + (rays[i].purpose != RayPurpose::shadow));
    }
}

TEST_CASE("each ray of a pixel with holes has its purpose and its parent, and its stays have no gap") {
    const Watched w{"room", {}, true};
    const Watching made = watching(w, {24, 18});
    REQUIRE(made.job.config.has_textures());
    int continued = 0, sent_again = 0;
    for (std::uint32_t pixel = 0; pixel < 24 * 18; ++pixel) {
        INFO("pixel " << pixel);
        const std::vector<RayValues> rays =
            rays_of_pixel(made.job.image, made.traces[0].frame, made.job.config, pixel % 24, pixel / 24);
        CHECK(rays.at(0).parent == -1);
        for (std::size_t i = 1; i < rays.size(); ++i) {
            INFO("ray " << i);
            REQUIRE(rays[i].parent >= 0);
            REQUIRE(std::size_t(rays[i].parent) < i);
            const RayValues& parent = rays[std::size_t(rays[i].parent)];
            CHECK(parent.hit.found);
            CHECK(parent.purpose != RayPurpose::shadow);
            const bool is_shadow = ends_at_any(rays[i].ray.kind);
            CHECK((rays[i].purpose == RayPurpose::shadow) == is_shadow);
            const bool goes_on = !is_shadow && rays[i].depth == parent.depth;
            if (goes_on) CHECK((rays[i].purpose == RayPurpose::refraction && rays[i].ray.d == parent.ray.d));
            CHECK(rays[i].depth == parent.depth + (is_shadow || goes_on ? 0 : 1));
            continued += goes_on;
            if (rays[i].ray.holes == 0) continue;
            // The same ray as the one before it, which has met a cut-out.
            const RayValues& before = rays[i - 1];
            CHECK((rays[i].ray.o == before.ray.o && rays[i].ray.d == before.ray.d));
            CHECK((rays[i].ray.holes == before.ray.holes + 1 && before.hit.cutout != 0));
            CHECK((rays[i].parent == before.parent && rays[i].purpose == before.purpose));
            ++sent_again;
        }
        if (pixel % 7 == 0) check_story(story_of(made, w, pixel));
    }
    CHECK((continued > 10 && sent_again > 10));
}

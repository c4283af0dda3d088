// The judge in two levels: it accepts correct pictures, judges all of their rays, and detects any
// modification of the machine's output, the memory or the placement of instances.
#include <functional>

#include <catch2/catch.hpp>

#include <glm/gtc/matrix_transform.hpp>

#include "model/compile/surfaces.hpp"
#include "model/layout/words.hpp"
#include "sim/judge/reference/reference.hpp"
#include "sim/judge/cause/finished.hpp"
#include "sim/judge/paths/answer.hpp"
#include "sim/judge/paths/camera.hpp"
#include "sim/judge/paths/judge_picture.hpp"
#include "sim/judge/paths/placed.hpp"
#include "tests/support/levels/finished_instances.hpp"
#include "tests/support/levels/closed_instances.hpp"
#include "tests/support/machine/frames.hpp"

namespace rayclock::test::judge_levels_test {

using namespace rayclock;
using namespace rayclock::test;

namespace {

constexpr FrameSize size{40, 30};

/// A picture of the model, for modification.
struct Case {
    PlacedScene placed;
    Scene scene;
    Whitted settings;
    Job job;
    RecordedFrame trace;

    Case(PlacedScene of, bool is_finished, const Config& config, int depth = 3, int aa = 1)
        : placed(std::move(of)), scene(flattened(placed)) {
        settings.depth = depth, settings.aa = aa;
        Config units = with(config, {{"levels", 2}, {"stack_depth", 64}});
        if (is_finished) units = fitted_config(scene, settings, units);
        job = make_job(scene, *scene.camera, size, units, {}, settings);
        trace = record_frame(job, job.frame);
    }
    FrameInputs inputs() const { return {scene, *scene.camera, trace.frame, job.image.lattice, job.config}; }
    PictureJudgement judged() const {
        return judge_picture(inputs(), job.image, settings,
                             {trace.trace.hits, trace.trace.colours, trace.trace.signatures});
    }
    Judgement judged_hits() const {
        const HitFrame reference = Reference(scene).frame(*scene.camera, size);
        const Picture picture = shade(scene, scaled(job, job.frame, trace.trace.hits));
        return judge(inputs(), job.image, {reference, trace.trace.hits, picture});
    }
    /// Replaces the placement of the instances.
    void move(const std::function<void(PlacedScene&)>& change) {
        change(placed);
        scene = flattened(placed);
    }
    std::uint32_t line_of(std::uint32_t first) const {
        for (std::uint32_t line = 0; line < job.image.lines(); ++line)
            if (line_kind(job.image.line(line)) == LineKind::placement &&
                unpack<Placement>(job.image.line(line), job.config).first == first)
                return line;
        FAIL("no such instance");
        return 0;
    }
    void change_line(std::uint32_t line, const std::function<void(Placement&)>& change) {
        Placement map = unpack<Placement>(job.image.line(line), job.config);
        change(map);
        std::uint32_t* const words = &job.image.words[std::size_t(line) * 16];
        std::fill_n(words, 16, 0u);
        Words scratch;
        write_payload(map, job.config, words, scratch);
        set_line_kind(words, LineKind::placement);
    }
};

/// Balls and cubes at random places, turned, sheared, mirrored and of any size, with mirrors.
PlacedScene anywhere(double least, double most, double shear) {
    PlacedScene scene = solids(10, 7, least, most, shear);
    scene.own.materials = {coloured({0.6, 0.5, 0.4}, 0.4, 0), coloured({0.2, 0.5, 0.8}, 0.7, 0)};
    scene.own.lights = {{{6, 9, 4}, glm::dvec3(0.8)}};
    scene.own.camera = Camera{{9, 7, 8}, {0, 0, 0}, {0, 1, 0}, 50};
    for (std::size_t i = 0; i < scene.instances.size(); i += 3) scene.instances[i].material = 1;
    return scene;
}

Config formats(int coord_bits, int dir_bits, int origin_bits) {
    return with(named_config("default"),
                {{"coord_bits", coord_bits}, {"dir_bits", dir_bits}, {"origin_bits", origin_bits}});
}

void check_sound(const Case& made) {
    const PictureJudgement j = made.judged();
    for (const PictureFault& f : j.faults)
        FAIL_CHECK("pixel (" << f.x << ", " << f.y << "), after ray " << f.ray << ": " << f.what);
    CHECK(j.wrong == 0);
    CHECK(j.colours == made.trace.trace.colours.size());
    const RayCounts& sent = made.trace.trace.counts;
    CHECK(j.rays.primary == sent.primary);
    CHECK(j.rays.shadow == sent.shadow);
    CHECK(j.rays.reflection == sent.reflection);
    CHECK(j.rays.refraction <= sent.refraction);
    CHECK(sent.shadow > 100);
    CHECK(sent.reflection > 100);
}

}   // namespace

TEST_CASE("every ray and colour of a sound picture of instances is right, and all are judged",
          "[judge][levels]") {
    for (const bool is_smooth : {false, true})
        check_sound(Case(mixed(is_smooth), true, named_config("default"), 5));
    check_sound(Case(mixed(true), true, named_config("small"), 3, 2));
    check_sound(Case(under_a_pane(), true, named_config("default"), 4));   // rays that are too short
    for (const auto& [n, m, b] :
         std::vector<std::tuple<int, int, int>>{{12, 14, 12}, {16, 18, 12}, {20, 20, 10}}) {
        INFO("N " << n << " M " << m);
        check_sound(Case(mixed(false), true, formats(n, m, b)));
        check_sound(Case(anywhere(0.4, 2, 1), true, formats(n, m, b)));
    }
}

TEST_CASE("every ray is judged in scenes of planes, true spheres and instances, in every structure",
          "[judge][levels]") {
    for (const Structure structure : tree_structures()) {
        INFO(name_of(structure));
        check_sound(Case(mixed_with_round(false), true, of_structure(named_config("default"), structure), 5));
    }
    check_sound(Case(mixed_with_round(true), true, named_config("small"), 3, 2));
    check_sound(Case(mixed_with_round(false), true, formats(16, 18, 12)));
    for (const char* name : {"spheres", "plane", "mirrors"}) {
        INFO(name);
        PlacedScene placed;
        placed.own = make_builtin(name, Primitives::native);
        const Case made(placed, true, named_config("default"), 4);
        const PictureJudgement j = made.judged();
        CHECK(j.wrong == 0);
        CHECK(j.rays.shadow == made.trace.trace.counts.shadow);
    }
}

TEST_CASE("an answer of planes and true spheres next to instances with any fault is wrong",
          "[judge][levels]") {
    const Case made(mixed_with_round(false), true, named_config("default"), 2);
    const FrameInputs inputs = made.inputs();
    const PlacedWorld world(inputs, made.job.image);
    REQUIRE(world.faults().empty());
    const std::vector<Closest>& hits = made.trace.trace.hits;
    const auto first = std::uint32_t(made.scene.triangles.size()), plane = first + 2;
    const auto judged = [&](std::size_t at, const Closest& answer) {
        const std::uint32_t x = std::uint32_t(at) % size.width, y = std::uint32_t(at) / size.width;
        Ray ray;
        ray.d = exact_direction(inputs.frame, inputs.config, made.settings, int(x), int(y), 0);
        for (std::size_t k = 0; k < 3; ++k)
            ray.o[k] = inputs.frame.eye[k] * (1 << inputs.config.origin_frac());
        const char* const wrong = judge_answer(world, inputs.config, ray, answer);
        return std::string(wrong ? wrong : "");
    };
    const auto seen_plane =
        std::find_if(hits.begin(), hits.end(), [&](const Closest& c) { return c.found && c.prim == plane; });
    REQUIRE(seen_plane != hits.end());
    const auto placed = [&](Closest answer) {   // a pixel's hit does not contain it
        answer.instance_line = world.line(world.place_of(answer.prim));
        return answer;
    };
    int spheres = 0, planes = 0, triangles = 0, hidden = 0;
    for (std::size_t at = 0; at < hits.size(); ++at) {
        if (!hits[at].found) continue;
        INFO("pixel " << at);
        const Closest answer = placed(hits[at]);
        const auto says = [&](const std::function<void(Closest&)>& change) {
            Closest other = answer;
            change(other);
            return judged(at, other);
        };
        CHECK(says([](Closest&) {}) == "");
        CHECK(says([](Closest& c) { c = {}; }) == "it meets something");
        CHECK(says([](Closest& c) { --c.t; }) != "");
        CHECK(says([](Closest& c) { c.instance_line ^= 1; }) == "it meets another instance");
        if (answer.prim < first) {
            ++triangles;
            CHECK(says([&](Closest& c) { c.prim = first; }) != "");
        } else if (answer.prim < plane) {
            ++spheres;
            CHECK(says([](Closest& c) { c.t += 64; }) ==
                  "t is farther behind the sphere's than it may be rounded");
            CHECK(says([&](Closest& c) { c.prim ^= 1; }) != "");
            hidden += says([&](Closest& c) { c = placed(*seen_plane); }) == "a sphere is closer";
        } else {
            ++planes;
            CHECK(says([](Closest& c) { ++c.t; }) == "t is not the exact one, rounded up");
            CHECK(says([&](Closest& c) { c.prim = first; }) == "it misses that sphere");
        }
    }
    CHECK(spheres > 10);
    CHECK(planes > 10);
    CHECK(triangles > 10);
    CHECK(hidden > 10);
}

TEST_CASE(
    "whichever way instances are turned, sheared, mirrored and scaled, the judge finds a sound picture right",
    "[judge][levels]") {
    const auto [least, most, shear] = GENERATE(values<std::tuple<double, double, double>>(
        {{0.5, 0.5, 0}, {0.02, 3, 0}, {0.3, 2, 3}, {1e-3, 1e3, 0}, {0.2, 2, 40}}));
    INFO(least << " to " << most << ", shear " << shear);
    for (const auto& [n, m] : std::vector<std::pair<int, int>>{{12, 12}, {16, 24}, {18, 20}, {20, 18}}) {
        INFO("N " << n << " M " << m);
        const Case made(anywhere(least, most, shear), false, formats(n, m, 10));
        const Judgement j = made.judged_hits();
        for (const PictureFault& f : j.faults) FAIL_CHECK("pixel (" << f.x << ", " << f.y << "): " << f.what);
        CHECK(j.wrong == 0);
        CHECK(j.bugs() == 0);
        CHECK(j.rays.primary == std::uint64_t(size.width) * size.height);
    }
}

TEST_CASE("the judge sees a hit, a colour and a path that are not the frame's in two levels",
          "[judge][levels]") {
    Case made(mixed(false), true, named_config("default"));
    REQUIRE(made.judged().wrong == 0);
    const std::size_t at = 15 * 40 + 20;
    REQUIRE(made.trace.trace.hits[at].found);
    SECTION("a colour") { ++made.trace.trace.colours[at][1]; }
    SECTION("a hit") { made.trace.trace.hits[at].v += 1; }
    SECTION("a path") { made.trace.trace.signatures[at] ^= 1; }
    const PictureJudgement j = made.judged();
    CHECK(j.wrong == 1);
    CHECK(j.pixels[at]);
}

TEST_CASE("the judge sees memory that does not hold the scene's instances", "[judge][levels]") {
    Case made(mixed(true), true, named_config("default"));
    REQUIRE(made.judged().wrong == 0);
    const auto says = [&](const std::string& what) {
        const PictureJudgement j = made.judged();
        CHECK(j.wrong > 0);
        REQUIRE(!j.faults.empty());
        INFO(j.faults[0].what);
        CHECK(j.faults[0].what.find(what) != std::string::npos);
    };
    const std::uint32_t line = made.line_of(2);   // the first ball, after two triangles of the floor
    SECTION("another map by a unit") {
        made.change_line(line, [](Placement& p) { p.a[4] -= 2; });
        says("instance 0 has another map in memory than its place");
    }
    SECTION("another place by a unit") {
        made.change_line(line, [](Placement& p) { p.b[2] += 2; });
        says("instance 0 has another map in memory than its place");
    }
    SECTION("another instance's numbers") {
        const std::uint32_t count = std::uint32_t(made.placed.meshes[0].triangles.size());
        made.change_line(line, [&](Placement& p) { p.first += count; });
        says("is placed 0 times by memory");
    }
    SECTION("numbers of none") {
        made.change_line(line, [](Placement& p) { p.first += 1; });
        says("places no instance of the scene");
    }
    SECTION("another line") {
        made.change_line(line, [](Placement& p) { p.here += 1; });
        says("instance 0 is told that it lies in another line of memory");
    }
    SECTION("a turned instance that is said to be where the scene is") {
        made.change_line(line, [](Placement& p) { p.is_same = 1; });
        says("instance 0 is said to be placed by the identity, and is not");
    }
    SECTION("the scene's own mesh, and memory does not say so") {
        made.change_line(made.line_of(0), [](Placement& p) { p.is_same = 0; });
        says("the scene's own mesh is placed by the identity, and memory does not say so");
    }
    SECTION("another material") {
        made.change_line(made.line_of(2 + 1280), [](Placement& p) { p.material = 0; });
        const PictureJudgement j = made.judged();
        CHECK(j.wrong > 10);
        CHECK(j.faults[0].what == "memory does not hold the surface that was hit");
    }
    SECTION("an instance that has moved since") {
        made.move([](PlacedScene& s) { s.instances[3].place[3].y += 1e-3; });
        says("instance 3 has another map in memory than its place");
    }
    SECTION("a material that has changed since") {
        made.move([](PlacedScene& s) { s.own.materials[1].diffuse += 0.001; });
        CHECK(made.judged().wrong > 10);
    }
    SECTION("a corner that has moved since") {
        made.move([](PlacedScene& s) { s.meshes[0].vertices[7] *= 1.001; });
        CHECK(made.judged().wrong > 0);
    }
}

TEST_CASE("an answer of a machine of two levels that is off in anything is a bug", "[judge][levels]") {
    Case made(anywhere(0.4, 2, 1), false, named_config("default"));
    REQUIRE(made.judged_hits().wrong == 0);
    std::vector<Closest>& hits = made.trace.trace.hits;
    std::size_t hit = 0, miss = 0;
    while (!hits[hit].found || hits[hit].t < 2) ++hit;
    while (hits[miss].found) ++miss;
    const auto one_wrong = [&](std::size_t at, const std::function<void(Closest&)>& change) {
        const Closest before = hits[at];
        change(hits[at]);
        const Judgement j = made.judged_hits();
        CHECK(j.wrong == 1);
        CHECK(j.bugs() == 1);
        CHECK(j.pixels[at] == PixelCause::bug);
        hits[at] = before;
    };
    const Closest other = hits[hit];
    one_wrong(hit, [](Closest& c) { c = {}; });
    one_wrong(hit, [](Closest& c) { ++c.t; });
    one_wrong(hit, [](Closest& c) { ++c.u; });
    one_wrong(hit, [](Closest& c) { c.prim ^= 1; });
    one_wrong(miss, [&](Closest& c) { c = other; });
}

}   // namespace rayclock::test::judge_levels_test

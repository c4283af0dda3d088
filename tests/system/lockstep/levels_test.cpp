// Two levels: model and RTL walk instances equally, and the transformation of rays into instances does not
// change hits.
#include <algorithm>

#include <catch2/catch.hpp>

#include "tests/support/machine/structures.hpp"
#include "tests/support/levels/picture.hpp"
#include "tests/support/machine/build_all.hpp"
#include "tests/support/machine/frames.hpp"

namespace rayclock::test::levels_test {

using namespace rayclock;
using namespace rayclock::test;

namespace {

Config two(const std::string& name, int interval, const Values& more = {}) {
    Values values{{"levels", 2}, {"xform_interval", interval}};
    values.insert(values.end(), more.begin(), more.end());
    return with(quick_config(name), values);
}

Config of(const std::string& name, Structure structure, int interval, Values more = {}) {
    more.insert(more.begin(), {"structure", int(structure)});
    return two(name, interval, more);
}

/// Value of mesh_structure.
int mesh(Structure structure) { return int(choice_named<MeshStructure>(name_of(structure))); }
const Values fast{{"timing", 1}, {"raygen_queue", 32}, {"box_queue", 32}, {"tri_queue", 64}};
Config both(const std::string& name, Structure upper, Structure lower, int interval, Values more = {}) {
    more.insert(more.begin(), {"mesh_structure", mesh(lower)});
    return of(name, upper, interval, more);
}

/// Returns chips with two structures.
const std::vector<Config>& two_engines() {
    static const std::vector<Config> all{
        // The lower unit has a longer interval.
        both("default", Structure::octree, Structure::bvh, 1, {{"box_lanes", 2}}),
        both("small", Structure::spheres, Structure::bsp, 2, {{"box_queue", 4}}),   // the door closes
        both("small", Structure::bsp, Structure::spheres, 4, fast)};
    return all;
}

/// Returns formats, and the engines that two_engines() does not have above, each with its own RTL.
const std::vector<Config>& chips() {
    static const std::vector<Config> all = [] {
        std::vector<Config> made{two("default", 2), two("narrow", 4)};
        for (const Structure s : engines())
            if (s != Structure::bvh && std::none_of(two_engines().begin(), two_engines().end(),
                                                    [&](const Config& c) { return c.engine() == s; }))
                made.push_back(of("small", s, 2));
        return made;
    }();
    return all;
}

/// Returns the chips of the slow tests.
const std::vector<Config>& more_chips() {
    static const std::vector<Config> all = [] {
        std::vector<Config> made{two("small", 4), two("small", 1, fast), two("broad", 2),
                                 of("default", Structure::spheres, 1),
                                 of("small", Structure::spheres, 4, fast)};
        for (const Structure s : engines())
            if (s != Structure::bvh && s != Structure::spheres) made.push_back(of("small", s, 2));
        return made;
    }();
    return all;
}

}   // namespace

TEST_CASE("the RTL of two levels builds", "[.build]") {
    std::vector<RtlJob> jobs;
    for (const auto& some : {chips(), two_engines()})
        for (const Config& config : some) jobs.push_back({"rc_chip", config.name + ", two levels", config});
    REQUIRE_NOTHROW(build_all(jobs));
}

namespace {
void check_gearboxes(const Config& config) {
    INFO(config.name << ", " << name_of(config.structure) << " over " << name_of(config.lower_structure())
                     << ", every " << config.xform_interval);
    const Shot shot = make_deep_shot("gearbox:1", {32, 24}, config);
    check_lockstep(shot.job);
    const FrameSize small{12, 9};
    check_lockstep(make_deep_shot("gearbox:2", small, config).job, {9, 30, 77}, 77);
    check_lockstep(make_deep_shot("teapot:3", small, config).job);   // one instance: the scene itself
}
}   // namespace

TEST_CASE("model and RTL walk instances alike", "[levels]") {
    check_gearboxes(GENERATE(from_range(chips())));
}

TEST_CASE("model and RTL walk two structures alike", "[levels]") {
    check_gearboxes(GENERATE(from_range(two_engines())));
}

TEST_CASE("model and RTL walk instances alike, more chips", "[levels][slow]") {
    check_gearboxes(GENERATE(from_range(more_chips())));
}

TEST_CASE("model and RTL walk two structures alike, an upper unit of a longer interval", "[levels][slow]") {
    check_gearboxes(both("small", Structure::bvh, Structure::kd, 2, {{"box_lanes", 1}}));
}

TEST_CASE("two levels of any two structures hit the same, bit for bit", "[levels]") {
    const auto answers = [](Structure upper, Structure lower) {
        return run_model(make_shot("gearbox:4", {40, 30}, both("default", upper, lower, 2)).job).answers;
    };
    const std::vector<Closest> right = answers(Structure::bvh, Structure::bvh);
    const Structure upper = GENERATE(from_range(tree_structures()));
    for (const Structure lower : tree_structures()) {
        const std::vector<Closest> got = answers(upper, lower);
        REQUIRE(got.size() == right.size());
        std::size_t wrong = 0;
        for (std::size_t i = 0; i < got.size(); ++i) {
            const Closest &a = got[i], &b = right[i];
            wrong += a.found != b.found || a.prim != b.prim || a.t != b.t || a.u != b.u || a.v != b.v;
        }
        INFO(name_of(upper) << " over " << name_of(lower));
        CHECK(wrong == 0);
    }
}

TEST_CASE("a machine of two levels hits what its rays hit alone, whatever the memory", "[levels]") {
    const Config config = two("default", GENERATE(1, 2, 4));
    const Scene scene = make_builtin("gearbox:2");
    const FrameSize size{40, 30};
    const LevelsPicture alone =
        trace_levels(compile_levels(*scene.placed, scene.camera->eye, config), *scene.camera, size, config);
    for (const Values& values : {Values{}, Values{{"dram", 0}, {"mem_latency", 60}, {"node_sets", 1}},
                                 Values{{"contexts", 1}, {"pipelines", 2}}}) {
        const Job job = make_shot("gearbox:2", size, with(config, values)).job;
        const FrameResult run = run_model(job, {20, 30, 5});
        REQUIRE(run.answers.size() == alone.answers.size());
        std::size_t wrong = 0;
        for (std::size_t i = 0; i < alone.answers.size(); ++i) {
            const Closest &a = run.answers[i], &b = alone.answers[i];
            wrong += a.found != b.found || a.prim != b.prim || a.t != b.t || a.u != b.u || a.v != b.v;
        }
        CHECK(wrong == 0);
        CHECK(run.visits == alone.counts.visits + alone.counts.changes);
        CHECK(run.triangle_tests == alone.counts.tests);
        CHECK(run.accounts.units[index(Unit::xform)][0] ==
              alone.counts.changes * std::uint64_t(config.xform_interval));
    }
}

}   // namespace rayclock::test::levels_test

// Structures: boxes, globes, planes, octants and a plain list hold the same scene, and rays hit the same in
// each. The RTL of each structure walks like its model.
#include <catch2/catch.hpp>

#include <memory>
#include <tuple>

#include "model/compile/compile.hpp"
#include "model/unit/raygen/raygen.hpp"
#include "model/engine/check.hpp"
#include "model/trace/walk.hpp"
#include "sim/load/load.hpp"
#include "sim/explore/stress/families.hpp"
#include "tests/support/machine/structures.hpp"
#include "tests/support/machine/build_all.hpp"
#include "tests/support/machine/frames.hpp"

using namespace rayclock;
using namespace rayclock::test;

namespace {

Config structured(Config config, Structure structure) {
    return with(config, {{"structure", int(structure)}});
}

/// Returns a configuration with the deeper stack that some structures need.
Config deep(const std::string& name, Structure structure) {
    Config config = structured(quick_config(name), structure);
    config.stack_depth = std::max(config.stack_depth, config.node_width == 2 ? 64 : 32);
    return config;
}

/// Returns every structure with every build rule.
std::vector<Config> all_structures(const Config& config) {
    std::vector<Config> all;
    all.push_back(structured(config, Structure::none));
    for (const Structure s : tree_structures()) {
        all.push_back(structured(config, s));
        if (s == Structure::octree) all.push_back(with(all.back(), {{"straddlers", int(Straddlers::inner)}}));
        if (s == Structure::bsp) all.push_back(with(all.back(), {{"straddlers", int(Straddlers::stop)}}));
    }
    all.push_back(with(structured(config, Structure::bvh), {{"splits", 1}}));
    return all;
}

/// Returns a fast chip that shades with all units.
Config shaded(Config config, Structure structure) {
    config = structured(config, structure);
    for (bool Config::*unit : {&Config::shading, &Config::spheres, &Config::planes, &Config::smooth,
                               &Config::refraction, &Config::supersampling})
        config.*unit = 1;
    config.stack_depth = 64;
    config.timing = Timing::fast;
    config.raygen_queue = config.box_queue = 32;
    config.tri_queue = 64;
    check_config(config, "test");
    return config;
}

bool same(const Closest& a, const Closest& b) {
    const auto fields = [](const Closest& c) { return std::tie(c.found, c.prim, c.t, c.u, c.v, c.back); };
    return fields(a) == fields(b);
}
bool same(const Trace& a, const Trace& b) {
    return std::equal(a.hits.begin(), a.hits.end(), b.hits.begin(), b.hits.end(),
                      [](const Closest& x, const Closest& y) { return same(x, y); });
}

/// Walks one ray after the other through one image.
class Walker {
public:
    Walker(const std::vector<PrimData>& prims, const Config& config)
        : config_(config),
          image_(compile_triangles(prims, config, "the case")),
          decoder_(image_, config),
          walk_(frame_, config_, decoder_) {}
    Closest closest(const stress::Shot& shot) {
        walk_.start_at(make_ray(shot.o, shot.d, config_));
        walk_.run(Nothing{});
        return walk_.closest();
    }

private:
    struct Nothing {
        static void visit(const auto&) {}
        static void test(std::uint32_t) {}
        static void decided(std::uint32_t, bool) {}
    };
    Config config_;
    MemoryImage image_;
    Frame frame_{};
    Decoder decoder_;
    Walk walk_;
};

void same_hits(const stress::Family& family, Config config, std::uint64_t seed, int rays) {
    INFO(family.name << ", " << config.coord_bits << " bits, seed " << seed);
    config.stack_depth = 64;
    Rng rng(seed);
    const stress::Case subject = family.make(config.coord_bits, config.dir_bits, rng);
    std::vector<PrimData> prims;
    for (const oracle::Corners& t : subject.mesh.triangles)
        prims.push_back({t.a, t.b, t.c, std::uint32_t(prims.size())});
    std::erase_if(prims, [&](const PrimData& t) { return !counts(t, config); });
    std::vector<std::unique_ptr<Walker>> walkers;
    for (const Config& c : all_structures(config)) walkers.push_back(std::make_unique<Walker>(prims, c));
    for (int i = 0; i < rays; ++i) {
        const stress::Shot shot = subject.shoot(rng);
        const Closest hit = walkers[0]->closest(shot);
        CAPTURE(i, shot.o[0], shot.o[1], shot.o[2], shot.d[0], shot.d[1], shot.d[2]);
        for (std::size_t k = 1; k < walkers.size(); ++k) {
            CAPTURE(k);
            REQUIRE(same(walkers[k]->closest(shot), hit));
        }
    }
}

Config lattice_of(int bits) {
    Config config;
    config.coord_bits = bits;
    config.dir_bits = std::min(24, 62 - 2 * bits);
    check_config(config, "test");
    return config;
}

Job finished(const std::string& name, FrameSize size, const Config& config) {
    Scene scene = load_scene(name, {}, Primitives::native);
    if (!scene.camera) scene.camera = fit_camera(scene, double(size.width) / size.height);
    return make_job(scene, *scene.camera, size, config, {}, Whitted{4});
}

}   // namespace

TEST_CASE("the RTL of the structures builds", "[.build]") {
    std::vector<RtlJob> jobs{{"rc_chip", "small, none", structured(quick_config("small"), Structure::none)}};
    for (const Structure s : {Structure::bvh, Structure::kd})
        jobs.push_back({"rc_chip", "default, " + name_of(s), deep("default", s)});
    for (const Structure s : engines())
        jobs.push_back({"rc_chip", name_of(s) + " of all units", shaded(quick_config("small"), s)});
    REQUIRE_NOTHROW(build_all(jobs));
}

TEST_CASE("rays of every family hit the same in every structure", "[structures][long]") {
    const int bits = GENERATE(12, 18, 20);
    for (const stress::Family& family : stress::families())
        for (std::uint64_t seed = 1; seed <= 3; ++seed) same_hits(family, lattice_of(bits), seed, 200);
}

TEST_CASE("rays of every family hit the same in every structure, sheared", "[structures]") {
    Config config = lattice_of(16);
    config.dir_bits = 24;
    config.primitive_test = PrimitiveTest::sheared;
    for (const stress::Family& family : stress::families()) same_hits(family, config, 7, 200);
}

TEST_CASE("rays of every family hit the same in every structure, many rays", "[structures][slow]") {
    const int bits = GENERATE(12, 13, 14, 15, 16, 17, 18, 19, 20);
    for (const stress::Family& family : stress::families())
        for (std::uint64_t seed = 11; seed <= 30; ++seed) same_hits(family, lattice_of(bits), seed, 5000);
}

TEST_CASE("pictures do not depend on the structure", "[structures][long]") {
    const std::string scene = GENERATE("tetra:4", "mount:3", "balls:1", "rings:1", "teapot:4", "tree:4",
                                       "cornell"),
                      name = GENERATE("default", "narrow", "broad");
    INFO(scene << " " << name);
    const FrameSize size{40, 30};
    std::vector<Trace> traces;
    const std::vector<Config> all = all_structures(quick_config(name));
    for (Config config : all) {
        config.stack_depth = 64;
        const Job job = make_shot(scene, size, config).job;
        traces.push_back(record_trace(job.image, job.frame, job.config));
    }
    for (std::size_t i = 1; i < traces.size(); ++i) {
        CAPTURE(i);
        CHECK(same(traces[i], traces[0]));
        // No plane may cut anything: there may be none.
        const bool stops = all[i].is_walked(Structure::bsp) && all[i].straddlers == Straddlers::stop;
        CHECK(traces[i].triangle_tests < traces[0].triangle_tests + stops);
    }
}

TEST_CASE("finished pictures do not depend on the structure", "[structures]") {
    const std::string scene = GENERATE("spheres", "balls:1", "mount:2", "teapot:3", "mirrors", "plane");
    INFO(scene);
    std::vector<Trace> traces;
    for (const Config& config : all_structures(shaded(quick_config("small"), Structure::bvh))) {
        const Job job = finished(scene, {32, 24}, config);
        traces.push_back(record_trace(job.image, job.frame, job.config));
    }
    for (std::size_t i = 1; i < traces.size(); ++i) {
        CAPTURE(i);
        CHECK(same(traces[i], traces[0]));
        CHECK(traces[i].colours == traces[0].colours);
        CHECK(traces[i].signatures == traces[0].signatures);
    }
}

// These chips are relaxed; "finished pictures of every engine" uses fast ones. The tests of two levels run
// the other engines.
TEST_CASE("model and RTL agree on trees of boxes and of cells", "[structures]") {
    const Structure structure = GENERATE(Structure::bvh, Structure::kd);
    const std::string scene = GENERATE("gears:1", "balls:1", "rings:1", "tetra:4");
    INFO(scene << " in " << name_of(structure));
    check_lockstep(make_shot(scene, {48, 36}, deep("default", structure)).job);
}

TEST_CASE("model and RTL agree on every engine", "[structures][slow]") {
    for (const Structure structure : engines())
        for (const char* scene : {"gears:1", "balls:1", "rings:1", "tetra:4"}) {
            INFO(scene << " in " << name_of(structure));
            check_lockstep(make_shot(scene, {48, 36}, deep("default", structure)).job);
        }
}

// The chip is the one for boxes.
TEST_CASE("model and RTL agree on boxes with spatial splits", "[structures]") {
    const std::string scene = GENERATE("rings:1", "tree:4");
    INFO(scene);
    check_lockstep(make_shot(scene, {48, 36}, with(deep("default", Structure::bvh), {{"splits", 1}})).job);
}

// The chip is the one for a kd-tree.
TEST_CASE("model and RTL agree on an octree", "[structures]") {
    const std::string scene = GENERATE("gears:1", "balls:1", "tetra:4"), rule = GENERATE("leaves", "inner");
    INFO(scene << " " << rule);
    Config config = deep("default", Structure::octree);
    set_parameter(config, "straddlers", rule, "test");
    check_lockstep(make_shot(scene, {24, 18}, config).job);
}

TEST_CASE("model and RTL agree on finished pictures of every engine", "[structures]") {
    const Structure structure = GENERATE(from_range(engines()));
    const std::string scene = GENERATE("spheres", "balls:1", "mount:2", "plane");
    INFO(scene << " in " << name_of(structure));
    check_lockstep(finished(scene, {20, 15}, shaded(quick_config("small"), structure)));
}

TEST_CASE("model and RTL agree on a list of all primitives", "[structures]") {
    const std::string scene = GENERATE("tetra:1", "tetra:3", "mount:1", "cornell");
    INFO(scene);
    check_lockstep(make_shot(scene, {20, 15}, structured(quick_config("small"), Structure::none)).job);
}

TEST_CASE("model and RTL agree on every structure, other configurations", "[structures][slow]") {
    const std::string name = GENERATE("small", "narrow", "broad", "wide", "saarcor", "rpu", "ulx3s");
    INFO(name);
    for (const Structure structure : tree_structures())
        check_lockstep(make_shot("gears:2", {48, 36}, deep(name, structure)).job);
    check_lockstep(make_shot("tetra:3", {20, 15}, structured(quick_config(name), Structure::none)).job);
}

TEST_CASE("model and RTL agree on finished pictures of every structure", "[structures][slow]") {
    const std::string scene = GENERATE("spheres", "mirrors", "teapot:3");
    for (const Structure structure : tree_structures())
        check_lockstep(finished(scene, {16, 12}, shaded(quick_config("default"), structure)));
    check_lockstep(finished(scene, {16, 12}, shaded(quick_config("default"), Structure::none)));
}

TEST_CASE("a structure refuses what it cannot walk", "[structures]") {
    Config config = structured(quick_config("default"), Structure::kd);
    config.primitive_test = PrimitiveTest::moller;
    CHECK_THROWS_WITH(check_config(config, "f"), Catch::Contains("structure=kd needs primitive_test"));
    config.structure = Structure::octree;
    CHECK_THROWS_WITH(check_config(config, "f"), Catch::Contains("structure=octree needs primitive_test"));
    config.structure = Structure::spheres;
    CHECK_THROWS_WITH(check_config(config, "f"), Catch::Contains("structure=spheres needs primitive_test"));
    config = deep("default", Structure::spheres);
    config.stack_depth = 1;
    CHECK_THROWS_WITH(make_shot("gears:1", {8, 6}, config), Catch::Contains("--set stack_depth="));
    config = quick_config("default");
    config.splits = Splits::on;
    config.primitive_test = PrimitiveTest::woop;
    CHECK_THROWS_WITH(check_config(config, "f"), Catch::Contains("splits=on needs"));
    config.primitive_test = PrimitiveTest::exact;
    config.levels = 2;
    CHECK_THROWS_WITH(check_config(config, "f"), Catch::Contains("splits=on needs levels=1"));
    config = deep("default", Structure::kd);
    config.stack_depth = 1;
    CHECK_THROWS_WITH(make_shot("gears:1", {8, 6}, config), Catch::Contains("--set stack_depth="));
    config = structured(quick_config("default"), Structure::none);
    config.addr_bits = 8;
    CHECK_THROWS_WITH(make_shot("gears:1", {8, 6}, config), Catch::Contains("lines of 64 bytes"));
}

TEST_CASE("no plane separates primitives that are all the same", "[structures]") {
    const Config config = structured(lattice_of(18), GENERATE(from_range(tree_structures())));
    for (const std::uint32_t n : {1u, 6u, 7u, 1000u}) {
        std::vector<PrimData> prims(n, {{0, 0, 0}, {1000, 0, 0}, {0, 1000, 0}, 0});
        for (std::uint32_t i = 0; i < n; ++i) prims[i].prim = i;
        Walker walker(prims, config);
        const Closest hit = walker.closest({{10, 10, 500}, {0, 0, -100000}, {}});
        CHECK(hit.found == 1);
        CHECK(hit.prim == 0);
    }
}

// Parameters of parts that a machine does not have: the program says so, and it is true.
#include <algorithm>

#include <catch2/catch.hpp>

#include "model/base/error.hpp"
#include "model/engine/check.hpp"
#include "model/scene/builtin.hpp"
#include "model/core/parameters.hpp"
#include "sim/run/frame/frame.hpp"
#include "sim/load/load.hpp"
#include "sim/run/request/ineffective.hpp"
#include "sim/run/request/material.hpp"

using namespace rayclock;

namespace {

Config configured(const std::vector<std::pair<std::string, std::string>>& values) {
    Config config = named_config("default");
    for (const auto& [key, value] : values) set_parameter(config, key, value, "test");
    return config;
}

/// A small frame's digest and cycles.
std::pair<std::uint64_t, std::uint64_t> frame_of(const Config& config) {
    static const Scene scene = make_builtin("gears:1", Primitives::triangles);
    const FrameResult run = run_model(make_job(scene, *scene.camera, {16, 12}, config));
    return {run.digest, run.cycles};
}

}   // namespace

TEST_CASE("a setting that is said to have no effect has none") {
    const std::vector<std::vector<std::pair<std::string, std::string>>> machines{{{"dram", "ddr3"}},
                                                                                 {{"dram", "ideal"}},
                                                                                 {{"structure", "none"}},
                                                                                 {{"structure", "kd"}},
                                                                                 {{"structure", "octree"}}};
    for (const auto& values : machines) {
        const Config config = configured(values);
        const auto frame = frame_of(config);
        int idle = 0;
        for (const Parameter& p : parameters()) {
            Config other = config;
            const std::string item = std::string(p.key) + "=";
            if (ineffective_settings(config, {item}).empty()) continue;
            ++idle;
            p.set(other, p.power_of_two() ? p.get(config) * 2 : p.get(config) + 1);
            if (p.get(other) > p.hi) p.set(other, p.power_of_two() ? p.get(config) / 2 : p.lo);
            INFO(values[0].second << ", " << p.key);
            CHECK_NOTHROW(check_config(other, "test"));
            CHECK(frame_of(other) == frame);
        }
        CHECK(idle > 8);
    }
}

TEST_CASE("every parameter either always has an effect or has a rule for when it has none") {
    using Values = std::vector<std::pair<std::string, std::string>>;
    // A machine on which the parameter changes nothing, and what the note names.
    struct Row {
        const char* key;
        Values machine;
        const char* because;
    };
    const std::vector<Row> rows{{"straddlers", {}, "structure=bvh"},
                                {"references", {{"structure", "spheres"}}, "structure=spheres"},
                                {"box_bits", {{"structure", "kd"}}, "structure=kd"},
                                {"leaf_size", {{"structure", "kd"}}, "structure=kd"},
                                {"stack_depth", {{"structure", "none"}}, "structure=none"},
                                {"box_queue", {{"structure", "none"}}, "structure=none"},
                                {"node_sets", {{"structure", "none"}}, "structure=none"},
                                {"node_ways", {{"structure", "none"}}, "structure=none"},
                                {"node_line", {{"structure", "none"}}, "structure=none"},
                                {"node_mshrs", {{"structure", "none"}}, "structure=none"},
                                {"box_lanes", {{"structure", "kd"}}, "structure=kd"},
                                {"splits", {{"structure", "kd"}}, "structure=kd"},
                                {"xform_interval", {}, "levels=1"},
                                {"mesh_structure", {}, "levels=1"},
                                {"l2_ways", {}, "l2_sets=0"},
                                {"l2_line", {}, "l2_sets=0"},
                                {"l2_mshrs", {}, "l2_sets=0"},
                                {"dram_channels", {{"dram", "ideal"}}, "dram=ideal"},
                                {"mem_latency", {{"dram", "hbm2"}}, "dram=hbm2"},
                                {"mem_interval", {{"dram", "sdr"}}, "dram=sdr"},
                                {"origin_bits", {}, "shading=0"},
                                {"lights", {}, "shading=0"},
                                {"bounces", {}, "shading=0"},
                                {"shade_queue", {}, "shading=0"},
                                {"shade_interval", {}, "shading=0"},
                                {"surf_sets", {}, "shading=0"},
                                {"surf_ways", {}, "shading=0"},
                                {"surf_line", {}, "shading=0"},
                                {"surf_mshrs", {}, "shading=0"},
                                {"texels", {}, "shading=0"},
                                {"tex_sets", {}, "shading=0"},
                                {"tex_ways", {{"shading", "1"}}, "textures=0"},
                                {"tex_line", {{"shading", "1"}}, "textures=0"},
                                {"tex_mshrs", {{"shading", "1"}}, "textures=0"},
                                {"stream_sets", {}, "source=camera"},
                                {"stream_ways", {}, "source=camera"},
                                {"stream_line", {}, "source=camera"},
                                {"stream_mshrs", {}, "source=camera"}};
    // What every machine has; what is refused without shading; what only has to be large enough.
    const std::vector<std::string> always{
        "coord_bits",   "dir_bits",     "t_frac_bits", "recip_bits",  "bary_bits",     "primitive_test",
        "structure",    "levels",       "node_width",  "contexts",    "raygen_queue",  "raygen_interval",
        "tri_queue",    "tri_interval", "pipelines",   "tile_bits",   "prim_sets",     "prim_ways",
        "prim_line",    "prim_mshrs",   "l2_sets",     "cache_queue", "timing",        "shading",
        "spheres",      "planes",       "smooth",      "refraction",  "supersampling", "dram",
        "panes",        "horizon",      "addr_bits",   "prim_bits",   "pixel_bits",    "scan_out",
        "pixel_writes", "source",       "textures"};
    for (const Parameter& p : parameters()) {
        CAPTURE(p.key);
        const std::string key = p.key;
        const auto row = std::find_if(rows.begin(), rows.end(), [&](const Row& r) { return r.key == key; });
        const bool matters = std::find(always.begin(), always.end(), key) != always.end();
        REQUIRE((row != rows.end()) != matters);   // one of the two
        if (row != rows.end())
            CHECK(ineffective_settings(configured(row->machine), {key + "=1"}) ==
                  std::vector<std::string>{key + " has no effect with " + row->because});
        for (const char* structure : {"bvh", "kd", "octree", "none"})
            if (matters)
                CHECK(ineffective_settings(configured({{"structure", structure}}), {key + "=1"}).empty());
    }
    CHECK(rows.size() + always.size() == parameters().size());
}

TEST_CASE("options of a finished picture without effect are reported") {
    const auto told = [](const Finish& f, const Whitted& w) {
        return ineffective_finish(f, w, make_builtin("mirrors"));
    };
    Finish finish;
    finish.threshold = 0.1, finish.contrast = 0.1;
    CHECK(told(finish, {.depth = 4, .aa = 3}).empty());
    CHECK(told(finish, {.depth = 0, .aa = 3}) ==
          std::vector<std::string>{"--threshold has no effect with --depth 0"});
    CHECK(told(finish, {.depth = 4, .aa = 2}) ==
          std::vector<std::string>{
              "--contrast has no effect with --aa 2, since the first 4 samples are always taken"});
    CHECK(told({}, {.depth = 0, .aa = 1}).empty());
}

TEST_CASE("requested bounces that no material causes are reported") {
    Finish finish;
    Scene dull = make_builtin("icosphere:1");
    CHECK(ineffective_finish(finish, {.depth = 5}, dull).empty());
    finish.depth = 2;
    CHECK(ineffective_finish(finish, {.depth = 2}, make_builtin("mirrors")).empty());
    CHECK(ineffective_finish(finish, {.depth = 0}, dull).empty());
    const std::string told =
        "--depth 2 draws no reflected or refracted ray, since no material reflects or transmits light";
    dull.materials[0].name = "clay";
    CHECK(ineffective_finish(finish, {.depth = 2}, dull) == std::vector<std::string>{told});
    dull.materials[0].name = "default";
    CHECK(ineffective_finish(finish, {.depth = 2}, dull) ==
          std::vector<std::string>{told +
                                   "; --material mirror=0.5 lets reflect what has no material of its own"});
    for (const auto& [scene, bounces] :
         {std::pair{"cornell", false}, {"mirrors", true}, {"spheres", true}, {"icosphere:1", false}})
        CHECK(has_bounces(load_scene(scene)) == bounces);
}

TEST_CASE("a material is given to what has none, and to nothing else") {
    const auto given = [](const std::string& typed, const std::string& own = "default") {
        Scene scene = make_builtin("square");
        scene.materials = {{.name = "default"}, {.name = "clay"}};
        scene.materials[0].name = own;
        give_material(scene, typed);
        CHECK(scene.materials[1].mirror == 0);
        CHECK_NOTHROW(check_scene(scene, "test"));
        return scene.materials[0];
    };
    const Material half = given("mirror=0.5,colour=1:0.5:0,schlick=true");
    CHECK(half.mirror == 0.5);
    CHECK(half.colour == glm::dvec3(1, 0.5, 0));
    CHECK(half.schlick);
    CHECK(half.diffuse == Material{}.diffuse);
    CHECK(given("glass").transmit == 0.85);
    CHECK(given("glass,index=1.25").index == 1.25);
    CHECK(given("glass,index=1.25").transmit == 0.85);
    const auto says = [&](const std::string& typed, const std::string& own = "default") -> std::string {
        try {
            given(typed, own);
        } catch (const UserError& error) {
            return error.what();
        }
        return {};
    };
    CHECK(says("glas") == "--material: no material is called 'glas'; did you mean 'glass'?");
    CHECK_THAT(says("mirror=2"), Catch::Contains("--material: mirror") && Catch::Contains("not 2"));
    CHECK_THAT(says("miror=1"), Catch::Contains("miror") && Catch::Contains("mirror"));
    CHECK_THAT(says("mirror=x"), Catch::Contains("--material: 'x' is not a number"));
    CHECK_THAT(says("mirror=0.5,glass"), Catch::Contains("'glass' is not key=value"));
    CHECK_THAT(says("colour=1:0"), Catch::Contains("--material: colour"));
    CHECK_THAT(says(""), Catch::Contains("--material needs a name or key=value"));
    CHECK_THAT(says("glass", "brass"), Catch::Contains("every surface of") && Catch::Contains("has one"));
}

TEST_CASE("a setting without effect is reported with the parameter that disables it") {
    const Config config = configured({{"dram", "ddr3"}, {"structure", "none"}});
    CHECK(ineffective_settings(config, {"mem_latency=5"}) ==
          std::vector<std::string>{"mem_latency has no effect with dram=ddr3"});
    CHECK(ineffective_settings(config, {"l2_ways=2", "contexts=8", "node_sets=4"}) ==
          std::vector<std::string>{"l2_ways has no effect with l2_sets=0",
                                   "node_sets has no effect with structure=none"});
    CHECK(ineffective_settings(configured({{"dram", "ideal"}}), {"mem_latency=5"}).empty());
}

TEST_CASE("a name that is far from all lists them, if they are few") {
    Config config;
    CHECK_THROWS_WITH(
        set_parameter(config, "dram", "hypermemory", "--set"),
        "--set: no dram is called 'hypermemory'; there are 'ideal', 'sdr', 'ddr3', 'rpu', 'sdr_half', "
        "'ddr4', 'lpddr4', 'hbm2', 'board'");
    CHECK_THROWS_WITH(named_config("nonsense"),
                      Catch::Contains("is called 'nonsense'; there are 'default', 'small'"));
}

// Elastic verification: RTL of other timing passes if its values are right, and every wrong, lost, repeated
// or reordered transfer is named with unit, link, ray and pixel.
#include <catch2/catch.hpp>

#include "model/compile/frame.hpp"
#include "model/compile/surfaces.hpp"
#include "sim/load/load.hpp"
#include "sim/run/elastic/elastic.hpp"
#include "sim/run/elastic/unit_alone.hpp"
#include "tests/system/elastic/faulty.hpp"
#include "tests/support/machine/frames.hpp"
#include "sim/view/report/lockstep.hpp"

namespace rayclock::test::elastic_test {

using namespace rayclock;
using namespace rayclock::test;
using Catch::Contains;

namespace {

const std::string rtl_folder = "tests/system/elastic/";

Job small_job(const Values& values = {}) {
    return make_shot("gears:2", {24, 18}, with(quick_config("small"), values)).job;
}

/// Requires that the RTL has the right values in another number of cycles, and that lockstep says so.
ElasticResult check_other_timing(const Job& job, const std::string& unit) {
    const ElasticResult elastic = run_elastic(job);
    INFO((elastic.first ? elastic.first->unit + " " + elastic.first->link + " expected " +
                              elastic.first->expected + " got " + elastic.first->got
                        : "no difference"));
    CHECK(elastic.agrees());
    CHECK(elastic.rtl.digest != elastic.model.digest);   // the digest includes the cycles
    CHECK(elastic.rtl.hits.hits == elastic.model.hits.hits);
    const LockstepResult lockstep = run_lockstep(job);
    CHECK_FALSE(lockstep.agrees());
    REQUIRE(lockstep.first);
    CHECK(lockstep.first->unit == unit);
    return elastic;
}

double hit_rate(const FrameResult& run, Unit cache) {
    const CauseCounts& c = run.accounts.units[index(cache)];
    return double(c[0]) / double(c[0] + c[1] + c[2]);
}

/// A fault, and where it must be noticed.
struct Case {
    FaultyUnit faulty;
    std::string unit, link;
};

void check_noticed(const Case& c, const Job& job) {
    INFO(name_of(c.faulty));
    const OtherUnit other(c.faulty);
    const ElasticResult result = run_elastic(job);
    CHECK(result.value_mismatches > 0);
    REQUIRE(result.first);
    const Divergence& d = *result.first;
    INFO(d.unit << ", " << d.link << ", ray " << d.ray << ", pixel (" << d.x << ", " << d.y << "), expected "
                << d.expected << ", got " << d.got << ", " << d.later);
    CHECK(d.unit == c.unit);
    CHECK(d.link == c.link);
    CHECK(d.ray < std::uint32_t(job.config.contexts));
    if (c.link != "slot" || c.faulty.fault != Fault::value) {   // sched invents pixels outside the picture
        CHECK(d.x < 24);
        CHECK(d.y < 18);
    }
    if (c.faulty.fault == Fault::lost && c.link != "slot") CHECK_THAT(d.got, Contains("none"));
}

}   // namespace

TEST_CASE("the project's RTL passes elastic verification in the model's cycles") {
    for (const std::string& config : quick_configs()) {
        INFO(config);
        const Job job = make_shot("gears:1", {24, 18}, quick_config(config)).job;
        for (const Disturbance& disturbance : {Disturbance{}, Disturbance{25, 60, 3}}) {
            const ElasticResult result = run_elastic(job, disturbance);
            CHECK(result.agrees());
            CHECK(result.rtl.cycles == result.model.cycles);
            CHECK(result.rtl.accounts == result.model.accounts);
            CHECK(result.rtl.digest == result.model.digest);
            CHECK(result.events_compared >= run_lockstep(job, disturbance).events_compared);
        }
    }
}

TEST_CASE("elastic verification runs several frames on one machine") {
    const Shot shot = make_shot("gears:1", {24, 18}, quick_config("small"));
    std::vector<RecordedFrame> frames;
    for (int i = 0; i < 3; ++i) {
        Camera camera = *shot.scene.camera;
        camera.fov_degrees *= 1 - 0.1 * i;
        frames.push_back(
            record_frame(shot.job, make_frame(camera, {24, 18}, shot.job.image, shot.job.config)));
    }
    const ElasticResult result = run_elastic(shot.job, frames, parse_free_units("all", shot.job.config));
    CHECK(result.agrees());
    REQUIRE(result.rtl_runs.size() == 3);
    for (std::size_t i = 0; i < 3; ++i) CHECK(result.rtl_runs[i].cycles == result.runs[i].cycles);
}

TEST_CASE("a tri with five more cycles passes, and lockstep names tri") {
    const OtherUnit other("tri", rtl_folder + "late_tri.sv");
    const ElasticResult result = check_other_timing(small_job(), "tri");
    CHECK(result.rtl.cycles > result.model.cycles);
}

TEST_CASE("a tri that accepts a primitive every third cycle passes, and lockstep names tri", "[slow]") {
    const OtherUnit other("tri", rtl_folder + "slow_tri.sv");
    const ElasticResult result = check_other_timing(small_job(), "tri");
    CHECK(result.rtl.cycles > result.model.cycles);
}

TEST_CASE("a box that answers out of order across rays passes, and lockstep names box", "[slow]") {
    const OtherUnit other("box", rtl_folder + "unordered_box.sv");
    check_other_timing(small_job(), "box");
}

TEST_CASE("caches of another replacement policy pass with other hit rates", "[slow]") {
    const OtherUnit other("tags", rtl_folder + "fifo_tags.sv");
    const Job job = make_shot("gears:4", {48, 36}, quick_config("small")).job;
    const ElasticResult result = run_elastic(job);
    CHECK(result.agrees());
    const auto rate = [&](const FrameResult& run) { return hit_rate(run, Unit::prim_cache); };
    CHECK(rate(result.rtl) != rate(result.model));
    const LockstepResult lockstep = run_lockstep(job);
    REQUIRE(lockstep.first);
    CHECK_THAT(lockstep.first->unit, Contains("cache"));
}

TEST_CASE("a wrong, a lost and a repeated answer of tri are named", "[long]") {
    for (const Fault fault : {Fault::value, Fault::lost, Fault::twice})
        check_noticed({{"tri", "rsp", fault, 20}, "tri", "tri_rsp"}, small_job());
}

TEST_CASE("primitives of a leaf in the wrong order are named, with the number of the transfer", "[slow]") {
    // The first leaf of a node begins with its second primitive, and continues with its first one.
    const OtherUnit other(
        "list",
        {{"in.offset[O-1:0]};", "in.offset[O-1:0]} + (in.count[C-1:0] > C'(1) ? 1 : 0);"},
         {", next_triangle};", ", next_triangle == C'(1) && end_leaf == '0 ? C'(0) : next_triangle};"}});
    const ElasticResult result = run_elastic(small_job({{"leaf_size", 4}}));
    REQUIRE(result.first);
    CHECK(result.first->unit == "list");
    CHECK(result.first->link == "prim_req");
    CHECK_THAT(result.first->later, Contains("number 2 of") && Contains("before number 1"));
}

TEST_CASE("don't-care outputs are ignored for a replaced unit, and compared for all others", "[slow]") {
    const Job job = small_job();
    for (const std::string unit : {"tri", "box"}) {
        INFO(unit);
        const OtherUnit other(unit, rtl_folder + "careless_" + unit + ".sv");
        std::vector<RecordedFrame> frames;
        frames.push_back(record_frame(job, job.frame));
        const auto run = [&](const std::string& free) {
            return run_elastic(job, frames, parse_free_units(free, job.config));
        };
        CHECK(run(unit).agrees());
        CHECK(run("all").agrees());
        CHECK(run(unit).rtl.cycles == run(unit).model.cycles);   // no unit reads them
        const ElasticResult strict = run("list");
        REQUIRE(strict.first);
        CHECK(strict.first->unit == unit);
        const LockstepResult lockstep = run_lockstep(job);
        CHECK(lockstep.value_mismatches > 0);
        CHECK(lockstep.cycle_gap == 0);
    }
}

TEST_CASE("transfers after the frame, early signals and invented requests are noticed", "[slow]") {
    const Job job = small_job();
    const auto first_with = [&](const std::string& unit, const std::string& file) {
        INFO(file);
        const OtherUnit other(unit, rtl_folder + file);
        const ElasticResult result = run_elastic(job);
        REQUIRE(result.first);
        return std::pair(result.first->unit, result.first->link);
    };
    CHECK(first_with("tri", "again_tri.sv") == std::pair<std::string, std::string>("tri", "tri_rsp"));
    CHECK(first_with("host", "early_host.sv") == std::pair<std::string, std::string>("host", "running"));
    CHECK(first_with("arbiter", "inventive_arbiter.sv") ==
          std::pair<std::string, std::string>("memport", "mem_req"));
    const OtherUnit other("tri", rtl_folder + "again_tri.sv");
    CHECK_FALSE(run_unit_alone(job, record_frame(job, job.frame), "tri").agrees());
}

TEST_CASE("an offer that is withdrawn or changes before it is accepted is named", "[slow]") {
    const Job job = small_job();
    const std::string begin = "  rc_fifo #(.Width(rc_pkg::RayW), .Depth(rc_pkg::RaygenQueue)) u_queue (",
                      output = ".valid_o(ray_valid_o), .ready_i(ray_ready_i)",
                      data = "assign ray_o = ray_data;";
    const auto first_with = [&](const std::vector<std::pair<std::string, std::string>>& changes) {
        const OtherUnit other("raygen", changes);
        const ElasticResult result = run_elastic(job);
        CHECK(result.rtl.hits.hits == result.model.hits.hits);
        REQUIRE(result.first);
        CHECK(result.first->unit == "raygen");
        CHECK(result.first->link == "ray");
        return *result.first;
    };
    const Divergence withdrawn =
        first_with({{begin,
                     "  logic kept, stalled_q;\n  assign ray_valid_o = kept && !stalled_q;\n"
                     "  always_ff @(posedge clk_i) stalled_q <= rst_ni && ray_valid_o && !ray_ready_i;\n" +
                         begin},
                    {output, ".valid_o(kept), .ready_i(ray_ready_i && !stalled_q)"}});
    CHECK_THAT(withdrawn.got, Contains("valid is 0"));
    const Divergence changed = first_with({{data, "assign ray_o = ray_ready_i ? ray_data : ~ray_data;"}});
    CHECK_THAT(changed.got, Contains("another payload"));

    const RecordedFrame frame = record_frame(job, job.frame);
    const auto alone_with = [&](const OtherUnit&) {
        const UnitAlone alone = run_unit_alone(job, frame, "tri");
        REQUIRE(alone.first);
        return alone.first->expected;
    };
    CHECK_THAT(alone_with(OtherUnit("tri", rtl_folder + "restless_tri.sv")), Contains("valid stays 1"));
    CHECK_THAT(alone_with(OtherUnit("tri", rtl_folder + "changing_tri.sv")),
               Contains("payload stays unchanged"));
}

TEST_CASE("counters that are off by one cycle are noticed", "[slow]") {
    const Job job = small_job();
    const auto first_with = [&](const std::string& unit, const std::string& text, const std::string& other) {
        const OtherUnit changed(unit, {{text, other}});
        const ElasticResult result = run_elastic(job);
        REQUIRE(result.first);
        CHECK(result.value_mismatches > 0);
        return *result.first;
    };
    // The register's first cycle is counted twice, and the counters of causes see no first cycle.
    const Divergence cycles =
        first_with("host", "cycles_q <= cycles_q + 1'b1", "cycles_q <= cycles_q + (cycles_q == '0 ? 2 : 1)");
    CHECK(cycles.unit == "host");
    CHECK(cycles.link == "cycles");
    CHECK_THAT(divergence_lines(cycles), Contains("unit host, register cycles"));
}

TEST_CASE("a failed assertion is a difference, in a frame and in a unit alone", "[slow]") {
    const Job job = small_job();
    const OtherUnit other("tri", {{"endmodule",
                                   "  always_ff @(posedge clk_i)\n    if (rst_ni && rsp_valid_o) a_never: "
                                   "assert (!rsp_valid_o);\nendmodule"}});
    const ElasticResult result = run_elastic(job);
    REQUIRE(result.first);
    CHECK(result.first->unit == "rtl");
    CHECK_THAT(divergence_lines(*result.first), Contains("unit rtl, assertion"));
    CHECK_FALSE(result.agrees());
    const UnitAlone alone = run_unit_alone(job, record_frame(job, job.frame), "tri");
    REQUIRE(alone.first);
    CHECK_THAT(divergence_lines(*alone.first), Contains("unit rtl, assertion"));
}

TEST_CASE("faults are named in later frames, and the judge outlives each frame", "[slow]") {
    const Job job = small_job();
    std::vector<RecordedFrame> frames;
    for (int i = 0; i < 3; ++i) frames.push_back(record_frame(job, job.frame));
    const OtherUnit other(FaultyUnit{"tri", "rsp", Fault::value, int(frames[0].trace.triangle_tests) + 20});
    const ElasticResult result = run_elastic(job, frames, parse_free_units("tri", job.config));
    REQUIRE(result.first);
    CHECK(result.first->unit == "tri");
    CHECK(result.first->frame == 1);
    CHECK(result.rtl_runs.size() == 3);
}

TEST_CASE("chips with a shared cache, two levels, or a stream of rays pass elastic verification", "[slow]") {
    const auto check = [](const Job& job) {
        const ElasticResult result = run_elastic(job);
        INFO((result.first ? result.first->unit + " " + result.first->link + " " + result.first->got : ""));
        CHECK(result.agrees());
        CHECK(result.rtl.cycles == result.model.cycles);
    };
    check(small_job({{"l2_sets", 4}}));
    check(make_shot("gearbox:1", {24, 18}, with(quick_config("small"), {{"levels", 2}})).job);
}

TEST_CASE("a cache may prefetch, also between frames", "[slow]") {
    const Job job = small_job({{"l2_sets", 4}});
    const OtherUnit other("node_cache", rtl_folder + "prefetching_node_cache.sv");
    std::vector<RecordedFrame> frames;
    for (int i = 0; i < 3; ++i) frames.push_back(record_frame(job, job.frame));
    const ElasticResult result = run_elastic(job, frames, parse_free_units("node_cache", job.config));
    INFO((result.first ? result.first->unit + " " + result.first->link + " " + result.first->got : ""));
    CHECK(result.agrees());
    CHECK(result.rtl.memory.reads > result.model.memory.reads);
}

TEST_CASE("a unit alone gives the answers of the model's pure function, in any order", "[slow]") {
    const Job job = small_job();
    const RecordedFrame frame = record_frame(job, job.frame);
    for (const std::string unit : {"tri", "box"}) {
        const UnitAlone result = run_unit_alone(job, frame, unit);
        CHECK(result.agrees());
        CHECK(result.answers == result.requests);
        // As many corner cases follow.
        CHECK(result.answers == 2 * (unit == "tri" ? frame.trace.triangle_tests : frame.trace.visits));
    }
    for (const auto& [unit, file] : {std::pair{"tri", "slow_tri.sv"}, std::pair{"box", "unordered_box.sv"}}) {
        const OtherUnit other(unit, rtl_folder + file);
        CHECK(run_unit_alone(job, frame, unit).agrees());
    }
    for (const Fault fault : {Fault::value, Fault::lost, Fault::twice}) {
        const FaultyUnit faulty{"tri", "rsp", fault, 20};
        INFO(name_of(faulty));
        const OtherUnit other(faulty);
        const UnitAlone result = run_unit_alone(job, frame, "tri");
        CHECK(result.value_mismatches > 0);
        REQUIRE(result.first);
        CHECK(result.first->link == "tri_rsp");
    }
    CHECK_THROWS_WITH(run_unit_alone(job, frame, "list"), Contains("cannot run alone"));
    CHECK_THROWS_WITH(run_unit_alone(job, frame, "shade"), Contains("no such unit"));
}

TEST_CASE("node units agree alone, also in corners that no ray of the frame reaches", "[slow]") {
    for_each_engine([]<class E>(E) {
        for (const int shading : {0, 1}) {
            const std::string unit = unit_name(E::structure);
            INFO(unit << ", shading=" << shading);
            const Job job =
                small_job({{"structure", int(E::structure)}, {"shading", shading}, {"stack_depth", 64}});
            const RecordedFrame frame = record_frame(job, job.frame);
            const UnitAlone result = run_unit_alone(job, frame, unit, 3);
            CHECK(result.agrees());
            CHECK(result.answers == 2 * frame.trace.visits);
        }
    });
    // Rays of the frame have no component of 0.
    const Job job = small_job();
    const OtherUnit other("slab", {{"s0_len_i == '0;", "1'b0;"}});
    CHECK_FALSE(run_unit_alone(job, record_frame(job, job.frame), "box").agrees());
}

TEST_CASE("every wrong, lost or repeated transfer is named with its unit and link", "[slow]") {
    using enum Fault;
    const std::vector<Case> cases{
        {{"box", "rsp", value, 9, 3}, "box", "box_rsp"},
        {{"box", "rsp", lost, 30}, "box", "box_rsp"},
        {{"box", "rsp", twice, 30}, "box", "box_rsp"},
        {{"node_cache", "rsp", value, 12}, "node_cache", "box_req"},
        {{"node_cache", "rsp", lost, 40}, "node_cache", "box_req"},
        {{"node_cache", "rsp", twice, 40}, "node_cache", "box_req"},
        {{"node_cache", "miss", value, 3}, "node_cache", "box_req"},
        {{"node_cache", "miss", lost, 5}, "node_cache", "box_req"},
        {{"node_cache", "miss", twice, 5}, "node_cache", "node_miss"},
        {{"prim_cache", "rsp", value, 12, 40}, "prim_cache", "tri_req"},
        {{"prim_cache", "rsp", lost, 40}, "prim_cache", "tri_req"},
        {{"prim_cache", "rsp", twice, 40}, "prim_cache", "tri_req"},
        {{"prim_cache", "miss", value, 3}, "prim_cache", "tri_req"},
        {{"prim_cache", "miss", lost, 5}, "prim_cache", "tri_req"},
        {{"prim_cache", "miss", twice, 5}, "prim_cache", "prim_miss"},
        {{"list", "prim_req", value, 50}, "list", "prim_req"},
        {{"list", "prim_req", lost, 50}, "list", "prim_req"},
        {{"list", "prim_req", twice, 50}, "list", "prim_req"},
        {{"list", "tri_req", value, 50, 2}, "list", "tri_req"},
        {{"list", "tested", value, 20}, "list", "tested"},
        {{"list", "tested", lost, 20}, "list", "tested"},
        {{"list", "closest", value, 7}, "list", "hit"},
        {{"list", "closest", lost, 7}, "list", "hit"},
        {{"trav", "leaves", value, 20}, "trav", "leaves"},
        {{"trav", "leaves", lost, 20}, "trav", "leaves"},
        {{"trav", "node_req", value, 60}, "trav", "node_req"},
        {{"trav", "node_req", lost, 60}, "trav", "node_req"},
        {{"trav", "node_req", twice, 60}, "trav", "node_req"},
        {{"trav", "done", lost, 9}, "trav", "hit"},
        {{"raygen", "ray", value, 30, 20}, "raygen", "ray"},
        {{"raygen", "ray", lost, 30}, "raygen", "ray"},
        {{"sched", "slot", value, 30, 8}, "sched", "slot"},
        {{"sched", "slot", lost, 30}, "sched", "slot"},
        {{"sched", "slot", twice, 30}, "sched", "slot"},
        {{"sched", "hit", value, 30}, "sched", "hit"},
    };
    const Job job = small_job();
    for (const Case& c : cases) check_noticed(c, job);
}

TEST_CASE("wrong, lost and repeated transfers of a chip that shades are named", "[slow]") {
    using enum Fault;
    const Whitted settings{2};
    Scene scene = load_scene("balls:1", {}, Primitives::native);
    if (!scene.camera) scene.camera = fit_camera(scene, 4.0 / 3);
    const Config config = fitted_config(scene, settings, quick_config("small"));
    const Job job = make_job(scene, *scene.camera, {24, 18}, config, {}, settings);
    const std::vector<Case> cases{
        {{"shade", "spawn", value, 20}, "shade", "spawn"},
        {{"shade", "spawn", lost, 20}, "shade", "spawn"},
        {{"shade", "spawn", twice, 20}, "shade", "spawn"},
        {{"shade", "surf_req", value, 9}, "shade", "surf_req"},
        {{"shade", "pixel", value, 7}, "shade", "hit"},
        {{"shade", "pixel", lost, 7}, "shade", "hit"},
        {{"surf_cache", "rsp", lost, 9}, "surf_cache", "surf_rsp"},
        {{"list", "closest", lost, 30}, "list", "closest"},
        {{"trav", "done", lost, 30}, "trav", "closest"},
    };
    for (const Case& c : cases) check_noticed(c, job);
}

}   // namespace rayclock::test::elastic_test

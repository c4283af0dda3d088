// Lockstep itself: it must see wrong values and wrong cycles, and name the first of them.
#include <catch2/catch.hpp>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "model/machine/machine.hpp"
#include "model/machine/payload_replay.hpp"
#include "sim/view/divergence/fields.hpp"
#include "sim/load/load.hpp"
#include "sim/run/lockstep/driver.hpp"
#include "sim/run/lockstep/lockstep.hpp"
#include "sim/view/report/builds.hpp"
#include "sim/view/report/lockstep.hpp"
#include "tests/support/files/test_folder.hpp"

using namespace rayclock;
namespace fs = std::filesystem;

namespace {

/// While it lives, the RTL is a copy with one text replaced.
class Mutant {
public:
    Mutant(const std::string& file, const std::string& old, const std::string& fresh) {
        const fs::path rtl = folder_.path() / "rtl";
        fs::copy(RAYCLOCK_SOURCE_DIR "/rtl", rtl, fs::copy_options::recursive);
        std::string text = test::content_of((rtl / file).string());
        const std::size_t at = text.find(old);
        REQUIRE(at != std::string::npos);
        REQUIRE(text.find(old, at + 1) == std::string::npos);
        std::ofstream(rtl / file) << text.replace(at, old.size(), fresh);
        setenv("RAYCLOCK_RTL", rtl.c_str(), 1);
    }
    ~Mutant() { unsetenv("RAYCLOCK_RTL"); }
    Mutant(const Mutant&) = delete;

private:
    test::TestFolder folder_;
};

Job small_job(int tri_interval = 1) {
    Config config = named_config("small");   // builds fastest
    config.tri_interval = tri_interval;
    Scene scene = load_scene("icosphere:2");
    scene.camera = fit_camera(scene, 4.0 / 3);
    return make_job(scene, *scene.camera, {24, 18}, config);
}

/// The model's first transfer that satisfies `wanted`: cycle, ray and pixel.
struct Event {
    std::uint64_t cycle = 0;
    std::uint32_t ray = 0, x = 0, y = 0;
};
template <class P> std::uint32_t id_of(const P& payload) {
    if constexpr (requires { payload.ray; })
        return payload.ray;
    else
        return payload.id;
}
template <class Payload, class Wanted> Event first_event(const Job& job, Link link, Wanted wanted) {
    const RecordedFrame frame = record_frame(job, job.frame);
    Machine machine(job.config, job.khz);
    PayloadReplay payloads(job.image, job.config);
    machine.start(frame.frame, frame.trace);
    payloads.start(frame.frame);
    Event found;
    for (bool done = false; !done && !machine.done();) {
        const std::uint64_t now = machine.cycle();
        machine.step([&](const Move& move) {
            payloads(move, [&](int pipeline, Link c, const auto& payload) {
                if constexpr (std::is_same_v<std::decay_t<decltype(payload)>, Payload>) {
                    if (done || c != link || !wanted(payload)) return;
                    const Slot pixel = machine.pixel(pipeline, id_of(payload));
                    found = {now, id_of(payload), pixel.x, pixel.y};
                    done = true;
                }
            });
        });
    }
    return found;
}

void check_first(const LockstepResult& result, const Event& event, const std::string& unit,
                 const std::string& link) {
    REQUIRE(result.first);
    INFO(result.first->expected << " / " << result.first->got);
    CHECK_FALSE(result.agrees());
    CHECK(result.first->cycle == event.cycle);
    CHECK(result.first->unit == unit);
    CHECK(result.first->link == link);
    CHECK(result.first->ray == event.ray);
    CHECK(result.first->x == event.x);
    CHECK(result.first->y == event.y);
}

}   // namespace

TEST_CASE("lockstep agrees where nothing is wrong") {
    const LockstepResult result = run_lockstep(small_job());
    CHECK(result.agrees());
    CHECK_FALSE(result.first);
    CHECK(result.events_compared > 1000);
}

TEST_CASE("lockstep names the first wrong value") {
    const Job job = small_job();
    const Event event =
        first_event<TriRsp>(job, Link::tri_rsp, [](const TriRsp& rsp) { return rsp.closer != 0; });
    REQUIRE(event.cycle > 0);
    const Mutant mutant("unit/tri/rc_hitdiv.sv", "assign v_o = {", "assign v_o = (BaryBits+1)'(1) + {");
    const LockstepResult result = run_lockstep(job);
    check_first(result, event, "tri", "tri_rsp");
    CHECK(result.value_mismatches > 1);
    CHECK(result.cycle_gap == 0);   // nothing depends on v
    CHECK(result.first->expected.starts_with("v="));
    CHECK(std::stoul(result.first->got.substr(2)) == std::stoul(result.first->expected.substr(2)) + 1);
    CHECK(result.model.hits.hits != result.rtl.hits.hits);
    CHECK(result.model.digest != result.rtl.digest);
}

TEST_CASE("lockstep names the pixel whose ray is wrong", "[long]") {
    const Job job = small_job();
    const Event event = first_event<Ray>(job, Link::ray, [](const Ray& ray) { return ray.ray == 5; });
    const Mutant mutant("unit/raygen/rc_raygen.sv", "assign ray_o = ray_data;",
                        "assign ray_o = ray_data ^ {{(rc_pkg::RayW-1){1'b0}}, ray_data[rc_pkg::RayW-1 -: "
                        "rc_pkg::RayBits] == rc_pkg::RayBits'(5)};");
    const LockstepResult result = run_lockstep(job);
    check_first(result, event, "raygen", "ray");
    CHECK(event.x == 3);   // the sixth in Morton order
    CHECK(event.y == 0);
    CHECK(result.first->expected.find("len[0]=") != std::string::npos);
}

TEST_CASE("lockstep names the first cycle in which the RTL is late") {
    const Job job = small_job();
    const Event event = first_event<NodeAnswer>(job, Link::box_rsp, [](const NodeAnswer&) { return true; });
    const std::string queue =
        "  rc_fifo #(.Width(rc_pkg::NodeAnswerW), .Depth(rc_pkg::BoxQueue)) u_queue (\n    .clk_i, .rst_ni, ";
    const Mutant mutant(
        "engine/rc_node_answer.sv",
        queue + ".valid_i(end_valid_i), .ready_o(queue_ready), .data_i(queue_data),",
        "  logic late_q;\n  logic [rc_pkg::NodeAnswerW-1:0] data_q;\n  always_ff @(posedge clk_i) begin\n"
        "    late_q <= rst_ni && end_valid_i;\n    data_q <= queue_data;\n  end\n" +
            queue + ".valid_i(late_q), .ready_o(queue_ready), .data_i(data_q),");
    const LockstepResult result = run_lockstep(job);
    REQUIRE(result.first);
    CHECK(result.first->cycle == event.cycle);
    CHECK(result.first->unit == "box");
    CHECK(result.first->link == "box_rsp");
    CHECK(result.first->expected == "a transfer");
    CHECK(result.first->got == "no offer");
    CHECK(result.first->later == "the RTL makes it 1 cycle later");
    CHECK(result.first->ray == event.ray);
    CHECK(result.cycle_gap > 0);
    CHECK_FALSE(result.agrees());
    // Late, but right: the machines ran on alone, and the pictures are the same.
    CHECK(result.model.hits.hits == result.rtl.hits.hits);
    CHECK(result.rtl.cycles > result.model.cycles);
    CHECK(result.value_mismatches == 0);
}

TEST_CASE("lockstep names the first cycle in which the RTL is early") {
    const Mutant mutant("unit/tri/rc_tri.sv", "|valid_q[Interval-2:0];", "|valid_q[Interval-3:0];");
    const LockstepResult result = run_lockstep(small_job(4));
    REQUIRE(result.first);
    CHECK(result.first->unit == "tri");   // which took it too soon
    CHECK(result.first->link == "tri_req");
    CHECK(result.first->expected == "an offer that is not accepted");
    CHECK(result.first->got == "a transfer");
    CHECK(result.first->later == "the model makes it 1 cycle later");
    CHECK_FALSE(result.agrees());
}

TEST_CASE("lockstep ends when the RTL never gives a pixel", "[long]") {
    const Job job = small_job();
    LockstepResult result;
    const Mutant hanging(
        "unit/sched/rc_sched.sv", "assign hit_valid_o   = pixel_valid_i;",
        "assign hit_valid_o   = pixel_valid_i && place != (2*PixelBits)'(12 << PixelBits | 9);");
    CHECK_NOTHROW(result = run_lockstep(job));
    REQUIRE(result.first);
    CHECK(result.first->unit == "sched");
    CHECK(result.first->link == "hit");
    CHECK(result.first->got == "no offer");
    CHECK(result.first->x == 12);
    CHECK(result.first->y == 9);
    CHECK(result.value_mismatches == 1);   // a pixel of the sphere that never came out
    CHECK(result.cycle_gap > 0);
}

TEST_CASE("a frame that ends too early is the first divergence") {
    const Job job = small_job();
    // The frame is over when three pixels are still to come.
    const RecordedFrame frame = record_frame(job, job.frame);
    Machine machine(job.config, job.khz);
    machine.start(frame.frame, frame.trace);
    while (machine.finished_pixels() < frame.trace.rays.size() - 3) machine.step();
    const std::uint64_t ends = machine.cycle();
    const Mutant mutant("host/rc_host.sv", "left_q == 32'(hits);", "left_q == 32'(hits) + 32'd3;");
    const LockstepResult result = run_lockstep(job);
    REQUIRE(result.first);
    CHECK(result.first->unit == "host");
    CHECK(result.first->link == "running");
    CHECK(result.first->cycle == ends);
    CHECK(result.first->expected == "the frame runs");
    CHECK(result.first->got == "the frame does not run");
    CHECK(result.cycle_gap == result.model.cycles - ends);
    CHECK(result.value_mismatches == 0);
    CHECK_FALSE(result.counters_compared);
    CHECK_FALSE(result.agrees());
    CHECK_THAT(lockstep_lines(result), Catch::Contains("unit host, signal running") &&
                                           Catch::Contains("since the RTL counts only while its frame runs"));
}

TEST_CASE("a done that is left from the frame before is the first divergence", "[long]") {
    const Job job = small_job();
    std::vector<RecordedFrame> frames;
    for (int i = 0; i < 2; ++i) frames.push_back(record_frame(job, job.frame));
    const Mutant mutant("host/rc_host.sv", "          done_q  <= 1'b0;\n", "");
    const LockstepResult result = run_lockstep(job, frames);
    REQUIRE(result.first);
    CHECK(result.first->unit == "host");
    CHECK(result.first->link == "done");
    CHECK(result.first->frame == 1);
    CHECK(result.first->cycle == result.first->frame_begins);
    CHECK(result.first->expected == "the frame is not done");
    CHECK(result.first->got == "the frame is done");
    CHECK_FALSE(result.agrees());
}

TEST_CASE("a value that units pass on has the unit's name that drives it") {
    Config config = named_config("small");
    const auto unit = [&](Link link, const char* field, RayEnd end = {}) {
        return std::string(driver_of(link, field, config, end));
    };
    const RayEnd nothing{false, false}, done{true, false}, all{true, true};
    CHECK(unit(Link::hit, "", nothing) == "trav");
    CHECK(unit(Link::hit, "t", done) == "list");
    CHECK(unit(Link::hit, "x", all) == "sched");
    CHECK(unit(Link::tri_req, "") == "prim_cache");
    CHECK(unit(Link::tri_req, "o[1]") == "list");
    CHECK(unit(Link::tri_req, "best_det") == "list");
    CHECK(unit(Link::box_req, "recip[0]") == "trav");
    CHECK(unit(Link::box_req, "exp[0]") == "node_cache");
    CHECK(unit(Link::tri_rsp, "u") == "tri");
    config.shading = 1;
    CHECK(unit(Link::hit, "colour[2]", nothing) == "shade");
    CHECK(unit(Link::hit, "colour[2]", all) == "sched");
    CHECK(unit(Link::closest, "", nothing) == "trav");
    CHECK(unit(Link::closest, "found", done) == "list");
}

TEST_CASE("every field that a unit before a cache sends is a field of a link behind the cache") {
    std::set<std::string> of_tri, of_trav;
    const auto add = [](std::set<std::string>& names, Link link, const Config& config) {
        for (const PayloadField& field : payload_fields(link, config)) {
            const std::size_t element = field.name.find_last_not_of("0123456789");
            names.insert(field.name);
            if (field.name[element] == '_') names.insert(field.name.substr(0, element));
        }
    };
    Config whole = named_config("default"), sheared = whole;
    whole.shading = whole.spheres = whole.planes = 1;
    sheared.primitive_test = PrimitiveTest::sheared;
    for (const Config& config : {whole, sheared}) add(of_tri, Link::tri_req, config);
    for (std::size_t i = 0; i < link_count; ++i)
        if (const Link link = Link(i); is_node_request(link) || link == Link::xform_req) {
            Config config = whole;
            config.levels = 2;
            add(of_trav, link, config);
            add(of_trav, link, whole);
        }
    for (const std::string_view name : sent_by_list) CHECK(of_tri.count(std::string(name)) == 1);
    for (const std::string_view name : sent_by_trav) CHECK(of_trav.count(std::string(name)) == 1);
}

TEST_CASE("a ray that ends too early is reported with the unit that ended it", "[long]") {
    const Job job = small_job();
    // The group below the top never matters: the ray is done when it is left.
    const Mutant mutant("unit/trav/rc_stack.sv", "below_matters = top_below <= tested.t_best;",
                        "below_matters = 1'b0;");
    const LockstepResult result = run_lockstep(job);
    REQUIRE(result.first);
    CHECK(result.first->unit == "trav");
}

TEST_CASE("a build reports each minute once") {
    BuildLines lines;
    const auto line = [&](double seconds, const char* stage = "Yosys") {
        return lines.line({"the netlist of 'small'", stage, seconds, {}}).value_or("");
    };
    CHECK(line(0) == "building the netlist of 'small', once for all runs");
    CHECK(line(59.9).empty());
    CHECK(line(60.1) == "still building the netlist of 'small': Yosys, 1 min");
    CHECK(line(61).empty());
    CHECK(line(190, "Verilator") == "still building the netlist of 'small': Verilator, 3 min");
    CHECK(line(200, "").empty());   // it is done
    CHECK(line(0) == "building the netlist of 'small', once for all runs");
}

TEST_CASE("a wrong cycle register is reported in a sentence") {
    LockstepResult result;
    result.counter = CounterDifference{"host", "cycles", 24352, 24300, 0};
    CHECK_THAT(
        lockstep_lines(result),
        Catch::Contains("the frame took 24,352 cycles in the model, and the RTL's register says 24,300"));
    result.counter = CounterDifference{"box", "busy with work", 3, 4, 1};
    CHECK_THAT(lockstep_lines(result),
               Catch::Contains("box was busy with work in 3 cycles of the model and in 4 of "
                               "the RTL; 1 more counter differs"));
}

TEST_CASE("lockstep sees a unit that counts a cycle under a wrong cause", "[long]") {
    const Job job = small_job();
    const Mutant mutant("engine/rc_node_unit.sv", "cause_o = node_waits_i ?", "cause_o = !node_waits_i ?");
    const LockstepResult result = run_lockstep(job);
    CHECK(result.account_mismatches == 1);
    CHECK_FALSE(result.agrees());
    CHECK_FALSE(result.first);
    CHECK(result.value_mismatches == 0);
    CHECK(result.cycle_gap == 0);
    CHECK(result.model.hits.hits == result.rtl.hits.hits);
    const CauseCounts &model = result.model.accounts.units[index(Unit::box)],
                      &rtl = result.rtl.accounts.units[index(Unit::box)];
    CHECK(model[1] == rtl[2]);
    CHECK(model[2] == rtl[1]);
    CHECK(model[1] != model[2]);
    REQUIRE(result.counter);
    CHECK(result.counter->unit == "box");
    CHECK(result.counter->cause == "starved by memory");
    CHECK(result.counter->model == model[1]);
    CHECK(result.counter->rtl == rtl[1]);
    CHECK(result.counter->others == 1);
    CHECK(lockstep_lines(result).find("counters DIFFER\n    box was starved by memory in ") !=
          std::string::npos);
}

TEST_CASE("lockstep ends when the RTL deadlocks, and names where it began") {
    const Job job = small_job();
    const Event event = first_event<PrimMiss>(job, Link::prim_miss, [](const PrimMiss&) { return true; });
    // One source of the memory port is never served: rays that need a triangle wait for ever.
    const Mutant mutant("rc_top.sv", ".valid_i(miss_valid), .ready_o(miss_ready)",
                        ".valid_i(miss_valid & {Pipelines{2'b01}}), .ready_o(miss_ready)");
    LockstepResult result;
    CHECK_NOTHROW(result = run_lockstep(job));
    REQUIRE(result.first);
    CHECK(result.first->cycle == event.cycle);
    CHECK(result.first->unit == "memport");   // which should have accepted it
    CHECK(result.first->link == "prim_miss");
    CHECK(result.first->expected == "a transfer");
    CHECK(result.first->got == "an offer that is not accepted");
    CHECK(result.first->later == "the RTL makes no further transfer there");
    CHECK_FALSE(result.counters_compared);
    CHECK(lockstep_lines(result).find("counters not compared") != std::string::npos);
    CHECK(result.cycle_gap > 0);
    CHECK_FALSE(result.agrees());
    CHECK(result.rtl.pixels < result.model.pixels);
    CHECK(result.value_mismatches > 0);   // pixels that never came
    CHECK_THROWS_WITH(run_rtl(job), Catch::Contains("rtl: nothing has moved for"));
}

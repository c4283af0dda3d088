// The torture set: model and RTL agree in every corner that it reaches, and it reaches them.
#include <map>
#include <set>

#include <catch2/catch.hpp>

#include "model/machine/machine.hpp"
#include "model/core/parameters.hpp"
#include "sim/view/report/accounts.hpp"
#include "sim/view/report/lockstep.hpp"
#include "sim/explore/torture/torture.hpp"
#include "tests/support/machine/build_all.hpp"

using namespace rayclock;

namespace {

bool has_textures(const std::string& chip) { return torture_chip(chip).has_textures(); }

void check_lockstep(const std::string& chip) {
    for (const TortureCase& torture : torture_cases(chip)) {
        const LockstepResult result = run_torture(torture);
        INFO(torture.name << "\n" << lockstep_lines(result));
        CHECK(result.agrees());
        CHECK(result.counters_compared);
    }
}

}   // namespace

// Not a test of its own; see tests/system/lockstep/lockstep_test.cpp.
TEST_CASE("the RTL of the tortured chips without textures builds", "[.build]") {
    std::vector<test::RtlJob> jobs;
    for (const std::string& chip : torture_chips())
        if (!has_textures(chip)) jobs.push_back({"rc_chip", "tortured " + chip, torture_chip(chip)});
    REQUIRE_NOTHROW(test::build_all(jobs));
}

TEST_CASE("model and RTL agree under torture") {
    check_lockstep(
        GENERATE(filter([](const std::string& c) { return !has_textures(c); }, from_range(torture_chips()))));
}

TEST_CASE("model and RTL agree under torture with textures", "[long]") {
    check_lockstep(GENERATE(filter(has_textures, from_range(torture_chips()))));
}

TEST_CASE("the torture set has every engine, level, timing and interval") {
    std::map<std::string, std::set<int>> seen;
    for (const std::string& chip : torture_chips()) {
        const Config c = torture_chip(chip);
        for (const Config& level : {c.upper(), c.lower()}) seen["engine"].insert(int(level.engine()));
        for (const Parameter& p : parameters())
            if (!p.is("xform_interval") || c.has_instances()) seen[p.key].insert(p.get(c));
        seen["two engines"].insert(c.has_two_engines());
        seen["homes"].insert(c.has_homes());
        seen["lanes are fewer than children"].insert(c.has_boxes() && c.box_interval() > 1);
    }
    const std::set<int> both{0, 1};
    CHECK(seen["engine"].size() == std::tuple_size_v<Engines> + 1);   // and none
    CHECK(seen["levels"] == std::set<int>{1, 2});
    for (const char* key :
         {"timing", "primitive_test", "shading", "two engines", "homes", "lanes are fewer than children"}) {
        INFO(key);
        CHECK(seen[key] == both);
    }
    CHECK(seen["tri_interval"] == std::set<int>{1, 2, 4});
    CHECK(seen["raygen_interval"] == std::set<int>{1, 2, 4, 8});
    CHECK(seen["shade_interval"] == std::set<int>{1, 2, 4, 8});
    CHECK(seen["xform_interval"] == std::set<int>{1, 4});   // 2 lies between
    CHECK(seen["pipelines"] == std::set<int>{1, 2});
}

TEST_CASE("every count in a report is that of the transfers in a trace") {
    for (const TortureCase& torture : torture_cases(GENERATE(from_range(torture_chips())))) {
        const Config& config = torture.job.config;
        const std::vector<RecordedFrame> frames = record_torture(torture);
        Machine machine(config, torture.job.khz, torture.disturbance);
        prepare_frame(machine, 0, std::span(frames));
        std::array<std::uint64_t, link_count> moved{};
        machine.start(frames[0].frame, frames[0].trace);
        while (!machine.done()) machine.step([&](const Move& move) { ++moved[index(move.link)]; });
        const FrameResult run = frame_result(frames[0], {machine.cycle(),
                                                         machine.finished_pixels(),
                                                         machine.accounts(),
                                                         machine.memory().stats(),
                                                         0,
                                                         false,
                                                         {}});
        const auto count = [&](Link link) { return moved[index(link)]; };
        std::map<std::string, std::uint64_t> brought;   // by unit
        for (std::size_t i = 0; i < link_count; ++i) {
            const std::string name = link_infos[i].name;
            if (name.ends_with("_req")) brought[link_infos[i].to] += moved[i];
        }
        brought["stream"] = count(Link::slot);
        brought["sched"] = count(Link::slot), brought["raygen"] = count(Link::ray);
        brought["trav"] = config.is_list() ? frames[0].trace.visits : count(Link::node_req);
        brought["list"] = count(Link::tri_rsp);
        brought["tex"] = count(Link::texel_rsp);
        brought["dispatch"] = count(Link::tile);
        brought["memport"] = count(config.l2_sets > 0 ? Link::l2_req : Link::mem_req);
        for (const UnitAccount& a : unit_accounts(config, run)) {
            INFO(torture.name << ", " << a.unit);
            if (a.unit == "shade")   // whole passes, at least one for each answer
                CHECK((a.busy == a.count * std::uint64_t(config.shade_interval) &&
                       a.count >= count(Link::closest)));
            else
                CHECK(a.count == brought[a.unit]);
        }
    }
}

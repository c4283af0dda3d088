// The torture set: model and RTL agree in every corner that it reaches, and it reaches them.
#include <catch2/catch.hpp>

#include "sim/report/lockstep.hpp"
#include "sim/torture/torture.hpp"
#include "tests/support/machine/build_all.hpp"

using namespace rayclock;

// Not a test of its own; see tests/system/lockstep_test.cpp.
TEST_CASE("the RTL of the tortured chips builds", "[.build]") {
    std::vector<test::RtlJob> jobs;
    for (const std::string& chip : torture_chips())
        jobs.push_back({"rc_chip", "tortured " + chip, torture_chip(chip)});
    REQUIRE_NOTHROW(test::build_all(jobs));
}

TEST_CASE("model and RTL agree under torture") {
    for (const TortureCase& torture : torture_cases(GENERATE(from_range(torture_chips())))) {
        const LockstepResult result = run_torture(torture);
        INFO(torture.name << "\n" << lockstep_lines(result));
        CHECK(result.agrees());
        CHECK(result.counters_compared);
    }
}

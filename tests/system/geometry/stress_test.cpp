// Hard cases: the families match their descriptions, the exact test passes all of them, and faults and
// cheaper tests do not.
#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>

#include "model/base/error.hpp"
#include "sim/explore/stress/aim.hpp"
#include "sim/explore/stress/stress_report.hpp"
#include "sim/explore/stress/sketch.hpp"

namespace rayclock::test::stress_test {

using namespace rayclock;
using namespace rayclock::stress;
using stress::Shot;

namespace {

std::vector<std::string> all_families() {
    std::vector<std::string> names;
    for (const Family& f : families()) names.push_back(f.name);
    return names;
}
Plan small_plan(std::vector<std::string> tests, std::uint64_t rays) {
    Plan plan;
    plan.tests = std::move(tests);
    plan.bits = {12, 16, 20};
    plan.families = all_families();
    plan.rays = rays;
    return plan;
}
std::vector<Counts> counts_of(const StressResult& outcome) {
    std::vector<Counts> counts;
    for (const Cell& cell : outcome.cells) counts.push_back(cell.counts);
    return counts;
}
/// A file that is deleted at the end.
struct Temporary {
    std::string path =
        (std::filesystem::temp_directory_path() /
         ("rayclock_stress_" +
          std::to_string(std::hash<std::string>{}(Catch::getResultCapture().getCurrentTestName()))))
            .string();
    Temporary() { std::filesystem::remove(path); }
    ~Temporary() { std::filesystem::remove(path); }
};

}   // namespace

TEST_CASE(
    "families of hard cases are closed where they say so, lie in the lattice, and have the crossings of the "
    "origin",
    "[stress]") {
    const int bits = GENERATE(12, 15, 18, 20);
    for (const Family& f : families())
        for (unsigned seed = 1; seed <= 4; ++seed) {
            INFO(f.name << " at N = " << bits << ", seed " << seed);
            const Config config = format_of(bits, seed);
            Rng rng(seed);
            const Case subject = f.make(bits, config.dir_bits, rng);
            if (f.closed && !f.leaks) CHECK(subject.mesh.closed());
            const int limit = 1 << (bits - 1), far = 1 << (config.dir_bits - 1);
            for (std::size_t k = 0; k < 3; ++k)
                CHECK((subject.mesh.lo[k] > -limit && subject.mesh.hi[k] < limit));
            const oracle::Surface surface(subject.mesh.triangles);
            std::vector<std::uint32_t> found;
            int hits = 0, unbalanced = 0, outside_format = 0;
            for (int i = 0; i < 300; ++i) {
                const Shot shot = subject.shoot(rng);
                for (std::size_t k = 0; k < 3; ++k)
                    outside_format +=
                        shot.o[k] < -limit || shot.o[k] >= limit || shot.d[k] < -far || shot.d[k] >= far;
                outside_format += shot.d == Vec3i{};
                int sum = shot.inside.value_or(0);
                surface.candidates(shot.o, shot.d, found);
                for (const std::uint32_t t : found) {
                    const int sense = oracle::exact_hit(shot.o, shot.d, subject.mesh.triangles[t], t).sense;
                    sum += sense;
                    hits += sense != 0;
                }
                if (shot.inside && f.closed && !f.leaks) unbalanced += sum != 0;
            }
            CHECK(outside_format == 0);
            CHECK(unbalanced == 0);
            CHECK(hits > 30);
        }
}

TEST_CASE("the exact test meets every demand in every hard case, on every lattice", "[stress]") {
    Plan plan = small_plan({"exact"}, 600'000);
    plan.bits = {12, 13, 14, 15, 16, 17, 18, 19, 20};
    const StressResult outcome = run(plan);
    for (const Cell& cell : outcome.cells) {
        if (family(cell.family).leaks) continue;
        INFO(cell.family << " at N = " << cell.bits);
        CHECK(cell.counts.leaks == 0);
        CHECK(cell.counts.double_hits == 0);
        CHECK(cell.counts.oracle_mismatches == 0);
        CHECK(cell.counts.boxes_lost == 0);
        CHECK(cell.counts.false_shadows + cell.counts.light_leaks == 0);
        CHECK(cell.counts.crossings > cell.counts.rays / 20);
    }
    const auto sound = [](const Cell& cell) { return !family(cell.family).leaks; };
    CHECK(sum(outcome.cells, sound).walked > 25'000);
    CHECK(sum(outcome.cells, sound).shadow_rays > 5'000);
    CHECK(sum(outcome.cells, sound).boxes > 5'000);
    // The surface with gaps leaks, although every decision about it is exact.
    const Counts seams = sum(outcome.cells, [](const Cell& cell) { return cell.family == "t_junction"; });
    CHECK(seams.leaks > 0);
    CHECK(seams.oracle_mismatches == 0);
    CHECK(meets_demand(named_test("exact"), outcome.cells));
}

TEST_CASE("controls are noticed, the sheared test is watertight, float and truncated tests are not",
          "[stress][long]") {
    std::vector<std::string> names;
    for (const NamedTest& test : named_tests()) names.push_back(test.name);
    const StressResult outcome = run(small_plan(names, 1'000'000));
    const auto of = [&](const std::string& test, const std::string& where) {
        return sum(outcome.cells,
                   [&](const Cell& cell) { return cell.test == test && cell.family == where; });
    };
    for (const NamedTest& test : named_tests()) {
        INFO(test.name);
        CHECK(meets_demand(test, outcome.cells));
    }
    CHECK(of("inclusive", "edges").double_hits > of("inclusive", "edges").rays / 2);
    CHECK(of("exclusive", "corners").leaks > of("exclusive", "corners").rays / 2);
    CHECK(of("inward_boxes", "flat_boxes").oracle_mismatches > 0);
    for (const char* baseline : {"unit24", "moller", "truncated"}) {
        INFO(baseline);
        CHECK(of(baseline, "edges").leaks > of(baseline, "edges").rays / 100);
    }
    CHECK(of("woop", "edges").double_hits > 0);
    CHECK(of("moller", "quad").leaks > 0);
    CHECK(of("sheared", "edges").oracle_mismatches > 0);   // watertight, but not exact
}

TEST_CASE("the study distinguishes a test that meets no demand from one that does", "[stress]") {
    const NamedTest exact = named_test("exact"), control = named_test("inclusive");
    Cell clean{"exact", 16, "edges", {}}, seams{"exact", 16, "t_junction", {}};
    clean.counts.rays = seams.counts.rays = 100;
    CHECK_FALSE(meets_demand(exact, {clean, seams}));   // the seams do not leak
    CHECK(has_too_few_rays(exact, {clean, seams}));
    seams.counts.rays = 10'000;
    CHECK_FALSE(has_too_few_rays(exact, {clean, seams}));
    seams.counts.leaks = 1;
    CHECK(meets_demand(exact, {clean, seams}));
    for (auto count : {&Counts::leaks, &Counts::double_hits, &Counts::oracle_mismatches, &Counts::boxes_lost,
                       &Counts::false_shadows, &Counts::light_leaks}) {
        Cell wrong = clean;
        wrong.counts.*count = 1;
        CHECK_FALSE(meets_demand(exact, {wrong, seams}));
        CHECK_FALSE(has_too_few_rays(exact, {wrong, seams}));
    }
    Cell unnoticed = clean;
    unnoticed.test = "inclusive";
    CHECK_FALSE(meets_demand(control, {unnoticed}));
    CHECK(has_too_few_rays(control, {unnoticed}));
    unnoticed.counts.double_hits = 1;
    CHECK(meets_demand(control, {unnoticed}));
}

TEST_CASE("a stress run gives the same counts with any threads, and when it is stopped and gone on with",
          "[stress][long]") {
    Plan plan = small_plan({"exact", "moller"}, 1'500'000);
    plan.bits = {14};
    plan.families = {"edges", "t_junction", "quad"};
    plan.threads = 1;
    const std::vector<Counts> straight = counts_of(run(plan));
    plan.threads = 3;
    CHECK(counts_of(run(plan)) == straight);

    Temporary state;
    plan.state = state.path;
    plan.stop_after = 11;
    const StressResult part = run(plan);
    CHECK(part.partial);
    CHECK(part.rays > 0);
    CHECK(part.rays < 1'650'000);
    plan.stop_after = ~std::uint64_t(0);
    const StressResult rest = run(plan);
    CHECK_FALSE(rest.partial);
    CHECK(rest.rays_before == part.rays);
    CHECK(counts_of(rest) == straight);
    const StressResult again = run(plan);   // nothing is left to do
    CHECK(again.rays_before == again.rays);
    CHECK(counts_of(again) == straight);

    plan.seed = 2;
    CHECK_THROWS_WITH(run(plan), Catch::Contains("is the state of another stress run"));
    std::ofstream(state.path) << "{\"plan\":";
    CHECK_THROWS_WITH(run(plan), Catch::Contains("line 1, column 9"));
}

TEST_CASE("different seeds give different rays", "[stress]") {
    Plan plan = small_plan({"moller"}, 50'000);
    plan.families = {"edges"};
    const std::vector<Counts> first = counts_of(run(plan));
    plan.seed = 2;
    CHECK(counts_of(run(plan)) != first);
}

TEST_CASE("every family has a picture with rays in it", "[stress]") {
    for (const Family& f : families()) {
        INFO(f.name);
        const std::string svg = sketch(f);
        CHECK(svg.starts_with("<svg "));
        CHECK(svg.ends_with("</svg>\n"));
        CHECK(svg.find("nan") == std::string::npos);
        CHECK(svg.find("<circle") != std::string::npos);
        CHECK(svg.find("stroke=\"#888\"") != std::string::npos);
    }
}

}   // namespace rayclock::test::stress_test

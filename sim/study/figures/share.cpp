// Measures the share of time in intersection tests, with and without a hierarchy.
#include <algorithm>

#include <fmt/format.h>

#include "model/base/stopwatch.hpp"
#include "model/scene/builtin.hpp"
#include "sim/judge/reference/whitted.hpp"
#include "sim/study/figures/figures_page.hpp"
#include "sim/view/report/accounts.hpp"
#include "sim/view/report/text.hpp"

namespace rayclock::figures {

namespace {

constexpr const char* share_scenes[] = {"balls:2", "mount:4", "gears:1"};
constexpr int share_depth = 4;

/// Times of the reference on one thread.
struct Measured {
    double total = 0;    ///< seconds of a frame
    double search = 0;   ///< the part spent searching hits
    RefEffort effort;
};

/// Returns the time that reading the clock adds to a search: the least of many batches.
double clock_cost() {
    constexpr int batches = 200, times = 200;
    double least = 1;
    for (int i = 0; i < batches; ++i) {
        double sum = 0;
        for (int k = 0; k < times; ++k) {
            const Stopwatch watch;
            sum += watch.seconds();
        }
        least = std::min(least, sum / times);
    }
    return least;
}

/// Measures a frame several times and returns the quickest, which other work on this computer disturbed
/// least.
Measured measure(RefGeometry& geometry, const Scene& scene, FrameSize size, bool tests_all) {
    Measured best;
    for (int i = 0; i < 3; ++i) {
        Measured m;
        m.effort.tests_all = tests_all;
        geometry.watch(&m.effort);
        const Stopwatch watch;
        ref_whitted(geometry, scene, *scene.camera, size, {.depth = share_depth}, 1, stopping({}));
        m.total = watch.seconds();
        geometry.watch(nullptr);
        // One reading lies inside the search's time, the other outside.
        const double cost = clock_cost() * double(m.effort.rays);
        m.total -= 2 * cost;
        m.search = m.effort.seconds - cost;
        if (i == 0 || m.total < best.total) best = m;
    }
    return best;
}

std::string per_ray(std::uint64_t n, std::uint64_t rays) {
    return fmt::format("{:.1f}", double(n) / double(rays));
}

void reference_rows(Page& page, const std::string& name, std::vector<std::vector<std::string>>& rows) {
    stop_if_interrupted();
    const Scene scene = make_builtin(name, Primitives::native);
    RefGeometry geometry(scene);
    const Measured all = measure(geometry, scene, page.studio().size, true),
                   tree = measure(geometry, scene, page.studio().size, false);
    const double test = all.search / double(all.effort.tests),
                 tests = test * double(tree.effort.tests) / tree.total;
    const std::uint64_t rays = all.effort.rays;
    rows.push_back({name, grouped(primitive_count(scene)), "none", grouped(rays), "0",
                    per_ray(all.effort.tests, rays), per_cent(all.search / all.total),
                    per_cent(all.search / all.total), fmt::format("{:.2f} s", all.total)});
    rows.push_back({name, grouped(primitive_count(scene)), "hierarchy", grouped(tree.effort.rays),
                    per_ray(tree.effort.boxes, rays), per_ray(tree.effort.tests, rays), per_cent(tests),
                    per_cent(tree.search / tree.total), fmt::format("{:.2f} s", tree.total)});
    page.numbers["test_share"][name]["reference"] = {
        {"rays", rays},
        {"without",
         {{"tests", all.effort.tests}, {"search_share", all.search / all.total}, {"seconds", all.total}}},
        {"with",
         {{"boxes", tree.effort.boxes},
          {"tests", tree.effort.tests},
          {"test_share", tests},
          {"search_share", tree.search / tree.total},
          {"seconds", tree.total}}}};
}

void machine_row(Page& page, const std::string& name, Tracer tracer,
                 std::vector<std::vector<std::string>>& rows) {
    Stage stage(page.studio(), name, {.depth = share_depth});
    const Shot shot = stage.take(tracer, {.depth = share_depth});
    const FrameResult& run = *shot.run;
    const std::uint64_t rays = shot.rays.all(), primitives = primitive_count(stage.scene());
    double tri = 0, box = 0, shade = 0;
    for (const UnitAccount& a : unit_accounts(stage.job().config, run)) {
        const double busy = double(a.busy) / (double(a.instances) * double(run.cycles));
        if (a.unit == "tri") tri = busy;
        if (a.unit == "box") box = busy;
        if (a.unit == "shade") shade = busy;
    }
    const double without = double(rays) * double(primitives);
    rows.push_back({name, grouped(primitives), title_of(tracer), grouped(rays), per_ray(run.box_tests, rays),
                    per_ray(run.triangle_tests, rays), per_cent(tri), per_cent(box), per_cent(shade),
                    grouped(run.cycles), grouped(std::uint64_t(without)),
                    fmt::format("{:.0f}", without / double(run.cycles))});
    page.numbers["test_share"][name][title_of(tracer)] = {{"rays", rays},
                                                          {"box_tests", run.box_tests},
                                                          {"tests", run.triangle_tests},
                                                          {"cycles", run.cycles},
                                                          {"tri_busy", tri},
                                                          {"box_busy", box},
                                                          {"shade_busy", shade},
                                                          {"tests_without", without}};
}

}   // namespace

void test_share(Page& page) {
    page.say(
        fmt::format("\n## Time in intersection tests\n\nWhitted (1980) found 75 to 95 % of the time in "
                    "intersection tests; he tested every ray against every object of the scene. Depth {}; "
                    "camera, shadow, reflected and refracted rays.\n",
                    share_depth));
    if (page.studio().has(Tracer::reference)) {
        std::vector<std::vector<std::string>> rows;
        for (const char* scene : share_scenes) reference_rows(page, scene, rows);
        page.say(
            "\nThe reference, on one thread of the computer that made this page. *None*: every ray tests "
            "every primitive; a shadow ray stops at the first blocker. *Search*: the time of boxes and "
            "tests, measured around each ray's search, without the cost of reading the clock. *Tests* with "
            "the hierarchy: their number times the time of one test without it. Times depend on the host and "
            "differ from run to run; the counts do not.\n");
        page.table({"scene", "primitives", "structure", "rays", "boxes a ray", "tests a ray",
                    "tests, of the time", "search, of the time", "frame"},
                   rows);
    }
    std::vector<std::vector<std::string>> rows;
    for (const Tracer tracer : page.measured())
        if (tracer != Tracer::reference)
            for (const char* scene : share_scenes) machine_row(page, scene, tracer, rows);
    if (rows.empty()) return;
    page.say(
        "\nThe machine has a unit for each of these tasks, and the units work at the same time. A share is "
        "the share of cycles in which the unit is busy; the shares need not add up to 100 %. Without a "
        "structure `tri`, with one test a cycle, would need one cycle for each pair of ray and primitive. "
        "That column is computed, not measured.\n");
    page.table({"scene", "primitives", "engine", "rays", "boxes a ray", "tests a ray", "tri busy", "box busy",
                "shade busy", "cycles", "rays x primitives", "times as many"},
               rows);
}

}   // namespace rayclock::figures

// Runs batches of a stress plan on all cores and saves the state.
#include "sim/explore/stress/stress_batches.hpp"

#include <algorithm>
#include <ctime>
#include <filesystem>

#include <fmt/format.h>

#include "model/base/stopwatch.hpp"
#include "model/engine/check.hpp"
#include "sim/explore/stress/shadows.hpp"
#include "sim/explore/stress/state.hpp"
#include "sim/files/process/parallel.hpp"
#include "sim/run/frame/frame.hpp"

namespace rayclock::stress {

namespace {

constexpr std::uint64_t batch_rays = 1 << 17, shadow_every = 64;
constexpr double seconds_between_saves = 5;

/// Returns the processor time of this thread.
double thread_seconds() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

/// Adds secondary rays from the same surface, with the machine's scheme of origins.
void add_shadows(const Mesh& mesh, int coord_bits, std::uint64_t seed, std::uint64_t rays, Counts& counts) {
    const ShadowCounts shadows = shadow_counts(mesh.triangles, coord_bits, seed, rays);
    counts.shadow_rays += shadows.rays;
    counts.false_shadows += shadows.false_shadows;
    counts.light_leaks += shadows.light_leaks;
}

/// Runs one batch of one cell. Each batch has its own seed, so batches may run in any order.
Counts run_batch(const Plan& plan, const Cell& cell, std::uint64_t batch, std::uint64_t rays) {
    const Family& which = family(cell.family);
    const NamedTest& test = named_test(cell.test);
    // The seed does not depend on the test, so all tests get the same rays.
    Rng seeds(plan.seed * 0x100000001b3 + std::uint64_t(cell.bits) * 0x9e3779b9 + batch);
    for (const char* c = which.name; *c; ++c) seeds = Rng(seeds.next() + std::uint64_t(*c));
    Rng rng(seeds.next());
    Config config = format_of(cell.bits, batch);
    config.primitive_test = test.primitive_test;
    const Case subject = which.make(config.coord_bits, config.dir_bits, rng);
    Judge judge(subject, config, test, which.closed);
    Counts counts;
    for (std::uint64_t i = 0; i < rays; ++i) judge.judge(subject.shoot(rng), counts);
    if (test.demand == Demand::truth && which.closed && !which.leaks)
        add_shadows(subject.mesh, cell.bits, rng.next(), rays / shadow_every, counts);
    return counts;
}

/// A batch of a cell.
struct Unit {
    std::size_t cell = 0;
    std::uint64_t batch = 0, rays = 0;
};
/// The batches in execution order: the first batch of every cell, then the second of every cell, and so on.
struct Work {
    std::vector<Cell> cells;
    std::vector<Unit> units;
};

Work make_work(const Plan& plan) {
    Work work;
    std::vector<std::uint64_t> left;
    const std::uint64_t cells_per_test = plan.bits.size() * plan.families.size();
    for (const std::string& test : plan.tests)
        for (const int bits : plan.bits)
            for (const std::string& name : plan.families) {
                work.cells.push_back({test, bits, name, {}});
                const std::uint64_t rays = in_machine(named_test(test)) ? plan.rays : (plan.rays + 9) / 10;
                left.push_back((rays + cells_per_test - 1) / cells_per_test);
            }
    for (std::uint64_t batch = 0; work.units.empty() || work.units.back().batch + 1 == batch; ++batch)
        for (std::size_t i = 0; i < left.size(); ++i) {
            if (left[i] == 0) continue;
            const std::uint64_t rays = std::min(batch_rays, left[i]);
            work.units.push_back({i, batch, rays});
            left[i] -= rays;
        }
    return work;
}

}   // namespace

Config format_of(int bits, std::uint64_t batch) {
    Config config;
    config.coord_bits = bits;
    const int widest = std::min(24, 62 - 2 * bits);
    config.dir_bits = batch % 2 == 0 ? widest : std::max(18, bits + 2);
    config.stack_depth = 64;
    check_config(config, "stress");
    return config;
}

namespace {

/// Returns the number of rays of each cell after `units` units.
std::vector<std::uint64_t> rays_after(const Work& work, std::uint64_t units) {
    std::vector<std::uint64_t> rays(work.cells.size());
    for (std::uint64_t u = 0; u < units; ++u) rays[work.units[u].cell] += work.units[u].rays;
    return rays;
}

/// Loads the counts of an earlier run into the cells. Returns the number of its units.
std::uint64_t go_on(const Plan& plan, Work& work) {
    std::error_code error;
    const bool is_new =
        std::filesystem::status(plan.state, error).type() == std::filesystem::file_type::not_found;
    if (plan.state.empty() || is_new) return 0;
    return read_state(plan, work.cells, work.units.size(),
                      [&](std::uint64_t units) { return rays_after(work, units); });
}

/// The result of a unit, and its processor time.
struct UnitResult {
    std::size_t unit = 0;
    Counts counts;
    double seconds = 0;
};

}   // namespace

StressResult run(const Plan& plan, const Progress& progress) {
    Work work = make_work(plan);
    const std::uint64_t first = go_on(plan, work),
                        end = std::min<std::uint64_t>(work.units.size(), plan.stop_after);
    StressResult outcome;
    std::uint64_t rays_all = 0;
    for (std::size_t u = 0; u < work.units.size(); ++u) {
        if (u < first) outcome.rays_before += work.units[u].rays;
        rays_all += work.units[u].rays;
    }

    const Stopwatch watch;
    double saved = 0;
    std::uint64_t added = first, done_rays = outcome.rays_before;
    const auto save = [&] {
        if (!plan.state.empty()) write_state(plan, work.cells, added);
        saved = watch.seconds();
    };
    const auto make = [&](std::size_t i) {
        const double begin = thread_seconds();
        const Unit& unit = work.units[first + i];
        UnitResult made{first + i, run_batch(plan, work.cells[unit.cell], unit.batch, unit.rays), 0};
        made.seconds = thread_seconds() - begin;
        return made;
    };
    // Adds results in the order of units, so that a saved state always covers a prefix of them.
    const auto take = [&](const UnitResult& made) {
        work.cells[work.units[made.unit].cell].counts += made.counts;
        ++added;
        done_rays += made.counts.rays;
        outcome.core_seconds += made.seconds;
        if (progress)
            progress(fmt::format("rays, {:.2f} M/s",
                                 double(done_rays - outcome.rays_before) / 1e6 / watch.seconds()),
                     done_rays, rays_all);
        if (watch.seconds() - saved > seconds_between_saves) save();
    };
    parallel::in_order(
        plan.threads, [&](std::size_t i) { return first + i < end && !interrupted(); }, make, take);
    save();

    outcome.partial = added < work.units.size();
    outcome.seconds = watch.seconds();
    for (const Cell& cell : work.cells) outcome.rays += cell.counts.rays;
    outcome.cells = std::move(work.cells);
    return outcome;
}

}   // namespace rayclock::stress

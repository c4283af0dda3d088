#include "sim/stress/run.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <ctime>
#include <filesystem>
#include <future>
#include <mutex>
#include <thread>

#include <fmt/format.h>

#include "sim/engine/engine.hpp"
#include "sim/stress/shadows.hpp"
#include "sim/stress/state.hpp"

namespace rayclock::stress {

namespace {

constexpr std::uint64_t batch_rays = 1 << 17, shadow_every = 64;
constexpr double seconds_between_saves = 5;

/// Processor time of this thread.
double thread_seconds() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

/// Secondary rays from the same surface, by the machine's scheme of origins.
void add_shadows(const Mesh& mesh, int coord_bits, std::uint64_t seed, std::uint64_t rays, Counts& counts) {
    const ShadowCounts shadows = shadow_counts(mesh.triangles, coord_bits, seed, rays);
    counts.shadow_rays += shadows.rays;
    counts.false_shadows += shadows.false_shadows;
    counts.light_leaks += shadows.light_leaks;
}

/// One batch of one cell; its seed is its own, so that batches may be run in any order.
Counts run_batch(const Plan& plan, const Cell& cell, std::uint64_t batch, std::uint64_t rays) {
    const Family& which = family(cell.family);
    const NamedTest& test = named_test(cell.test);
    // All tests see the same rays.
    Rng seeds(plan.seed * 0x100000001b3 + std::uint64_t(cell.bits) * 0x9e3779b9 + batch);
    for (const char* c = which.name; *c; ++c) seeds = Rng(seeds.next() + std::uint64_t(*c));
    Rng rng(seeds.next());
    Config config = format_of(cell.bits, batch);
    config.primitive_test = int(test.primitive_test);
    const Case subject = which.make(config.coord_bits, config.dir_bits, rng);
    Judge judge(subject, config, test, which.closed);
    Counts counts;
    for (std::uint64_t i = 0; i < rays; ++i) judge.judge(subject.shoot(rng), counts);
    if (test.demand == Demand::truth && which.closed && !which.leaks) add_shadows(subject.mesh, cell.bits, rng.next(), rays / shadow_every, counts);
    return counts;
}

/// A batch of a cell.
struct Unit {
    std::size_t cell = 0;
    std::uint64_t batch = 0, rays = 0;
};
/// The work in the order in which it is done: every cell's first batch, then every cell's second, and so on.
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

} // namespace

Config format_of(int bits, std::uint64_t batch) {
    Config config;
    config.coord_bits = bits;
    const int widest = std::min(24, 62 - 2 * bits);
    config.dir_bits = batch % 2 == 0 ? widest : std::max(18, bits + 2);
    config.stack_depth = 64;
    check_config(config, "stress");
    return config;
}

Outcome run(const Plan& plan, const Progress& progress) {
    using Clock = std::chrono::steady_clock;
    Work work = make_work(plan);
    std::uint64_t first = 0;
    const auto rays_after = [&](std::uint64_t batches) {
        std::vector<std::uint64_t> rays(work.cells.size());
        for (std::uint64_t u = 0; u < batches; ++u) rays[work.units[u].cell] += work.units[u].rays;
        return rays;
    };
    std::error_code error;
    const bool is_new = std::filesystem::status(plan.state, error).type() == std::filesystem::file_type::not_found;
    if (!plan.state.empty() && !is_new) first = read_state(plan, work.cells, work.units.size(), rays_after);

    Outcome outcome;
    std::uint64_t rays_all = 0;
    for (std::size_t u = 0; u < work.units.size(); ++u) (u < first ? outcome.rays_before : rays_all) += work.units[u].rays;
    rays_all += outcome.rays_before;

    // Results are added up in the order of the units, so that a state is always that of a beginning.
    const auto start = Clock::now();
    std::vector<std::optional<Counts>> results(work.units.size() - std::min<std::size_t>(first, work.units.size()));
    std::uint64_t added = first;
    std::atomic<std::uint64_t> next = first, done_rays = outcome.rays_before;
    std::mutex mutex;
    auto saved = start;
    const auto save = [&] {
        if (!plan.state.empty()) write_state(plan, work.cells, added);
        saved = Clock::now();
    };
    std::atomic<double> core_seconds = 0;
    const auto help = [&] {
        const double begin = thread_seconds();
        for (std::uint64_t u = next++; u < std::min<std::uint64_t>(work.units.size(), plan.stop_after) && !interrupted(); u = next++) {
            const Unit& unit = work.units[u];
            const Counts counts = run_batch(plan, work.cells[unit.cell], unit.batch, unit.rays);
            done_rays += counts.rays;
            const std::lock_guard lock(mutex);
            results[u - first] = counts;
            for (; added < work.units.size() && results[added - first]; ++added) work.cells[work.units[added].cell].counts += *results[added - first];
            if (progress) progress(fmt::format("rays, {:.2f} M/s", double(done_rays - outcome.rays_before) / 1e6 / std::chrono::duration<double>(Clock::now() - start).count()),
                                   done_rays, rays_all);
            if (std::chrono::duration<double>(Clock::now() - saved).count() > seconds_between_saves) save();
        }
        core_seconds = core_seconds + thread_seconds() - begin;
    };
    const std::size_t cores = plan.threads > 0 ? std::size_t(plan.threads) : std::max(1u, std::thread::hardware_concurrency());
    std::vector<std::future<void>> helpers;
    for (std::size_t i = 1; i < cores; ++i) helpers.push_back(std::async(std::launch::async, help));
    help();
    for (auto& helper : helpers) helper.get();
    save();

    outcome.partial = added < work.units.size();
    outcome.seconds = std::chrono::duration<double>(Clock::now() - start).count();
    outcome.core_seconds = core_seconds;
    for (const Cell& cell : work.cells) outcome.rays += cell.counts.rays;
    outcome.cells = std::move(work.cells);
    return outcome;
}

} // namespace rayclock::stress

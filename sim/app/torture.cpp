// rayclock verify --torture: runs frames that reach the machine's extreme cases, on model and RTL in
// lockstep.

#include <fmt/format.h>

#include "model/base/stopwatch.hpp"
#include "sim/app/options/commands.hpp"
#include "sim/app/options/options.hpp"
#include "sim/explore/torture/torture.hpp"
#include "sim/files/process/parallel.hpp"
#include "sim/run/rtl/builder.hpp"
#include "sim/view/report/json.hpp"
#include "sim/view/report/lockstep.hpp"
#include "sim/view/report/text.hpp"

namespace rayclock {

namespace {

nlohmann::ordered_json case_json(const TortureCase& torture, const LockstepResult& r) {
    return {{"name", torture.name},
            {"frames", torture.frames.size()},
            {"events_compared", r.events_compared},
            {"value_mismatches", r.value_mismatches},
            {"account_mismatches", r.account_mismatches},
            {"cycle_gap", r.cycle_gap},
            {"first_divergence", divergence_json(r.first)},
            {"counters_compared", r.counters_compared},
            {"first_counter", counter_json(r.counter)},
            {"digest", digest_text(r.model.digest)}};
}

/// A case of the set, and its result in lockstep.
struct TortureRun {
    const TortureCase* torture;
    LockstepResult result;
};

/// Sums over the cases that have run.
struct TortureTotals {
    nlohmann::ordered_json cases = nlohmann::ordered_json::array();
    std::uint64_t frames = 0, transfers = 0, failed = 0;

    void add(const TortureRun& run) {
        cases.push_back(case_json(*run.torture, run.result));
        frames += run.torture->frames.size();
        transfers += run.result.events_compared;
        failed += !run.result.agrees();
    }
    bool is_good() const { return failed == 0 && !interrupted(); }
    const char* verdict() const {
        return is_good() ? "VERIFIED" : interrupted() ? "PARTIAL: interrupted" : "FAILED";
    }
};

/// Builds the RTL of the set's chips. Returns all cases.
std::vector<TortureCase> build_torture_set(const std::vector<std::string>& chips) {
    parallel::for_each(chips.size(), 0, [&](std::size_t i) { build_rtl(torture_chip(chips[i])); });
    std::vector<TortureCase> all;
    for (const std::string& chip : chips)
        for (TortureCase& torture : torture_cases(chip)) all.push_back(std::move(torture));
    return all;
}

/// Runs the cases on all cores, and prints those that differ.
TortureTotals run_cases(const std::vector<TortureCase>& all, bool is_quiet) {
    const Progress progress = terminal_progress();
    TortureTotals totals;
    parallel::in_order(
        0, [&](std::size_t i) { return i < all.size() && !interrupted(); },
        [&](std::size_t i) {
            return TortureRun{&all[i], run_torture(all[i])};
        },
        [&](const TortureRun& run) {
            totals.add(run);
            if (!run.result.agrees() && !is_quiet)
                fmt::print("{}:\n{}", run.torture->name, lockstep_lines(run.result));
            if (progress) progress("torture", totals.cases.size(), all.size());
        });
    return totals;
}

}   // namespace

int run_torture_set(const JsonOutput& json) {
    const Stopwatch watch;
    const std::vector<std::string>& chips = torture_chips();
    const TortureTotals totals = run_cases(build_torture_set(chips), json.is_alone());
    const double seconds = watch.seconds();
    if (!json.is_alone())
        fmt::print(
            "  torture: {} cases on {} chips, {} frames, {} transfers compared, {} cases differ\n  {} in "
            "{:.1f} s\n",
            totals.cases.size(), chips.size(), totals.frames, grouped(totals.transfers), totals.failed,
            totals.verdict(), seconds);
    json.write({{"torture", totals.cases}, {"partial", interrupted()}, {"host", {{"seconds", seconds}}}});
    return totals.is_good() ? 0 : 1;
}

}   // namespace rayclock

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

struct Made {
    const TortureCase* torture;
    LockstepResult result;
};

}   // namespace

int run_torture_set(const JsonOutput& json) {
    const Stopwatch watch;
    const Progress progress = terminal_progress();
    const std::vector<std::string>& chips = torture_chips();
    parallel::for_each(chips.size(), 0, [&](std::size_t i) { build_rtl(torture_chip(chips[i])); });
    std::vector<TortureCase> all;
    for (const std::string& chip : chips)
        for (TortureCase& torture : torture_cases(chip)) all.push_back(std::move(torture));
    nlohmann::ordered_json cases = nlohmann::ordered_json::array();
    std::uint64_t frames = 0, transfers = 0, failed = 0;
    parallel::in_order(
        0, [&](std::size_t i) { return i < all.size() && !interrupted(); },
        [&](std::size_t i) {
            return Made{&all[i], run_torture(all[i])};
        },
        [&](const Made& made) {
            const auto& [torture, result] = made;
            cases.push_back(case_json(*torture, result));
            frames += torture->frames.size();
            transfers += result.events_compared;
            failed += !result.agrees();
            if (!result.agrees() && !json.is_alone())
                fmt::print("{}:\n{}", torture->name, lockstep_lines(result));
            if (progress) progress("torture", cases.size(), all.size());
        });
    const bool good = failed == 0 && !interrupted();
    const double seconds = watch.seconds();
    if (!json.is_alone())
        fmt::print(
            "  torture: {} cases on {} chips, {} frames, {} transfers compared, {} cases differ\n  {} in "
            "{:.1f} s\n",
            cases.size(), chips.size(), frames, grouped(transfers), failed,
            good            ? "VERIFIED"
            : interrupted() ? "PARTIAL: interrupted"
                            : "FAILED",
            seconds);
    json.write({{"torture", cases}, {"partial", interrupted()}, {"host", {{"seconds", seconds}}}});
    return good ? 0 : 1;
}

}   // namespace rayclock

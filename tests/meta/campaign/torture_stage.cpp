// The stage in which the torture set judges every fault.
#include <cstdio>
#include <stdexcept>

#include <fmt/format.h>

#include "sim/run/rtl/builder.hpp"
#include "tests/meta/campaign/copies.hpp"
#include "tests/meta/campaign/judge.hpp"
#include "tests/meta/campaign/stages.hpp"

namespace rayclock::campaign {

namespace fs = std::filesystem;

namespace {

constexpr int most_seconds = 600;   // of a sound run, on the processor

/// `judge` is given the number of a fault, 0 for none, and how many seconds it may take. With a fault a run
/// may take three times as long as without; then it does not end.
void torture_all(const fs::path& folder, const std::function<Verdict(int, int)>& judge) {
    std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
    const Verdict sound = judge(0, most_seconds);
    if (sound.noticed) throw std::runtime_error("with every fault asleep the torture set fails: " + sound.by);
    fmt::print("with every fault asleep: {:.1f} s\n", sound.seconds);
    const int limit = 10 + 3 * int(sound.seconds);
    const Lines mutants = lines_of(folder / "mutants"), done = lines_of(folder / "torture");
    int noticed = 0;
    for (const auto& [number, line] : mutants) {
        if (done.contains(number)) {
            noticed += is_noticed(done, number);
            continue;
        }
        const Verdict verdict = judge(number, limit);
        noticed += verdict.noticed;
        append(folder / "torture", number, verdict);
        if (!verdict.noticed) fmt::print("survived: {}\n", description(line));
    }
    fmt::print("{} of {} noticed by the torture set\n", noticed, mutants.size());
}

}   // namespace

void torture_rtl(const fs::path& folder) {
    use_rtl_copy(folder);
    const Caller caller = caller_of(folder);
    caller.call(0);
    for (const std::string& chip : torture_chips()) build_rtl(torture_chip(chip));
    const TortureJudge judge(torture_chips(), true);
    torture_all(folder, [&](int number, int seconds) {
        caller.call(number);
        const Verdict verdict = judge(seconds);
        caller.call(0);
        return verdict;
    });
}

void torture_model(const fs::path& folder) {
    for (const std::string& chip : torture_chips()) build_rtl(torture_chip(chip));
    const TortureJudge judge(torture_chips(), false);
    torture_all(folder, [&](int number, int seconds) { return judge.with_fault(number, seconds); });
}

}   // namespace rayclock::campaign

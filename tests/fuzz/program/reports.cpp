// Fuzzes the reports that this program reads back: parts of sweeps, reports and pages of simulate.
#include <nlohmann/json.hpp>

#include "sim/view/compare/compare.hpp"
#include "sim/explore/sweep/front.hpp"
#include "sim/explore/sweep/key.hpp"
#include "sim/explore/sweep/merge.hpp"
#include "sim/explore/sweep/table.hpp"
#include "tests/fuzz/program/scratch.hpp"
#include "tests/fuzz/program/targets.hpp"

namespace rayclock {

// Only the whole program has this function.
const char* sweep::program_stamp() { return "fuzzed"; }

namespace fuzz {

namespace {

int clock_of(const std::string& text) {
    if (text.empty()) throw UserError("no clock");
    return 66'000;
}

}   // namespace

void merge(std::string_view bytes) {
    const std::string file = scratch_file("part.json", bytes);
    passes([&] {
        const sweep::MergedSweep merged = sweep::merge({file}, clock_of);
        const auto& [axes, results] = std::tie(merged.settings.axes, merged.outcome.results);
        demand(!axes.empty() && !results.empty(), "a sweep has axes and points");
        const sweep::Front front = sweep::front_of(results, sweep::parse_cost(merged.settings.cost));
        const std::string csv = sweep::csv(axes, results, front);
        demand(csv.size() > results.size(), "a table has a row for each point");
        demand(sweep::points_json(axes, results, front).size() == results.size(), "each point is told again");
        sweep::text(axes, merged.outcome, front);
        sweep::knee_json(axes, results, front);
    });
}

void compare(std::string_view bytes) {
    const std::string file = scratch_file("report", bytes), other = fuzz::file("report.html").string();
    passes([&] {
        for (const std::vector<std::string>& pair :
             {std::vector<std::string>{file, file}, {other, file}, {file, other}}) {
            std::vector<NamedReport> reports;
            for (const std::string& name : pair) reports.push_back(read_report(name));
            const Comparison comparison = compare_reports(reports);
            if (pair[0] == pair[1]) demand(comparison.differences.empty(), "a report is equal to itself");
            comparison_text(reports, comparison, 0);
            comparison_json(reports, comparison);
            beyond(comparison, {"clocks.*.cycles"}, 0);
            if (const auto change = pixel_change(reports[0], reports[1]); change && pair[0] == pair[1])
                demand(change->faster == 0 && change->slower == 0, "no pixel is faster than itself");
        }
    });
}

}   // namespace fuzz
}   // namespace rayclock

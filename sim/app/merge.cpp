// rayclock merge: joins the parts of a sweep that several machines computed.
#include <fmt/format.h>

#include "sim/app/options/commands.hpp"
#include "sim/app/parts/sweep_outputs.hpp"
#include "sim/app/run/sweep_run.hpp"

namespace rayclock {

namespace {

struct MergeOptions {
    std::vector<std::string> reports;
    SweepOutputs outputs;
};

void declare_merge(Parser& parser, MergeOptions& o) {
    parser
        .option("REPORT", o.reports,
                "reports that sweep --shard wrote with --json, of all parts and in any order; or one of a "
                "whole sweep, to draw it again")
        .required();
    sweep_outputs(parser, o.outputs);
}

int run_merge(const MergeOptions& o) {
    check_outputs(o.outputs);
    const sweep::MergedSweep merged = sweep::merge(o.reports, axis_clock);
    const sweep::SweepSettings& settings = merged.settings;
    check_plots(o.outputs, settings.axes,
                settings.is_stream()     ? Drawn::stream
                : settings.has_picture() ? Drawn::picture
                                         : Drawn::sample);
    write_sweep(o.outputs, merged,
                fmt::format("{} points from {} file{}", merged.outcome.results.size(), o.reports.size(),
                            o.reports.size() == 1 ? "" : "s"),
                nullptr);
    return 0;
}

}   // namespace

Command merge_command() {
    return command("merge", "join the parts of a sweep that several machines computed",
                   "rayclock merge part1.json part2.json --json sweep.json -o sweep.csv", declare_merge,
                   run_merge);
}

}   // namespace rayclock

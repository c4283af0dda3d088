// rayclock compare: what changed between reports.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"
#include "sim/app/commands.hpp"
#include "sim/app/options.hpp"
#include "sim/compare/compare.hpp"
#include "sim/files/streams.hpp"

namespace rayclock {

namespace {

struct Options {
    std::vector<std::string> reports, figures;
    std::optional<std::string> max_worse;
    bool all = false;
    JsonOutput json;
};

void declare(Parser& parser, Options& o) {
    parser.option("REPORT", o.reports, "reports that simulate or verify wrote with --json; two or more")
        .required();
    parser.flag("--all", o.all, "print every figure that differs, and not only the thirty largest changes");
    parser.option("--max-worse", o.max_worse,
                  "exit code 1 if the last report is worse than the first by more than this percentage: 2%");
    parser.option(
        "--figure", o.figures,
        "a figure that --max-worse looks at, with all below it; * is any one key; may be repeated. "
        "Without it: cycles and bytes of every clock, pixels with another primitive, PSNR, wrong pixels");
    json_option(parser, o.json);
}

int run(const Options& o) {
    if (o.reports.size() < 2) throw UserError("compare needs two reports or more");
    if (!o.figures.empty() && !o.max_worse) throw UserError("--figure needs --max-worse");
    const double share = o.max_worse ? parse_percent("--max-worse", *o.max_worse, true) / 100 : 0;
    o.json.check();
    std::vector<NamedReport> reports;
    for (const std::string& file : o.reports) reports.push_back(read_report(file));
    const Comparison comparison = compare_reports(reports);
    const std::vector<std::string> figures =
        o.figures.empty()
            ? std::vector<std::string>{"clocks.*.cycles", "clocks.*.dram_bytes",
                                       "error.pixels_other_primitive", "error.psnr_db", "judge.wrong"}
            : o.figures;
    const std::vector<Difference> bad =
        o.max_worse ? beyond(comparison, figures, share) : std::vector<Difference>{};
    std::vector<std::string> names;
    for (const Difference& d : bad) names.push_back(d.figure);
    if (!o.json.is_alone()) {
        write_output(comparison_text(reports, comparison, o.all ? 0 : 30));
        if (o.max_worse)
            write_output(bad.empty() ? fmt::format("  nothing is worse by more than {}\n", *o.max_worse)
                                     : fmt::format("  WORSE by more than {}: {}\n", *o.max_worse,
                                                   printable(fmt::format("{}", fmt::join(names, ", ")))));
    }
    nlohmann::ordered_json json = comparison_json(reports, comparison);
    json["worse"] = names;
    o.json.write(json);
    return bad.empty() ? 0 : 1;
}

}   // namespace

Command compare_command() {
    return command("compare", "what changed between reports, for better or worse",
                   "rayclock compare before.json after.json --max-worse 1%", declare, run);
}

}   // namespace rayclock

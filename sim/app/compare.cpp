// rayclock compare: compares reports.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"
#include "sim/app/options/command_line.hpp"
#include "sim/app/options/commands.hpp"
#include "sim/app/options/options.hpp"
#include "sim/files/output.hpp"
#include "sim/files/streams.hpp"
#include "sim/view/compare/compare.hpp"
#include "sim/view/page/frame.hpp"

namespace rayclock {

namespace {

struct CompareOptions {
    std::vector<std::string> reports, figures;
    std::optional<std::string> max_worse;
    bool all = false;
    std::string report;
    JsonOutput json;
};

void declare_compare(Parser& parser, CompareOptions& o) {
    parser
        .option("REPORT", o.reports,
                "reports that simulate or verify wrote with --json, or simulate with --report; two or more")
        .required();
    parser.flag("--all", o.all, "print every figure that differs, not only the thirty largest changes");
    parser.option("--max-worse", o.max_worse,
                  "exit code 1 if the last report is worse than the first by more than this percentage: 2%");
    parser.option(
        "--figure", o.figures,
        "a figure that --max-worse checks, with all figures below it; * stands for any key; may be repeated. "
        "Without it: cycles and bytes of every clock, pixels with another primitive, PSNR, wrong pixels");
    parser.option(
        "--report", o.report,
        "one HTML file: effects; for pages of simulate also the cycles that each pixel gained or lost");
    json_option(parser, o.json);
}

int run_compare(const CompareOptions& o) {
    if (o.reports.size() < 2) throw UserError("compare needs two reports or more");
    if (!o.figures.empty() && !o.max_worse) throw UserError("--figure needs --max-worse");
    const double share = o.max_worse ? parse_percent("--max-worse", *o.max_worse, true) / 100 : 0;
    o.json.check();
    if (!o.report.empty()) {
        check_writable(o.report);
        check_page_library();
    }
    std::vector<NamedReport> reports;
    for (const std::string& file : o.reports) reports.push_back(read_report(file));
    const Comparison comparison = compare_reports(reports);
    const std::optional<PixelChange> change = pixel_change(reports.front(), reports.back());
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
    if (!o.report.empty()) {
        std::vector<std::pair<std::string, std::string>> origin{{"command", command_line()}};
        for (auto& version : versions()) origin.push_back(std::move(version));
        write_bytes(o.report, comparison_page(reports, comparison, origin));
    }
    nlohmann::ordered_json json = comparison_json(reports, comparison);
    json["pixels"] = nullptr;
    if (change)
        json["pixels"] = {{"faster", change->faster},
                          {"slower", change->slower},
                          {"equal", change->equal},
                          {"cycles_gained", change->gained},
                          {"cycles_lost", change->lost}};
    json["worse"] = names;
    o.json.write(json);
    return bad.empty() ? 0 : 1;
}

}   // namespace

Command compare_command() {
    return command("compare", "compare reports: which figures are better, which are worse",
                   "rayclock compare before.json after.json --max-worse 1%", declare_compare, run_compare);
}

}   // namespace rayclock

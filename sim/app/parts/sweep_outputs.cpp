// Checks and writes the outputs of sweep and merge.
#include "sim/app/parts/sweep_outputs.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "model/base/nearest.hpp"
#include "sim/app/options/command_line.hpp"
#include "sim/app/run/sweep_run.hpp"
#include "sim/explore/sweep/cost.hpp"
#include "sim/explore/sweep/plot.hpp"
#include "sim/explore/sweep/sweep_page.hpp"
#include "sim/explore/sweep/table.hpp"
#include "sim/files/output.hpp"
#include "sim/files/streams.hpp"
#include "sim/view/page/frame.hpp"
#include "sim/view/report/text.hpp"

namespace rayclock {

void sweep_outputs(Parser& parser, SweepOutputs& o) {
    parser.option("-o,--output", o.table, "table as CSV");
    parser.option(
        "--plot", o.plots,
        "NAME, NAME.svg or NAME.pdf: plots error against cost and against speed, with the fronts and the "
        "knee; X,Y=NAME: plots column Y of the table against column X; X,Y writes X-Y.svg; may be repeated");
    parser.option("--report", o.report,
                  "one HTML file: all points in linked charts, fronts, each axis alone");
    limits_options(parser, o.limits);
    json_option(parser, o.json);
}

namespace {

/// The argument of --plot.
struct Plot {
    std::string name;
    /// Columns X and Y; empty for the fronts.
    std::optional<std::pair<std::string, std::string>> columns;
};
Plot plot_of(const std::string& typed) {
    const std::size_t equals = typed.find('='), comma = typed.substr(0, equals).find(',');
    if (comma == std::string::npos) {
        if (equals != std::string::npos)
            throw UserError("--plot: " + shown(typed) + " is not NAME, X,Y or X,Y=NAME");
        return {typed, std::nullopt};
    }
    const std::string columns = typed.substr(0, equals), x = columns.substr(0, comma),
                      y = columns.substr(comma + 1);
    std::string name = equals == std::string::npos ? x + "-" + y : typed.substr(equals + 1);
    // Linked axes have slashes in their names.
    if (equals == std::string::npos) std::replace(name.begin(), name.end(), '/', '-');
    if (name.empty()) throw UserError("--plot: " + shown(typed) + " names no file after the columns");
    return {name, std::pair(x, y)};
}

}   // namespace

void check_plots(const SweepOutputs& o, const std::vector<sweep::Axis>& axes, Drawn drawn) {
    const bool has_picture = drawn == Drawn::picture;
    const char* const what = drawn == Drawn::stream ? "a stream of rays" : "a sample";
    if (!has_picture && !o.report.empty())
        throw UserError(fmt::format("--report shows the errors of pictures, and {} has no picture", what));
    const std::vector<std::string> known = sweep::column_names(axes);
    for (const std::string& typed : o.plots)
        if (const Plot plot = plot_of(typed); plot.columns)
            for (const std::string& column : {plot.columns->first, plot.columns->second}) {
                if (std::find(known.begin(), known.end(), column) == known.end())
                    throw UserError("--plot: the table has no column " + shown(column) +
                                    did_you_mean(column, known));
                if (!has_picture && sweep::is_of_picture(column))
                    throw UserError(fmt::format("--plot: the column {} is empty, because {} has no picture",
                                                shown(column), what));
                if (sweep::has_words(axes, column))
                    throw UserError("--plot: the column " + shown(column) + " holds words, not numbers");
            }
}

void check_outputs(const SweepOutputs& o) {
    limits_of(o.limits);
    o.json.check();
    if (!o.table.empty()) check_writable(o.table);
    for (const std::string& typed : o.plots) plot::check_plot_path(plot_of(typed).name);
    if (o.report.empty()) return;
    check_writable(o.report);
    check_page_library();
}

void write_sweep(const SweepOutputs& o, const sweep::MergedSweep& swept, const std::string& how,
                 const nlohmann::ordered_json& shard) {
    const std::vector<sweep::Axis>& axes = swept.settings.axes;
    const std::vector<sweep::Result>& results = swept.outcome.results;
    const sweep::Front front = sweep::front_of(results, sweep::parse_cost(swept.settings.cost));
    const std::string scene = swept.scene.at("name").get<std::string>();
    const Limits limits = limits_of(o.limits);
    const std::string far = sweep::far_points(axes, results, limits);
    if (!o.json.is_alone()) {
        if (!far.empty()) write_output(far + "\n");
        const nlohmann::ordered_json& stream = swept.settings.stream;
        const std::string traced =
            swept.settings.is_stream()
                ? fmt::format("{} rays of {}", grouped(stream.at("rays").get<std::uint64_t>()),
                              printable(stream.at("file").get<std::string>()))
                : fmt::format("{}x{}", swept.size.width, swept.size.height) +
                      (swept.settings.has_picture()
                           ? ""
                           : fmt::format(", samples of {:g} %",
                                         100 * swept.settings.sample.at("share").get<double>()));
        write_output(fmt::format("{}, {}: {}\n{}", printable(scene), traced, how,
                                 sweep::text(axes, swept.outcome, front)));
        if (swept.outcome.partial)
            write_output("  PARTIAL: interrupted; the same command continues where it stopped\n");
    }
    if (!o.table.empty()) write_file(o.table, sweep::csv(axes, results, front));
    for (const std::string& typed : o.plots) {
        const Plot plot = plot_of(typed);
        plot::write_plot(plot.name, plot.columns
                                        ? sweep::column_plot(scene, swept.size, axes, results, front,
                                                             plot.columns->first, plot.columns->second)
                                        : sweep::front_plot(scene, swept.size, axes, results, front));
    }
    if (!o.report.empty()) {
        std::vector<std::pair<std::string, std::string>> origin{{"command", command_line()}};
        for (auto& version : versions()) origin.push_back(std::move(version));
        write_bytes(o.report, sweep::sweep_page(swept, front, far, origin));
    }
    o.json.write(sweep_json(swept, limits, shard));
}

}   // namespace rayclock

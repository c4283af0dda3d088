// rayclock study sampling: makes docs/measured/sampling-figures.md.
#include <fmt/format.h>

#include "model/base/quote.hpp"
#include "sim/app/options/commands.hpp"
#include "sim/app/options/options.hpp"
#include "sim/files/output.hpp"
#include "sim/files/process/stopping.hpp"
#include "sim/study/sampling.hpp"
#include "sim/study/typed.hpp"
#include "sim/view/report/text.hpp"

namespace rayclock {

namespace {

constexpr int usual_seeds = 300;
constexpr double least_coverage = 0.93, max_coverage = 0.97;

struct SamplingOptions {
    std::string output;
    int seeds = usual_seeds;
    int threads = 0;
    JsonOutput json;
};

void declare_sampling(Parser& parser, SamplingOptions& o) {
    parser.option("-o,--output", o.output, "Markdown file to write");
    parser.option("--seeds", o.seeds, "samples of each frame").within(2, 100000).with_default();
    threads_option(parser, o.threads);
    json_option(parser, o.json);
}

int run_sampling(const SamplingOptions& o) {
    o.json.check();
    if (!o.output.empty()) check_writable(o.output);
    sampling::Study study;
    study.frames = sampling::usual_frames();
    study.seeds = o.seeds;
    study.threads = o.threads;
    const std::vector<sampling::FrameRows> rows = sampling::measure(study, stopping(terminal_progress()));
    std::string command = "rayclock study sampling";
    if (o.seeds != usual_seeds) command += fmt::format(" --seeds {}", o.seeds);
    const std::string page = sampling::page(rows, study, command + " -o " + page_path(o.output));
    if (!o.output.empty()) write_file(o.output, page);
    const double covered = sampling::coverage(rows);
    if (!o.json.is_alone()) {
        if (o.output.empty()) fmt::print("{}", page);
        fmt::print("the intervals contain the cycles in {:.1f} % of {} samples\n", 100 * covered,
                   rows.size() * std::size_t(o.seeds));
    }
    o.json.write(sampling::rows_json(rows));
    return covered >= least_coverage && covered <= max_coverage ? 0 : 1;
}

}   // namespace

Command sampling_command() {
    return command("sampling", "docs/measured/sampling-figures.md: samples of frames against whole frames",
                   "rayclock study sampling -o docs/measured/sampling-figures.md", declare_sampling,
                   run_sampling);
}

}   // namespace rayclock

// rayclock study tradeoff: makes docs/measured/speed-against-error.md with its plots.
#include <fmt/format.h>

#include "model/base/quote.hpp"
#include "sim/app/options/commands.hpp"
#include "sim/app/options/options.hpp"
#include "sim/run/rtl/builder.hpp"
#include "sim/study/tradeoff.hpp"
#include "sim/study/typed.hpp"
#include "sim/view/report/text.hpp"

namespace rayclock {

namespace {

struct TradeoffOptions {
    std::string output, size = default_size;
    std::vector<std::string> scenes = sweep::default_tradeoff_scenes();
    LimitsChoice limits;
    bool fresh = false, no_netlist = false;
    int threads = 0;
};

void declare_tradeoff(Parser& parser, TradeoffOptions& o) {
    parser.option("-o,--output", o.output, "Markdown file to write; the plots go next to it").required();
    parser.option("--scenes", o.scenes, "scenes, separated by commas").by_commas().with_default();
    size_option(parser, o.size);
    fresh_option(parser, o.fresh);
    netlist_option(parser, o.no_netlist);
    limits_options(parser, o.limits);
    threads_option(parser, o.threads);
}

std::string command_of(const TradeoffOptions& o) {
    std::string text = "rayclock study tradeoff -o " + page_path(o.output);
    if (o.scenes != sweep::default_tradeoff_scenes())
        text += fmt::format(" --scenes {}", fmt::join(o.scenes, ","));
    if (o.size != default_size) text += " --size " + o.size;
    if (o.no_netlist) text += " --no-netlist";
    return text + typed_limits(o.limits);
}

int run_tradeoff(const TradeoffOptions& o) {
    const FrameSize size = parse_size(o.size);
    const Limits limits = limits_of(o.limits);
    sweep::check_tradeoff_paths(o.output, o.scenes);
    const Progress progress = terminal_progress();
    results::Cache cache(rtl_cache() / "sweep", o.fresh);
    sweep::write_tradeoff(o.output, {o.scenes, size, o.threads, !o.no_netlist, limits}, command_of(o), cache,
                          progress);
    fmt::print("{} written\n", printable(o.output));
    return 0;
}

}   // namespace

Command tradeoff_command() {
    return command("tradeoff", "docs/measured/speed-against-error.md: the cost and the effect of each bit",
                   "rayclock study tradeoff -o docs/measured/speed-against-error.md", declare_tradeoff,
                   run_tradeoff);
}

}   // namespace rayclock

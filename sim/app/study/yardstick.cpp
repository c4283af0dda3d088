// rayclock study yardstick: makes docs/measured/comparison-with-other-chips.md, simulated figures next to
// published ones.
#include <fmt/format.h>

#include "model/base/quote.hpp"
#include "sim/app/options/commands.hpp"
#include "sim/app/options/options.hpp"
#include "sim/files/image/image.hpp"
#include "sim/files/process/interrupt.hpp"
#include "sim/files/process/stopping.hpp"
#include "sim/silicon/chip/clock.hpp"
#include "sim/study/yardstick.hpp"
#include "sim/view/report/text.hpp"

namespace rayclock {

namespace {

struct YardstickOptions {
    std::string output;
    int threads = 0;
};

void declare_yardstick(Parser& parser, YardstickOptions& o) {
    parser.option("-o,--output", o.output, "Markdown file to write").required();
    threads_option(parser, o.threads);
}

int run_yardstick(const YardstickOptions& o) {
    check_writable(o.output);
    const Progress progress = stopping(terminal_progress());
    const std::optional<chip::RoutedClock> routed = chip::routed_clock(named_config("ulx3s"));
    const RoutedBoard board = routed ? RoutedBoard{routed->khz(), routed->device} : RoutedBoard{};
    write_file(o.output, yardstick_page(board, o.threads, progress));
    fmt::print("{} written\n", printable(o.output));
    return 0;
}

}   // namespace

Command yardstick_command() {
    return command("yardstick",
                   "docs/measured/comparison-with-other-chips.md: this machine compared with published "
                   "figures of SaarCOR and RPU",
                   "rayclock study yardstick -o docs/measured/comparison-with-other-chips.md",
                   declare_yardstick, run_yardstick);
}

}   // namespace rayclock

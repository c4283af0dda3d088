// rayclock board serve: a simulated board behind a pseudo-terminal, which other programs drive like a real
// one.
#include <cstdio>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"
#include "model/base/stopwatch.hpp"
#include "sim/app/options/command_line.hpp"
#include "sim/app/parts/board_session.hpp"
#include "sim/board/server.hpp"
#include "sim/files/image/image.hpp"
#include "sim/files/process/interrupt.hpp"
#include "sim/files/table.hpp"
#include "sim/run/request/config_file.hpp"
#include "sim/view/report/text.hpp"

namespace rayclock {

int serve_board(const BoardOptions& o) {
    o.json.check();
    if (!o.output.empty()) check_png(o.output);
    if (!o.output.empty() && o.dark) throw UserError("--dark: there is no screen for the picture of -o");
    sdram_part(o.sdram);   // throws
    Config config = load_config(o.config);
    const int khz = settle_board(o, config);
    const std::unique_ptr<SimulatedBoard> board = simulate_board(o, config, khz);
    const bool talks = !o.json.is_alone();
    const Stopwatch watch;
    {
        PseudoTerminal terminal(o.is_simulated() ? "" : o.port);
        if (talks) {
            fmt::print(
                "a board at {:.1f} MHz is simulated behind {}\n"
                "  rayclock board SCENE --port {} drives it; Ctrl-C ends it\n",
                khz / 1e3, terminal.name(), shell_word(o.is_simulated() ? terminal.name() : o.port));
            std::fflush(stdout);
        }
        ServeLimits limits;
        if (o.cycles > 0) limits.last_cycle = o.cycles;
        serve(*board, terminal, interrupted, limits);
    }
    std::vector<std::string> faults = memory_faults(*board);
    for (const std::string& fault : screen_faults(*board)) faults.push_back(fault);
    const bool has_picture = board->screen().frames() > 0;
    if (!o.output.empty() && has_picture)
        write_file(o.output, png_bytes(picture_of({int(Screens::width), int(Screens::height)},
                                                  board->screen().picture().pixels)));
    if (talks) {
        fmt::print(
            "  simulated {} cycles in {:.1f} s{}\n", grouped(board->cycle()), watch.seconds(),
            o.dark ? ""
                   : fmt::format("; the screen showed {} whole pictures", grouped(board->screen().frames())));
        for (const std::string& fault : faults) fmt::print("  fault: {}\n", fault);
        if (!o.output.empty())
            fmt::print("  {}{}\n", printable(o.output),
                       has_picture ? " has the last of them" : " is not written: there was no picture yet");
    }
    const bool is_good = faults.empty() && (o.output.empty() || has_picture);
    o.json.write({{"cycles", board->cycle()},
                  {"screen_pictures", board->screen().frames()},
                  {"faults", faults},
                  {"good", is_good}});
    return is_good ? 0 : 1;
}

}   // namespace rayclock

// Shows the progress of RTL builds on standard error.
#include "sim/view/report/builds.hpp"

#include <cstdio>

#include <fmt/format.h>
#include <unistd.h>

#include "sim/run/rtl/builder.hpp"
#include "sim/view/report/terminal_line.hpp"

namespace rayclock {

namespace {

/// Draws a line that replaces itself and disappears when the build ends.
void draw(const BuildStep& step) {
    const std::string left = step.left ? fmt::format(", about {:.0f} s left", *step.left) : "";
    if (step.stage.empty())
        wipe_line();
    else
        draw_line(fmt::format("building {}: {}, {:.0f} s{}", step.what, step.stage, step.seconds, left));
}

}   // namespace

std::optional<std::string> BuildLines::line(const BuildStep& step) {
    if (step.stage.empty()) {
        minutes_.erase(step.what);
        return {};
    }
    const auto [told, begins] = minutes_.try_emplace(step.what, 0);
    if (begins) return fmt::format("building {}, once for all runs", step.what);
    const int minutes = int(step.seconds / 60);
    if (minutes <= told->second) return {};
    told->second = minutes;
    return fmt::format("still building {}: {}, {} min", step.what, step.stage, minutes);
}

void show_builds() {
    if (isatty(STDERR_FILENO))
        report_builds(draw);
    else
        report_builds([lines = BuildLines()](const BuildStep& step) mutable {
            if (const auto line = lines.line(step)) fmt::print(stderr, "rayclock: {}\n", *line);
        });
}

}   // namespace rayclock

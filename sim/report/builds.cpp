#include "sim/report/builds.hpp"

#include <cstdio>
#include <mutex>
#include <set>
#include <string>

#include <fmt/format.h>
#include <unistd.h>

#include "sim/report/terminal_line.hpp"
#include "sim/rtl/builder.hpp"

namespace rayclock {

namespace {

/// A line that is drawn again and again, and gone in the end.
void draw(const BuildStep& step) {
    const std::string left = step.left ? fmt::format(", about {:.0f} s left", *step.left) : "";
    if (step.stage.empty())
        wipe_line();
    else
        draw_line(fmt::format("building {}: {}, {:.0f} s{}", step.what, step.stage, step.seconds, left));
}

/// One line for each build, at its beginning.
class Lines {
public:
    void tell(const BuildStep& step) {
        if (step.stage.empty())
            said_.erase(step.what);
        else if (said_.insert(step.what).second)
            fmt::print(stderr, "rayclock: building {}, once for all runs; this may take a minute\n",
                       step.what);
    }

private:
    std::set<std::string> said_;
};

}   // namespace

void show_builds() {
    if (isatty(STDERR_FILENO))
        report_builds(draw);
    else
        report_builds([lines = Lines()](const BuildStep& step) mutable { lines.tell(step); });
}

}   // namespace rayclock

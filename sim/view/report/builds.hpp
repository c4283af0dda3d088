#pragma once
// Progress output for RTL builds, the slowest work of the program.
#include <map>
#include <optional>
#include <string>

#include "sim/run/rtl/builder.hpp"

namespace rayclock {

/// Formats builds as lines for a log: one when a build begins, then one a minute with the current stage.
class BuildLines {
public:
    /// Returns the line for a step, or nothing if the step has no line.
    std::optional<std::string> line(const BuildStep& step);

private:
    std::map<std::string, int> minutes_;   // minutes already reported of each running build
};

/// Reports all later builds of RTL on standard error: as a moving line on a terminal, otherwise by
/// BuildLines.
void show_builds();

}   // namespace rayclock

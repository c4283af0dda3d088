#pragma once
// What people see while RTL is built, which takes longer than anything else that the program does.
#include <map>
#include <optional>
#include <string>

#include "sim/run/rtl/builder.hpp"

namespace rayclock {

/// Builds as lines for a log: one when a build begins, and one after each minute of it with its stage.
class BuildLines {
public:
    /// The line for a step, if it has one.
    std::optional<std::string> line(const BuildStep& step);

private:
    std::map<std::string, int> minutes_;   // of each build that is under way, as far as they are told
};

/// From now on builds of RTL are told on standard error: a line that moves on a terminal, otherwise
/// BuildLines.
void show_builds();

}   // namespace rayclock

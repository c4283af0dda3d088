#pragma once
// What was typed, so that a report can say how to repeat it.
#include <string>
#include <utility>
#include <vector>

namespace rayclock {

/// Called once, by main().
void keep_command_line(int argc, char** argv);

/// As a shell would take it, with the program called rayclock.
std::string command_line();

/// The command that explains a pixel of the picture that was made by this command line, at a clock; PIXEL
/// stands for the pixel. Options that `explain` does not have are left out.
std::string explain_line(int khz);

/// Program and compiler, each with its version.
std::vector<std::pair<std::string, std::string>> versions();

}   // namespace rayclock

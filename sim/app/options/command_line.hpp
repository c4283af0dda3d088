#pragma once
// The command line as typed, so that a report can be reproduced.
#include <string>
#include <utility>
#include <vector>

namespace rayclock {

/// Returns a word in shell syntax.
std::string shell_word(const std::string& word);

/// Stores the arguments; main() calls it once.
void keep_command_line(int argc, char** argv);

/// Returns the command line in shell syntax, with the program called rayclock.
std::string command_line();

/// Returns the command that explains a pixel of this command's picture at a clock; PIXEL stands for the
/// pixel. Omits options that `explain` lacks.
std::string explain_line(int khz);

/// Returns the versions of the program and of the compiler.
std::vector<std::pair<std::string, std::string>> versions();

}   // namespace rayclock

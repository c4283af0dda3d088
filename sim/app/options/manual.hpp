#pragma once
// The manual page and the completions of shells, made from the declared options of all commands.
#include <string>
#include <string_view>
#include <vector>

#include "sim/app/options/command.hpp"

namespace rayclock {

/// Returns the text for `form`: man, bash, zsh or fish. `footer` is the help about exit codes and
/// environment. Throws UserError for any other form.
std::string manual(std::string_view form, const std::vector<Command>& commands, const std::string& footer);

}   // namespace rayclock

#pragma once
// The manual page, and what shells complete, made from the options that the commands declare.
#include <string>
#include <string_view>
#include <vector>

#include "sim/app/command.hpp"

namespace rayclock {

/// `form`: man, bash, zsh or fish. `footer`: what the help says of exit codes and environment. Throws
/// UserError for any other form.
std::string manual(std::string_view form, const std::vector<Command>& commands, const std::string& footer);

}   // namespace rayclock

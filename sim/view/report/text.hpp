#pragma once
#include <string>

#include "model/base/progress.hpp"
#include "sim/files/table.hpp"

namespace rayclock {

/// Draws progress with the time that is left on standard error, if that is a terminal; otherwise does
/// nothing. What comes after a comma in `what` is shown, and is not part of the name of the work.
Progress terminal_progress();

/// write_bytes() of sim/files/output.hpp; "-" is standard output. Throws UserError if it cannot.
void write_file(const std::string& path, const std::string& text);

}   // namespace rayclock

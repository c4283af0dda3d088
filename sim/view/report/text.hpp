#pragma once
// Progress on the terminal, and writing of text files.
#include <string>

#include "model/base/progress.hpp"
#include "sim/files/table.hpp"

namespace rayclock {

/// Returns a callback that draws progress and the remaining time on standard error if it is a terminal.
/// Otherwise the callback does nothing. Text after a comma in `what` is shown, but does not belong to the
/// name of the work.
Progress terminal_progress();

/// Writes a file with write_bytes() of sim/files/output.hpp; "-" is standard output. Throws UserError if the
/// file cannot be written.
void write_file(const std::string& path, const std::string& text);

}   // namespace rayclock

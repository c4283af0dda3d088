#pragma once
// The progress line of the terminal.
#include <string>

namespace rayclock {

/// Draws the progress line on standard error, replacing its text. Any thread may call it.
void draw_line(const std::string& text);
void wipe_line();

/// Returns the seconds since the line was last drawn or wiped.
double seconds_since_line();

}   // namespace rayclock

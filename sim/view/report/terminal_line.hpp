#pragma once
#include <string>

namespace rayclock {

/// The one line on standard error that is drawn again and again while somebody waits at a terminal. Any
/// thread may draw it.
void draw_line(const std::string& text);
void wipe_line();

/// Since it was drawn or wiped last.
double seconds_since_line();

}   // namespace rayclock

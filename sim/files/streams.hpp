// The program's own streams: what is printed has arrived, or it is said.
#pragma once
#include <string>
#include <string_view>

namespace rayclock {

/// Call before anything is opened. Occupies the numbers of closed standard streams, so that no file is taken
/// for one of them, and turns the signals of a broken pipe and of a file that may not grow into errors of the
/// write.
void guard_streams();

/// Text that may be longer than a buffer: if it does not arrive, finish_output() knows why.
void write_output(std::string_view text);

/// Flushes and closes standard output; empty if all that was printed has arrived, or the reason.
std::string finish_output();

}   // namespace rayclock

#pragma once
// The program's standard streams: the program reports it if printed text does not arrive.
#include <string>
#include <string_view>

namespace rayclock {

/// Prepares the standard streams; call it before anything is opened. It occupies the descriptors of closed
/// standard streams, so that no file gets their numbers. It also turns the signals SIGPIPE (broken pipe) and
/// SIGXFSZ (file size limit) into errors of the write.
void guard_streams();

/// Prints text that may be longer than the stream's buffer. finish_output() reports the reason if it does not
/// arrive.
void write_output(std::string_view text);

/// Flushes and closes standard output. Returns an empty string if all printed text has arrived, and the
/// reason if not.
std::string finish_output();

}   // namespace rayclock

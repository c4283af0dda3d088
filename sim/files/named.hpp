#pragma once
// The user's files of this run: no output replaces an input.
#include <string>

struct stat;

namespace rayclock {

/// A file of the user's is read, and this is it. Throws UserError if an output was announced that would
/// replace it.
void note_input(const std::string& path, const struct stat& file);

/// A file is going to be written at `path`. Throws UserError if an input is there.
void note_output(const std::string& path);

/// It has been written: the name now means another file.
void forget_output(const std::string& path);

}   // namespace rayclock

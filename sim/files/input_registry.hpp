#pragma once
// The register of the user's files in this run: it prevents an output from replacing an input.
#include <string>

struct stat;

namespace rayclock {

/// Registers a file that the program reads; `file` is its status. Throws UserError if an announced output
/// would replace it. Safe to call from several threads.
void note_input(const std::string& path, const struct stat& file);

/// Announces an output at `path`. Throws UserError if `path` is a registered input.
void note_output(const std::string& path);

/// Withdraws the announcement of `path` once it is written: the name now refers to another file.
void forget_output(const std::string& path);

}   // namespace rayclock

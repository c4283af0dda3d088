#pragma once
// Writing whole files: a file appears complete or not at all. Every error is reported, including one in the
// last byte.
#include <filesystem>
#include <string>
#include <string_view>

namespace rayclock {

/// Throws UserError if no file could be created at `path`: empty name, missing folder, a directory, no
/// permission, a symbolic link. It refuses a link because renaming would replace the link and not the file
/// that it points to. Call it before the work that produces the file.
void check_writable(const std::string& path);

/// Checks the same, and also throws UserError for a pipe or a device: the output must be an ordinary file.
void check_replaceable(const std::string& path);

/// Whether a file must survive a crash of the machine or may be missing after it.
enum class Durable { yes, no };

/// Writes a file under a temporary name in the same folder, then renames it. Until the rename, and after an
/// error, the old file at `path` is untouched. Writes to a device or a pipe in place. Throws UserError if it
/// cannot write.
void write_bytes(const std::string& path, std::string_view bytes, Durable durable = Durable::yes);

}   // namespace rayclock

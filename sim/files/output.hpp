// Writing whole files: they appear complete or not at all, and every error is seen, that of the last byte as
// well.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>

namespace rayclock {

/// Fails early (UserError) if a file could not be created at `path`: missing folder, a directory, no
/// permission, a symbolic link. A link is refused because renaming would replace it, not the file that it
/// points to.
void check_writable(const std::string& path);

/// The same, and refuses pipes and devices, too: what is written there must be an ordinary file.
void check_replaceable(const std::string& path);

/// Whether a file must outlive a crash of the machine, or may as well be missing after it.
enum class Durable { yes, no };

/// Writes under a temporary name in the same folder, then renames. Until the end, and after an error,
/// whatever stood at `path` is untouched. A device or a pipe is written to in place. Throws UserError.
void write_bytes(const std::string& path, std::string_view bytes, Durable durable = Durable::yes);

}   // namespace rayclock

// Reading a whole file, with a sentence for everything that can be wrong with its name.
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>

namespace rayclock {

/// Whose file it is: an output may replace the program's own file, and never a user's.
enum class Owner { user, program };

/// All bytes of an ordinary, non-empty file of at most `most` bytes. Throws UserError: missing, a directory,
/// a pipe or a device (which may never end), unreadable, empty, too long. `asked_by` is told as well, if
/// somebody else's file names this one. A user's file that an announced output would replace is refused.
std::string read_file(const std::filesystem::path& path, const std::string& asked_by = {},
                      std::uint64_t most = std::uint64_t{1} << 40, Owner owner = Owner::user);

/// All bytes of a file of this program's own; empty if it cannot be read. Of a file that still grows, those
/// that it has now.
std::string read_if_there(const std::filesystem::path& path);

/// The extension in small letters without the dot: "obj".
std::string extension(const std::filesystem::path& path);

}   // namespace rayclock

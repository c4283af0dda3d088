#pragma once
// Reading a whole file. Each way in which a file can be unusable has its own error message.
#include <cstdint>
#include <filesystem>
#include <string>

namespace rayclock {

/// Who owns a file: an output may replace the program's own file, but never a user's file.
enum class Owner { user, program };

/// Reads all bytes of an ordinary, non-empty file of at most `most` bytes. Throws UserError if the file is
/// missing, unreadable, empty or too long, or a directory, a pipe or a device (which may never end). If
/// another file names this one, pass its name as `asked_by`: the message then mentions it. Throws UserError
/// too if an announced output would replace this file and its owner is the user.
std::string read_file(const std::filesystem::path& path, const std::string& asked_by = {},
                      std::uint64_t most = std::uint64_t{1} << 40, Owner owner = Owner::user);

/// Reads all bytes of a file of this program's own. Returns an empty string if it cannot. If the file still
/// grows, returns the bytes that it has at the call.
std::string read_if_there(const std::filesystem::path& path);

/// Returns the extension in lower case without the dot: "obj".
std::string extension(const std::filesystem::path& path);

}   // namespace rayclock

// Reading a whole file, with a sentence for everything that can be wrong with its name.
#pragma once
#include <filesystem>
#include <string>

namespace rayclock {

/// All bytes of an ordinary, non-empty file. Throws UserError: missing, a directory, a device, unreadable, empty.
std::string read_file(const std::filesystem::path& path);

/// The extension in small letters without the dot: "obj".
std::string extension(const std::filesystem::path& path);

} // namespace rayclock

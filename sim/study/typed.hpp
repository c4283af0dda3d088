#pragma once
// Text of the commands that pages print.
#include <filesystem>
#include <string>

namespace rayclock {

/// Returns a path for a page. Absolute paths lose their folders, which only this machine has.
inline std::string page_path(const std::filesystem::path& path) {
    return (path.is_absolute() ? path.filename() : path).string();
}

}   // namespace rayclock

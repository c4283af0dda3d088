#pragma once
// What to type for a page, as it stands in the page.
#include <filesystem>
#include <string>

namespace rayclock {

/// A path as a page may name it: where this machine keeps its files is nobody's business.
inline std::string told_path(const std::filesystem::path& path) {
    return (path.is_absolute() ? path.filename() : path).string();
}

}   // namespace rayclock

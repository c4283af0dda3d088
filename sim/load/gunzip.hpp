#pragma once
#include <filesystem>
#include <string>

#include "sim/load/loading.hpp"

namespace rayclock {

/// The extension that says how to read a mesh: that before .gz, if there is one.
std::string mesh_extension(const std::filesystem::path& path);

/// What a file compressed by gzip holds; several behind each other are one. What comes of it is held to
/// Loading's allowance. Throws UserError for what is not gzip, is cut off or damaged.
std::string gunzip(const std::filesystem::path& path, const std::string& bytes, Loading& loading);

}   // namespace rayclock

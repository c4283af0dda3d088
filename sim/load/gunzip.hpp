#pragma once
// Meshes that are compressed by gzip.
#include <filesystem>
#include <string>

#include "sim/load/loading.hpp"

namespace rayclock {

/// Returns the extension that names the mesh's format: the one before .gz if the file is compressed.
std::string mesh_extension(const std::filesystem::path& path);

/// Decompresses a gzip file. Several gzip members in a row make one text. Charges the result to Loading's
/// allowance. Throws UserError if the file is not gzip, is truncated or damaged, or exceeds the allowance.
std::string gunzip(const std::filesystem::path& path, const std::string& bytes, Loading& loading);

}   // namespace rayclock

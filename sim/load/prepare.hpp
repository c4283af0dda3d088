// What the importer gets to see: files in memory that have been checked from the first byte to the last.
//
// The importer drops faces with bad indices, guesses at cut-off files and crashes on some broken ones, all
// without a word. So each format has a checker that refuses with file, line and value, and hands over only
// what it has understood, written anew in the plainest form of the format.
#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "model/core/progress.hpp"

namespace rayclock {

struct Prepared {
    std::string main;                            ///< the name in `files` to start with
    std::map<std::string, std::string> files;    ///< name -> bytes
    std::vector<std::string> materials;          ///< names of materials; the importer sees "m0", "m1" ...
    std::vector<double> refraction;              ///< glTF: index of refraction of each material, which it cannot read
    bool has_normals = true;                     ///< false: normals in the file only repeat the facets (STL)
};

/// One `newmtl` block in plain form, without its first line.
struct MtlBlock {
    std::string name, text;
};

/// More triangles than this do not load: they would fill the memory long before they were traced.
constexpr std::uint64_t max_triangles = 100'000'000;

/// More corners than this in one face are refused: cutting a polygon takes quadratic time.
constexpr std::uint64_t max_corners = 10'000;

Prepared prepare_obj(const std::filesystem::path& path, std::string text, const Progress& progress);
Prepared prepare_ply(const std::filesystem::path& path, std::string bytes, const Progress& progress);
Prepared prepare_stl(const std::filesystem::path& path, std::string bytes, const Progress& progress);
Prepared prepare_gltf(const std::filesystem::path& path, std::string bytes, const Progress& progress);

/// Reads a material file. One that does not exist defines nothing: meshes often travel without theirs.
std::vector<MtlBlock> read_mtl(const std::filesystem::path& path);

} // namespace rayclock

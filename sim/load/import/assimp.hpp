// Files of other programs (FBX, X3D, LWO, Blender and some fifty more) by Assimp: the converter of Debian's
// package assimp-utils makes glTF of them, in a process of its own. What it crashes on, how long it takes and
// how much memory stay there. Formats that this program reads itself are not given to it:
// docs/decisions/input-files.md has the figures.
#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace rayclock {

/// The program, and the package that has it.
constexpr const char *assimp_program = "assimp", *assimp_package = "assimp-utils";

/// What the process may take: 10 s, 2 GB and a quarter of a GB, and more for a large file.
struct AssimpLimits {
    explicit AssimpLimits(std::uint64_t file_bytes);
    std::uint64_t processor_seconds, seconds, memory_bytes, result_bytes;
};

/// True for an extension ("fbx") that is given to Assimp.
bool assimp_reads(const std::string& extension);

/// The file as GLB. `unpacked` is what it holds, if it is compressed. Throws UserError with the file's name
/// if Assimp is not there, refuses the file, crashes, or takes too much; and std::runtime_error after Ctrl-C.
std::string assimp_glb(const std::filesystem::path& file, std::uint64_t file_bytes,
                       const std::optional<std::string>& unpacked);

}   // namespace rayclock

#pragma once
// Files of other programs (FBX, X3D, LWO, Blender and about forty more formats), read by Assimp. The
// converter of Debian's package assimp-utils turns them into glTF in a separate process. So its crashes, time
// and memory cannot harm this program. Formats that this program reads itself do not go to Assimp:
// docs/decisions/input-files.md has the figures.
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace rayclock {

/// The converter, and its Debian package.
constexpr const char *assimp_program = "assimp", *assimp_package = "assimp-utils";

/// Limits of the process: 10 s of processor time, 2 GB of memory and 256 MB of output, and more for a large
/// file.
struct AssimpLimits {
    explicit AssimpLimits(std::uint64_t file_bytes);
    std::uint64_t processor_seconds, seconds, memory_bytes, result_bytes;
};

/// Returns true for an extension ("fbx") that Assimp reads.
bool assimp_reads(const std::string& extension);

/// Returns the file as GLB. `unpacked` holds the content of a compressed file. Throws UserError with the
/// file's name if Assimp is missing, rejects the file, crashes or exceeds a limit. Throws std::runtime_error
/// after Ctrl-C.
std::string assimp_glb(const std::filesystem::path& file, std::uint64_t file_bytes,
                       const std::optional<std::string>& unpacked);

}   // namespace rayclock

#pragma once
// The place of this code on the disk.
#include <filesystem>

namespace rayclock {

/// Returns the folder of the file that holds this code: the program, or the Python module. The files that
/// come with it are found from there. Returns an empty path if the system does not say.
std::filesystem::path program_folder();

}   // namespace rayclock

#pragma once
// Exports one frame of a chip as files that do not need this program, for another simulator or for a board.
#include <string>
#include <vector>

#include "sim/run/frame/frame.hpp"

namespace rayclock {

/// A file of an export.
struct ExportedFile {
    std::string name;   ///< path within the export's folder
    std::string bytes;
};
/// All files of an export, and what they should produce.
struct Export {
    std::vector<ExportedFile> files;
    std::uint64_t cycles = 0;   ///< the frame's cycles, which the test bench expects
    std::uint64_t digest = 0;
};

/// Returns the RTL, the memory image, the register writes, the expected pixels and account, and a test bench
/// that checks them. `job` must use the ideal memory, because the bench has its timing. `title` names the
/// exported frame, `command` the command that made it. Throws UserError if the configuration has no RTL.
Export make_export(const Job& job, const std::string& title, const std::string& command,
                   const Progress& progress = {});

}   // namespace rayclock

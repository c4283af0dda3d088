#pragma once
// A frame of a chip as files that need nothing of this program: for another simulator, or for a board.
#include <string>
#include <vector>

#include "sim/run/engine/engine.hpp"

namespace rayclock {

struct ExportedFile {
    std::string name;   ///< from the export's folder
    std::string bytes;
};
struct Export {
    std::vector<ExportedFile> files;
    std::uint64_t cycles = 0;   ///< of the frame, as the test bench expects them
    std::uint64_t digest = 0;
};

/// The RTL, the memory image, the registers, the expected pixels and account, and a test bench that checks
/// them. `job` must have the ideal memory: its timing is the bench's. `title` names what is exported,
/// `command` made it. Throws UserError if the configuration has no RTL.
Export make_export(const Job& job, const std::string& title, const std::string& command,
                   const Progress& progress = {});

}   // namespace rayclock

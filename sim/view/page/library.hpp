#pragma once
// The JavaScript modules of Vega that pages contain.
#include <filesystem>
#include <string>
#include <vector>

namespace rayclock {

/// A JavaScript module of Vega.
struct LibraryModule {
    std::string name, source;
};

/// Returns the Vega modules that the page's charts need, each after the modules that it requires. Reads
/// Debian's package libjs-vega, or the folder RAYCLOCK_VEGA. `trees` adds the module with tree layouts.
/// Throws UserError if a module is missing.
std::vector<LibraryModule> chart_library(bool trees);

/// Returns the folder in which chart_library() looks for the modules.
std::filesystem::path chart_library_folder();

}   // namespace rayclock

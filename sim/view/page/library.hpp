#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace rayclock {

struct LibraryModule {
    std::string name, source;
};

/// The modules of Vega that the page's charts need, each after those that it asks for. From Debian's package
/// libjs-vega (and with `trees` the one that lays out trees), or from the folder RAYCLOCK_VEGA. Throws
/// UserError if one is missing.
std::vector<LibraryModule> chart_library(bool trees);

/// Where they are looked for.
std::filesystem::path chart_library_folder();

}   // namespace rayclock

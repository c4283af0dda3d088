#pragma once
// The Verilog sources: where they are, what is wrong with that place, and their texts.
#include <filesystem>
#include <string>
#include <vector>

namespace rayclock {

/// Folder of the Verilog sources: $RAYCLOCK_RTL (to try out a changed copy), or that of the tree that this
/// program lies in, or what was installed with it, or that of the tree that it was built from.
std::filesystem::path rtl_sources();

/// What is wrong with that folder, in a sentence; empty if all is well.
std::string rtl_sources_problem();

/// All of them but the package, in a fixed order. Throws UserError with the problem.
std::vector<std::filesystem::path> rtl_files();

/// A source as a build sees it: `name` is its path from the folder, without any character that a tool could
/// trip over.
struct RtlText {
    std::string name, text;
};
/// rtl_files() and the waivers, lint.vlt, which are the first. Throws UserError.
std::vector<RtlText> rtl_texts();

}   // namespace rayclock

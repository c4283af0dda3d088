#pragma once
// The Verilog sources: their folder, its errors, and their texts.
#include <filesystem>
#include <string>
#include <vector>

namespace rayclock {

/// Returns the folder of the Verilog sources. It is $RAYCLOCK_RTL (to try a changed copy), or part of the
/// tree or installation around this program. Otherwise it is part of the tree that the program was built
/// from.
std::filesystem::path rtl_sources();

/// Returns a sentence about an error in that folder; empty if there is none.
std::string rtl_sources_problem();

/// Returns all sources except the package, in a fixed order. Throws UserError if rtl_sources_problem() has
/// one.
std::vector<std::filesystem::path> rtl_files();

/// Returns the text of the module rc_NAME in the folder. Throws UserError if there is none.
std::string module_text(const std::string& name);

/// Builds the RTL with the text of a file in place of the module rc_NAME's from now on. The file may hold
/// further modules. It may instantiate the module that it replaces under the name rc_NAME_own. Throws
/// UserError if the folder has no such module, or if the file cannot be read or has no module of that name.
void replace_module(const std::string& name, const std::filesystem::path& file);

/// Returns ", with tri=my_tri.sv" for all replaced modules, for messages; empty if there is none.
std::string replacements_text();

/// Undoes replace_module() for all modules.
void restore_modules();

/// A source for a build. `name` is its path from the folder, without characters that a tool cannot handle.
struct RtlText {
    std::string name, text;
};
/// The sources that a build needs: the chip's, or also the sources of the board around it (rtl/board). So a
/// change of the board does not rebuild a chip.
enum class RtlScope { chip, board };

/// Returns the texts of lint.vlt, which holds the waivers, and of rtl_files(). Verilator does not warn about
/// replaced modules. Throws UserError.
std::vector<RtlText> rtl_texts(RtlScope scope = RtlScope::chip);

}   // namespace rayclock

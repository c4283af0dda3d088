// Finding and reading the Verilog sources.
#include "sim/run/rtl/sources.hpp"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <cstring>
#include <map>
#include <regex>
#include <set>

#include <fmt/format.h>

#include "model/base/error.hpp"
#include "model/base/quote.hpp"
#include "sim/files/input.hpp"
#include "sim/files/program_folder.hpp"

namespace rayclock {

namespace fs = std::filesystem;

namespace {

bool is_file(const fs::path& path) {
    std::error_code error;
    return fs::is_regular_file(path, error);
}

const char* chosen_folder() {
    const char* chosen = std::getenv("RAYCLOCK_RTL");
    return chosen && *chosen ? chosen : nullptr;
}

/// Returns the tree around this program's file: a source tree, which may have been moved after the build, or
/// an installation. Returns an empty path if there is none.
fs::path own_tree() {
    fs::path place = program_folder();
    for (; !place.empty() && place != place.root_path(); place = place.parent_path())
        for (const fs::path& tree : {place / "share/rayclock", place})
            if (is_file(tree / "rtl/rc_top.sv")) return tree;
    return {};
}

/// The texts in place of modules, by the names of their sources: "rc_tri.sv".
struct Replacement {
    std::string option, text;
};
std::map<std::string, Replacement>& replacements() {
    static std::map<std::string, Replacement> all;
    return all;
}

/// Matches the head of a module, up to its name.
std::regex head_of(const std::string& module) {
    return std::regex("\\bmodule\\s+(automatic\\s+|static\\s+)?" + module + "\\b");
}

std::string text_of(const fs::path& path) {
    if (!is_file(path)) throw UserError(path.string() + ": no ordinary file, and the RTL needs it");
    std::string text = read_if_there(path);
    if (text.empty()) throw UserError(path.string() + ": empty, or cannot be read");
    return text;
}

/// Replaces characters that Verilator's makefiles and wrappers cannot handle: blanks, quotes, dollars.
std::string safe_name(const fs::path& file, std::set<std::string>& taken) {
    std::string name = file.string();
    for (char& c : name)
        if (!std::isalnum(static_cast<unsigned char>(c)) && !std::strchr("_./-", c)) c = '_';
    while (!taken.insert(name).second) name.insert(0, 1, '_');
    return name;
}

}   // namespace

fs::path rtl_sources() {
    if (const char* chosen = chosen_folder()) return chosen;
    static const fs::path tree = own_tree();
    return (tree.empty() ? fs::path(RAYCLOCK_SOURCE_DIR) : tree) / "rtl";
}

std::string rtl_sources_problem() {
    const fs::path folder = rtl_sources();
    const std::string name = (chosen_folder() ? "RAYCLOCK_RTL=" : "") + folder.string();
    const std::string cure = chosen_folder() ? "; it must be a copy of the project's folder rtl"
                                             : "; set RAYCLOCK_RTL to the folder rtl of rayclock's sources";
    std::error_code error;
    const fs::file_status status = fs::status(folder, error);
    if (status.type() == fs::file_type::not_found)
        return name + " does not exist, and the RTL is built from it" + cure;
    if (error)
        return fmt::format("{} cannot be read ({}), and the RTL is built from it{}", name, error.message(),
                           cure);
    if (!fs::is_directory(status)) return name + " is not a folder, and the RTL is built from it" + cure;
    for (const char* file : {"rc_top.sv", "lint.vlt"})
        if (!is_file(folder / file)) return fmt::format("{} has no file {} in it{}", name, file, cure);
    return {};
}

std::vector<fs::path> rtl_files() {
    if (const std::string problem = rtl_sources_problem(); !problem.empty()) throw UserError(problem);
    std::vector<fs::path> files;
    std::error_code error;
    for (fs::recursive_directory_iterator it(rtl_sources(), error), end; !error && it != end;
         it.increment(error))
        if (it->path().extension() == ".sv" && it->path().filename() != "rc_pkg.sv")
            files.push_back(it->path());
    if (error)
        throw UserError(fmt::format("{}: cannot be read ({})", rtl_sources().string(), error.message()));
    std::sort(files.begin(), files.end());
    return files;
}

std::string module_text(const std::string& name) {
    const std::string source = "rc_" + name + ".sv";
    const std::vector<fs::path> files = rtl_files();
    const auto file = std::ranges::find_if(files, [&](const fs::path& f) { return f.filename() == source; });
    if (file == files.end()) throw UserError(fmt::format("the RTL has no module {}", shown("rc_" + name)));
    return text_of(*file);
}

void replace_module(const std::string& name, const fs::path& file) {
    const std::string option = fmt::format("--unit {}={}", printable(name), printable(file.string()));
    try {
        module_text(name);
    } catch (const UserError& error) {
        throw UserError(option + ": " + error.what());
    }
    const std::string module = "rc_" + name;
    std::error_code error;
    if (fs::is_directory(file, error)) throw UserError(option + ": this is a folder, not a file");
    if (!is_file(file)) throw UserError(option + ": there is no such file");
    const std::string text = read_if_there(file);
    if (text.empty()) throw UserError(option + ": the file is empty, or cannot be read");
    if (!std::regex_search(text, head_of(module)))
        throw UserError(fmt::format("{}: the file has no module {}", option, module));
    // The cache of built RTL knows the text of this file only.
    if (text.find("`include") != text.npos)
        throw UserError(option + ": the file includes another one; put that text into the file");
    if (text.find("$finish") != text.npos)
        throw UserError(option +
                        ": the file has $finish, which would end the program; $error reports a fault");
    for (const char* const outer : {"pipeline", "top", "chip"})
        if (name == outer && text.find(module + "_own") != text.npos)
            throw UserError(
                fmt::format("{0}: a wrapper around {1} hides the signals that are compared; write the "
                            "text of {1} anew",
                            option, module));
    if (!replacements().emplace(module + ".sv", Replacement{name + "=" + file.string(), text}).second)
        throw UserError(option + ": this module is replaced twice");
}

std::string replacements_text() {
    std::string text;
    for (const auto& [source, r] : replacements()) text += (text.empty() ? ", with " : ", ") + r.option;
    return text;
}

void restore_modules() { replacements().clear(); }

std::vector<RtlText> rtl_texts(RtlScope scope) {
    std::vector<fs::path> files = rtl_files();
    if (scope == RtlScope::chip)
        std::erase_if(
            files, [](const fs::path& f) { return *f.lexically_relative(rtl_sources()).begin() == "board"; });
    files.insert(files.begin(), rtl_sources() / "lint.vlt");
    std::vector<RtlText> texts;
    std::set<std::string> taken{"rc_pkg.sv"};
    for (const fs::path& file : files) {
        const std::string name = safe_name(file.lexically_relative(rtl_sources()), taken);
        const auto other = replacements().find(file.filename().string());
        if (other == replacements().end()) {
            texts.push_back({name, text_of(file)});
            continue;
        }
        texts.push_back({name, other->second.text});
        // The first text is a configuration file of Verilator.
        texts.front().text += fmt::format("`verilator_config\nlint_off -file \"*/{}\"\n", other->first);
        const std::string module = file.stem(), own = module + "_own";
        if (other->second.text.find(own) != std::string::npos)
            texts.push_back({safe_name(fs::path(name).parent_path() / (own + ".sv"), taken),
                             std::regex_replace(text_of(file), head_of(module), "module $1" + own)});
    }
    return texts;
}

}   // namespace rayclock

// Loads Vega from Debian's package, which has one file for each module. Modules refer to each other by
// require(). A page gets the modules that its charts need, and a few lines that join them.
#include "sim/view/page/library.hpp"

#include <cstdlib>
#include <set>

#include "model/base/error.hpp"
#include "sim/files/input.hpp"
#include "sim/view/page/html.hpp"

namespace rayclock {

namespace {

/// The modules of Vega's own entry point, except maps, trees, forces, word clouds and regressions.
constexpr const char* roots[] = {"vega-util",       "vega-dataflow",        "vega-format", "vega-transforms",
                                 "vega-encode",     "vega-view-transforms", "vega-parser", "vega-view",
                                 "vega-scenegraph", "vega-scale",           "vega-runtime"};

std::filesystem::path file_of(const std::string& module) {
    // Debian names the file of vega-selections "vega-selection".
    const std::string name = module == "vega-selections" ? "vega-selection" : module;
    return chart_library_folder() / (name + ".min.js");
}

std::vector<std::string> asked_for(const std::string& source) {
    std::vector<std::string> modules;
    const std::string_view head = std::string_view(source).substr(0, 2000), call = "require(\"";
    for (std::size_t at = head.find(call); at != head.npos; at = head.find(call, at)) {
        at += call.size();
        modules.emplace_back(head.substr(at, head.find('"', at) - at));
    }
    return modules;
}

/// Appends a module after the modules that it requires.
void add(const std::string& module, std::set<std::string>& seen, std::vector<LibraryModule>& modules) {
    if (!seen.insert(module).second) return;
    const std::string source = read_if_there(file_of(module));
    if (source.empty())
        throw UserError("--report: " + file_of(module).string() +
                        " is missing, which draws the charts; Debian's package libjs-vega has it");
    for (const std::string& other : asked_for(source)) add(other, seen, modules);
    modules.push_back({module, source});
}

}   // namespace

std::filesystem::path chart_library_folder() {
    const char* folder = std::getenv("RAYCLOCK_VEGA");
    return folder && *folder ? folder : "/usr/share/javascript/vega";
}

std::vector<LibraryModule> chart_library(bool trees) {
    std::set<std::string> seen;
    std::vector<LibraryModule> modules;
    if (trees) add("vega-hierarchy", seen, modules);
    for (const char* root : roots) add(root, seen, modules);
    return modules;
}

}   // namespace rayclock

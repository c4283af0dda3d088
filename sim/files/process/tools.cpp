// Finding the tools and parsing their version lines.
#include "sim/files/process/tools.hpp"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "sim/files/process/process.hpp"

namespace rayclock {

namespace fs = std::filesystem;

namespace {

std::string problem_of(const RtlTools& tools) {
    const auto missing = [](const char* program, const char* what) {
        const bool there = !find_program(program).empty();
        return fmt::format("{} {}, and {} needs it; 'rayclock doctor' tells what is missing", program,
                           there ? "does not run" : "is not installed", what);
    };
    if (tools.verilator.empty() || tools.verilator_root.empty()) return missing("verilator", "the RTL");
    if (tools.compiler.empty()) return missing("c++", "the RTL");
    std::error_code error;
    const fs::path header = fs::path(tools.verilator_root) / "include/verilated.h";
    if (fs::is_regular_file(header, error)) return {};
    return header.string() +
           " is missing, and the RTL needs it; install Verilator again, or set VERILATOR_ROOT";
}

}   // namespace

std::string version_line(const std::vector<std::string>& words) {
    const std::string text = output_of(words);
    return text.substr(0, text.find('\n'));
}

const RtlTools& rtl_tools() {
    static const RtlTools tools = [] {
        RtlTools found;
        found.verilator = version_line({"verilator", "--version"});
        if (!found.verilator.empty())
            found.verilator_root = version_line({"verilator", "--getenv", "VERILATOR_ROOT"});
        found.compiler = version_line({"c++", "--version"});
        if (!found.compiler.empty()) found.compiler += ", " + version_line({"c++", "-dumpmachine"});
        found.problem = problem_of(found);
        return found;
    }();
    return tools;
}

const std::vector<TriedTool>& tried_tools() {
    static const std::vector<TriedTool> tools{
        {"verilator", {"5.006", "5.032"}}, {"c++", {"12", "14", "clang 14"}}, {"yosys", {"0.23", "0.52"}}};
    return tools;
}

std::string short_version(const std::string& tool, const std::string& line) {
    const bool clang = line.find("clang version ") != std::string::npos;
    // GCC's line ends with the version: c++ (Debian 12.2.0-14) 12.2.0. Other lines begin with the name and
    // the version.
    std::size_t at = line.find(' ') + 1;
    if (clang)
        at = line.find("clang version ") + 14;
    else if (tool == "c++")
        at = line.substr(0, line.find(',')).rfind(' ') + 1;
    const std::size_t end = line.find_first_not_of(tool == "c++" ? "0123456789" : "0123456789.", at);
    const std::string number = line.substr(at, end == std::string::npos ? end : end - at);
    return number.empty() ? number : (clang ? "clang " : "") + number;
}

std::string untried(const std::string& tool, const std::string& line) {
    for (const TriedTool& tried : tried_tools()) {
        if (tried.name != tool || line.empty()) continue;
        const std::string version = short_version(tool, line);
        if (std::find(tried.versions.begin(), tried.versions.end(), version) != tried.versions.end())
            return {};
        return fmt::format("{} {} was not tried with rayclock, only {}; it is used anyway", tool,
                           version.empty() ? "of this version" : version, fmt::join(tried.versions, ", "));
    }
    return {};
}

}   // namespace rayclock

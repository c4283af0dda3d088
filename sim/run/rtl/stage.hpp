#pragma once
// The common steps of all builds, each in a separate folder: copy the sources, run the tools, and remove
// everything except the result.
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "model/core/config.hpp"

namespace rayclock {

/// Called repeatedly while a tool works, with its name and the estimated seconds until the end, if they are
/// known.
using Working = std::function<void(const char* stage, std::optional<double> left)>;

/// Returns the options in RAYCLOCK_CXXFLAGS.
std::string added_flags();

/// Returns the sources of a module and the waivers, but not the package, as one text.
std::string source_inputs(const std::string& module);

/// Copies the sources of a module to a folder in which tools run, under names that all tools can handle. So
/// tools see no path of the user. Returns the names there: the waivers, the package, all others. Throws
/// UserError.
std::vector<std::string> stage_sources(const std::filesystem::path& folder, const Config& config,
                                       const std::string& module);

/// Runs commands at the same time in a folder, each with its output in a log there. If one fails, ends all
/// others and throws UserError with the tool's message after `what`, or with the cause if it is known. Throws
/// Interrupted after Ctrl-C.
struct ToolJob {
    std::vector<std::string> words;
    std::string log;
};
void run_tools(const std::filesystem::path& folder, const std::vector<ToolJob>& jobs, const std::string& what,
               const std::function<void()>& meanwhile);

/// Removes everything in a folder except one file.
void tidy(const std::filesystem::path& folder, const std::filesystem::path& kept);

}   // namespace rayclock

#pragma once
// What every build does in a folder of its own: sources are put there, tools are run, and all but what they
// were to make is removed.
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "model/core/config.hpp"

namespace rayclock {

/// Called again and again while a tool works: its name, and about how many seconds all is done in, once that
/// can be guessed.
using Working = std::function<void(const char* stage, std::optional<double> left)>;

/// Options of RAYCLOCK_CXXFLAGS.
std::string added_flags();

/// Sources and waivers, but not the package, as one text.
std::string source_ingredients();

/// Copies of the sources, under names that no tool trips over, in a folder that tools are run in: they see no
/// path of the user's. Returns their names there: the waivers, the package, all others.
std::vector<std::string> stage_sources(const std::filesystem::path& folder, const Config& config);

/// Runs commands at the same time in a folder, each with its output in a log there. The first that fails ends
/// all others: std::runtime_error with its words after `what`, or UserError if the cause is known for it.
struct ToolJob {
    std::vector<std::string> words;
    std::string log;
};
void run_tools(const std::filesystem::path& folder, const std::vector<ToolJob>& jobs, const std::string& what,
               const std::function<void()>& meanwhile);

/// Leaves one file alone in a folder.
void tidy(const std::filesystem::path& folder, const std::filesystem::path& kept);

}   // namespace rayclock

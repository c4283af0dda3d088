#pragma once
// The page about textures: its text, its pictures, and the figures as JSON.
#include <nlohmann/json.hpp>

#include "sim/study/textures/measure_textures.hpp"

namespace rayclock::texture_study {

/// Returns the file name of a picture of the page, in the folder `figures` next to the page.
std::string picture_name(const std::string& scene, const std::string& what);

/// Makes folder/figures. Throws UserError if the folder cannot be written, or if two scenes would write the
/// same files.
void prepare_pictures(const std::vector<std::string>& scenes, const std::string& folder);

/// Writes the pictures of the page into folder/figures. Throws UserError if it cannot write.
void write_pictures(const std::vector<SceneFigures>& all, const std::string& folder);

/// Returns the page as Markdown. `command` is the command that makes the page.
std::string page(const std::vector<SceneFigures>& all, const Study& study, const std::string& command);

nlohmann::ordered_json figures_json(const std::vector<SceneFigures>& all, const Study& study);

}   // namespace rayclock::texture_study

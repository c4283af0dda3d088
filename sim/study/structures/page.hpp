#pragma once
// docs/structures.md: every structure on one machine.
#include <string>

#include <nlohmann/json.hpp>

#include "sim/study/structures/measure.hpp"
#include "sim/view/plot/chart.hpp"

namespace rayclock::structures {

/// Scenes of the page in docs/, and the small ones on which a list of all primitives is walked as well.
const std::vector<std::string>& large_scenes();
const std::vector<std::string>& small_scenes();

/// What the page says.
struct Figures {
    std::vector<SceneCells> large, small;
    std::optional<std::vector<Areas>> areas;   ///< as in trees(), then the list's
};

/// As Markdown, with `picture` beside it. `command` is what to type for it.
std::string page(const Figures& figures, const Study& study, const std::string& command,
                 const std::string& picture);
plot::Drawing picture(const Figures& figures, const Study& study);
/// The same figures, a row for each scene, structure and kind of frame (docs/report.md).
nlohmann::ordered_json rows(const Figures& figures, const Limits& limits);

/// A frame's pipeline, if areas were counted: with all units if its rays meet true spheres or are shaded.
const area::Count* area_of(const Figures& figures, const SceneCells& scene, std::size_t structure,
                           bool finished);

/// Geometric mean over the scenes in which all structures were built.
double mean_of(const std::vector<SceneCells>& scenes, std::size_t structure, double (*value)(const Cell&));

/// Of each scene and each of surroundings(): which structure needs the fewest cycles, and by how much.
std::string best_table(const std::vector<SceneCells>& scenes, const Config& base);

/// Why the figures of a scene are what they are, in a paragraph; empty if nobody has looked at the scene. Of
/// the empty name: of all scenes of the page in docs/ together.
const char* reason(const std::string& scene);

}   // namespace rayclock::structures

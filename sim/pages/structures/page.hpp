#pragma once
// docs/structures.md: every structure on one machine.
#include <string>

#include "sim/area/run.hpp"
#include "sim/pages/structures/measure.hpp"
#include "sim/plot/chart.hpp"

namespace rayclock::structures {

/// Scenes of the page in docs/, and the small ones on which a list of all primitives is walked as well.
const std::vector<std::string>& large_scenes();
const std::vector<std::string>& small_scenes();

/// What the page says.
struct Figures {
    std::vector<SceneCells> large, small;
    std::optional<std::vector<area::Count>> counts;   ///< of one pipeline: as in trees(), then the list's
};

/// As Markdown, with `picture` beside it. `command` is what to type for it.
std::string page(const Figures& figures, const Study& study, const std::string& command,
                 const std::string& picture);
plot::Drawing picture(const Figures& figures, const Study& study);

/// Why the figures of a scene are what they are, in a paragraph; empty if nobody has looked at the scene. Of
/// the empty name: of all scenes of the page in docs/ together.
const char* reason(const std::string& scene);

}   // namespace rayclock::structures

#pragma once
// The page docs/measured/structures.md: every structure on one machine.
#include <string>

#include <nlohmann/json.hpp>

#include "sim/study/structures/measure_structures.hpp"
#include "sim/view/plot/chart.hpp"

namespace rayclock::structures {

/// Return the scenes of the page in docs/, and the small scenes that are also walked as a list of all
/// primitives.
const std::vector<std::string>& large_scenes();
const std::vector<std::string>& small_scenes();

/// The data of the page.
struct Figures {
    std::vector<SceneCells> large, small;
    std::optional<std::vector<Areas>> areas;   ///< in the order of trees(), then the list
};

/// Returns the page as Markdown, which links to `picture`. `command` is the command that makes it.
std::string page(const Figures& figures, const Study& study, const std::string& command,
                 const std::string& picture);
plot::Drawing picture(const Figures& figures, const Study& study);
/// Returns the same data with a row for each scene, structure and kind of frame (docs/guide/report.md).
nlohmann::ordered_json rows(const Figures& figures, const Limits& limits);

/// Returns the pipeline of a frame, if areas were counted. It has all units if the frame's rays meet true
/// spheres or are shaded.
const area::Count* area_of(const Figures& figures, const SceneCells& scene, std::size_t structure,
                           bool finished);

/// Return figures of a structure's frame of camera rays.
inline double fps_of(const Cell& c) { return c.camera.fps(); }
inline double cycles_of(const Cell& c) { return c.camera.cycles_per_ray(); }
inline double bytes_of(const Cell& c) { return double(c.report.bytes); }

/// Returns the geometric mean over the scenes in which all structures were built.
double mean_of(const std::vector<SceneCells>& scenes, std::size_t structure, double (*value)(const Cell&));

/// Returns the scenes whose camera rays meet only triangles. These run on the smaller pipeline.
std::vector<SceneCells> triangle_scenes(const Figures& figures);

/// The structure with the fewest cycles a camera ray, and the next one. Null: there is none.
struct Ranking {
    const Cell *best = nullptr, *next = nullptr;
};
/// Ranks the structures of a scene in one of surroundings(). "bvh, splits" is left out, since it is a way to
/// build a bvh.
Ranking ranked(const SceneCells& scene, std::size_t at);
/// Returns the ranking of each scene in each of surroundings() as a table.
std::string best_table(const std::vector<SceneCells>& scenes, const Config& base);

/// Returns visits, tests, cycles and bytes of a scene's structures divided by those of bvh. Returns an empty
/// string if the scene has no bvh.
std::string ratio_table(const SceneCells& scene);
/// Compares the structures over all scenes. Every figure follows from the measurements.
std::string summary(const Figures& figures);
/// Explains the results of a scene of the page in docs/ by its geometry, without figures. Returns an empty
/// string for any other scene.
const char* cause(const std::string& scene);

}   // namespace rayclock::structures

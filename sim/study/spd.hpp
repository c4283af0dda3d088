#pragma once
// The page docs/measured/ray-counts.md: rays of Haines' Standard Procedural Databases, traced by reference
// and model, with the published counts.
#include <array>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "model/base/progress.hpp"
#include "model/scene/camera.hpp"
#include "model/scene/scene.hpp"
#include "model/scene/whitted.hpp"
#include "sim/files/table.hpp"
#include "sim/judge/reference/octree.hpp"

namespace rayclock::spd {

/// Counts of eye rays that hit, reflected rays, refracted rays and shadow rays.
using RaysByKind = std::array<std::uint64_t, 4>;

/// An octree over the scene as given (sim/judge/reference/octree.hpp), and the work of the reference's rays
/// in it.
struct Octree {
    int depth = 0;
    OctreeSize size;
    OctreeWork work;
};

/// The reference's rays by Havran's rules, which walk the octrees.
struct HavranRays {
    std::uint64_t primary_hits = 0, all = 0;
};

/// The counts of one scene.
struct Counted {
    std::string scene;
    std::size_t objects = 0;   ///< as the octrees count objects
    std::vector<Octree> octrees;
    std::optional<RaysByKind> published;
    RaysByKind reference{}, model{};
    HavranRays havran;
    std::uint64_t rays = 0;   ///< rays of the model
    double reference_seconds = 0, model_seconds = 0;
};

/// Returns the scenes with a published count.
std::vector<std::string> published_scenes();

Counted count(const std::string& scene, FrameSize size, int threads, const Progress& progress);

/// Builds the octrees of `scene` and traces the rays of a picture through them, by Havran's rules.
void count_octrees(Counted& counted, const Scene& scene, const Camera& camera, FrameSize size,
                   const Whitted& settings, int threads, const Progress& progress);
/// Return the counts of octrees and of their rays with Havran's: text tables, the section of the page, and
/// JSON. His figures are for scenes at their default sizes and pictures of 513x513.
Table octree_table(const std::vector<Counted>& all);
Table havran_table(const std::vector<Counted>& all);
std::string octree_page(const std::vector<Counted>& all);
nlohmann::ordered_json octree_json(const Counted& counted);

/// Returns true if model and reference are close to the published counts, and the model to the reference.
bool is_good(const Counted& counted);

std::string text(const std::vector<Counted>& all);
/// Returns the page as Markdown. `command` is the command that makes it.
std::string page(const std::vector<Counted>& all, FrameSize size, const std::string& command);
nlohmann::ordered_json json(const std::vector<Counted>& all, FrameSize size);

}   // namespace rayclock::spd

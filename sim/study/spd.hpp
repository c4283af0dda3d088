#pragma once
// docs/spd.md: rays of Haines' Standard Procedural Databases, by reference and model, beside the published
// counts.
#include <array>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "model/base/progress.hpp"
#include "sim/judge/reference/octree.hpp"
#include "model/scene/camera.hpp"
#include "model/scene/scene.hpp"
#include "model/scene/whitted.hpp"
#include "sim/files/table.hpp"

namespace rayclock::spd {

/// Eye rays that hit, reflected, refracted, shadow rays.
using Kinds = std::array<std::uint64_t, 4>;

/// An octree over the scene as given (sim/judge/reference/octree.hpp), and what the reference's rays would do
/// in it.
struct Octree {
    int depth = 0;
    OctreeSize size;
    OctreeWork work;
};

/// The reference's rays by Havran's rules, those that walk the octrees.
struct HavranRays {
    std::uint64_t primary_hits = 0, all = 0;
};

struct Counted {
    std::string scene;
    std::size_t objects = 0;   ///< in the sense of the octrees
    std::vector<Octree> octrees;
    std::optional<Kinds> published;
    Kinds reference{}, model{};
    HavranRays havran;
    std::uint64_t rays = 0;   ///< of the model
    double reference_seconds = 0, model_seconds = 0;
};

/// The scenes with a published count.
std::vector<std::string> published_scenes();

Counted count(const std::string& scene, FrameSize size, int threads, const Progress& progress);

/// Builds the octrees of `scene` and sends the rays of a picture through them, by Havran's rules.
void count_octrees(Counted& counted, const Scene& scene, const Camera& camera, FrameSize size,
                   const Whitted& settings, int threads, const Progress& progress);
/// Counts of octrees and of their rays beside Havran's: tables for people, the part of the page, and as JSON.
/// His figures are of scenes at their default sizes and of pictures of 513x513.
Table octree_table(const std::vector<Counted>& all);
Table havran_table(const std::vector<Counted>& all);
std::string octree_page(const std::vector<Counted>& all);
nlohmann::ordered_json octree_json(const Counted& counted);

/// Whether both engines are close to the published counts, and the model to the reference.
bool is_good(const Counted& counted);

std::string text(const std::vector<Counted>& all);
/// As Markdown. `command` is what to type for it.
std::string page(const std::vector<Counted>& all, FrameSize size, const std::string& command);
nlohmann::ordered_json json(const std::vector<Counted>& all, FrameSize size);

}   // namespace rayclock::spd

#pragma once
// docs/spd.md: rays of Haines' Standard Procedural Databases, by reference and model, beside the published
// counts.
#include <array>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "model/base/progress.hpp"
#include "model/reference/octree.hpp"
#include "model/scene/camera.hpp"
#include "sim/files/table.hpp"

namespace rayclock::spd {

/// Eye rays that hit, reflected, refracted, shadow rays.
using Kinds = std::array<std::uint64_t, 4>;

/// An octree over the scene as given (model/reference/octree.hpp), and what the reference's rays would do in
/// it.
struct Octree {
    int depth = 0;
    OctreeSize size;
    OctreeWork work;
};

struct Counted {
    std::string scene;
    std::size_t objects = 0;   ///< in the sense of the octrees
    std::vector<Octree> octrees;
    std::optional<Kinds> published;
    Kinds reference{}, model{};
    std::uint64_t rays = 0;   ///< of the model
    double reference_seconds = 0, model_seconds = 0;
};

/// The scenes with a published count.
std::vector<std::string> published_scenes();

Counted count(const std::string& scene, FrameSize size, int threads, const Progress& progress);
/// Counts of octrees beside Havran's: table for people and for the page, and as JSON. His figures are of
/// scenes at their default sizes and of pictures of 513x513.
Table octree_table(const std::vector<Counted>& all);
nlohmann::ordered_json octree_json(const Counted& counted);

/// Whether both engines are close to the published counts, and the model to the reference.
bool is_good(const Counted& counted);

std::string text(const std::vector<Counted>& all);
/// As Markdown. `command` is what to type for it.
std::string page(const std::vector<Counted>& all, FrameSize size, const std::string& command);
nlohmann::ordered_json json(const std::vector<Counted>& all, FrameSize size);

}   // namespace rayclock::spd

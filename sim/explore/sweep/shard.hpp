#pragma once
// A sweep on several machines: which points are whose, and what their reports must agree in.
#include <nlohmann/json.hpp>

#include "model/scene/whitted.hpp"
#include "sim/run/film/choice.hpp"
#include "sim/explore/sweep/axes.hpp"

namespace rayclock::sweep {

/// The points of a part, by their numbers, in order. Parts differ in size by one point at most, and points
/// that share a trace stay together as far as that allows. Throws UserError if there are more parts than
/// points.
std::vector<std::size_t> points_of(const Shard& shard, const std::vector<Point>& points);

/// What was asked for, but for the scene, the configuration and the size.
struct Asked {
    std::vector<Axis> axes;
    std::string clock;
    std::string cost;
    std::optional<int> cache_bytes;
    bool netlists = true;
    nlohmann::ordered_json picture;   ///< what is drawn beside the scene at rest, as picture_json() says it
};
/// The finished picture's settings, or null, and the frames.
nlohmann::ordered_json picture_json(const PictureChoice& choice);
nlohmann::ordered_json asked_json(const Asked& asked);
/// Throws a JSON exception if it is not as asked_json() made it.
Asked asked_of(const nlohmann::ordered_json& json);

/// Keeps the points whose caches hold so many bytes in each pipeline, if that was asked for. Throws UserError
/// if there is none.
void keep_size(std::vector<Point>& points, const std::optional<int>& bytes);

/// What a report says of the part; null for the whole. Of another scene or another program nothing can be
/// merged.
nlohmann::ordered_json shard_json(const Shard& shard, const std::vector<std::size_t>& points,
                                  const Scene& scene);

}   // namespace rayclock::sweep

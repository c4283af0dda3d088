#pragma once
// Divides a sweep between machines: the points of each part, and the values in which their reports must
// agree.
#include <nlohmann/json.hpp>

#include "model/scene/whitted.hpp"
#include "sim/explore/sweep/axes.hpp"
#include "sim/run/film/choice.hpp"
#include "sim/run/sample/sample.hpp"
#include "sim/run/stream/input.hpp"

namespace rayclock::sweep {

/// Returns the numbers of a part's points, in order. Sizes of parts differ by at most one point, and points
/// that share a trace stay together as far as that allows. Throws UserError if there are more parts than
/// points.
std::vector<std::size_t> points_of(const Shard& shard, const std::vector<Point>& points);

/// The options of a sweep, except the scene, the configuration and the size.
struct SweepSettings {
    std::vector<Axis> axes;
    std::string clock;
    std::string cost;
    std::optional<int> cache_bytes;
    bool netlists = true;
    nlohmann::ordered_json picture;   ///< picture_json(): settings beyond the scene at rest
    nlohmann::ordered_json stream;    ///< stream_json(): the rays in place of a picture; else null
    nlohmann::ordered_json sample;    ///< sample_json(): size and seed of the samples; null: whole frames

    bool is_stream() const { return !stream.is_null(); }
    bool has_picture() const { return stream.is_null() && sample.is_null(); }
};
/// Returns the finished picture's settings, or null, and the frames.
nlohmann::ordered_json picture_json(const PictureChoice& choice);
nlohmann::ordered_json sample_json(const sample::Ask& ask);
/// Returns the name, the number and the digest of a stream's rays.
nlohmann::ordered_json stream_json(const StreamInput& stream);
nlohmann::ordered_json settings_json(const SweepSettings& settings);
/// Reads the output of settings_json(). Throws a JSON exception if the format is wrong.
SweepSettings settings_of(const nlohmann::ordered_json& json);

/// Keeps only points whose caches hold this many bytes in each pipeline, if a size was requested. Throws
/// UserError if none is left.
void keep_size(std::vector<Point>& points, const std::optional<int>& bytes);

/// Returns a report's entry for its part; null for a whole sweep. It names the scene and the program, because
/// reports of another scene or program cannot be merged.
nlohmann::ordered_json shard_json(const Shard& shard, const std::vector<std::size_t>& points,
                                  const Scene& scene);

}   // namespace rayclock::sweep
